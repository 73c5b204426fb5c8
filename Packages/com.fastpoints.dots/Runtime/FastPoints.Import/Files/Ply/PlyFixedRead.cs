using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>A slot of <see cref="PlyFixedReader"/>.</summary>
    sealed class PlyFixedRead : PlyRead
    {
        readonly PlyFixedReader m_reader;
        NativeArray<PlyCopy> m_copies;

        public PlyFixedRead(PlyFixedReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, (long)capacity * reader.RecordBytes, allocator)
        {
            m_reader = reader;
            m_copies = ToNative(PlyCopy.From(reader.Steps(Points)), allocator);
        }

        protected override JobHandle Schedule(BlockRange range)
        {
            var read = File.Begin(m_reader.OffsetOfPoint(FirstPoint), range.Count * m_reader.RecordBytes);
            return new DecodePlyFixedJob
            {
                Input = File.Buffer,
                Copies = m_copies,
                RecordBytes = m_reader.RecordBytes,
                Points = range.Count,
                IsBigEndian = m_reader.IsBigEndian,
                Output = Points.Bytes,
                Result = Result,
            }.Schedule(read);
        }

        protected override void DisposeTables() => m_copies.Dispose();
    }

    /// <summary>Decodes records of one length into columns. See <see cref="PlyRecords"/>.</summary>
    [BurstCompile]
    unsafe struct DecodePlyFixedJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input;
        [ReadOnly] public NativeArray<PlyCopy> Copies;
        public int RecordBytes;
        public int Points;
        public bool IsBigEndian;
        [WriteOnly] public NativeArray<byte> Output;
        [WriteOnly] public NativeReference<DecodeResult> Result;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* output = (byte*)Output.GetUnsafePtr();
            PlyRecords.ToColumns(input, RecordBytes, Points, (PlyCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, IsBigEndian,
                output);
            Result.Value = new DecodeResult { Points = Points };
        }
    }
}
