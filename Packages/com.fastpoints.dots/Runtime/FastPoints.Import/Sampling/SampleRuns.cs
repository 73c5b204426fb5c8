using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Sampling
{
    /// <summary>Chooses runs of records, spread evenly over a source, that a sample reads.</summary>
    internal static class SampleRuns
    {
        const int MinRuns = 16;

        /// <summary>The sample of a larger source has at most one of this many points.</summary>
        const int PointsPerSampled = 8;

        /// <param name="reader">A reader whose blocks are known.</param>
        /// <param name="maxRuns">The most runs; fewer and longer ones if only prefixes of blocks are cheap.</param>
        /// <param name="runPoints">Records of a run.</param>
        /// <returns>The runs in the order of the source. None is empty.</returns>
        public static List<BlockRange> Choose(PointReader reader, long maxRuns, int runPoints)
        {
            var runs = new List<BlockRange>();
            long points = reader.PointCount;
            int blocks = reader.BlockCount;
            if (points == 0)
                return runs;
            long wanted = Math.Max(MinRuns, Math.Min(maxRuns, points / (PointsPerSampled * runPoints)));
            long length = Math.Max(1, Math.Min(runPoints, (points + wanted - 1) / wanted));
            if (!reader.HasFixedStride)
            {
                // Only prefixes of blocks are cheap: they are longer if there are fewer.
                long chosen = Math.Min(wanted, blocks);
                length = wanted * length / chosen;
                for (long i = 0; i < chosen; i++)
                {
                    int block = (int)(i * blocks / chosen);
                    int count = (int)Math.Min(length, reader.PointsInBlock(block));
                    if (count > 0)
                        runs.Add(new BlockRange(block, 0, count));
                }
                return runs;
            }
            int at = 0;
            for (long i = 0; i < wanted && i * length < points; i++)
            {
                long first = Math.Max(points / wanted, length) * i;
                while (first >= reader.FirstPointOfBlock(at) + reader.PointsInBlock(at))
                    at++;
                int inBlock = (int)(first - reader.FirstPointOfBlock(at));
                runs.Add(new BlockRange(at, inBlock, (int)Math.Min(length, reader.PointsInBlock(at) - inBlock)));
            }
            return runs;
        }
    }
}
