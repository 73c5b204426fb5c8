using System;
using System.Collections.Generic;
using System.Diagnostics;
using FastPoints.Build;
using FastPoints.Reading;
using FastPoints.Sources;

namespace FastPoints.Editor
{
    /// <summary>Runs one conversion while the editor stays usable: opens the sources on a pool thread, then steps the work
    /// a few milliseconds an update. It can be paused, cancelled for good, or suspended for a later session to
    /// continue.</summary>
    /// <remarks>Main thread. <see cref="Tick"/> never waits; the two ways to end it early wait for what must not be interrupted:
    /// a header being read, running slices, the writer.</remarks>
    internal sealed class ConversionSession : IDisposable
    {
        readonly string m_target;
        readonly ConvertSettings m_settings;
        readonly Stopwatch m_watch = new Stopwatch();
        PoolTask<PointReader> m_opening;
        PointReader m_reader;
        JobCoroutine m_coroutine;

        /// <param name="sources">Null if the target is a converted cloud, which gets normals.</param>
        /// <param name="settings">The settings, which the session owns from now on.</param>
        public ConversionSession(IReadOnlyList<string> sources, string target, ConvertSettings settings)
        {
            m_target = target;
            m_settings = settings;
            m_settings.KeepUnfinished = true;
            m_opening = sources == null ? null : PoolTask.Begin(target, () => Open(sources));
        }

        public ConversionState State { get; private set; } = ConversionState.Opening;

        public StageProgress Progress { get; } = new StageProgress();

        public SourceInfo Source { get; private set; } // The source's header; null until it is open, or without one.

        public SourceStamp Stamp { get; private set; } // The source's stamp from before it was opened; null until it is open.

        public ConvertResult Result { get; private set; }

        /// <summary>The failure: a <see cref="PointCloudException"/> of one line, or an unexpected exception.</summary>
        public Exception Failure { get; private set; }

        public double Fraction => State == ConversionState.Done ? 1 : ConversionProgress.FractionOf(Progress);

        public double Seconds => m_watch.Elapsed.TotalSeconds;

        /// <summary>Estimated from the speed so far; infinity before anything is known.</summary>
        public double SecondsLeft => Fraction > 0 ? Seconds * (1 - Fraction) / Fraction : double.PositiveInfinity;

        public bool IsEnded => State >= ConversionState.Done;

        public int Workers => m_settings.Workers;

        public void Adapt(int workers, double inFlightMs)
        {
            m_settings.Workers = workers;
            m_settings.InFlightMs = inFlightMs;
            if (m_reader != null)
                m_reader.MaxIndexingJobs = workers;
        }

        public bool Tick(double budgetMs)
        {
            try
            {
                if (State == ConversionState.Opening && m_opening?.IsDone != false)
                    Begin();
                if (State == ConversionState.Building && m_coroutine.Tick(budgetMs))
                    End(ConversionState.Done);
            }
            catch (Exception e)
            {
                Failure = e;
                End(ConversionState.Failed);
                // What is on disk is worth keeping if the system was at fault, for example with a full disk or too little
                // memory, but not if the source is.
                var known = PointCloudException.Of(m_target, e);
                var cause = known.InnerException;
                if (known.IsInputAtFault || known.Code == FailureCode.Unexpected &&
                    !(cause is OutOfMemoryException || FileFailures.IsFileFailure(cause) && !(cause is ArgumentException)))
                    CloudFolderWriter.DeleteUnfinished(m_target);
            }
            return IsEnded;
        }

        public void Pause()
        {
            if (State != ConversionState.Building)
                return;
            State = ConversionState.Paused;
            m_watch.Stop();
        }

        public void Resume()
        {
            if (State != ConversionState.Paused)
                return;
            State = ConversionState.Building;
            m_watch.Start();
        }

        /// <summary>Ends it for good and deletes everything it has made.</summary>
        public void Cancel()
        {
            if (IsEnded)
                return;
            m_settings.KeepUnfinished = false;
            End(ConversionState.Cancelled);
            CloudFolderWriter.DeleteUnfinished(m_target);
        }

        /// <summary>Suspends it before scripts are reloaded or the editor quits. Everything it allocated is freed.</summary>
        public void Suspend()
        {
            if (!IsEnded)
                End(ConversionState.Suspended);
        }

        public void Dispose() => Suspend();

        void Begin()
        {
            m_coroutine = new JobCoroutine(m_opening == null ? AddNormals.Run(m_target,
                new NormalSettings { Workers = () => m_settings.Workers }, null, Progress) : Convert());
            State = ConversionState.Building;
            m_watch.Start();
        }

        IEnumerator<JobStep> Convert()
        {
            var opened = m_opening;
            m_opening = null;
            m_reader = opened.Take();
            Source = m_reader.Info;
            return ConvertCloud.Run(new[] { m_reader }, m_target, m_settings, r => Result = r, Progress);
        }

        PointReader Open(IReadOnlyList<string> sources)
        {
            var stamp = SourceStamp.Of(sources);
            var reader = PointReaders.Open(sources);
            Stamp = stamp;
            return reader;
        }

        void End(ConversionState state)
        {
            State = state;
            m_watch.Stop();
            m_coroutine?.Cancel();
            m_reader ??= m_opening?.TakeOrDefault();
            m_opening = null;
            m_reader?.Dispose();
            m_reader = null;
        }
    }

    internal enum ConversionState
    {
        Opening,
        Building,
        Paused,
        Done,
        Failed,
        Cancelled, // It was ended early; nothing is left of it.
        Suspended, // It was ended early; the next session of the same target continues from what lies on disk.
    }
}
