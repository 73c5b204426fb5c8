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
