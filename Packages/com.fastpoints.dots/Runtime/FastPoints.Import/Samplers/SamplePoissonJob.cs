using System.Runtime.CompilerServices;
using FastPoints.Points;
using FastPoints.Records;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Samplers
{
    /// <summary>The Poisson-disk sampler, by dart throwing (Cook 1986): from the widest spacing down, points are tried, and a
    /// point is taken if no taken point is nearer than its node's spacing. Cubes of one spacing are sampled together, so that the
    /// distance holds across the borders of nodes; a leaf's points neither keep nor demand it.</summary>
    /// <remarks>Points are tried tile by tile along the Morton curve (cubes of <see cref="TileSpacingsLog2"/>), those of a tile
    /// in the order of their priority: everything near a dart is in the cache, and the sample is as even as one in the order of
    /// priority alone (a test holds it). Most darts fall where a tile is covered; for the others, taken points are in a hash grid
    /// with cells of twice the spacing, so that whatever lies nearer than that is in two by two by two cells; the slots are
    /// chains without keys, as a point of another cell fails the distance anyway. Which points a node has depends only on the
    /// points themselves. One run of the job is a slice; the job runs again until it is done.</remarks>
    [BurstCompile]
    internal unsafe struct SamplePoissonJob : IJob
    {
        /// <summary>What the next slice continues.</summary>
        public enum Stage
        {
            Start,
            Look,
            NextSpacing,
            FillGrid,
            Queue,
            Throw,
            Average,
            Split,
            Done,
        }

        /// <summary>A slice takes about 4 ms.</summary>
        public const int PointsOfSlice = 60000;

        // A dart, or a point that adds to an average, costs as much as this many points that are only visited.
        const int LooksOfDart = 3;
        const int LooksOfAverage = 8;

        /// <summary>Edge of a tile: log2 of the spacings.</summary>
        public const int TileSpacingsLog2 = PoissonCover.TileSpacingsLog2;

        // These are an eighth of all points, which cover most of a tile.
        const int FirstClasses = PoissonPriority.Classes - 12;

        // Points in a run share a guess at the sample that keeps them off.
        const int RunLog2 = 3;

        public int Count;
        public int RootSideLog2;
        public NodeSizes Sizes;
        public RecordLayout Layout;

        /// <summary>Corner of a cube that contains all the points.</summary>
        public Grid3 Corner;
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<byte> CommonCubeLog2;
        [ReadOnly] public NativeArray<uint> Priority;

        /// <summary>The same as those of <see cref="SampleRandomJob"/>.</summary>
        public NativeArray<ChunkTop> Tops;

        /// <summary>Out: the node of each point.</summary>
        public NativeArray<int> NodeOfPoint;

        /// <summary>Out: drafts, parents before children.</summary>
        public NativeList<NodeDraft> Nodes;

        /// <summary>Averages over the points that each sampled point represents: those that are nearer to it than to any other at
        /// its spacing. Off for the plain sampler.</summary>
        public AveragedColumns Averaged;

        /// <summary>Its <see cref="PoissonScratch.Now"/> is reset before the first slice.</summary>
        public PoissonScratch Scratch;

        /// <summary>About this many points are visited in one run.</summary>
        public int PointsPerSlice;

        [NativeDisableUnsafePtrRestriction] byte* m_records;
        [NativeDisableUnsafePtrRestriction] int* m_nodeOfPoint;
        PoissonScratch.State m_now;
        long m_budget;

        NodeDrafting Drafting => new NodeDrafting
        {
            CommonCubeLog2 = (byte*)CommonCubeLog2.GetUnsafeReadOnlyPtr(),
            NodeOfPoint = m_nodeOfPoint,
            Sizes = Sizes,
            Tops = Tops,
            Nodes = Nodes,
        };

        public SliceTimes Slices;

        public void Execute()
        {
            if (Scratch.IsDone)
                return;
            long begin = SliceTimes.Begin();
            Run();
            Slices.End(begin);
        }

        void Run()
        {
            m_now = Scratch.Now.Value;
            m_records = (byte*)Records.GetUnsafeReadOnlyPtr();
            m_nodeOfPoint = (int*)NodeOfPoint.GetUnsafePtr();
            m_budget = PointsPerSlice;
            while (m_budget > 0 && m_now.Stage != Stage.Done)
            {
                switch (m_now.Stage)
                {
                    case Stage.Start:
                        Start();
                        break;
                    case Stage.Look:
                        Look();
                        break;
                    case Stage.NextSpacing:
                        NextSpacing();
                        break;
                    case Stage.FillGrid:
                        FillGrid();
                        break;
                    case Stage.Queue:
                        QueueTile();
                        break;
                    case Stage.Throw:
                        Throw();
                        break;
                    case Stage.Average:
                        AverageRange();
                        break;
                    default:
                        Split();
                        break;
                }
            }
            Scratch.Now.Value = m_now;
        }

        void Start()
        {
            Nodes.Clear();
            Scratch.Ranges.Clear();
            Scratch.Samples.Clear();
            UnsafeUtility.MemSet(m_nodeOfPoint, 0xFF, (long)Count * sizeof(int));
            int runs = (Count >> RunLog2) + 1;
            Scratch.KeeperOfRun.ResizeUninitialized(runs);
            UnsafeUtility.MemSet(Scratch.KeeperOfRun.GetUnsafePtr(), 0xFF, (long)runs * sizeof(int));
            if (Averaged.IsOn)
            {
                Averaged.Averages.Clear();
                UnsafeUtility.MemSet(Averaged.AverageOfPoint.GetUnsafePtr(), 0xFF, (long)Count * sizeof(int));
            }
            m_now.At = -1;
            m_now.Stage = Stage.NextSpacing;
            if (Count > 0)
                Visit(new SampledRange { First = 0, End = Count, Parent = -1, SideLog2 = (byte)RootSideLog2 });
        }

        /// <summary>Decides what becomes of a range after all its points were visited.</summary>
        void Visit(in SampledRange range)
        {
            m_now.Looking = new RangeSurveyState(range);
            m_now.Stage = Stage.Look;
        }

        void Look()
        {
            if (!m_now.Looking.GoOn((byte*)CommonCubeLog2.GetUnsafeReadOnlyPtr(), m_nodeOfPoint, ref m_budget))
                return;
            Place(m_now.Looking.Range, m_now.Looking.Look);
            m_now.Stage = m_now.At < 0 ? Stage.NextSpacing : Stage.Split;
        }

        /// <summary>Takes a range whole, or lets it wait for its spacing's turn.</summary>
        void Place(SampledRange range, in RangeSurvey look)
        {
            if (!Drafting.TakeWhole(ref range, look, out int top))
                Scratch.Ranges.Add(range);
            else if (top >= 0 && !Tops[top].IsLeaf)
                AddTop(range);
        }

        /// <summary>Makes the rest of a chunk's top keep its distance from what is sampled beside it.</summary>
        void AddTop(in SampledRange range)
        {
            for (int i = range.First; i < range.End; i++)
                if (m_nodeOfPoint[i] == Nodes.Length - 1)
                    Scratch.Samples.Add(new PoissonSample { Place = PlaceAt(i), Point = i });
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        Grid3 PlaceAt(int point) => Layout.PlaceOf(m_records + (long)point * Layout.StrideBytes) - Corner;

        /// <summary>Begins the widest spacing that ranges wait for, with a grid of all points taken so far.</summary>
        void NextSpacing()
        {
            m_now.FirstRange = Scratch.Ranges.TakeWidest(out int cell);
            if (m_now.FirstRange < 0)
            {
                m_now.Stage = Stage.Done;
                return;
            }
            int taken = Scratch.Samples.Length;
            m_now.CellLog2 = cell;
            m_now.FirstSample = taken;
            // Each level of a surface has about three times the points of all above.
            int bits = 64 - math.lzcnt((ulong)math.min(math.max(2L * taken, 4096), Count));
            Scratch.Heads.ResizeUninitialized(1 << bits);
            UnsafeUtility.MemSet(Scratch.Heads.GetUnsafePtr(), 0xFF, (long)sizeof(int) << bits);
            PoissonCover.Begin((ulong*)Scratch.Covered.GetUnsafePtr(), cell);
            m_budget -= (1L << bits) >> 4;
            m_now.Point = 0;
            m_now.Stage = Stage.FillGrid;
        }

        /// <summary>Puts the points taken so far into the grid.</summary>
        void FillGrid()
        {
            var grid = GridOfSpacing;
            var samples = Scratch.Samples.GetUnsafePtr();
            int end = (int)math.min(m_now.FirstSample, m_now.Point + m_budget);
            for (int s = m_now.Point; s < end; s++)
            {
                // Tops of chunks may be finer than what is sampled beside them.
                if (Nodes[m_nodeOfPoint[samples[s].Point]].CellLog2 < m_now.CellLog2)
                    continue;
                int slot = grid.SlotOf(samples[s].Place);
                samples[s].Next = grid.Heads[slot];
                grid.Heads[slot] = s;
            }
            m_budget -= end - m_now.Point;
            m_now.Point = end;
            if (end < m_now.FirstSample)
                return;
            m_now.Stage = Stage.Queue;
            m_now.At = m_now.FirstRange;
            m_now.Point = m_now.EndOfTile = Scratch.Ranges[m_now.At].First;
        }

        /// <summary>Queues the next darts of the current tile: those of the first classes, then the others. Points that are
        /// already kept off are skipped, which along the curve is quickly seen for most. After a range's last tile, it makes the
        /// node.</summary>
        void QueueTile()
        {
            var range = Scratch.Ranges[m_now.At];
            if (m_now.Point == range.End)
            {
                EndRange(range);
                return;
            }
            var priority = (uint*)Priority.GetUnsafeReadOnlyPtr();
            var common = (byte*)CommonCubeLog2.GetUnsafeReadOnlyPtr();
            var samples = Scratch.Samples.GetUnsafePtr();
            int* keeper = Scratch.KeeperOfRun.GetUnsafePtr();
            var nodeOfPoint = m_nodeOfPoint;
            int tileLog2 = m_now.CellLog2 + TileSpacingsLog2, first = m_now.Point, end = first;
            var cover = CoverAt(first);
            var grid = GridOfSpacing;
            bool isBegun = m_now.EndOfTile > first;
            if (!isBegun)
                cover.Clear();
            Scratch.Waiting.Clear();
            int* next = stackalloc int[PoissonPriority.Classes];
            UnsafeUtility.MemClear(next, PoissonPriority.Classes * sizeof(int));
            do
            {
                if (nodeOfPoint[end] >= 0)
                {
                    // These are the ones in the grid.
                    if (!isBegun && Nodes[nodeOfPoint[end]].CellLog2 >= m_now.CellLog2)
                        cover.Cover(PlaceAt(end));
                    continue;
                }
                int priorityClass = PoissonPriority.ClassOf(priority[end]);
                if (priorityClass < FirstClasses == isBegun)
                    continue;
                var place = PlaceAt(end);
                if (cover.IsCovered(place))
                    continue;
                // The sample that kept off one point keeps off most of its neighbours on the curve.
                int found = keeper[end >> RunLog2];
                if (found >= 0 && grid.IsNear(samples + found, place, out _))
                    continue;
                next[priorityClass]++;
                Scratch.Waiting.Add(end);
            }
            while (++end < range.End && common[end] <= tileLog2);
            SortWaiting(priority, next);
            m_budget -= end - first;
            m_now.EndOfTile = end;
            m_now.IsLastOfTile = isBegun;
            m_now.Dart = 0;
            m_now.Stage = Stage.Throw;
        }

        /// <summary>Sorts darts by class; those of one class follow the Morton curve.</summary>
        void SortWaiting(uint* priority, int* next)
        {
            int sum = 0;
            for (int c = 0; c < PoissonPriority.Classes; c++)
            {
                int with = next[c];
                next[c] = sum;
                sum += with;
            }
            Scratch.Darts.ResizeUninitialized(sum);
            var darts = Scratch.Darts.GetUnsafePtr();
            var waiting = Scratch.Waiting.GetUnsafePtr();
            for (int i = 0; i < sum; i++)
                darts[next[PoissonPriority.ClassOf(priority[waiting[i]])]++] = waiting[i];
        }

        PoissonGrid GridOfSpacing =>
            new PoissonGrid(Scratch.Heads.GetUnsafePtr(), math.tzcnt(Scratch.Heads.Length), m_now.CellLog2);

        /// <summary>The cover of the tile that contains a point.</summary>
        PoissonCover CoverAt(int point) =>
            new PoissonCover((ulong*)Scratch.Covered.GetUnsafePtr(), m_now.CellLog2, PlaceAt(point));

        void Throw()
        {
            var darts = Scratch.Darts.GetUnsafePtr();
            ref var range = ref Scratch.Ranges[m_now.At];
            var samples = Scratch.Samples.GetUnsafePtr();
            int* keeper = Scratch.KeeperOfRun.GetUnsafePtr();
            var grid = GridOfSpacing;
            var cover = CoverAt(m_now.Point);
            int taken = Scratch.Samples.Length, node = Nodes.Length;
            int end = (int)math.min(Scratch.Darts.Length, m_now.Dart + m_budget / LooksOfDart + 1);
            for (int d = m_now.Dart; d < end; d++)
            {
                int point = darts[d];
                var place = PlaceAt(point);
                if (cover.IsCovered(place))
                    continue;
                int found = keeper[point >> RunLog2];
                if (found >= 0 && grid.IsNear(samples + found, place, out _))
                    continue;
                found = grid.Find(samples, place, out int slot);
                if (found >= 0)
                {
                    keeper[point >> RunLog2] = found;
                    continue;
                }
                if (range.Count == Sizes.MaxPointsPerNode)
                    continue;
                range.Count++;
                m_nodeOfPoint[point] = node;
                keeper[point >> RunLog2] = taken;
                Scratch.Samples.Add(new PoissonSample { Place = place, Point = point, Next = grid.Heads[slot] });
                samples = Scratch.Samples.GetUnsafePtr();
                grid.Heads[slot] = taken++;
                cover.Cover(place);
            }
            m_budget -= LooksOfDart * (long)(end - m_now.Dart);
            m_now.Dart = end;
            if (end < Scratch.Darts.Length)
                return;
            m_now.Stage = Stage.Queue;
            if (m_now.IsLastOfTile)
                m_now.Point = m_now.EndOfTile;
        }

        void EndRange(SampledRange range)
        {
            range.Parent = Drafting.AddSampled(range);
            Scratch.Ranges[m_now.At] = range;
            m_now.At = range.Next;
            if (m_now.At >= 0)
            {
                m_now.Point = m_now.EndOfTile = Scratch.Ranges[m_now.At].First;
                return;
            }
            BeginSplit(m_now.FirstRange);
            if (!Averaged.IsOn)
                return;
            m_now.Stage = Stage.Average;
            m_now.FirstAverage = Averaged.Averages.Length;
            Averaged.Averages.Resize(m_now.FirstAverage + Scratch.Samples.Length - m_now.FirstSample,
                NativeArrayOptions.ClearMemory);
        }

        /// <summary>Adds each point of a range to its nearest new sample, unless one of a wider spacing is nearer.</summary>
        void AverageRange()
        {
            var range = Scratch.Ranges[m_now.At];
            var samples = Scratch.Samples.GetUnsafePtr();
            var averages = Averaged.Averages.GetUnsafePtr() + m_now.FirstAverage;
            var grid = GridOfSpacing;
            int end = (int)math.min(range.End, m_now.Point + m_budget / LooksOfAverage + 1);
            for (int i = m_now.Point; i < end; i++)
            {
                if (m_nodeOfPoint[i] >= 0 && (range.Count == 0 || m_nodeOfPoint[i] != range.Parent))
                    continue;
                int nearest = grid.Nearest(samples, PlaceAt(i)) - m_now.FirstSample;
                if (nearest < 0)
                    continue;
                var own = Averaged.Of(i, m_records + (long)i * Layout.StrideBytes, Layout);
                averages[nearest].Points += own.Points;
                averages[nearest].Sum += own.Sum;
            }
            m_budget -= LooksOfAverage * (long)(end - m_now.Point);
            m_now.Point = end;
            if (end < range.End)
                return;
            if (range.Next >= 0)
            {
                m_now.At = range.Next;
                m_now.Point = Scratch.Ranges[m_now.At].First;
                return;
            }
            for (int s = m_now.FirstSample; s < Scratch.Samples.Length; s++)
                Averaged.AverageOfPoint[samples[s].Point] = m_now.FirstAverage + s - m_now.FirstSample;
            BeginSplit(m_now.FirstRange);
        }

        /// <summary>Continues with a range's parts, or with the next spacing if no range is left.</summary>
        void BeginSplit(int number)
        {
            m_now.At = number;
            m_now.Stage = number < 0 ? Stage.NextSpacing : Stage.Split;
            if (number >= 0)
                m_now.Point = Scratch.Ranges[number].First;
        }

        void Split()
        {
            var range = Scratch.Ranges[m_now.At];
            if (m_now.Point == range.End)
            {
                BeginSplit(range.Next);
                return;
            }
            int first = m_now.Point;
            m_now.Point = Drafting.EndOfPart(range, first);
            Visit(new SampledRange
            {
                First = first,
                End = m_now.Point,
                Parent = range.Parent,
                SideLog2 = (byte)(range.SideLog2 - 1),
            });
        }
    }
}
