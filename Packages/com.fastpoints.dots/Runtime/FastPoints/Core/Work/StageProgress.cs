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
        string m_name;
        long m_points;
        long m_bytes;

        /// <summary>Raised by each <see cref="Report"/>, begin and end: listeners must throttle themselves.</summary>
        public event Action<StageProgress> Changed;

        public IReadOnlyList<Stage> Finished => m_finished;

        /// <summary>A prefix for the names of all stages that begin from now on; null for none.</summary>
        public string Group { get; set; }

        /// <summary>Name of the running stage, or null.</summary>
        public string Current => m_name;

        /// <summary>Share of the running stage that is done, 0 to 1.</summary>
        public double Fraction { get; private set; }

        public double Seconds => m_watch.Elapsed.TotalSeconds;
        public long Points => m_points;
        public long Bytes => m_bytes;
        public double PointsPerSecond => Seconds > 0 ? m_points / Seconds : 0;

        /// <summary>Seconds left at the speed so far, or infinity before anything is done.</summary>
        public double SecondsLeft => Fraction > 0 ? Seconds * (1 - Fraction) / Fraction : double.PositiveInfinity;

        public void Begin(string name)
        {
            if (m_name != null)
                End();
            m_name = Group == null ? name : Group + ": " + name;
            m_points = 0;
            m_bytes = 0;
            Fraction = 0;
            m_watch.Restart();
            Changed?.Invoke(this);
        }

        /// <summary>Reports total points and bytes of the running stage so far, and the share of it that is done.</summary>
        public void Report(double share, long points, long bytes)
        {
            Fraction = Math.Max(0, Math.Min(1, share));
            m_points = points;
            m_bytes = bytes;
            Changed?.Invoke(this);
        }

        public void End()
        {
            if (m_name == null)
                return;
            m_watch.Stop();
            m_finished.Add(new Stage { Name = m_name, Seconds = Seconds, Points = m_points, Bytes = m_bytes });
            m_name = null;
            Fraction = 1;
            Changed?.Invoke(this);
        }
    }
}
