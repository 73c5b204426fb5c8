using System;
using System.Collections.Generic;
using System.Diagnostics;

namespace FastPoints
{
    /// <summary>The stages of a long piece of work, and the share that is done. For the thread of the work alone.</summary>
    public sealed class StageProgress
    {
        /// <summary>The name, time and amounts of one stage.</summary>
        public struct Stage
        {
            public string Name;
            public double Seconds;
            public long Points;
            public long Bytes;
        }

        readonly List<Stage> m_finished = new List<Stage>();
        readonly Stopwatch m_watch = new Stopwatch();

        /// <summary>Raised by each <see cref="Report"/>, begin and end: listeners must throttle themselves.</summary>
        public event Action<StageProgress> Changed;

        public IReadOnlyList<Stage> Finished => m_finished;

        /// <summary>A prefix for the names of all stages that begin from now on; null for none.</summary>
        public string Group { get; set; }

        /// <summary>Name of the running stage, or null.</summary>
        public string Current { get; private set; }

        /// <summary>Share of the running stage that is done, 0 to 1.</summary>
        public double Fraction { get; private set; }

        public double Seconds => m_watch.Elapsed.TotalSeconds;
        public long Points { get; private set; }
        public long Bytes { get; private set; }
        public double PointsPerSecond => Seconds > 0 ? Points / Seconds : 0;

        /// <summary>Seconds left at the speed so far, or infinity before anything is done.</summary>
        public double SecondsLeft => Fraction > 0 ? Seconds * (1 - Fraction) / Fraction : double.PositiveInfinity;

        public void Begin(string name)
        {
            if (Current != null)
                End();
            Current = Group == null ? name : Group + ": " + name;
            Points = 0;
            Bytes = 0;
            Fraction = 0;
            m_watch.Restart();
            Changed?.Invoke(this);
        }

        /// <summary>Reports total points and bytes of the running stage so far, and the share of it that is done.</summary>
        public void Report(double share, long points, long bytes)
        {
            Fraction = Math.Max(0, Math.Min(1, share));
            Points = points;
            Bytes = bytes;
            Changed?.Invoke(this);
        }

        public void End()
        {
            if (Current == null)
                return;
            m_watch.Stop();
            m_finished.Add(new Stage { Name = Current, Seconds = Seconds, Points = Points, Bytes = Bytes });
            Current = null;
            Fraction = 1;
            Changed?.Invoke(this);
        }
    }
}
