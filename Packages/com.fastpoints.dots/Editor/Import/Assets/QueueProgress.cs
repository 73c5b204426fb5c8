using System.IO;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>The running conversion's line in the Progress window, where it can be paused and cancelled.</summary>
    internal sealed class QueueProgress
    {
        readonly EditorImports m_imports;
        int m_line;

        public QueueProgress(EditorImports imports) => m_imports = imports;

        public ConversionSession Session { get; private set; } // The conversion that has a line; null for none.

        public void Report()
        {
            var queue = m_imports.Queue;
            if (Session != queue.Session)
                Begin(queue);
            Progress.Report(m_line, (float)Session.Fraction,
                queue.IsPausedByPlayMode ? "until play mode ends" : ConversionProgress.Describe(Session.Progress));
            if (Session.SecondsLeft < int.MaxValue)
                Progress.SetRemainingTime(m_line, (long)Session.SecondsLeft);
        }

        public void End(Progress.Status status)
        {
            if (Session != null)
                Progress.Finish(m_line, status);
            Session = null;
        }

        void Begin(ImportQueue queue)
        {
            var request = queue.CurrentRequest;
            Session = queue.Session;
            // Unity cancels progress that it manages before scripts are reloaded, as if the user had: the conversion would be
            // lost.
            m_line = Progress.Start("Convert " + Path.GetFileName(AssetDatabase.GUIDToAssetPath(request.AssetGuid)), null,
                Progress.Options.Unmanaged);
            Progress.SetTimeDisplayMode(m_line, Progress.TimeDisplayMode.ShowRemainingTime);
            Progress.RegisterCancelCallback(m_line, () =>
            {
                // Unity itself ends what was cancelled in its window.
                Session = null;
                m_imports.Cancel(request);
                return true;
            });
            Progress.RegisterPauseCallback(m_line, isPaused =>
            {
                if (isPaused)
                    queue.Pause(request);
                else
                    queue.Resume(request);
                // Reading a header cannot be paused, and the window must not show that it is.
                return (request.State == ImportState.Paused) == isPaused;
            });
        }
    }
}
