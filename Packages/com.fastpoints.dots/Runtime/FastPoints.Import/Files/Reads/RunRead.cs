using System;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Profiling.LowLevel.Unsafe;

namespace FastPoints.Files
{
    /// <summary>A slot for sources of a fixed stride that reads many short runs, scattered over the file, into places of a batch
    /// with one request, as samples need. A block read for each of them would cost several times as much.</summary>
    /// <remarks>Slots that write to different places of one batch may be in flight together. Memory is bounded by the buffer,
    /// whatever is requested.</remarks>
    internal abstract unsafe class RunRead : IDisposable
    {
        /// <summary>Bytes behind a record that decoders may load and ignore.</summary>
        const int PaddingBytes = 16;

        readonly FixedRecords m_file;
        NativeArray<byte> m_records;
        NativeArray<BufferedRun> m_runs;
        // The read manager keeps the pointer to its commands until the read has ended.
        NativeArray<ReadCommand> m_commands;
        NativeReference<long> m_ended;
        ReadHandle m_read;
        bool m_isReading;

        /// <param name="target">The batch that the points go to, whose schema says what is wanted.</param>
        /// <param name="maxRuns">The most runs in one request.</param>
        /// <param name="maxBytes">The most bytes in one request, at least those of the longest run.</param>
        private protected RunRead(in FixedRecords file, PointBatch target, int maxRuns, int maxBytes, Allocator allocator)
        {
            m_file = file;
            Target = target;
            m_records = new NativeArray<byte>(maxBytes + PaddingBytes, allocator, NativeArrayOptions.UninitializedMemory);
            m_runs = new NativeArray<BufferedRun>(maxRuns, allocator, NativeArrayOptions.UninitializedMemory);
            m_commands = new NativeArray<ReadCommand>(maxRuns, allocator, NativeArrayOptions.UninitializedMemory);
            m_ended = new NativeReference<long>(allocator);
        }

        public PointBatch Target { get; }

        /// <summary>Completes when the points are in place.</summary>
        public JobHandle Decoded { get; private set; }

        /// <summary>Separate stretches of the file in the last request.</summary>
        public int Stretches { get; private set; }

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
        /// <param name="most">The most to take.</param>
        /// <param name="gapBytes">Runs that are no farther apart are read in one stretch: use more for a file that is slow to
        /// seek.</param>
        /// <returns>The number of runs that were taken.</returns>
        public int Begin(NativeArray<PointRun> runs, int first, int most, int gapBytes)
        {
            if (m_isReading)
                throw new InvalidOperationException("the slot is still reading; Complete it first");
            most = Math.Min(Math.Min(most, runs.Length - first), m_runs.Length);
            int capacity = m_records.Length - PaddingBytes;
            byte* buffer = (byte*)m_records.GetUnsafePtr();
            int taken = 0, used = 0, stretches = 0;
            long stretchEnd = -1;
            for (; taken < most; taken++)
            {
                var run = runs[first + taken];
                long begin = m_file.DataOffset + run.First * m_file.RecordBytes;
                long end = begin + BytesOf(run, m_file.RecordBytes);
                bool joins = stretches > 0 && begin - stretchEnd <= gapBytes;
                long added = joins ? end - stretchEnd : end - begin;
                if (used + added > capacity)
                    break;
                if (!joins)
                    m_commands[stretches++] = new ReadCommand { Buffer = buffer + used, Offset = begin };
                used += (int)added;
                stretchEnd = end;
                var command = m_commands[stretches - 1];
                command.Size = end - command.Offset;
                m_commands[stretches - 1] = command;
                m_runs[taken] = new BufferedRun
                {
                    FirstByte = (int)((byte*)command.Buffer - buffer + (begin - command.Offset)),
                    StrideBytes = run.Step * m_file.RecordBytes,
                    Count = run.Count,
                    Place = run.Place,
                };
            }
            if (taken == 0)
                throw new ArgumentException("a run does not fit into the slot's " + capacity + " bytes", nameof(runs));
            Stretches = stretches;
            BytesRead = used;
            Begun = ReadClock.Now;
            m_read = AsyncReadManager.Read(m_file.Handle, new ReadCommandArray
            {
                CommandCount = stretches,
                ReadCommands = (ReadCommand*)m_commands.GetUnsafePtr(),
            });
            m_isReading = true;
            var stamped = new TimestampJob { At = m_ended }.Schedule(m_read.JobHandle);
            Decoded = JobHandle.CombineDependencies(stamped, Schedule(m_records, m_runs, taken, m_read.JobHandle));
            return taken;
        }

        /// <summary>Waits for the decoding if necessary (poll <c>Decoded.IsCompleted</c> to avoid that), and closes the
        /// request.</summary>
        /// <exception cref="PointCloudException">The read failed, or the file has become shorter since it was
        /// opened.</exception>
        public void Complete()
        {
            Decoded.Complete();
            if (!m_isReading)
                return;
            m_isReading = false;
            var status = m_read.Status;
            m_read.Dispose();
            if (status == ReadStatus.Complete)
                return;
            bool isShort = status == ReadStatus.Truncated;
            throw new PointCloudException(isShort ? FailureCode.Truncated : FailureCode.ReadFailed, m_file.Path,
                m_commands[0].Offset, isShort ? "the file became shorter while it was read"
                : "reading " + NumberText.Of(BytesRead) + " bytes from here on failed");
        }

        /// <summary>Cancels what is in flight, waits for it and frees the memory. May be called twice.</summary>
        public virtual void Dispose()
        {
            if (!m_records.IsCreated)
                return;
            if (m_isReading)
            {
                m_read.Cancel();
                Decoded.Complete();
                m_read.JobHandle.Complete();
                m_read.Dispose();
                m_isReading = false;
            }
            m_records.Dispose();
            m_runs.Dispose();
            m_commands.Dispose();
            m_ended.Dispose();
        }

        /// <summary>Decodes the runs after the read.</summary>
        private protected abstract JobHandle Schedule(NativeArray<byte> records, NativeArray<BufferedRun> runs, int runCount,
            JobHandle read);
    }

    /// <summary>A file, open, and where its records of one length begin.</summary>
    readonly struct FixedRecords
    {
        public readonly string Path;
        public readonly FileHandle Handle;
        public readonly long DataOffset;
        public readonly int RecordBytes;

        public FixedRecords(SourceInfo info, in FileHandle handle, long dataOffset)
        {
            Path = info.Path;
            Handle = handle;
            DataOffset = dataOffset;
            RecordBytes = info.RecordBytes;
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

    /// <summary>The clock for the duration of reads. Jobs can read it; the pump would see a finished read only in its next
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
