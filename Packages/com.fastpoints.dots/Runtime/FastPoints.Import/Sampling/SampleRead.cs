using FastPoints.Core;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>A slot for blocks of a sample that is in memory.</summary>
    sealed class SampleRead : BlockRead
    {
        readonly PointReader m_reader;
        readonly PointBatch m_sample;
        NativeArray<PointColumn> m_columns;

        /// <param name="sample">All points; a block has every n-th of them, where n is the number of blocks.</param>
        public SampleRead(PointReader reader, PointBatch sample, PointSchema wanted, int capacity, Allocator allocator)
        {
            m_reader = reader;
            m_sample = sample;
            Points = new PointBatch(wanted, capacity, allocator);
            Result = new NativeReference<DecodeResult>(allocator);
            m_columns = new NativeArray<PointColumn>(2 * wanted.Count, allocator);
            for (int c = 0; c < wanted.Count; c++)
            {
                m_columns[2 * c] = sample.Column(sample.Schema.IndexOf(wanted[c].Name));
                m_columns[2 * c + 1] = Points.Column(c);
            }
        }

        public override void Begin(BlockRange range)
        {
            Range = range;
            FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
            Decoded = new CopyStrideJob
            {
                From = m_sample.Bytes,
                Columns = m_columns,
                To = Points.Bytes,
                Result = Result,
                First = range.Block + range.First * m_reader.BlockCount,
                Step = m_reader.BlockCount,
                Count = range.Count,
            }.Schedule();
        }

        public override void Complete()
        {
            Decoded.Complete();
            Points.Count = Result.Value.Points;
        }

        public override void Dispose()
        {
            if (!m_columns.IsCreated)
                return;
            Decoded.Complete();
            m_columns.Dispose();
            Points.Dispose();
            Result.Dispose();
        }
    }

    /// <summary>Copies every n-th point of a batch to the beginning of another.</summary>
    [BurstCompile]
    internal unsafe struct CopyStrideJob : IJob
    {
        [ReadOnly] public NativeArray<byte> From;

        /// <summary>Two numbers for each column: where it is, and where it goes.</summary>
        [ReadOnly] public NativeArray<PointColumn> Columns;
        public NativeArray<byte> To;
        public NativeReference<DecodeResult> Result;
        public int First;
        public int Step;
        public int Count;

        public void Execute()
        {
            for (int c = 0; c < Columns.Length; c += 2)
            {
                int size = Columns[c].Type.SizeOf();
                byte* from = (byte*)From.GetUnsafeReadOnlyPtr() + Columns[c].OffsetBytes + (long)First * size;
                byte* to = (byte*)To.GetUnsafePtr() + Columns[c + 1].OffsetBytes;
                for (int i = 0; i < Count; i++, from += (long)Step * size, to += size)
                    UnsafeUtility.MemCpy(to, from, size);
            }
            Result.Value = new DecodeResult { Points = Count };
        }
    }
}
