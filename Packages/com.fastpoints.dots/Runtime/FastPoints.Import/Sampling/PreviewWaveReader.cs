using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>How the points of a <see cref="PreviewWaveSampler"/>'s waves are read into their entries.</summary>
    internal abstract class PreviewWaveReader
    {
        const double MaxFrameMs = 250; // If frames are farther apart, the machine was busy or the work was paused.

        protected PreviewWaveReader(PointReader reader, int entryCount, string method)
        {
            Reader = reader;
            Buffer = new SampleBuffer(SampleSchema.Of(reader.Info), reader.Info.Transform, entryCount);
            Method = method;
        }

        public SampleBuffer Buffer { get; } // The caller disposes it.

        public string Method { get; protected set; }

        public long BytesRead { get; protected set; }

        /// <summary>Jobs that fill the entries up to <see cref="EndIndex"/>, unless <see cref="Read"/> has awaited
        /// them.</summary>
        public JobHandle Filling { get; protected set; }

        /// <summary>Number of entries in the sample that the waves so far have reached.</summary>
        public int EndIndex { get; protected set; }

        protected PointReader Reader { get; }

        /// <summary>Reads in flight: <c>slots</c> if that is not 0; otherwise <c>first</c>, growing while long frames leave
        /// workers idle.</summary>
        public static InFlightLimit LimitFor(PointReader reader, PointSchema schema, int slots, int first) => slots > 0
            ? new InFlightLimit(slots, slots, () => 0)
            : new InFlightLimit(first, SourceScan.SlotsIn(reader, schema, 0, SourceScan.MaxSlotBytes), () => MaxFrameMs);

        /// <summary>Coroutine: reads more points into the following entries, and moves <see cref="EndIndex"/> behind
        /// them.</summary>
        /// <param name="wanted">The approximate number of entries to reach; all of them for the last wave.</param>
        /// <param name="next">The same of the wave after this one, which may be prepared; 0 for none.</param>
        public abstract IEnumerator<JobStep> Read(int wanted, int next, int slots, StageProgress progress);

        /// <summary>Call it when <see cref="Filling"/> has ended.</summary>
        /// <exception cref="PointCloudException">A read failed.</exception>
        public virtual void EndReads() => Filling = default;

        /// <summary>Frees what <see cref="Read"/> needs and awaits jobs in flight. May be called twice.</summary>
        public abstract void Free();

        public void Report(StageProgress progress)
        {
            int count = Buffer.Points.Count;
            progress?.Report(count / (double)Math.Max(1, Buffer.EntryCount), count, BytesRead);
        }
    }
}
