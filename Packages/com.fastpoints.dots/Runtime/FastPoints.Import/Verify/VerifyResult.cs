using System.Collections.Generic;

namespace FastPoints.Verify
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

            /// <summary>Points of nodes that have a spacing: neither leaves nor chains at one place.</summary>
            public long SampledPoints;

            /// <summary>Smallest distance between two points that were sampled together, of one chunk or in one go of the upper
            /// levels, whichever nodes they are of; in CRS units, infinity where there are no two.</summary>
            public double MinDistance;

            /// <summary>The same for sampled points of any chunks.</summary>
            public double MinDistanceAcrossChunks;

            /// <summary>Sampled points at the sides of chunks with another one nearer than the spacing.</summary>
            public long NearAcrossChunks;

            public static Level None => new Level
            {
                MinDistance = double.PositiveInfinity,
                MinDistanceAcrossChunks = double.PositiveInfinity,
            };
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
