using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>How near one another the sampled points of a level are. Lengths are in CRS units.</summary>
    internal struct LevelSpacing
    {
        /// <summary>Smallest distance between two points that were sampled together, in one chunk or in one pass of the upper
        /// levels, across nodes; infinity if there are no two.</summary>
        public double MinDistance;

        public double MinDistanceAcrossChunks;
        public long NearAcrossChunks; // Number of sampled points at the sides of chunks with another one nearer than the spacing.

        public static LevelSpacing None => new LevelSpacing
        {
            MinDistance = double.PositiveInfinity,
            MinDistanceAcrossChunks = double.PositiveInfinity,
        };
    }

    /// <summary>Measures how evenly the samplers have chosen the points of a sound cloud: in each file, and across chunks, inside
    /// which alone they keep their distance.</summary>
    internal sealed unsafe class MeasureSpacing : IDisposable
    {
        readonly CloudFolder m_folder;
        readonly List<LevelSpacing> m_levels;

        /// <summary>By level: the smallest of its nodes', and the points that others of other chunks may be close to.</summary>
        readonly List<double> m_spacings = new List<double>();
        readonly List<NativeList<double3>> m_atSides = new List<NativeList<double3>>();

        MeasureSpacing(CloudFolder folder, List<LevelSpacing> levels)
        {
            m_folder = folder;
            m_levels = levels;
        }

        /// <summary>Coroutine.</summary>
        /// <param name="levels">Receives what was found, by level.</param>
        /// <exception cref="PointCloudException">The cloud cannot be read.</exception>
        public static IEnumerator<JobStep> Run(string cloud, List<LevelSpacing> levels)
        {
            using var folder = CloudFolder.Open(cloud);
            // One file does not tell chunks apart, and all of its points may not fit into memory.
            if (folder.Manifest.IsSingleFile)
                yield break;
            using var measure = new MeasureSpacing(folder, levels);
            yield return JobStep.Of(CoroutineGroup.Run(measure.Containers(), JobsUtility.JobWorkerCount + 1));
            for (int level = 0; level < levels.Count; level++)
            {
                var found = levels[level];
                yield return JobStep.Of(CountNear(measure.m_atSides[level], measure.m_spacings[level],
                    (smallest, near) => (found.MinDistanceAcrossChunks, found.NearAcrossChunks) = (smallest, near)));
                levels[level] = found;
            }
        }

        public void Dispose()
        {
            foreach (var points in m_atSides)
                points.Dispose();
            m_atSides.Clear();
        }

        IEnumerable<IEnumerator<JobStep>> Containers()
        {
            var pagesOfContainer = new SortedDictionary<string, List<int>>(StringComparer.Ordinal);
            int page = 0;
            foreach (var table in m_folder.EachTable())
            {
                if (!pagesOfContainer.TryGetValue(m_folder.PlanesPathOf(page), out var pages))
                    pagesOfContainer.Add(m_folder.PlanesPathOf(page), pages = new List<int>());
                pages.Add(page++);
            }
            foreach (var pages in pagesOfContainer.Values)
                yield return Measure(pages);
        }

        IEnumerator<JobStep> Measure(List<int> pages)
        {
            using var nodes = new CloudSelection(m_folder);
            nodes.ChooseSampled(0, int.MaxValue, pages);
            if (nodes.NodeCount == 0)
                yield break;
            using var batch = new PointBatch(LoadNodes.SchemaFor(m_folder), nodes.PointCountOrThrow, Allocator.Persistent);
            yield return JobStep.Of(LoadNodes.Run(m_folder, nodes, batch, null));
            var job = JobFor(nodes, batch);
            var done = job.Schedule();
            try
            {
                yield return done;
                done.Complete();
                AddResults(job);
            }
            finally
            {
                done.Complete();
                job.Dispose();
            }
        }

        /// <summary>What was sampled together: points of a level, and those that upper levels left of other nodes' tops
        /// apart.</summary>
        MeasureGroupsJob JobFor(CloudSelection nodes, PointBatch batch)
        {
            var container = default(ContainerRecord);
            var ranges = new SortedDictionary<(int Level, bool IsTop, int SamplingGroup), List<NodeRange>>();
            int at = 0;
            foreach (int page in nodes.Pages)
                foreach (int n in nodes.NodesOf(page))
                {
                    container = m_folder.PlanesContainerOf(page);
                    var node = nodes.TableOf(page).Nodes[n];
                    var key = (m_folder.Manifest.Root.SideLog2 - node.SideLog2, (node.Flags & NodeRecord.TopFlag) != 0,
                        node.SamplingGroup);
                    if (!ranges.TryGetValue(key, out var ofGroup))
                        ranges.Add(key, ofGroup = new List<NodeRange>());
                    double spacing = math.cmin(m_folder.Manifest.Grid.Step) * math.pow(2.0, node.CellLog2);
                    ofGroup.Add(new NodeRange { First = at, Count = node.PointCount, Spacing = spacing });
                    at += node.PointCount;
                }
            var groups = new List<SampledGroup>();
            var all = new List<NodeRange>();
            foreach (var (key, ofGroup) in ranges)
            {
                var group = new SampledGroup { Level = key.Level, IsTop = key.IsTop, Spacing = double.PositiveInfinity };
                foreach (var range in ofGroup)
                {
                    group.Count += range.Count;
                    group.Spacing = math.min(group.Spacing, range.Spacing);
                    all.Add(range);
                }
                groups.Add(group);
            }
            var root = m_folder.Manifest.Root;
            var cube = container.Cube;
            var corner = cube.Corner - root.Corner;
            var step = m_folder.Manifest.Grid.Step;
            var min = new double3(corner.X, corner.Y, corner.Z) * step;
            return new MeasureGroupsJob
            {
                Batch = batch.Bytes,
                X = batch.Column(0),
                Y = batch.Column(1),
                Z = batch.Column(2),
                Step = step,
                Groups = new NativeArray<SampledGroup>(groups.ToArray(), Allocator.Persistent),
                Nodes = new NativeArray<NodeRange>(all.ToArray(), Allocator.Persistent),
                Points = new NativeArray<double3>(at, Allocator.Persistent),
                Scratch = new NativeArray<int>(NeighbourGrid.ScratchOf(at), Allocator.Persistent),
                CubeMin = min,
                CubeMax = min + step * (double)cube.Side,
                IsWhole = cube.SideLog2 == root.SideLog2,
                AtSides = new NativeList<double3>(Allocator.Persistent),
            };
        }

        void AddResults(in MeasureGroupsJob job)
        {
            int first = 0;
            foreach (var group in job.Groups)
            {
                while (m_levels.Count <= group.Level)
                {
                    m_levels.Add(LevelSpacing.None);
                    m_spacings.Add(double.PositiveInfinity);
                    m_atSides.Add(new NativeList<double3>(16, Allocator.Persistent));
                }
                m_spacings[group.Level] = math.min(m_spacings[group.Level], group.Spacing);
                if (group.AtSides > 0)
                    m_atSides[group.Level].AddRange(job.AtSides.AsArray().GetSubArray(first, group.AtSides));
                first += group.AtSides;
                var level = m_levels[group.Level];
                if (!group.IsTop)
                    level.MinDistance = math.min(level.MinDistance, group.MinDistance);
                m_levels[group.Level] = level;
            }
        }

        /// <summary>Coroutine: the smallest distance between any two points, and the number of points that have another one
        /// nearer than a spacing.</summary>
        public static IEnumerator<JobStep> CountNear(NativeList<double3> points, double spacing, Action<double, long> done)
        {
            double smallest = ClosestInOrder(points);
            // The nearest two are at most as far apart as a cell is large.
            double limit = math.max(spacing, smallest);
            long near = 0;
            if (limit > 0 && !double.IsInfinity(limit))
            {
                using var scratch = new NativeArray<int>(NeighbourGrid.ScratchOf(points.Length), Allocator.Persistent);
                using var distances = new NativeArray<double>(points.Length, Allocator.Persistent);
                var found = Find(points, limit, scratch, distances);
                try
                {
                    yield return found;
                }
                finally
                {
                    found.Complete();
                }
                foreach (double distance in distances)
                {
                    smallest = math.min(smallest, distance);
                    // Rounding of double coordinates is far below this; a distance that is exactly the spacing is not nearer.
                    near += distance < spacing * (1 - 1e-9) ? 1 : 0;
                }
            }
            done(smallest, near);
        }

        static double ClosestInOrder(NativeList<double3> points) =>
            NeighbourGrid.ClosestInOrder((double3*)points.GetUnsafeReadOnlyPtr(), points.Length);

        static JobHandle Find(NativeList<double3> points, double limit, NativeArray<int> scratch, NativeArray<double> distances)
        {
            var grid = new NeighbourGrid((double3*)points.GetUnsafeReadOnlyPtr(), points.Length, limit,
                (int*)scratch.GetUnsafePtr());
            grid.Add(0, points.Length);
            return new FindNearestJob { Grid = grid, Distances = distances }.Schedule(points.Length, 1024);
        }
    }

    internal struct NodeRange
    {
        public int First;
        public int Count;
        public double Spacing;
    }

    internal struct SampledGroup
    {
        public int Count;
        public int Level; // Counted from the root.
        public double Spacing; // Points nearer than this to the file's cube's sides may have neighbours beyond them; CRS units.
        public bool IsTop; // Whether they are what upper levels left of other nodes' tops, which were not sampled together.
        public double MinDistance; // Out: the smallest distance between two of the points, and how many are at the sides.
        public int AtSides;
    }

    /// <summary>Measures a file's points that were sampled together, and lists those at the sides of its cube.</summary>
    [BurstCompile]
    internal unsafe struct MeasureGroupsJob : IJob, IDisposable
    {
        [ReadOnly] public NativeArray<byte> Batch;
        public PointColumn X, Y, Z;
        public double3 Step;
        public NativeArray<SampledGroup> Groups;
        [ReadOnly] public NativeArray<NodeRange> Nodes; // The groups' nodes, one group after the other.
        public NativeArray<double3> Points; // Scratch: the points in that order, in CRS units from the cloud's corner.
        public NativeArray<int> Scratch;
        public double3 CubeMin;
        public double3 CubeMax;
        public bool IsWhole; // Whether all points are listed, not only those at the sides.
        public NativeList<double3> AtSides; // Out, group by group.

        public void Execute()
        {
            var bytes = (byte*)Batch.GetUnsafeReadOnlyPtr();
            var points = (double3*)Points.GetUnsafePtr();
            int at = 0;
            for (int n = 0; n < Nodes.Length; n++)
                for (int i = Nodes[n].First; i < Nodes[n].First + Nodes[n].Count; i++)
                    points[at++] = new double3(((double*)(bytes + X.OffsetBytes))[i], ((double*)(bytes + Y.OffsetBytes))[i],
                        ((double*)(bytes + Z.OffsetBytes))[i]) * Step;
            for (int g = 0; g < Groups.Length; g++)
            {
                var group = Groups[g];
                group.MinDistance = NeighbourGrid.ClosestPair(points, group.Count, (int*)Scratch.GetUnsafePtr());
                for (int i = 0; i < group.Count; i++)
                {
                    if (!IsWhole && math.cmin(math.min(points[i] - CubeMin, CubeMax - points[i])) >= group.Spacing)
                        continue;
                    AtSides.Add(points[i]);
                    group.AtSides++;
                }
                Groups[g] = group;
                points += group.Count;
            }
        }

        public void Dispose()
        {
            Groups.Dispose();
            Nodes.Dispose();
            Points.Dispose();
            Scratch.Dispose();
            AtSides.Dispose();
        }
    }

    [BurstCompile]
    internal unsafe struct FindNearestJob : IJobParallelFor
    {
        public NeighbourGrid Grid;

        [WriteOnly] public NativeArray<double> Distances;

        public void Execute(int index) => Distances[index] = Grid.DistanceOf(index);
    }
}
