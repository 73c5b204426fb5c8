using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>A slot of <see cref="PlyAsciiReader"/>.</summary>
    sealed class PlyAsciiRead : PlyRead
    {
        readonly PlyAsciiReader m_reader;
        NativeArray<PlyStep> m_steps;

        public PlyAsciiRead(PlyAsciiReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity,
                Math.Min(PlyAsciiReader.MaxBlockBytes + PlyAsciiReader.MaxLineBytes, reader.Info.FileBytes), allocator)
        {
            m_reader = reader;
            m_steps = ToNative(reader.Steps(Points), allocator);
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var block = m_reader.Block(range.Block);
            long left = m_reader.Info.FileBytes - block.OffsetBytes;
            int bytes = (int)Math.Min((long)block.Bytes + PlyAsciiReader.MaxLineBytes, left);
            var read = File.Begin(block.OffsetBytes, bytes);
            return new DecodePlyAsciiJob
            {
                Input = File.Buffer,
                InputOffset = block.OffsetBytes,
                InputBytes = File.Bytes,
                BlockBytes = Math.Min(block.Bytes, File.Bytes),
                ReachesFileEnd = bytes == left,
                StartsInRow = block.StartsInRow,
                RowsBefore = block.RowsBefore + range.First,
                Points = range.Count,
                Steps = m_steps,
                Output = Points.Bytes,
                Result = Result,
                Anomalies = Anomalies,
            }.Schedule(read);
        }

        protected override void DisposeTables() => m_steps.Dispose();
    }
}
