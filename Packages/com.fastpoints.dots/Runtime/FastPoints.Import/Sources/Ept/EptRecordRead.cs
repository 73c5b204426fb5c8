using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Sources
{
    [BurstCompile]
    unsafe struct DecodeEptJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeReference<DecompressState> State; // State of decompression; if broken, there are no records.

        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public int RecordBytes;
        public int FirstRecord;
        public int First;
        public int Count;

        public void Execute()
        {
            var result = First == 0 ? default : Result.Value;
            if (State.Value.IsBroken)
            {
                if (result.Error == 0)
                {
                    result.Error = EptError.Broken;
                    result.ErrorOffset = State.Value.Consumed;
                }
            }
            else
            {
                byte* records = (byte*)Records.GetUnsafeReadOnlyPtr() + (long)FirstRecord * RecordBytes;
                PointRecords.ToColumns(records, RecordBytes, Count, Copies, (byte*)Columns.GetUnsafePtr(), First);
                result.Points = First + Count;
            }
            Result.Value = result;
        }
    }

    static class EptError
    {
        public const int Broken = 1;
    }

    // Nodes of records, plain or in a zstandard frame, which is decompressed piece by piece, as far as the range goes.
    sealed class EptRecordRead : NodeRead
    {
        const int PointsPerSlice = 1 << 16; // About a millisecond of copying.
        const int BufferBytes = 256 << 10; // Less than a millisecond of decompression.

        readonly DecompressorHandle m_decompressor;
        readonly int m_recordBytes;
        readonly int m_bufferPoints;
        readonly NativeArray<FieldCopy> m_copies;
        readonly NativeArray<byte> m_buffer;
        readonly NativeReference<DecompressState> m_state;

        public EptRecordRead(EptReader reader, Func<StreamDecompressor> decompressor, PointSchema wanted, int capacity,
            Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_recordBytes = reader.Index.RecordBytes;
            m_bufferPoints = Math.Max(1, BufferBytes / m_recordBytes);
            try
            {
                m_copies = Own(new NativeArray<FieldCopy>(FieldCopyPlan.Make(reader.Index.Fields, Points), allocator));
                if (decompressor != null)
                    m_decompressor = Own(new DecompressorHandle(decompressor()));
            }
            catch
            {
                Dispose();
                throw;
            }
            m_state = Own(new NativeReference<DecompressState>(allocator));
            if (decompressor != null)
                m_buffer = OwnArray<byte>(m_bufferPoints * m_recordBytes, allocator);
        }

        protected override JobHandle Schedule(BlockRange range, in NodeBlock block)
        {
            if (m_decompressor != null)
                return Decompress(range, block);
            var decoded = BeginRead(range);
            for (int first = 0; first < range.Count; first += PointsPerSlice)
                decoded = Decode(File.Buffer, first, first, Math.Min(PointsPerSlice, range.Count - first)).Schedule(decoded);
            return decoded;
        }

        JobHandle Decompress(BlockRange range, in NodeBlock block)
        {
            long begin = block.FirstInNode + range.First, end = begin + range.Count;
            var decoded = BeginRead(range);
            for (long first = 0; first < end; first += m_bufferPoints)
            {
                int count = (int)Math.Min(m_bufferPoints, end - first);
                decoded = new DecompressJob
                {
                    Input = File.Buffer,
                    InputBytes = BytesRead,
                    Output = m_buffer,
                    Wanted = count * m_recordBytes,
                    IsFirst = first == 0,
                    Handle = m_decompressor.Handle,
                    State = m_state,
                }.Schedule(decoded);
                long from = Math.Max(first, begin);
                if (from < first + count)
                    decoded = Decode(m_buffer, (int)(from - first), (int)(from - begin), (int)(first + count - from))
                        .Schedule(decoded);
            }
            return decoded;
        }

        DecodeEptJob Decode(NativeArray<byte> records, int firstRecord, int first, int count) => new DecodeEptJob
        {
            Records = records,
            State = m_state,
            Copies = m_copies,
            Columns = Points.Bytes,
            Result = Result,
            RecordBytes = m_recordBytes,
            FirstRecord = firstRecord,
            First = first,
            Count = count,
        };

        protected override void Report(DecodeResult result)
        {
            if (m_decompressor == null)
                return;
            var failure = m_decompressor.Failure;
            m_decompressor.Failure = null;
            if (result.Error != 0)
                Reader.WarnBroken(Range.Block, "its zstandard stream is broken: points are left out",
                    "wanted " + Range.Count + " points, got " + result.Points
                        + (failure != null ? " (" + failure.Message + ")" : ""),
                    result.ErrorOffset);
        }
    }
}
