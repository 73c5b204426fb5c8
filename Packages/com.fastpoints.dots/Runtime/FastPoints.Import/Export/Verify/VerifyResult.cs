using System.Collections.Generic;

namespace FastPoints.Export
{
    /// <summary>The result of verifying a stored cloud.</summary>
    public sealed class VerifyResult
    {
        /// <summary>Statistics of one level of the octree.</summary>
        public struct Level
        {
            public int Nodes;
            public long Points;

            /// <summary>Edge of the finest sampling cells of the level's nodes in CRS units; 0 if all are leaves.</summary>
            public double Spacing;

            /// <summary>Number of points in nodes that have a spacing: neither leaves nor chains at one place.</summary>
            public long SampledPoints;

            /// <summary>Smallest distance between two points that were sampled together, in one chunk or in one go of the upper
            /// levels, across nodes; in CRS units, infinity if there are no two.</summary>
            public double MinDistance;

            /// <summary>The same for sampled points of any chunks.</summary>
            public double MinDistanceAcrossChunks;

            /// <summary>Number of sampled points at the sides of chunks with another one nearer than the spacing.</summary>
            public long NearAcrossChunks;

            public static Level None => new Level
            {
                MinDistance = double.PositiveInfinity,
                MinDistanceAcrossChunks = double.PositiveInfinity,
            };
        }

        /// <summary>Whether the cloud is in the making, so that only finished parts were verified.</summary>
        public bool IsBuilding;

        public const int MaxProblems = 100;

        readonly List<string> m_problems = new List<string>();

        /// <summary>The first <see cref="MaxProblems"/> problems, one line each.</summary>
        public IReadOnlyList<string> Problems => m_problems;
        public bool Ok => ProblemCount == 0;
        public int ProblemCount { get; private set; }

        /// <summary>Number of points that were read and found correct.</summary>
        public long Points;

        /// <summary>Statistics of each level; level 0 has the root's cube.</summary>
        public readonly List<Level> Levels = new List<Level>();

        public void Add(string problem)
        {
            ProblemCount++;
            if (m_problems.Count < MaxProblems)
                m_problems.Add(problem);
        }
    }
}
