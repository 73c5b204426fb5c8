using System;
using System.Collections.Generic;
using System.Diagnostics;
using FastPoints.Reading;

namespace FastPoints.Build
{
    internal sealed class ReadSources
    {
        readonly BuildContext m_build;
        readonly ScatterPoints m_scatter;
        readonly BuildCheckpoints m_checkpoints;
        readonly BuildGenerations m_generations;
        readonly Stopwatch m_watch = Stopwatch.StartNew();
        CoroutineStack m_firstGeneration;
        long m_sinceCheckpoint;
        long m_resumedPoints;

        public ReadSources(BuildContext build, ScatterPoints scatter, BuildCheckpoints checkpoints, BuildGenerations generations)
        {
            m_build = build;
            m_scatter = scatter;
            m_checkpoints = checkpoints;
            m_generations = generations;
        }

        public IEnumerator<JobStep> Run()
        {
            var journal = m_checkpoints.Journal;
            if (journal.CurrentStage != BuildJournal.Stage.Read)
                yield break;
            m_resumedPoints = m_scatter.PointsDone;
            try
            {
                for (int i = journal.Source; i < m_build.Readers.Count; i++)
                {
                    yield return JobStep.Of(Read(i));
                    journal.Source = i + 1;
                    journal.Block = 0;
                }
                yield return JobStep.Of(EndFirstGeneration());
            }
            finally
            {
                m_firstGeneration?.Dispose();
            }
            if (UsesFiles())
                yield return JobStep.Of(m_scatter.WriteAll());
        }

        /// <summary>Whether reading can be resumed; long reading uses files from now on.</summary>
        bool UsesFiles() => m_build.Files != null ||
            m_watch.Elapsed.TotalSeconds >= m_build.Settings.SecondsInMemory && m_build.TryUseFiles();

        /// <summary>With timed checkpoints the first one is early, to measure the speed.</summary>
        long PointsToCheckpoint()
        {
            var settings = m_build.Settings;
            if (m_build.Files == null && double.IsPositiveInfinity(settings.SecondsInMemory))
                return settings.PointsPerCheckpoint;
            long points = m_scatter.PointsDone - m_resumedPoints;
            return points == 0 ? Math.Max(1, settings.PointsPerCheckpoint / 8) : (long)Math.Min(settings.PointsPerCheckpoint,
                points / m_watch.Elapsed.TotalSeconds * settings.SecondsPerCheckpoint);
        }

        IEnumerator<JobStep> Read(int source)
        {
            var journal = m_checkpoints.Journal;
            var reader = m_build.Readers[source];
            var wanted = reader.Info.Schema.SelectWithPosition(m_build.Attributes);
            var limit = SourceScan.LimitFor(reader, wanted, m_build.RecordLayout.StrideBytes + sizeof(int),
                m_build.Plan.InFlightBytes, m_build.Settings.Workers, m_build.InFlightMs);
            m_scatter.BeginSource(reader, m_build.Grid.Sources[source]);
            if (journal.Statistics.Count <= source)
                journal.Statistics.Add(PointStatistics.None);
            for (int block = journal.Block; block < reader.BlockCount; block = journal.Block)
            {
                int end = block;
                long wantedPoints = PointsToCheckpoint();
                do
                    m_sinceCheckpoint += reader.PointsInBlock(end);
                while (++end < reader.BlockCount && m_sinceCheckpoint < wantedPoints);
                using (var scan = new CoroutineStack(SourceScan.Run(ScanRanges.Blocks(reader, block, end), wanted, m_scatter,
                    limit, m_build.Settings.Workers, null)))
                {
                    while (scan.MoveNext())
                    {
                        yield return scan.Current;
                        StepFirstGeneration();
                    }
                }
                var found = journal.Statistics[source];
                found.Include(m_scatter.TakeStatistics());
                journal.Statistics[source] = found;
                journal.Block = end;
                journal.OwnBlockPoints += m_build.TakeOwnBlockPoints?.Invoke() ?? 0;
                if (m_sinceCheckpoint < wantedPoints)
                    continue;
                m_sinceCheckpoint = 0;
                if (!UsesFiles())
                    continue;
                yield return JobStep.Of(m_scatter.WriteAll());
                // Reading continues while the disk writes what was read.
                yield return JobStep.Of(m_checkpoints.Begin());
            }
            yield return JobStep.Of(m_scatter.EndSource());
        }

        /// <summary>If reading takes long, the first generation is built meanwhile; not in its second half, since
        /// chunks follow soon.</summary>
        void StepFirstGeneration()
        {
            if (m_firstGeneration == null && m_generations.IsFirstDue && 2 * m_scatter.PointsDone <= m_build.Points)
                m_firstGeneration = new CoroutineStack(m_generations.WriteFirst());
            if (m_firstGeneration == null || !JobCoroutine.HasEnded(m_firstGeneration.Current))
                return;
            m_firstGeneration.Current.Complete();
            m_firstGeneration.MoveNext();
        }

        IEnumerator<JobStep> EndFirstGeneration()
        {
            for (bool more = m_firstGeneration != null; more; more = m_firstGeneration.MoveNext())
            {
                yield return m_firstGeneration.Current;
                m_firstGeneration.Current.Complete();
            }
        }
    }
}
