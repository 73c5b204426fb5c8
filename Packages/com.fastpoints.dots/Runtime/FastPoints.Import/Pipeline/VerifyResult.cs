using System.Collections.Generic;

namespace FastPoints.Pipeline
{
    /// <summary>What a proof of a stored cloud has found.</summary>
    public sealed class VerifyResult
    {
        /// <summary>One level of the octree.</summary>
        public struct Level
        {
            public int Nodes;
            public long Points;

            /// <summary>Edge of the finest sampling cells of the level's nodes, in CRS units; 0 where all are leaves.</summary>
            public double Spacing;

            /// <summary>Smallest distance between two points of one node, in CRS units; infinity where no node has two.</summary>
            public double MinDistance;
        }

        /// <summary>The cloud is in the making: what is finished of it was verified.</summary>
        public bool IsBuilding;

        public const int MaxProblems = 100;

        readonly List<string> m_problems = new List<string>();

        /// <summary>One line each; the first <see cref="MaxProblems"/>.</summary>
        public IReadOnlyList<string> Problems => m_problems;
        public bool Ok => ProblemCount == 0;
        public int ProblemCount { get; private set; }

        /// <summary>Points that were read and found right.</summary>
        public long Points;

        /// <summary>By level; level 0 has the root's cube.</summary>
        public readonly List<Level> Levels = new List<Level>();

        public void Add(string problem)
        {
            ProblemCount++;
            if (m_problems.Count < MaxProblems)
                m_problems.Add(problem);
        }
    }
}
