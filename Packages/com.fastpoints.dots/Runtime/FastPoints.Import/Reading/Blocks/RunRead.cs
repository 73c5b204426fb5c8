using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Profiling.LowLevel.Unsafe;

namespace FastPoints.Reading
{
    /// <summary>A slot for sources of a fixed stride that reads many short runs, scattered over the file, into places of a batch
    /// with one request, as samples need. A block read for each of them would cost several times as much.</summary>
    /// <remarks>Slots that write to different places of one batch may be in flight together. Memory is bounded by the buffer,
    /// whatever is requested.</remarks>
    internal sealed unsafe class RunRead : IDisposable
    {
        readonly FixedRecords m_records;
        readonly NativeFileRead m_file;
        readonly PointBatch m_target;
        NativeArray<BufferedRun> m_runs;
        NativeArray<FieldCopy> m_copies;
        NativeReference<long> m_ended;

        /// <param name="target">The batch that the points go to, whose schema says what is wanted.</param>
        /// <param name="maxRuns">The most runs in one request.</param>
        /// <param name="maxBytes">The most bytes in one request, at least those of the longest run.</param>
        public RunRead(FixedRecords records, PointBatch target, int maxRuns, int maxBytes, Allocator allocator)
        {
            m_records = records;
            m_target = target;
            m_copies = records.CopiesTo(target, allocator);
            m_file = new NativeFileRead(maxBytes, allocator, maxRuns);
            m_runs = new NativeArray<BufferedRun>(maxRuns, allocator, NativeArrayOptions.UninitializedMemory);
            m_ended = new NativeReference<long>(allocator);
        }

        /// <summary>Completes when the points are in place.</summary>
        public JobHandle Decoded { get; private set; }

        /// <summary>Separate segments of the file in the last request.</summary>
        public int Segments { get; private set; }

        /// <summary>Bytes read by the last request, including gaps.</summary>
        public long BytesRead { get; private set; }

        /// <summary>When the last request began and when its bytes had arrived, in the time of <see cref="ReadClock"/>.</summary>
        internal long Begun { get; private set; }

        internal long Ended => m_ended.Value;

        /// <summary>Bytes of the file from a run's first record to its last.</summary>
        public static long BytesOf(in PointRun run, int recordBytes) => (run.Last - run.First + 1) * recordBytes;

        /// <summary>Starts reading as many of the runs as fit; the slot must be idle. Main thread only; returns at
        /// once.</summary>
        /// <param name="runs">Runs in the file's order, without overlaps, all within the file.</param>
        /// <param name="first">The first one to take.</param>
        /// <param name="max">The most to take.</param>
        /// <param name="gapBytes">Runs that are no farther apart are read in one segment: use more for a file that is slow to
        /// seek.</param>
        /// <returns>The number of runs that were taken.</returns>
        public int Begin(NativeArray<PointRun> runs, int first, int max, int gapBytes)
        {
            if (m_file.IsReading)
                throw new InvalidOperationException(SlotRing.InFlight);
            max = Math.Min(Math.Min(max, runs.Length - first), m_runs.Length);
            int capacity = m_file.Buffer.Length - NativeFileRead.PaddingBytes;
            byte* buffer = (byte*)m_file.Buffer.GetUnsafePtr();
            var commands = m_file.Commands;
            int taken = 0, used = 0, segments = 0;
            long segmentEnd = -1;
            for (; taken < max; taken++)
            {
                var run = runs[first + taken];
                long begin = m_records.OffsetOf(run.First);
                long end = begin + BytesOf(run, m_records.RecordBytes);
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
                m_runs[taken] = new BufferedRun
                {
                    FirstByte = (int)((byte*)command.Buffer - buffer + (begin - command.Offset)),
                    StrideBytes = run.Step * m_records.RecordBytes,
                    Count = run.Count,
                    Place = run.Place,
                };
            }
            if (taken == 0)
                throw new ArgumentException("a run does not fit into the slot's " + capacity + " bytes", nameof(runs));
            Segments = segments;
            BytesRead = used;
            Begun = ReadClock.Now;
            var read = m_file.Begin(m_records.File, segments);
            var stamped = new TimestampJob { At = m_ended }.Schedule(read);
            var decoded = new DecodeRunsJob
            {
                Records = m_file.Buffer,
                Runs = m_runs,
                Copies = m_copies,
                RunCount = taken,
                RecordBytes = m_records.RecordBytes,
                Columns = m_target.Bytes,
            }.Schedule(read);
            Decoded = JobHandle.CombineDependencies(stamped, decoded);
            return taken;
        }

        /// <summary>Waits for the decoding if necessary (poll <c>Decoded.IsCompleted</c> to avoid that), and closes the
        /// request.</summary>
        /// <exception cref="PointCloudException">The read failed, or the file has become shorter since it was opened.</exception>
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

        /// <summary>Cancels what is in flight, waits for it and frees the memory. May be called twice.</summary>
        public void Dispose()
        {
            if (!m_runs.IsCreated)
                return;
            m_file.Cancel();
            Decoded.Complete();
            m_file.Dispose();
            m_runs.Dispose();
            m_copies.Dispose();
            m_ended.Dispose();
        }
    }

    /// <summary>Decodes scattered records that a read has brought into memory to their places in a batch.</summary>
    [BurstCompile]
    struct DecodeRunsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<BufferedRun> Runs;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public int RunCount;
        public int RecordBytes;

        // Other slots write to other parts of it at the same time.
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Columns;

        public unsafe void Execute()
        {
            byte* records = (byte*)Records.GetUnsafeReadOnlyPtr();
            byte* columns = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Columns);
            for (int i = 0; i < RunCount; i++)
            {
                var run = Runs[i];
                if (run.FirstByte + (run.Count - 1L) * run.StrideBytes + RecordBytes > Records.Length)
                    return;
                PointRecords.ToColumns(records + run.FirstByte, run.StrideBytes, run.Count,
                    (FieldCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, columns, run.Place);
            }
        }
    }

    /// <summary>Evenly spaced points of a source (First, First + Step, ...) and where in a batch they go, one after the
    /// other.</summary>
    internal struct PointRun
    {
        /// <summary>Index of the first point in the whole source.</summary>
        public long First;

        /// <summary>Points from one to the next, at least 1.</summary>
        public int Step;

        /// <summary>At least 1.</summary>
        public int Count;

        /// <summary>Place of the first point in the batch.</summary>
        public int Place;

        public long Last => First + (Count - 1L) * Step;
    }

    /// <summary>A <see cref="PointRun"/> whose records have been read. Blittable: jobs carry arrays of these.</summary>
    struct BufferedRun
    {
        /// <summary>Offset of the first record in the buffer.</summary>
        public int FirstByte;

        /// <summary>Bytes from one wanted record to the next.</summary>
        public int StrideBytes;

        public int Count;

        /// <summary>Place of the first point in the batch.</summary>
        public int Place;
    }

    /// <summary>Records when the jobs that it depends on were done.</summary>
    [BurstCompile]
    struct TimestampJob : IJob
    {
        /// <summary>In the time of <see cref="ReadClock"/>.</summary>
        public NativeReference<long> At;

        public void Execute() => At.Value = ReadClock.Now;
    }

    /// <summary>The clock for the duration of reads. Jobs can read it; the coroutine would see a finished read only in its next
    /// update.</summary>
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
