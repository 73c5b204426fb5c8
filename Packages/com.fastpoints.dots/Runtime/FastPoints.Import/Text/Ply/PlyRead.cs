using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Text
{
    [BurstCompile]
    unsafe struct DecodePlyListsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input;
        public long InputOffset;
        public int InputBytes;
        [ReadOnly] public NativeArray<PlyStep> Steps;
        public int FirstPoint;
        public int Points;
        public bool IsBigEndian;
        [WriteOnly] public NativeArray<byte> Output;
        [WriteOnly] public NativeReference<DecodeResult> Result;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* output = (byte*)Output.GetUnsafePtr();
            var result = default(DecodeResult);
            long position = 0;
            for (int i = -FirstPoint; i < Points; i++)
            {
                long start = position;
                int error = Pass(input, output, i, ref position);
                if (error != PlyError.None)
                {
                    result.Error = error;
                    result.ErrorOffset = InputOffset + start;
                    break;
                }
                if (i >= 0)
                    result.Points = i + 1;
            }
            Result.Value = result;
        }

        int Pass(byte* input, byte* output, int point, ref long position)
        {
            for (int i = 0; i < Steps.Length; i++)
            {
                var step = Steps[i];
                if (step.Bytes > InputBytes - position)
                    return PlyError.Truncated;
                byte* p = input + position;
                position += step.Bytes;
                if (step.Kind == PlyStepKind.List)
                {
                    ulong count = PlyBytes.Load(p, step.Bytes, IsBigEndian);
                    if (PlyBytes.IsNegative(count, step.Type))
                        return PlyError.BadListLength;
                    if (count > (ulong)((InputBytes - position) / step.ItemBytes))
                        return PlyError.Truncated;
                    position += (long)count * step.ItemBytes;
                }
                else if (step.Kind == PlyStepKind.Value && point >= 0)
                    Store(p, output + step.ColumnOffsetBytes, point, step.Bytes);
            }
            return PlyError.None;
        }

        void Store(byte* p, byte* column, int point, int bytes)
        {
            switch (bytes)
            {
                case 1:
                    column[point] = *p;
                    break;
                case 2:
                    ((ushort*)column)[point] = (ushort)PlyBytes.Load(p, 2, IsBigEndian);
                    break;
                case 4:
                    ((uint*)column)[point] = IsBigEndian ? PointRecords.ReverseBytes(*(uint*)p) : *(uint*)p;
                    break;
                default:
                    ((ulong*)column)[point] = IsBigEndian ? PointRecords.ReverseBytes(*(ulong*)p) : *(ulong*)p;
                    break;
            }
        }
    }

    sealed class PlyRead : OwningBlockRead
    {
        public const int MaxLineBytes = 64 << 10; // The last line may extend this many bytes behind its block.

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
            var read = DependencyOf(FileRead.Begin(m_ply.Handle, block.OffsetBytes, block.Bytes));
            return new DecodePlyListsJob
            {
                Input = FileRead.Buffer,
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
            Input = FileRead.Buffer,
            Range = lines,
            Steps = m_steps,
            Output = Points.Bytes,
            Result = Result,
            Anomalies = m_anomalies,
        }.Schedule(DependencyOf(FileRead.Begin(m_ply.Handle, lines.Offset, lines.Bytes)));

        protected override void Warn(DecodeResult result)
        {
            m_ply.WarnAnomalies(m_anomalies.Value);
            if (result.Error != PlyError.None)
                m_ply.WarnBroken(Range, result, m_reader.BlocksAreKnown);
        }
    }
}
