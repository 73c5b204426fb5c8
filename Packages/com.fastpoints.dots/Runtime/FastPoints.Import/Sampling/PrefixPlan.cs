using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Sampling
{
    /// <summary>Plans how many points a sample of prefixes takes from which blocks, wave by wave: first some blocks spread over
    /// the source, then all of them, then more of each, in proportion to their points. For a source with an octree it takes
    /// levels from the top, all of them whole except the last.</summary>
    sealed class PrefixPlan
    {
        /// <summary>The fewest points that are worth starting a block for: if all blocks would get fewer, fewer blocks
        /// are chosen.</summary>
        public const int MinPoints = 50;

        readonly PointReader m_reader;
        readonly SampleOrder m_order;

        /// <summary>Of a remote source each block costs a request: as many, if each has its share of a large sample.</summary>
        public const int MaxRemoteBlocks = 160;
        readonly int m_pointsPerBlock; // What each block of a large remote source gives, once; 0 for others.

        int m_next;

        /// <summary>Points taken so far, for the few among millions of blocks that have any taken.</summary>
        readonly Dictionary<int, int> m_taken = new Dictionary<int, int>();
        readonly List<List<int>> m_levels; // Blocks of each level of the source's own octree, or null.

        public PrefixPlan(PointReader reader, int wanted, uint seed)
        {
            m_reader = reader;
            int blocks = reader.BlockCount > 0 ? Math.Min(MaxRemoteBlocks, reader.BlockCount) : MaxRemoteBlocks;
            m_pointsPerBlock = reader.TakesFewRanges ? Math.Max(MinPoints, (wanted + blocks - 1) / blocks) : 0;
            m_order = new SampleOrder(Math.Max(1, reader.BlockCount), seed);
            if (reader.Tree == null)
                return;
            m_levels = new List<List<int>>();
            for (int i = 0; i < reader.Tree.NodeCount; i++)
            {
                var node = reader.Tree[i];
                while (m_levels.Count <= node.Level)
                    m_levels.Add(new List<int>());
                if (node.Block >= 0)
                    m_levels[node.Level].Add(node.Block);
            }
        }

        public int Taken { get; private set; }

        /// <summary>Returns what the next wave takes from which blocks until <paramref name="wanted"/> points are taken in
        /// all.</summary>
        public List<PrefixRange> Next(int wanted)
        {
            var prefixes = new List<PrefixRange>();
            if (m_levels == null && m_pointsPerBlock > 0)
            {
                TakeRemote(wanted, prefixes);
                return prefixes;
            }
            if (m_levels == null)
            {
                AddPrefixes(Choose(wanted), wanted, wanted, prefixes);
                return prefixes;
            }
            // The levels above are taken whole, and are not shared out here.
            long left = wanted;
            foreach (var level in m_levels)
            {
                long points = PointsOf(level);
                AddPrefixes(level, (int)Math.Min(left, points), wanted, prefixes);
                left -= points;
                if (left <= 0)
                    break;
            }
            return prefixes;
        }

        /// <summary>Distributes <paramref name="wanted"/> points among the blocks, minus those taken before.</summary>
        /// <param name="max">The most points that are taken in all.</param>
        void AddPrefixes(List<int> blocks, int wanted, int max, List<PrefixRange> prefixes)
        {
            long points = PointsOf(blocks), before = 0;
            foreach (int block in blocks)
            {
                int inBlock = m_reader.PointsInBlock(block);
                // Counts are differences of rounded sums, so that they add up.
                int count = (int)(Proportion(before + inBlock, points, wanted) - Proportion(before, points, wanted));
                before += inBlock;
                m_taken.TryGetValue(block, out int taken);
                count = Math.Min(count, inBlock) - taken;
                // If an earlier wave of fewer blocks took more than its share of some, the last ones wait for the next wave.
                count = Math.Min(count, max - Taken);
                if (count <= 0)
                    continue;
                prefixes.Add(new PrefixRange { Block = block, First = taken, Count = count, FirstInSample = Taken });
                m_taken[block] = taken + count;
                Taken += count;
            }
        }

        /// <summary>No block is read twice: each wave has other ones, spread over the source.</summary>
        void TakeRemote(int wanted, List<PrefixRange> prefixes)
        {
            for (; Taken < wanted && m_next < Math.Max(m_order.Length, m_reader.BlockCount); m_next++)
            {
                int block = AreBlocksShuffled ? m_next : m_order.StratumAt(m_next);
                if (block < 0 || block >= m_reader.BlockCount)
                    continue;
                int count = Math.Min(Math.Min(m_pointsPerBlock, m_reader.PointsInBlock(block)), wanted - Taken);
                prefixes.Add(new PrefixRange { Block = block, Count = count, FirstInSample = Taken });
                Taken += count;
            }
        }

        // Blocks at random offsets are spread already.
        bool AreBlocksShuffled => m_reader is LineReader && !m_reader.BlocksAreKnown;

        long PointsOf(List<int> blocks)
        {
            long points = 0;
            foreach (int block in blocks)
                points += m_reader.PointsInBlock(block);
            return points;
        }

        /// <summary>Computes floor(part * wanted / whole) with the product split so that it does not overflow.</summary>
        static long Proportion(long part, long whole, int wanted) =>
            whole == 0 ? 0 : part / whole * wanted + part % whole * (wanted / whole) + part % whole * (wanted % whole) / whole;

        /// <summary>Chooses blocks spread over the source: as many as get <see cref="MinPoints"/> each, and more if they do
        /// not have as many.</summary>
        List<int> Choose(int wanted)
        {
            var blocks = new List<int>();
            long points = 0;
            int count = AreBlocksShuffled ? m_reader.BlockCount : m_order.Length;
            for (int index = 0; index < count; index++)
            {
                if (blocks.Count > wanted / MinPoints && points >= wanted)
                    break;
                int block = AreBlocksShuffled ? index : m_order.StratumAt(index);
                if (block < 0 || block >= m_reader.BlockCount)
                    continue;
                blocks.Add(block);
                points += m_reader.PointsInBlock(block);
            }
            blocks.Sort();
            return blocks;
        }
    }

    /// <summary>Points of a block's prefix that one wave adds to those of earlier waves, and where they go.</summary>
    struct PrefixRange
    {
        public int Block;

        public int First;

        public int Count;
        public int FirstInSample; // Its first point's index in the sample.
    }
}
