using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>A slot of <see cref="XyzReader"/>.</summary>
    sealed class XyzRead : SlotRead
    {
        readonly XyzReader m_reader;
        readonly NativeFileRead m_file;
        NativeArray<XyzStep> m_steps;
        NativeReference<XyzAnomalies> m_anomalies;

        public XyzRead(XyzReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            m_file = new NativeFileRead(reader.Info.Path, reader.File,
                Math.Min(XyzReader.MaxBlockBytes + XyzReader.MaxLineBytes, reader.Info.FileBytes), allocator);
            m_steps = new NativeArray<XyzStep>(reader.StepsFor(Points), allocator);
            m_anomalies = new NativeReference<XyzAnomalies>(allocator);
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var block = m_reader.Block(range.Block);
            long left = m_reader.Info.FileBytes - block.OffsetBytes;
            int bytes = (int)Math.Min((long)block.Bytes + XyzReader.MaxLineBytes, left);
            var read = m_file.Begin(block.OffsetBytes, bytes);
            return new DecodeXyzJob
            {
                Input = m_file.Buffer,
                InputOffset = block.OffsetBytes,
                InputBytes = bytes,
                BlockBytes = Math.Min(block.Bytes, bytes),
                ReachesFileEnd = bytes == left,
                StartsInRow = block.StartsInRow,
                RowsBefore = bytes == 0 ? 0 : range.First,
                Rows = range.Count,
                Dialect = m_reader.Dialect,
                Steps = m_steps,
                Output = Points.Bytes,
                Result = Result,
                Anomalies = m_anomalies,
            }.Schedule(read);
        }

        protected override void EndRead() => m_file.End();

        protected override void Warn(DecodeResult result) => m_reader.Warn(Range, m_anomalies.Value);

        protected override void DisposeMemory()
        {
            m_file.Dispose();
            m_steps.Dispose();
            m_anomalies.Dispose();
        }
    }
}
