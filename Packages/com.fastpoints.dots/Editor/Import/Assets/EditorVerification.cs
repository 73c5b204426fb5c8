using System;
using System.Globalization;
using System.IO;
using FastPoints.Export;
using FastPoints.Reading;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    internal sealed class EditorVerification : IDisposable
    {
        int m_progress;

        public CloudVerification Check { get; private set; }

        public bool IsChecking => Check != null && !Check.IsDone;

        /// <summary>Begins with a folder; a check in progress is cancelled.</summary>
        public void Begin(string path)
        {
            Dispose();
            var check = Check = new CloudVerification(path);
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

        public void Update(double budgetMs)
        {
            if (!IsChecking)
                return;
            bool isDone = Check.Step(budgetMs);
            Progress.Report(m_progress, (float)Check.Fraction, Check.Describe());
            if (!isDone)
                return;
            Progress.Finish(m_progress, Check.Result.Ok ? Progress.Status.Succeeded : Progress.Status.Failed);
            if (Check.Result.Ok)
                Debug.Log("FastPoints: " + Check.Path + ": " + Check.Describe());
            else
                Debug.LogError("FastPoints: " + Check.Path + ": " + Check.Describe());
        }

        public void Dispose()
        {
            if (!IsChecking)
                return;
            Check.Dispose();
            Check = null;
            Progress.Finish(m_progress, Progress.Status.Canceled);
        }
    }

    /// <summary>Verifies a converted cloud, one slice in each update: every file, table, hash, point and count. Main
    /// thread.</summary>
    internal sealed class CloudVerification : IDisposable
    {
        readonly JobCoroutine m_work;
        readonly StageProgress m_progress = new StageProgress();

        public CloudVerification(string path)
        {
            Path = path;
            m_work = new JobCoroutine(VerifyCloud.Run(path, Array.Empty<PointReader>(), Result, m_progress));
        }

        public string Path { get; }

        public VerifyResult Result { get; } = new VerifyResult(); // Complete when Step has returned true.

        public double Fraction => m_progress.Fraction;

        public bool IsDone { get; private set; }

        public bool Step(double budgetMs)
        {
            if (IsDone)
                return true;
            try
            {
                IsDone = m_work.Tick(budgetMs);
            }
            catch (Exception e)
            {
                Result.Add(PointCloudException.Of(Path, e).FullMessage);
                IsDone = true;
            }
            return IsDone;
        }

        public string Describe()
        {
            if (!IsDone)
                return "verifying: " + Fraction.ToString("P0", CultureInfo.InvariantCulture);
            if (Result.Ok)
                return Result.Points.ToString("N0", CultureInfo.InvariantCulture) + " points are as they were converted" +
                    (Result.IsBuilding ? ", as far as the cloud is finished" : "");
            string more = Result.ProblemCount > Result.Problems.Count ? "\nand " +
                (Result.ProblemCount - Result.Problems.Count) + " more" : "";
            return Result.ProblemCount + " problems:\n" + string.Join("\n", Result.Problems) + more;
        }

        public void Dispose()
        {
            m_work.Cancel();
            IsDone = true;
        }
    }
}
