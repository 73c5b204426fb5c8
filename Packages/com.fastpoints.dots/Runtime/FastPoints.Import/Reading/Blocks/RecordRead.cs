using System;
using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Reading
{
    sealed class RecordRead : SlotRead
    {
        readonly FixedRecords m_records;
        readonly NativeArray<FieldCopy> m_copies;

        public RecordRead(PointReader reader, FixedRecords records, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, CheckCapacity(records, capacity), allocator)
        {
            m_records = records;
            m_copies = Own(records.CopiesTo(Points, allocator));
            OwnFile((long)capacity * records.RecordBytes, allocator);
        }

        static int CheckCapacity(FixedRecords records, int capacity) =>
            capacity >= 0 && (long)capacity * records.RecordBytes <= int.MaxValue - NativeFileRead.PaddingBytes
                ? capacity
                : throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "a slot holds at most 2 GiB of records");

        protected override JobHandle Schedule(BlockRange range) => new DecodeRecordsJob
        {
            Records = File.Buffer,
            Copies = m_copies,
            Columns = Points.Bytes,
            Result = Result,
            RecordBytes = m_records.RecordBytes,
            Count = range.Count,
        }.Schedule(DependencyOf(File.Begin(m_records.File, m_records.OffsetOf(FirstPoint),
            range.Count * m_records.RecordBytes)));

        protected override void Cancel() => File.Cancel();

        // The header's claims were checked against the file's size at opening: a short read means that the file has changed
        // since, an error, not a cloud with fewer points.
        protected override void EndRead()
        {
            var status = File.Close(out long got);
            if (status == ReadStatus.Complete)
                return;
            var result = Result;
            result.Value = default;
            bool isShort = status == ReadStatus.Truncated;
            throw PointCloudException.Wanted(isShort ? FailureCode.Truncated : FailureCode.ReadFailed, m_records.File.Path,
                File.Offset, isShort ? "the file became shorter" : "the read failed", NumberText.Of(Range.Count) +
                " points of " + NumberText.Of(m_records.RecordBytes) + " bytes", NumberText.Of(got / m_records.RecordBytes));
        }
    }

    [BurstCompile]
    internal struct DecodeRecordsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public int RecordBytes;
        public int Count;

        public unsafe void Execute()
        {
            PointRecords.ToColumns((byte*)Records.GetUnsafeReadOnlyPtr(), RecordBytes, Count,
                (FieldCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, (byte*)Columns.GetUnsafePtr());
            Result.Value = new DecodeResult { Points = Count };
        }
    }
}
