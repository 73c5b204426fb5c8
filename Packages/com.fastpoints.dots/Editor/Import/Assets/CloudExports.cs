using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Export;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Writes points of clouds to files, one file after another, a few milliseconds an update, each with a line in the
    /// Progress window. An export that is cancelled or interrupted by a reload of scripts leaves nothing.</summary>
    internal sealed class CloudExports : IDisposable
    {
        sealed class Export
        {
            public string Path;
            public PoolTask<PointReader> Opening;
            public ExportSettings Settings;
            public PointReader Reader;
            public JobCoroutine Coroutine;
            public ExportResult Result;
            public readonly StageProgress Stages = new StageProgress();
            public int Progress;
        }

        readonly List<Export> m_exports = new List<Export>();

        public bool IsExporting => m_exports.Count > 0;

        public IEnumerable<string> ReservedPaths => m_exports.ConvertAll(export => export.Path);

        public void Begin(IReadOnlyList<string> sources, string path, ExportSettings settings)
        {
            var export = new Export { Path = path, Settings = settings };
            export.Opening = PoolTask.Begin(path, () => Open(sources), reader => reader.DisposeUnread());
            export.Progress = Progress.Start("Export " + Path.GetFileName(path), path, Progress.Options.Managed);
            Progress.RegisterCancelCallback(export.Progress, () =>
            {
                // Unity itself ends what was cancelled in its window.
                m_exports.Remove(export);
                Free(export);
                return true;
            });
            m_exports.Add(export);
        }

        public void Update(double budgetMs)
        {
            if (m_exports.Count == 0)
                return;
            var export = m_exports[0];
            try
            {
                if (!Step(export, budgetMs))
                {
                    Progress.Report(export.Progress, (float)export.Stages.Fraction, export.Stages.Current ?? export.Path);
                    return;
                }
                Debug.Log("FastPoints: " + Describe(export));
                End(export, Progress.Status.Succeeded);
            }
            catch (Exception e)
            {
                Debug.LogError("FastPoints: " + PointCloudException.Of(export.Path, e).FullMessage);
                End(export, Progress.Status.Failed);
            }
        }

        public void Dispose()
        {
            while (m_exports.Count > 0)
                End(m_exports[0], Progress.Status.Canceled);
        }

        static PointReader Open(IReadOnlyList<string> sources) =>
            sources.Count == 1 && CloudFolder.IsCloud(sources[0]) ? ConvertedReader.OpenEdited(sources[0])
                : PointReaders.Open(sources);

        static bool Step(Export export, double budgetMs)
        {
            if (export.Coroutine == null)
            {
                if (!export.Opening.IsDone)
                    return false;
                export.Reader = export.Opening.Take();
                export.Coroutine =
                    new JobCoroutine(ExportCloud.Run(export.Reader, export.Path, export.Settings, r => export.Result = r,
                    export.Stages));
            }
            return export.Coroutine.Tick(budgetMs);
        }

        static string Describe(Export export)
        {
            var result = export.Result;
            string moved = result.PositionError > 0
                ? "; coordinates were rounded by at most " + NumberText.Of(result.PositionError) : "";
            string leftOut = result.PointsLeftOut > 0
                ? "; " + NumberText.Of(result.PointsLeftOut) + " points without a place were left out" : "";
            return export.Path + ": " + NumberText.Of(result.Points) + " points" + moved + leftOut +
                (result.Warnings.Count > 0 ? "\n" + string.Join("\n", result.Warnings) : "") +
                (result.Losses.Count > 0 ? "\n" + string.Join("\n", result.Losses) : "");
        }

        void End(Export export, Progress.Status status)
        {
            m_exports.Remove(export);
            Free(export);
            Progress.Finish(export.Progress, status);
        }

        static void Free(Export export)
        {
            export.Coroutine?.Cancel();
            export.Opening.Dispose();
            export.Reader?.Dispose();
        }
    }
}
