using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>A slot of <see cref="XyzReader"/>.</summary>
    sealed class XyzRead : BlockRead
    {
        readonly XyzReader m_reader;
        readonly NativeFileRead m_file;
        NativeArray<XyzStep> m_steps;
        NativeReference<DecodeResult> m_result;
        NativeReference<XyzAnomalies> m_anomalies;
        bool m_isBusy;
        bool m_isDisposed;

        public XyzRead(XyzReader reader, PointSchema wanted, int capacity, Allocator allocator)
        {
            foreach (var attribute in wanted)
            {
                int index = reader.Info.Schema.IndexOf(attribute.Name);
                if (index < 0 || reader.Info.Schema[index].Type != attribute.Type)
                    throw new ArgumentException("the file has no attribute " + attribute, nameof(wanted));
            }
            m_reader = reader;
            Points = new PointBatch(wanted, capacity, allocator);
            m_file = new NativeFileRead(reader.Info.Path, reader.File,
                Math.Min(XyzReader.MaxBlockBytes + XyzReader.MaxLineBytes, reader.Info.FileBytes), allocator);
            m_steps = new NativeArray<XyzStep>(reader.StepsFor(Points), allocator);
            m_result = new NativeReference<DecodeResult>(allocator);
            m_anomalies = new NativeReference<XyzAnomalies>(allocator);
            Result = m_result;
        }

        public override void Begin(BlockRange range)
        {
            if (m_isBusy)
                throw new InvalidOperationException("the slot has a range in flight");
            if (range.Block < 0 || range.Block >= m_reader.BlockCount)
                throw new ArgumentOutOfRangeException(nameof(range), range.Block, "no such block");
            int rows = m_reader.PointsInBlock(range.Block);
            if (range.First < 0 || range.Count < 0 || range.First > rows - range.Count || range.Count > Points.Capacity)
                throw new ArgumentOutOfRangeException(nameof(range), "wanted points " + range.First + " + " + range.Count +
                    " of " + rows + ", capacity " + Points.Capacity);
            var block = m_reader.Block(range.Block);
            long left = m_reader.Info.FileBytes - block.OffsetBytes;
            int bytes = range.Count == 0 ? 0 : (int)Math.Min((long)block.Bytes + XyzReader.MaxLineBytes, left);
            Range = range;
            FirstPoint = block.FirstPoint + range.First;
            Points.Count = 0;
            var read = m_file.Begin(block.OffsetBytes, bytes);
            Decoded = new DecodeXyzJob
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
                Result = m_result,
                Anomalies = m_anomalies,
            }.Schedule(read);
            m_isBusy = true;
        }

        public override void Complete()
        {
            if (!m_isBusy)
                throw new InvalidOperationException("the slot has no range in flight");
            m_isBusy = false;
            Decoded.Complete();
            m_file.End();
            Points.Count = m_result.Value.Points;
            m_reader.Warn(Range, m_anomalies.Value);
        }

        public override void Dispose()
        {
            if (m_isDisposed)
                return;
            m_isDisposed = true;
            m_isBusy = false;
            Decoded.Complete();
            m_file.Dispose();
            Points.Dispose();
            m_steps.Dispose();
            m_result.Dispose();
            m_anomalies.Dispose();
        }
    }
}
