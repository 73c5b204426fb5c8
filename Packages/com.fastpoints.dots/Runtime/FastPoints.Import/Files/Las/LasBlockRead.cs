using System;
using System.Globalization;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>One range of records: read as it lies in the file, then decoded by one job.</summary>
    sealed unsafe class LasBlockRead : BlockRead
    {
        readonly LasReader m_reader;
        readonly int m_capacity;
        NativeArray<byte> m_records;
        NativeArray<LasFieldCopy> m_copies;
        // The read manager keeps the pointer to its command until the read has ended.
        NativeArray<ReadCommand> m_command;
        NativeReference<DecodeResult> m_result;
        ReadHandle m_read;
        bool m_isReading;

        public LasBlockRead(LasReader reader, PointSchema wanted, int capacity, Allocator allocator)
        {
            m_reader = reader;
            m_capacity = capacity;
            long bytes = (long)capacity * reader.Info.RecordBytes;
            if (capacity < 0 || bytes > int.MaxValue)
                throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "a slot holds at most 2 GiB of records");
            var batch = new PointBatch(wanted, capacity, allocator);
            try
            {
                var copies = LasCopyPlan.Make(reader.Layout, batch);
                m_copies = new NativeArray<LasFieldCopy>(copies, allocator);
            }
            catch (ArgumentException)
            {
                batch.Dispose();
                throw;
            }
            Points = batch;
            m_records = new NativeArray<byte>((int)Math.Max(1, bytes), allocator, NativeArrayOptions.UninitializedMemory);
            m_command = new NativeArray<ReadCommand>(1, allocator);
            m_result = new NativeReference<DecodeResult>(allocator);
            Result = m_result;
        }

        public override void Begin(BlockRange range)
        {
            if (m_isReading)
                throw new InvalidOperationException("the slot is still reading; Complete it first");
            if (range.First < 0 || range.Count < 0 || range.Count > m_capacity
                || range.Count > m_reader.PointsInBlock(range.Block) - range.First)
                throw new ArgumentOutOfRangeException(nameof(range), range.Count, "the range leaves its block or the slot");
            Range = range;
            FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
            if (range.Count == 0)
            {
                m_result.Value = default;
                Decoded = default;
                return;
            }
            m_command[0] = new ReadCommand
            {
                Buffer = m_records.GetUnsafePtr(),
                Offset = m_reader.OffsetOfPoint(FirstPoint),
                Size = (long)range.Count * m_reader.Info.RecordBytes,
            };
            m_read = AsyncReadManager.Read(m_reader.File, new ReadCommandArray
            {
                CommandCount = 1,
                ReadCommands = (ReadCommand*)m_command.GetUnsafePtr(),
            });
            m_isReading = true;
            Decoded = new DecodeLasJob
            {
                Records = m_records,
                Copies = m_copies,
                Columns = Points.Bytes,
                Result = m_result,
                RecordBytes = m_reader.Info.RecordBytes,
                Count = range.Count,
            }.Schedule(m_read.JobHandle);
        }

        public override void Complete()
        {
            Decoded.Complete();
            if (m_isReading)
                CloseRead();
            Points.Count = m_result.Value.Points;
        }

        public override void Dispose()
        {
            if (!m_result.IsCreated)
                return;
            if (m_isReading)
            {
                m_read.Cancel();
                Decoded.Complete();
                m_read.JobHandle.Complete();
                m_read.Dispose();
                m_isReading = false;
            }
            Points.Dispose();
            m_records.Dispose();
            m_copies.Dispose();
            m_command.Dispose();
            m_result.Dispose();
        }

        /// <summary>The header's claims were held against the file's size when it was opened, so a short read means that the
        /// file has changed since: an error, and not a cloud with fewer points.</summary>
        void CloseRead()
        {
            m_isReading = false;
            var status = m_read.Status;
            long got = status == ReadStatus.Complete ? 0 : m_read.GetBytesRead();
            m_read.Dispose();
            if (status == ReadStatus.Complete)
                return;
            m_result.Value = default;
            Points.Count = 0;
            long offset = m_reader.OffsetOfPoint(FirstPoint);
            int recordBytes = m_reader.Info.RecordBytes;
            string wanted = Range.Count.ToString(CultureInfo.InvariantCulture) + " points of "
                + recordBytes.ToString(CultureInfo.InvariantCulture) + " bytes";
            string came = (got / recordBytes).ToString(CultureInfo.InvariantCulture);
            throw PointCloudException.Wanted(status == ReadStatus.Truncated ? FailureCode.Truncated : FailureCode.ReadFailed,
                m_reader.Info.Path, offset, status == ReadStatus.Truncated ? "the file became shorter" : "the read failed",
                wanted, came);
        }
    }

    /// <summary>Records that a read has brought into memory, to the columns of a batch. See <see cref="LasRecords"/>.</summary>
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
