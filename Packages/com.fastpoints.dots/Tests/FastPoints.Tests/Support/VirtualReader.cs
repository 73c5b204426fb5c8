using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests
{
    public sealed class VirtualReader : PointReader
    {
        readonly long m_points;

        public VirtualReader(long points, int blockPoints = 1 << 20, bool fixedStride = true)
        {
            m_points = points;
            MaxPointsPerBlock = blockPoints;
            HasCheapRanges = fixedStride;
            Info = new SourceInfo
            {
                Path = "virtual",
                Format = "virtual",
                PointsClaimed = (ulong)points,
                PointsReadable = points,
                RecordBytes = 12,
                Transform = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01) },
                Schema = new PointSchema(PositionColumns.Attributes(AttributeType.Int32)),
            };
        }

        public override int BlockCount => (int)(m_points / MaxPointsPerBlock);
        public override int MaxPointsPerBlock { get; }
        public override bool HasCheapRanges { get; }
        public override long FirstPointOfBlock(int block) => (long)block * MaxPointsPerBlock;
        public override int PointsInBlock(int block) => MaxPointsPerBlock;
        public override long BytesOfRange(BlockRange range) => 12L * range.Count;

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new VirtualRead(this, wanted, capacity, allocator);
    }

    /// <summary>A read that completes at once.</summary>
    abstract class ImmediateRead : BlockRead
    {
        readonly PointReader m_reader;
        NativeReference<DecodeResult> m_result;

        protected ImmediateRead(PointReader reader, PointSchema wanted, int capacity, Allocator allocator)
        {
            m_reader = reader;
            Points = new PointBatch(wanted, capacity, allocator);
            Result = m_result = new NativeReference<DecodeResult>(allocator);
        }

        protected abstract void Fill(BlockRange range, NativeArray<byte> bytes);

        public override void Begin(BlockRange range)
        {
            Range = range;
            FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
            Fill(range, Points.Bytes);
            m_result.Value = new DecodeResult { Points = range.Count };
            Decoded = default;
        }

        public override void Complete() => Points.Count = m_result.Value.Points;

        public override void Dispose()
        {
            if (!m_result.IsCreated)
                return;
            Points.Dispose();
            m_result.Dispose();
        }
    }

    sealed class VirtualRead : ImmediateRead
    {
        public VirtualRead(PointReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator) { }

        protected override void Fill(BlockRange range, NativeArray<byte> bytes)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                var column = bytes.GetSubArray(Points.Column(axis).OffsetBytes, 4 * range.Count).Reinterpret<int>(1);
                for (int i = 0; i < range.Count; i++)
                {
                    long point = FirstPoint + i;
                    column[i] = axis == 0 ? (int)(point % 150000) : axis == 1 ? (int)(point / 150000) : 7;
                }
            }
        }
    }
}
