using System;
using System.Collections.Generic;
using FastPoints.Reading;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Export
{
    internal struct ExportRange
    {
        public BlockRange Range;
        public double Fraction; // 1 for all.

        public int Node;
        public bool IsLastOfNode; // No other range of the same node follows.
        int m_level; // By the source's octree; 0 without one.

        public static int MaxPointsOf(IReadOnlyList<ExportRange> ranges)
        {
            int maxPoints = 1;
            foreach (var range in ranges)
                maxPoints = Math.Max(maxPoints, range.Range.Count);
            return maxPoints;
        }

        /// <summary>Chooses by level and budget, and leaves nodes out that no clip box keeps anything of.</summary>
        /// <returns>In the order of the source.</returns>
        /// <exception cref="PointCloudException">A level is wanted, and there is no octree.</exception>
        public static List<ExportRange> Choose(PointReader reader, ExportSettings settings)
        {
            var ranges = All(reader, settings.LocalClips(), out bool hasLevels);
            if (settings.Level >= 0 && !hasLevels)
                throw new PointCloudException(FailureCode.Unsupported, reader.Info.Path, -1,
                    "has no octree whose levels could be chosen: convert it first, or take a budget");
            var pointsOfLevel = new SortedDictionary<int, long>();
            foreach (var range in ranges)
            {
                pointsOfLevel.TryGetValue(range.m_level, out long points);
                pointsOfLevel[range.m_level] = points + range.Range.Count;
            }
            return Join(ranges, ShareOfLevel(pointsOfLevel, settings));
        }

        /// <returns>True: tasks return something.</returns>
        /// <exception cref="PointCloudException">The target is a file of the source.</exception>
        public static bool ThrowIfSource(PointReader reader, string path)
        {
            var files = new HashSet<string>();
            for (int block = 0; block < reader.BlockCount; block++)
                if (files.Add(reader.FileOfBlock(block, out _)) && string.Equals(SourcePath.Full(
                    reader.FileOfBlock(block, out _)), path, StringComparison.OrdinalIgnoreCase))
                    throw new PointCloudException(FailureCode.WriteFailed, path, -1, "is the source, and would be overwritten");
            return true;
        }

        static Dictionary<int, double> ShareOfLevel(SortedDictionary<int, long> pointsOfLevel, ExportSettings settings)
        {
            var shares = new Dictionary<int, double>();
            long left = settings.Budget > 0 ? settings.Budget : long.MaxValue;
            foreach (var level in pointsOfLevel)
            {
                bool isWanted = settings.Level < 0 || level.Key <= settings.Level;
                shares[level.Key] = !isWanted ? 0 : Math.Min(1, left / (double)level.Value);
                left -= isWanted ? Math.Min(left, level.Value) : 0;
            }
            return shares;
        }

        /// <summary>Drops what is not wanted, and reads parts of a block that follow one another in one go.</summary>
        static List<ExportRange> Join(List<ExportRange> ranges, Dictionary<int, double> shareOfLevel)
        {
            var joined = new List<ExportRange>();
            foreach (var range in ranges)
            {
                var next = range;
                next.Fraction = shareOfLevel[range.m_level];
                if (next.Fraction <= 0 || range.Range.Count == 0)
                    continue;
                var before = joined.Count > 0 ? joined[joined.Count - 1] : default;
                if (joined.Count > 0 && before.Range.Block == range.Range.Block && before.Fraction == 1 && next.Fraction == 1)
                {
                    next.Range = new BlockRange(range.Range.Block, before.Range.First, before.Range.Count + range.Range.Count);
                    joined.RemoveAt(joined.Count - 1);
                }
                joined.Add(next);
            }
            return joined;
        }

        static List<ExportRange> All(PointReader reader, LocalClip[] clips, out bool hasLevels)
        {
            var stored = reader as ConvertedReader;
            hasLevels = stored != null || reader.Tree != null;
            var nodeOfBlock = new int[reader.BlockCount];
            for (int block = 0; block < nodeOfBlock.Length; block++)
                nodeOfBlock[block] = -1;
            for (int node = 0; node < (reader.Tree?.NodeCount ?? 0); node++)
                if (reader.Tree[node].Block >= 0)
                    nodeOfBlock[reader.Tree[node].Block] = node;
            var order = new int[reader.BlockCount];
            var orders = new long[order.Length];
            for (int block = 0; block < order.Length; block++)
            {
                order[block] = block;
                orders[block] = reader.OrderOfBlock(block);
            }
            Array.Sort(orders, order);

            var ranges = new List<ExportRange>();
            foreach (int block in order)
            {
                int points = reader.PointsInBlock(block);
                if (stored != null && MayKeepAny(clips, stored.CubeOf(block)))
                {
                    int own = stored.OwnPointsOf(block), level = stored.LevelOf(block);
                    ranges.Add(new ExportRange { Range = new BlockRange(block, 0, own), m_level = level });
                    ranges.Add(new ExportRange { Range = new BlockRange(block, own, points - own), m_level = level + 1 });
                }
                else if (stored == null && (nodeOfBlock[block] < 0 || MayKeepAny(clips, CubeOf(reader, nodeOfBlock[block]))))
                {
                    // What no node names is below all of them.
                    int level = !hasLevels ? 0 : nodeOfBlock[block] < 0 ? int.MaxValue : reader.Tree[nodeOfBlock[block]].Level;
                    ranges.Add(new ExportRange { Range = new BlockRange(block, 0, points), m_level = level });
                }
            }
            return ranges;
        }

        static BoundsGeo CubeOf(PointReader reader, int node)
        {
            var at = reader.Tree[node];
            double edge = reader.Tree.EdgeOfLevel(at.Level);
            var corner = reader.Tree.Cube.Min + new double3(at.Cell.x, at.Cell.y, at.Cell.z) * edge;
            return new BoundsGeo(corner, corner + edge);
        }

        /// <summary>False if the clips certainly leave nothing of a box.</summary>
        static unsafe bool MayKeepAny(LocalClip[] clips, BoundsGeo box)
        {
            // Writers round nodes' boxes: nothing is lost by a box that is a little larger.
            var half = box.Size * (0.5 + 1e-6) + math.abs(box.Center) * 1e-14;
            fixed (LocalClip* first = clips)
                return LocalClip.MayKeep(first, clips.Length, box.Center, half);
        }
    }

    /// <summary>What of a cloud is exported. The defaults are all of it.</summary>
    internal sealed class ExportSettings
    {
        public IReadOnlyList<ClipBox> Clips = Array.Empty<ClipBox>();

        /// <summary>The world of <see cref="Clips"/> = this * georeferenced position: without it, they are in the cloud's
        /// coordinates.</summary>
        public CloudPlacement GeoToWorld = new CloudPlacement(double3x3.identity, default);
        public int[] Classes; // From 0 to 255; null for all.
        public IPointFilter Filter; // Null for all points. Whoever sets it disposes it after the export.
        public string[] Attributes; // Beside the position; null for all.
        public int Level = -1; // The last level of the octree; -1 for all.

        /// <summary>The most points, spread over what the boxes leave: the first levels of an octree and a share of the next, or
        /// an even share of any other source; 0 for all.</summary>
        public long Budget;

        /// <summary>Of the conversion that COPC needs: see <see cref="FastPoints.Build.ConvertSettings.MemoryBytes"/>; 0 for
        /// its default.</summary>
        public long MemoryBytes;
        public double InFlightMs; // See FastPoints.Build.ConvertSettings.InFlightMs.

        public LocalClip[] LocalClips()
        {
            var clips = new LocalClip[Clips.Count];
            for (int i = 0; i < clips.Length; i++)
                clips[i] = new LocalClip(Clips[i], GeoToWorld);
            return clips;
        }
    }

    /// <summary>Chooses points of a source: the command line's conditions and polygons.</summary>
    internal interface IPointFilter
    {
        IEnumerable<string> Attributes { get; } // Names of the attributes that it reads, beside the position.

        ulong Hash { get; } // Differs between those that keep different points.

        IFilterSlot CreateSlot(PointBatch batch, in PositionTransform transform);
    }

    internal interface IFilterSlot : IDisposable
    {
        /// <summary>The number of points left in the batch, when the scheduled jobs are complete.</summary>
        NativeReference<DecodeResult> Result { get; }

        /// <param name="range">Of the reader that filters.</param>
        /// <param name="firstPoint">Number of the batch's first point in the source.</param>
        JobHandle Schedule(NativeReference<DecodeResult> decodedResult, BlockRange range, long firstPoint, JobHandle decoded);
    }
}
