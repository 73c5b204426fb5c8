using System;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Reads one range of records as it lies in the file, then decodes it in one job.</summary>
    sealed class LasBlockRead : SlotRead
    {
        readonly LasReader m_reader;
        readonly NativeFileRead m_file;
        NativeArray<LasFieldCopy> m_copies;

        public LasBlockRead(LasReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, CheckCapacity(reader, capacity), allocator)
        {
            m_reader = reader;
            m_copies = new NativeArray<LasFieldCopy>(LasCopyPlan.Make(reader.Layout, Points), allocator);
            m_file = new NativeFileRead(reader.Info.Path, default, (long)capacity * reader.Info.RecordBytes, allocator);
        }

        static int CheckCapacity(LasReader reader, int capacity) =>
            capacity >= 0 && (long)capacity * reader.Info.RecordBytes <= int.MaxValue - NativeFileRead.PaddingBytes
                ? capacity
                : throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "a slot holds at most 2 GiB of records");

        protected override JobHandle Schedule(BlockRange range)
        {
            int recordBytes = m_reader.Info.RecordBytes;
            var read = m_file.Begin(m_reader.File, m_reader.OffsetOfPoint(FirstPoint), range.Count * recordBytes);
            return new DecodeLasJob
            {
                Records = m_file.Buffer,
                Copies = m_copies,
                Columns = Points.Bytes,
                Result = Result,
                RecordBytes = recordBytes,
                Count = range.Count,
            }.Schedule(read);
        }

        protected override void Cancel() => m_file.Cancel();

        protected override void DisposeMemory()
        {
            m_file.Dispose();
            m_copies.Dispose();
        }

        /// <summary>Closes the read. The header's claims were checked against the file's size at opening, so a short read means
        /// that the file has changed since: an error, not a cloud with fewer points.</summary>
        protected override void EndRead()
        {
            var status = m_file.Close(out long got);
            if (status == ReadStatus.Complete)
                return;
            var result = Result;
            result.Value = default;
            long offset = m_reader.OffsetOfPoint(FirstPoint);
            int recordBytes = m_reader.Info.RecordBytes;
            string wanted = NumberText.Of(Range.Count) + " points of "
                + NumberText.Of(recordBytes) + " bytes";
            string came = NumberText.Of(got / recordBytes);
            throw PointCloudException.Wanted(status == ReadStatus.Truncated ? FailureCode.Truncated : FailureCode.ReadFailed,
                m_reader.Info.Path, offset, status == ReadStatus.Truncated ? "the file became shorter" : "the read failed",
                wanted, came);
        }
    }

    /// <summary>Decodes records that a read has brought into memory into the columns of a batch. See
    /// <see cref="LasRecords"/>.</summary>
    [BurstCompile]
    internal struct DecodeLasJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<LasFieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public int RecordBytes;
        public int Count;

        public unsafe void Execute()
        {
            LasRecords.ToColumns((byte*)Records.GetUnsafeReadOnlyPtr(), RecordBytes, Count,
                (LasFieldCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, (byte*)Columns.GetUnsafePtr());
            Result.Value = new DecodeResult { Points = Count };
        }
    }
}
