using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;
using FastPoints.Preview;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Partition
{
    /// <summary>Stored positions of some points of one source, spread evenly over its records: enough to estimate the density,
    /// read in milliseconds. It is only an estimate: correctness never depends on it.</summary>
    internal sealed class SourceSample : IDisposable
    {
        // A thousand runs of a thousand records: on a 20 M point tile the largest chunk then missed its target by a tenth.
        const int MaxRuns = 1024;
        const int RunPoints = 1024;

        NativeList<double3> m_stored;
        NativeList<SampleRun> m_runs;

        SourceSample()
        {
            m_stored = new NativeList<double3>(RunPoints, Allocator.Persistent);
            m_runs = new NativeList<SampleRun>(MaxRuns, Allocator.Persistent);
        }

        /// <summary>Positions as the file stores them, including those that are not finite.</summary>
        public NativeArray<double3> Stored => m_stored.AsArray();

        /// <summary>Runs in the file's order: each stands for the points up to the next one.</summary>
        public NativeArray<SampleRun> Runs => m_runs.AsArray();

        /// <summary>Work for a pump: reads the sample. The reader's blocks are known.</summary>
        /// <param name="slots">Runs in flight.</param>
        /// <param name="take">Receives the sample at the end; the caller disposes it.</param>
        public static IEnumerator<Work> Read(PointReader reader, int slots, Action<SourceSample> take)
        {
            var sample = new SourceSample();
            var runs = SampleRuns.Choose(reader, MaxRuns, RunPoints);
            int longest = 1;
            foreach (var run in runs)
                longest = Math.Max(longest, run.Count);
            var positions = reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z);
            slots = Math.Min(runs.Count, slots);
            var reads = new BlockRead[slots];
            var buffers = new NativeArray<double3>[slots];
            var jobs = new JobHandle[slots];
            try
            {
                for (int s = 0; s < slots; s++)
                {
                    reads[s] = reader.CreateRead(positions, longest, Allocator.Persistent);
                    buffers[s] = new NativeArray<double3>(longest, Allocator.Persistent);
                }
                for (int r = 0; r < runs.Count + slots; r++)
                {
                    int s = slots == 0 ? 0 : r % slots;
                    if (r >= slots && r - slots < runs.Count)
                    {
                        yield return jobs[s];
                        jobs[s].Complete();
                        reads[s].Complete();
                        sample.Add(buffers[s], reads[s].Points.Count, PointsUpToNext(reader, runs, r - slots));
                    }
                    if (r < runs.Count)
                    {
                        reads[s].Begin(runs[r]);
                        var batch = reads[s].Points;
                        jobs[s] = new LoadSamplePositionsJob
                        {
                            Columns = batch.Bytes,
                            Decoded = reads[s].Result,
                            X = batch.Column(batch.Schema.IndexOf(AttributeNames.X)),
                            Y = batch.Column(batch.Schema.IndexOf(AttributeNames.Y)),
                            Z = batch.Column(batch.Schema.IndexOf(AttributeNames.Z)),
                            Stored = buffers[s],
                        }.Schedule(reads[s].Decoded);
                        JobHandle.ScheduleBatchedJobs();
                    }
                }
                take(sample);
                sample = null;
            }
            finally
            {
                for (int s = 0; s < slots; s++)
                {
                    jobs[s].Complete();
                    reads[s]?.Dispose();
                    if (buffers[s].IsCreated)
                        buffers[s].Dispose();
                }
                sample?.Dispose();
            }
        }

        /// <summary>Number of points from a run's first point to the next run's; the first run also stands for those before
        /// it.</summary>
        static long PointsUpToNext(PointReader reader, List<BlockRange> runs, int run)
        {
            long first = run == 0 ? 0 : reader.FirstPointOfBlock(runs[run].Block) + runs[run].First;
            return (run + 1 == runs.Count ? reader.PointCount
                : reader.FirstPointOfBlock(runs[run + 1].Block) + runs[run + 1].First) - first;
        }

        void Add(NativeArray<double3> stored, int count, long pointsStoodFor)
        {
            m_runs.Add(new SampleRun
            {
                Stretch = m_runs.Length,
                First = m_stored.Length,
                Count = count,
                Weight = pointsStoodFor / (double)Math.Max(1, count),
            });
            m_stored.AddRange(stored.GetSubArray(0, count));
        }

        public void Dispose()
        {
            if (!m_stored.IsCreated)
                return;
            m_stored.Dispose();
            m_runs.Dispose();
        }
    }
}
