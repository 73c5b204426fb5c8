using System;
using System.Globalization;
using FastPoints.Core;
using FastPoints.Export;
using FastPoints.Reading;

namespace FastPoints.Editor
{
    /// <summary>Verifies a converted cloud, one slice in each update: every file, table, hash, point and count. Main
    /// thread.</summary>
    internal sealed class CloudCheck : IDisposable
    {
        readonly JobCoroutine m_work;
        readonly StageProgress m_progress = new StageProgress();

        /// <param name="path">Path of the folder.</param>
        public CloudCheck(string path)
        {
            Path = path;
            m_work = new JobCoroutine(VerifyCloud.Run(path, Array.Empty<PointReader>(), Result, m_progress));
        }

        public string Path { get; }

        /// <summary>Complete when <see cref="Step"/> has returned true.</summary>
        public VerifyResult Result { get; } = new VerifyResult();

        /// <summary>Share of the points, 0 to 1.</summary>
        public double Share => m_progress.Share;

        public bool IsDone { get; private set; }

        /// <returns>Whether it is done.</returns>
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

        /// <summary>The result in one line or, if there are problems, several.</summary>
        public string Describe()
        {
            if (!IsDone)
                return "verifying: " + Share.ToString("P0", CultureInfo.InvariantCulture);
            if (Result.Ok)
                return Result.Points.ToString("N0", CultureInfo.InvariantCulture) + " points are as they were converted" +
                    (Result.IsBuilding ? ", as far as the cloud is finished" : "");
            string more = Result.ProblemCount > Result.Problems.Count ? "\nand " +
                (Result.ProblemCount - Result.Problems.Count) + " more" : "";
            return Result.ProblemCount + " problems:\n" + string.Join("\n", Result.Problems) + more;
        }

        /// <summary>Breaks it off.</summary>
        public void Dispose()
        {
            m_work.Cancel();
            IsDone = true;
        }
    }
}
