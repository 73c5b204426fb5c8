using System;
using System.IO;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Verifies converted clouds, one at a time, with a line in the Progress window. The result is written to the
    /// Console and kept for inspectors.</summary>
    internal sealed class EditorChecks : IDisposable
    {
        int m_progress;

        /// <summary>The last check; null if there was none.</summary>
        public CloudCheck Check { get; private set; }

        public bool IsChecking => Check != null && !Check.IsDone;

        /// <summary>Begins with a folder; a check in progress is broken off.</summary>
        public void Begin(string path)
        {
            Dispose();
            var check = Check = new CloudCheck(path);
            m_progress = Progress.Start("Verify " + Path.GetFileName(path), null, Progress.Options.Managed);
            Progress.RegisterCancelCallback(m_progress, () =>
            {
                // Unity itself ends what was cancelled in its window.
                check.Dispose();
                if (Check == check)
                    Check = null;
                return true;
            });
        }

        /// <summary>Called once an update of the editor.</summary>
        public void Update(double budgetMs)
        {
            if (!IsChecking)
                return;
            bool isDone = Check.Step(budgetMs);
            Progress.Report(m_progress, (float)Check.Share, Check.Describe());
            if (!isDone)
                return;
            Progress.Finish(m_progress, Check.Result.Ok ? Progress.Status.Succeeded : Progress.Status.Failed);
            if (Check.Result.Ok)
                Debug.Log("FastPoints: " + Check.Path + ": " + Check.Describe());
            else
                Debug.LogError("FastPoints: " + Check.Path + ": " + Check.Describe());
        }

        /// <summary>Breaks off the check in progress.</summary>
        public void Dispose()
        {
            if (!IsChecking)
                return;
            Check.Dispose();
            Check = null;
            Progress.Finish(m_progress, Progress.Status.Canceled);
        }
    }
}
