using System;
using System.Globalization;
using FastPoints.Build;

namespace FastPoints.Editor
{
    internal static class ConversionProgress
    {
        struct Weight
        {
            public string Stage;
            public double Fraction;
        }

        /// <summary>Each stage's share of the time: the mean of 5 M points of LAZ and 5 M of LAS, both in memory, on two cores.
        /// It suits a progress bar, no more: points that go to files and other samplers shift it.</summary>
        static readonly Weight[] s_weights =
        {
            new Weight { Stage = BuildStages.Sample, Fraction = 0.08 },
            new Weight { Stage = BuildStages.Read, Fraction = 0.40 },
            new Weight { Stage = BuildStages.Split, Fraction = 0.01 },
            new Weight { Stage = BuildStages.Index, Fraction = 0.44 },
            new Weight { Stage = BuildStages.Merge, Fraction = 0.06 },
            new Weight { Stage = BuildStages.Finish, Fraction = 0.01 },
        };

        /// <summary>Share of the whole build, or of the normals, that is done, 0 to 1; it never falls during a build.</summary>
        public static double FractionOf(StageProgress progress)
        {
            int finished = progress.Finished.Count;
            string stage = progress.Current ?? (finished > 0 ? progress.Finished[finished - 1].Name : null);
            if (stage == AddNormals.Stage)
                return progress.Fraction;
            double before = 0;
            foreach (var weight in s_weights)
            {
                if (weight.Stage == stage)
                    return Math.Min(1, before + weight.Fraction * progress.Fraction);
                before += weight.Fraction;
            }
            return 0;
        }

        public static string Describe(StageProgress progress)
        {
            if (progress.Current == null)
                return "opening";
            double speed = progress.PointsPerSecond;
            return speed <= 0 ? progress.Current : string.Format(CultureInfo.InvariantCulture, speed < 1e6
                ? "{0}: {1:0} thousand points/s" : "{0}: {2:0.0} million points/s", progress.Current, speed * 1e-3, speed * 1e-6);
        }
    }
}
