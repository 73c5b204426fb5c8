using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Sampling
{
    /// <summary>Chooses the ranges of records that a sample reads, spread evenly over a source.</summary>
    internal static class SampleRanges
    {
        const int MinRanges = 16;
        const int PointsPerSampled = 8; // The sample of a larger source has at most one of this many points.

        /// <param name="reader">A reader whose blocks are known.</param>
        /// <param name="maxRanges">The most ranges; fewer and longer ones if only prefixes of blocks are cheap.</param>
        /// <param name="rangePoints">Records of a range.</param>
        /// <returns>The ranges in the order of the source. None is empty.</returns>
        public static List<BlockRange> Choose(PointReader reader, long maxRanges, int rangePoints)
        {
            var ranges = new List<BlockRange>();
            long points = reader.PointCount;
            int blocks = reader.BlockCount;
            if (points == 0)
                return ranges;
            long wanted = Math.Max(MinRanges, Math.Min(maxRanges, points / (PointsPerSampled * rangePoints)));
            long length = Math.Max(1, Math.Min(rangePoints, (points + wanted - 1) / wanted));
            if (!reader.HasCheapRanges)
            {
                // Only prefixes of blocks are cheap: they are longer if there are fewer.
                long chosen = Math.Min(wanted, blocks);
                length = wanted * length / chosen;
                for (long i = 0; i < chosen; i++)
                {
                    int block = (int)(i * blocks / chosen);
                    int count = (int)Math.Min(length, reader.PointsInBlock(block));
                    if (count > 0)
                        ranges.Add(new BlockRange(block, 0, count));
                }
                return ranges;
            }
            int at = 0;
            for (long i = 0; i < wanted && i * length < points; i++)
            {
                long first = Math.Max(points / wanted, length) * i;
                while (first >= reader.FirstPointOfBlock(at) + reader.PointsInBlock(at))
                    at++;
                int inBlock = (int)(first - reader.FirstPointOfBlock(at));
                ranges.Add(new BlockRange(at, inBlock, (int)Math.Min(length, reader.PointsInBlock(at) - inBlock)));
            }
            return ranges;
        }
    }
}
