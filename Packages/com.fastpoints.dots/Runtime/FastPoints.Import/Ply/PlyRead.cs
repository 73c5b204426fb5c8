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
        readonly NativeArray<PlyStep> m_steps;
        readonly NativeReference<PlyAnomalies> m_anomalies;

        public PlyRead(PointReader reader, PlyFile ply, SegmentBlocks blocks, PointSchema wanted, int capacity,
            Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_reader = reader;
            m_ply = ply;
            m_blocks = blocks;
            long bytes = (long)blocks.MaxBytes + (ply.Header.IsAscii ? MaxLineBytes : 0);
            OwnFile(Math.Min(bytes, ply.Info.FileBytes), allocator);
            m_steps = Own(new NativeArray<PlyStep>(PlyPlan.Decoding(ply.Vertex, ply.Names, Points).ToArray(), allocator));
            m_anomalies = Own(new NativeReference<PlyAnomalies>(allocator));
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var block = m_blocks[range.Block];
            if (m_ply.Header.IsAscii)
                return ScheduleLines(AsciiRange.Of(block, range, m_ply.Info.FileBytes, MaxLineBytes));
            var read = DependencyOf(File.Begin(m_ply.Handle, block.OffsetBytes, block.Bytes));
            return new DecodePlyListsJob
            {
                Input = File.Buffer,
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
            Input = File.Buffer,
            Range = lines,
            Steps = m_steps,
            Output = Points.Bytes,
            Result = Result,
            Anomalies = m_anomalies,
        }.Schedule(DependencyOf(File.Begin(m_ply.Handle, lines.Offset, lines.Bytes)));

        protected override void Warn(DecodeResult result)
        {
            m_ply.WarnAnomalies(m_anomalies.Value);
            if (result.Error != PlyError.None)
                m_ply.WarnBroken(Range, result, m_reader.BlocksAreKnown);
        }
    }
}
