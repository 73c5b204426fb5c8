using System;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Profiling.LowLevel.Unsafe;

namespace FastPoints.Reading
{
    // Reads many short ranges, scattered over a file of fixed stride, into entries of a batch with one request, as samples need;
    // a block read for each would cost several times as much. Slots that write to different entries may be in flight together.
    internal sealed unsafe class StridedRead : IDisposable
    {
        readonly FixedRecords m_records;
        readonly NativeFileRead m_file;
        readonly PointBatch m_target;
        NativeArray<BufferedRange> m_ranges;
        NativeArray<FieldCopy> m_copies;
        NativeReference<long> m_ended;

        // maxBytes: of one request, at least those of the longest range.
        public StridedRead(FixedRecords records, PointBatch target, int maxRanges, int maxBytes, Allocator allocator)
        {
            m_records = records;
            m_target = target;
            m_copies = records.CopiesTo(target, allocator);
            m_file = new NativeFileRead(maxBytes, allocator, maxRanges);
            m_ranges = new NativeArray<BufferedRange>(maxRanges, allocator, NativeArrayOptions.UninitializedMemory);
            m_ended = new NativeReference<long>(allocator);
        }

        public JobHandle Decoded { get; private set; }

        public RemoteFetch Fetched { set => m_file.Fetched = value; }

        public int Segments { get; private set; }
        public long BytesRead { get; private set; }

        internal long Begun { get; private set; } // In the time of ReadClock; Ended when the bytes had arrived.

        internal long Ended => m_ended.Value;

        public static long BytesOf(in StridedRange range, int recordBytes) => (range.Last - range.First + 1) * recordBytes;

        // Starts as many of the ranges as fit, up to max, and says how many; main thread only. The ranges lie in the file's order
        // without overlaps. Those no farther apart than gapBytes are read in one segment: more for a file that is slow to seek.
        public int Begin(NativeArray<StridedRange> ranges, int first, int max, int gapBytes)
        {
            if (m_file.IsReading)
                throw new InvalidOperationException(SlotRing.InFlight);
            max = Math.Min(Math.Min(max, ranges.Length - first), m_ranges.Length);
            int capacity = m_file.Buffer.Length - NativeFileRead.PaddingBytes;
            byte* buffer = (byte*)m_file.Buffer.GetUnsafePtr();
            var commands = m_file.Commands;
            int taken = 0, used = 0, segments = 0;
            long segmentEnd = -1;
            for (; taken < max; taken++)
            {
                var range = ranges[first + taken];
                long begin = m_records.OffsetOf(range.First);
                long end = begin + BytesOf(range, m_records.RecordBytes);
                bool joins = segments > 0 && begin - segmentEnd <= gapBytes;
                long added = joins ? end - segmentEnd : end - begin;
                if (used + added > capacity)
                    break;
                if (!joins)
                    commands[segments++] = new ReadCommand { Buffer = buffer + used, Offset = begin };
                used += (int)added;
                segmentEnd = end;
                var command = commands[segments - 1];
                command.Size = end - command.Offset;
                commands[segments - 1] = command;
                m_ranges[taken] = new BufferedRange
                {
                    FirstByte = (int)((byte*)command.Buffer - buffer + (begin - command.Offset)),
                    StrideBytes = range.Step * m_records.RecordBytes,
                    Count = range.Count,
                    FirstInSample = range.FirstInSample,
                };
            }
            if (taken == 0)
                throw new ArgumentException("a run does not fit into the slot's " + capacity + " bytes", nameof(ranges));
            Segments = segments;
            BytesRead = used;
            Begun = ReadClock.Now;
            var read = m_file.Begin(m_records.File, segments);
            var stamped = new TimestampJob { At = m_ended }.Schedule(read);
            var decoded = new DecodeRangesJob
            {
                Records = m_file.Buffer,
                Ranges = m_ranges,
                Copies = m_copies,
                RangeCount = taken,
                RecordBytes = m_records.RecordBytes,
                Columns = m_target.Bytes,
            }.Schedule(read);
            Decoded = JobHandle.CombineDependencies(stamped, decoded);
            return taken;
        }

        public void Complete()
        {
            Decoded.Complete();
            var status = m_file.Close(out _);
            if (status == ReadStatus.Complete)
                return;
            bool isShort = status == ReadStatus.Truncated;
            throw new PointCloudException(isShort ? FailureCode.Truncated : FailureCode.ReadFailed, m_records.File.Path,
                m_file.Offset, isShort ? "the file became shorter while it was read"
                : "reading " + NumberText.Of(BytesRead) + " bytes from here on failed");
        }

        public void Dispose()
        {
            if (!m_ranges.IsCreated)
                return;
            m_file.Cancel();
            Decoded.Complete();
            m_file.Dispose();
            m_ranges.Dispose();
            m_copies.Dispose();
            m_ended.Dispose();
        }
    }

    [BurstCompile]
    struct DecodeRangesJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<BufferedRange> Ranges;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public int RangeCount;
        public int RecordBytes;

        // Other slots write to other parts of it at the same time.
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Columns;

        public unsafe void Execute()
        {
            byte* records = (byte*)Records.GetUnsafeReadOnlyPtr();
            byte* columns = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Columns);
            for (int i = 0; i < RangeCount; i++)
            {
                var range = Ranges[i];
                if (range.FirstByte + (range.Count - 1L) * range.StrideBytes + RecordBytes > Records.Length)
                    return;
                PointRecords.ToColumns(records + range.FirstByte, range.StrideBytes, range.Count, Copies, columns,
                    range.FirstInSample);
            }
        }
    }

    // First, First + Step, ... of a source, one after the other in a batch from FirstEntry on.
    internal struct StridedRange
    {
        public long First;
        public int Step;
        public int Count;
        public int FirstInSample;

        public long Last => First + (Count - 1L) * Step;
    }

    struct BufferedRange
    {
        public int FirstByte;
        public int StrideBytes;
        public int Count;
        public int FirstInSample;
    }

    [BurstCompile]
    struct TimestampJob : IJob
    {
        public NativeReference<long> At;

        public void Execute() => At.Value = ReadClock.Now;
    }

    // Jobs can read it; the coroutine would see a finished read only in its next update.
    static class ReadClock
    {
        public static long Now => ProfilerUnsafeUtility.Timestamp;

        public static double Seconds(long from, long to)
        {
            var ratio = ProfilerUnsafeUtility.TimestampToNanosecondsConversionRatio;
            return (to - from) * (double)ratio.Numerator / ratio.Denominator * 1e-9;
        }
    }
}
