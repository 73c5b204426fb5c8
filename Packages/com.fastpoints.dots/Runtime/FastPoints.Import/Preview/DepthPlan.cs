using System;
using System.Collections.Generic;
using FastPoints.Files;

namespace FastPoints.Preview
{
    /// <summary>
    /// In which order all points of a source are read, so that little of it is bare at any time. Where blocks are few enough for
    /// a decoder state each: a slice of every block, then more of those whose last slice came to most cells that were bare, then
    /// the rest. Otherwise whole blocks, spread over the source.
    /// </summary>
    /// <remarks>
    /// Slices come in rounds: the next round is chosen by what all of the last one found, so that the order depends on no number
    /// of slots or threads. Measured on clouds in the order of an octree, at half of the points, cells of which the full scan
    /// leaves 16 % bare: half of every block leaves 47 % bare, every second block 48 %, this 34 %.
    /// </remarks>
    public sealed class DepthPlan
    {
        /// <summary>A LAZ decoder's state takes about 0.3 MB.</summary>
        public const int MostSlicedBlocks = 128;

        const int SlicesPerBlock = 8;

        /// <summary>Of the blocks, one in so many is read from in a round.</summary>
        const int BlocksPerRange = 6;

        readonly PointReader m_reader;
        readonly List<int> m_order = new List<int>();
        readonly int[] m_taken;
        readonly double[] m_gain;
        int m_begun;

        /// <param name="canSlice">Whether a block can be gone on with where it was left.</param>
        public DepthPlan(PointReader reader, bool canSlice, uint seed)
        {
            m_reader = reader;
            IsSliced = canSlice && reader.BlockCount <= MostSlicedBlocks;
            m_taken = new int[reader.BlockCount];
            m_gain = new double[reader.BlockCount];
            var order = new SampleOrder(Math.Max(1, reader.BlockCount), seed);
            for (int place = 0; place < order.Places; place++)
            {
                int block = order.StratumAt(place);
                if (block >= 0 && block < m_taken.Length && reader.PointsInBlock(block) > 0)
                    m_order.Add(block);
            }
        }

        public bool IsSliced { get; }

        /// <summary>Points of the ranges that were given out.</summary>
        public long Taken { get; private set; }

        /// <summary>The ranges to read next; none when <paramref name="until"/> points were given out.</summary>
        public List<BlockRange> Next(long until)
        {
            var ranges = new List<BlockRange>();
            if (Taken >= until)
                return ranges;
            if (IsSliced && until >= m_reader.PointCount)
            {
                for (int block = 0; block < m_taken.Length; block++)
                    Take(block, int.MaxValue, ranges);
                return ranges;
            }
            if (m_begun < m_order.Count)
            {
                while (m_begun < m_order.Count && Taken < until && ranges.Count < RoundOf(m_order.Count))
                {
                    int block = m_order[m_begun++];
                    Take(block, IsSliced ? SliceOf(block) : int.MaxValue, ranges);
                }
                // Blocks of one file one after the other.
                ranges.Sort((a, b) => a.Block.CompareTo(b.Block));
                return ranges;
            }
            var best = new List<int>();
            foreach (int block in m_order)
                if (m_taken[block] < m_reader.PointsInBlock(block))
                    best.Add(block);
            best.Sort((a, b) => m_gain[a] != m_gain[b] ? m_gain[b].CompareTo(m_gain[a])
                : m_taken[a] != m_taken[b] ? m_taken[a].CompareTo(m_taken[b]) : a.CompareTo(b));
            for (int i = 0; i < best.Count && i < RoundOf(m_order.Count) && Taken < until; i++)
                Take(best[i], SliceOf(best[i]), ranges);
            return ranges;
        }

        /// <summary>Tells what a range has brought.</summary>
        /// <param name="points">Fewer than were asked for where the block is broken: nothing more is asked of it.</param>
        /// <param name="cells">Cells that were bare before.</param>
        public void Tell(BlockRange range, int points, int cells)
        {
            m_gain[range.Block] = cells / (double)Math.Max(1, range.Count);
            if (points == range.Count)
                return;
            Taken += m_reader.PointsInBlock(range.Block) - m_taken[range.Block];
            m_taken[range.Block] = m_reader.PointsInBlock(range.Block);
        }

        /// <summary>Whether a block is given out to its end.</summary>
        public bool IsTaken(int block) => m_taken[block] == m_reader.PointsInBlock(block);

        static int RoundOf(int blocks) => Math.Min(MostSlicedBlocks, (blocks + BlocksPerRange - 1) / BlocksPerRange);

        int SliceOf(int block) => (m_reader.PointsInBlock(block) + SlicesPerBlock - 1) / SlicesPerBlock;

        void Take(int block, int most, List<BlockRange> ranges)
        {
            int count = Math.Min(most, m_reader.PointsInBlock(block) - m_taken[block]);
            if (count == 0)
                return;
            ranges.Add(new BlockRange(block, m_taken[block], count));
            m_taken[block] += count;
            Taken += count;
        }
    }
}
