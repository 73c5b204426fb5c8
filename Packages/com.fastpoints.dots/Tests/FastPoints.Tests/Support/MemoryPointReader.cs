using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Tests
{
    /// <summary>A reader of points that lie in memory, in blocks of any size. Owns its batch.</summary>
    public sealed class MemoryPointReader : PointReader
    {
        readonly int m_pointsPerBlock;

        public MemoryPointReader(PointBatch points, int pointsPerBlock, bool fixedStride = true,
            int pointsReadable = int.MaxValue)
        {
            Points = points;
            m_pointsPerBlock = pointsPerBlock;
            HasCheapRanges = fixedStride;
            PointsReadable = Math.Min(pointsReadable, points.Count);
            Info = new SourceInfo
            {
                Path = "memory",
                Format = "TEST",
                PointsClaimed = (ulong)points.Count,
                PointsReadable = points.Count,
                RecordBytes = points.Schema.BytesPerPoint,
                Schema = points.Schema,
            };
        }

        public int PointsReadable { get; }
        public PointBatch Points { get; }
        public override bool HasCheapRanges { get; }
        public override int BlockCount => (Points.Count + m_pointsPerBlock - 1) / m_pointsPerBlock;
        public override int MaxPointsPerBlock => Math.Min(m_pointsPerBlock, Math.Max(1, Points.Count));
        public override long FirstPointOfBlock(int block) => (long)block * m_pointsPerBlock;
        public override int PointsInBlock(int block) => Math.Min(m_pointsPerBlock, Points.Count - block * m_pointsPerBlock);
        public override long BytesOfRange(BlockRange range) => (long)range.Count * Info.RecordBytes;

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new MemoryBlockRead(this, wanted, capacity, allocator);

        public override void DisposeUnread() => Points.Dispose();
    }

    sealed class MemoryBlockRead : BlockRead
    {
        readonly MemoryPointReader m_reader;
        NativeArray<PointColumn> m_from, m_to;

        public MemoryBlockRead(MemoryPointReader reader, PointSchema wanted, int capacity, Allocator allocator)
        {
            m_reader = reader;
            Points = new PointBatch(wanted, capacity, allocator);
            Result = new NativeReference<DecodeResult>(allocator);
            m_from = new NativeArray<PointColumn>(wanted.Count, allocator);
            m_to = new NativeArray<PointColumn>(wanted.Count, allocator);
            for (int i = 0; i < wanted.Count; i++)
            {
                m_from[i] = reader.Points.Column(reader.Points.Schema.IndexOf(wanted[i].Name));
                m_to[i] = Points.Column(i);
            }
        }

        public override void Begin(BlockRange range)
        {
            if (range.Count > Points.Capacity)
                throw new ArgumentOutOfRangeException(nameof(range), range.Count, "more than the slot's " + Points.Capacity);
            Range = range;
            FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
            Decoded = new CopyPointsJob
            {
                From = m_reader.Points.Bytes,
                To = Points.Bytes,
                FromColumns = m_from,
                ToColumns = m_to,
                First = (int)FirstPoint,
                Count = (int)Math.Max(0, Math.Min(range.Count, m_reader.PointsReadable - FirstPoint)),
                Result = Result,
            }.Schedule();
        }

        public override bool TryEnableStates() => true;

        internal override DecoderState KeepState(DecoderState reused)
        {
            var state = (MemoryState)reused ?? new MemoryState();
            state.Point = FirstPoint + Points.Count;
            return state;
        }

        internal override void Begin(BlockRange range, DecoderState from)
        {
            // As a decoder would find it: the state is that of the point before, or there is none and the range starts its block.
            if (from == null ? range.First != 0
                : ((MemoryState)from).Point != m_reader.FirstPointOfBlock(range.Block) + range.First)
                throw new ArgumentException("not the state in front of the range", nameof(from));
            Begin(range);
        }

        public override void Complete()
        {
            Decoded.Complete();
            Points.Count = Result.Value.Points;
        }

        public override void Dispose()
        {
            if (!m_from.IsCreated)
                return;
            Decoded.Complete();
            Points.Dispose();
            Result.Dispose();
            m_from.Dispose();
            m_to.Dispose();
        }
    }

    sealed class MemoryState : DecoderState
    {
        public long Point;

        public override long Bytes => sizeof(long);

        public override void Dispose() { }
    }

    [BurstCompile]
    struct CopyPointsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> From;
        [ReadOnly] public NativeArray<PointColumn> FromColumns;
        [ReadOnly] public NativeArray<PointColumn> ToColumns;
        public NativeArray<byte> To;
        public int First;
        public int Count;
        public NativeReference<DecodeResult> Result;

        public unsafe void Execute()
        {
            for (int i = 0; i < ToColumns.Length; i++)
            {
                int size = ToColumns[i].Type.SizeOf();
                UnsafeUtility.MemCpy((byte*)To.GetUnsafePtr() + ToColumns[i].OffsetBytes,
                    (byte*)From.GetUnsafeReadOnlyPtr() + FromColumns[i].OffsetBytes + (long)First * size, (long)Count * size);
            }
            Result.Value = new DecodeResult { Points = Count };
        }
    }
}
