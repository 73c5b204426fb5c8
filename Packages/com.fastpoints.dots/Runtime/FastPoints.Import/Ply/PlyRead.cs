using System;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Ply
{
    // Vertices without a fixed length: lines, or records with lists.
    sealed class PlyRead : SlotRead
    {
        // The last line may extend this many bytes behind its block.
        const int MaxLineBytes = 64 << 10;

        readonly PointReader m_reader;
        readonly PlyFile m_ply;
        readonly SegmentBlocks m_blocks;
        readonly NativeFileRead m_file;
        NativeArray<PlyStep> m_steps;
        NativeReference<PlyAnomalies> m_anomalies;

        public PlyRead(PointReader reader, PlyFile ply, SegmentBlocks blocks, PointSchema wanted, int capacity,
            Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            m_ply = ply;
            m_blocks = blocks;
            long bytes = (long)blocks.MaxBytes + (ply.Header.IsAscii ? MaxLineBytes : 0);
            m_file = new NativeFileRead(Math.Min(bytes, ply.Info.FileBytes), allocator);
            m_steps = new NativeArray<PlyStep>(PlyPlan.Decoding(ply.Vertex, ply.Names, Points).ToArray(), allocator);
            m_anomalies = new NativeReference<PlyAnomalies>(allocator);
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var block = m_blocks[range.Block];
            if (m_ply.Header.IsAscii)
                return ScheduleLines(AsciiRange.Of(block, range, m_ply.Info.FileBytes, MaxLineBytes));
            var read = DependencyOf(m_file.Begin(m_ply.Handle, block.OffsetBytes, block.Bytes));
            return new DecodePlyListsJob
            {
                Input = m_file.Buffer,
                InputOffset = block.OffsetBytes,
                InputBytes = block.Bytes,
                Steps = m_steps,
                FirstPoint = range.First,
                Points = range.Count,
                IsBigEndian = m_ply.IsBigEndian,
                Output = Points.Bytes,
                Result = Result,
            }.Schedule(read);
        }

        JobHandle ScheduleLines(AsciiRange lines) => new DecodePlyAsciiJob
        {
            Input = m_file.Buffer,
            Range = lines,
            Steps = m_steps,
            Output = Points.Bytes,
            Result = Result,
            Anomalies = m_anomalies,
        }.Schedule(DependencyOf(m_file.Begin(m_ply.Handle, lines.Offset, lines.Bytes)));

        protected override void EndRead() => m_file.End();

        protected override void Warn(DecodeResult result)
        {
            m_ply.WarnAnomalies(m_anomalies.Value);
            if (result.Error != PlyError.None)
                m_ply.WarnBroken(Range, result, m_reader.BlocksAreKnown);
        }

        protected override void DisposeMemory()
        {
            m_file.Dispose();
            m_steps.Dispose();
            m_anomalies.Dispose();
        }
    }
}
