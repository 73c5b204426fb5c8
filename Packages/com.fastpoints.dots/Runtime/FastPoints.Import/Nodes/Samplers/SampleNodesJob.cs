using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;
using Stage = FastPoints.Nodes.SampleScratch.Stage;

namespace FastPoints.Nodes
{
    /// <summary>The samplers: they divide a chunk's points into ranges, one a cube, and choose from the finest spacing up. Each
    /// range takes some of what its parts offer (leaves offer all their points) and offers these to the range above; a point's
    /// node is the coarsest that takes it.</summary>
    /// <remarks>
    /// The random sampler takes the point of highest priority from each cell: the best of those that won the cells below.
    ///
    /// The Poisson-disk sampler throws darts (Cook 1986): a point is taken if no taken point is nearer than the spacing. Ranges
    /// of one spacing are sampled against one another, so that the distance holds across their borders. Points are tried tile
    /// by tile along the Morton curve (cubes of <see cref="DartGrid.TileSpacingsLog2"/>), those of a tile in the order of their
    /// priority: everything near a dart is in the cache, and the sample is as even as one in the order of priority alone (a
    /// test holds it).
    ///
    /// Points are in Morton order, so that cubes and cells are ranges. Cubes with points in one octant only are skipped, and so
    /// is a node that gets no point: its children are attached to the node above. A node's cells are as fine as the sizes
    /// allow, and coarser if that made it too large: in a filled volume. Which points a node has depends only on the points
    /// themselves. One run of the job is a slice; the job runs again until it is done.
    /// </remarks>
    [BurstCompile]
    internal unsafe partial struct SampleNodesJob : IJob
    {
        public const int CostOfSlice = 2500000; // A slice takes about 4 ms at most. Costs are about nanoseconds.

        /// <summary>More than a point costs in most clouds (20 to 30, 95 to 120, and for averages 140 to 170 more).</summary>
        public const int CostPerPoint = 40;
        public const int CostPerPointOfDarts = 150;
        public const int CostPerPointOfAverages = 200;

        const int CostOfSurvey = 2;
        const int CostOfFill = 4;
        const int CostOfCandidate = 5;
        const int CostOfGather = 20;
        const int CostOfDart = 45;
        const int CostOfTile = 2000;
        const int CostOfExclusion = 18;
        const int CostOfAverageSurvey = 6;
        const int CostOfAverage = 140;

        public const int CountTables = 4;
        public const int CountsOfTable = 256;

        public int Count;
        public int RootSideLog2;
        public NodeSizes Sizes;
        public RecordLayout Layout;
        public bool IsRandom;

        public Grid3 Corner;
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<byte> CommonCubeLog2;
        [ReadOnly] public NativeArray<uint> Priority;

        /// <summary>The chunks' tops, if the points are these: a range within one of them becomes its node. Empty for whole
        /// points.</summary>
        public NativeArray<TopNode> Tops;
        public NativeArray<int> NodeOfPoint; // Out: the node of each point. Before the end, its range.
        public NativeList<NodeDraft> Nodes; // Out: drafts, parents before children.

        /// <summary>Averages over the points that each sampled point represents: what is nearer to it than to any other at its
        /// spacing, with all that this represents at finer ones. Off for the plain samplers.</summary>
        public AveragedColumns Averaged;
        public SampleScratch Scratch; // Its SampleScratch.Progress is reset before the first slice.

        public int CostPerSlice;
        public SliceTimes SliceTimes;

        [NativeDisableUnsafePtrRestriction] byte* m_records;
        [NativeDisableUnsafePtrRestriction] int* m_rangeOfPoint;
        [NativeDisableUnsafePtrRestriction] byte* m_common;
        [NativeDisableUnsafePtrRestriction] uint* m_priority;
        SampleScratch.State m_state;
        long m_budget;

        public void Execute()
        {
            if (Scratch.IsDone)
                return;
            long begin = SliceTimes.Begin();
            Run();
            SliceTimes.End(begin);
        }

        void Run()
        {
            m_state = Scratch.Progress.Value;
            m_records = (byte*)Records.GetUnsafeReadOnlyPtr();
            m_rangeOfPoint = (int*)NodeOfPoint.GetUnsafePtr();
            m_common = (byte*)CommonCubeLog2.GetUnsafeReadOnlyPtr();
            m_priority = (uint*)Priority.GetUnsafeReadOnlyPtr();
            m_budget = CostPerSlice;
            while (m_budget > 0 && m_state.Stage != Stage.Done)
            {
                switch (m_state.Stage)
                {
                    case Stage.Start:
                        Start();
                        break;
                    case Stage.Plan:
                        Plan();
                        break;
                    case Stage.Fill:
                        Fill();
                        break;
                    case Stage.NextSpacing:
                        NextSpacing();
                        break;
                    case Stage.ChooseCells:
                        ChooseCells();
                        break;
                    case Stage.Gather:
                        Gather();
                        break;
                    case Stage.Throw:
                        Throw();
                        break;
                    case Stage.Exclude:
                        ExcludePoints();
                        break;
                    case Stage.Average:
                        AddToAverages();
                        break;
                    case Stage.Count:
                        CountPoints();
                        break;
                    default:
                        Renumber();
                        break;
                }
            }
            Scratch.Progress.Value = m_state;
        }

        /// <summary>The end of what the budget allows from here.</summary>
        int Spend(int from, int end, int cost)
        {
            int to = (int)math.min(end, from + m_budget / cost + 1);
            m_budget -= (long)(to - from) * cost;
            return to;
        }

        void Start()
        {
            Nodes.Clear();
            Scratch.Ranges.Clear();
            Scratch.Offered.ResizeUninitialized(Count);
            if (IsRandom)
                Scratch.OfferedCommon.ResizeUninitialized(Count);
            if (Averaged.HasColumns)
            {
                Averaged.Sums.Clear();
                UnsafeUtility.MemSet(Averaged.AverageOfPoint.GetUnsafePtr(), 0xFF, (long)Count * sizeof(int));
            }
            m_state.Stage = Count > 0 ? Stage.Plan : Stage.Done;
            if (Count > 0)
                Scratch.Ranges.Add(new SampledCube { End = Count, Parent = -1, SideLog2 = (byte)RootSideLog2, Offered = -1 });
            BeginPlan(0);
        }

        void BeginPlan(int range)
        {
            m_state.Range = range;
            m_state.CellLog2 = -1;
            if (range >= Scratch.Ranges.Length)
            {
                m_state.Stage = m_state.Stage == Stage.Done ? Stage.Done : Stage.NextSpacing;
                return;
            }
            m_state.Stage = Stage.Plan;
            m_state.Point = Scratch.Ranges[range].First + 1;
            m_state.SideLog2 = m_state.Ends = 0;
            UnsafeUtility.MemClear(Scratch.Counts.GetUnsafePtr(), (long)Scratch.Counts.Length * sizeof(int));
        }

        /// <summary>Surveys the common cubes of neighbours, then decides how to handle the range.</summary>
        void Plan()
        {
            ref var range = ref Scratch.Ranges.ElementAt(m_state.Range);
            int* counts = (int*)Scratch.Counts.GetUnsafePtr();
            int end = Spend(m_state.Point, range.End, CostOfSurvey), largest = m_state.SideLog2;
            for (int i = m_state.Point; i < end; i++)
            {
                int side = m_common[i];
                counts[(i & CountTables - 1) * CountsOfTable + side]++;
                if (side < largest || side == 0)
                    continue;
                m_state.Ends = side > largest ? 0 : m_state.Ends;
                m_state.EndOfOctant[m_state.Ends++] = i;
                largest = side;
            }
            m_state.Point = end;
            m_state.SideLog2 = largest;
            if (end < range.End)
                return;
            var survey = new CubeSurvey { PointCount = range.End - range.First, CellsOfAnySize = 1, SideLog2 = largest };
            for (int side = 0; side < CubeSurvey.Sides; side++)
                for (int table = 0; table < CountTables; table++)
                    survey.CellsBelow[side] += counts[table * CountsOfTable + side];
            Decide(ref range, survey);
            if (range.Kind == SampledCubeKind.Sampled || range.Kind == SampledCubeKind.Passed)
            {
                AddChildren(m_state.Range);
                BeginPlan(m_state.Range + 1);
                return;
            }
            m_state.Point = range.First;
            m_state.Best = -1;
            m_state.Stage = Stage.Fill;
        }

        void Decide(ref SampledCube range, in CubeSurvey survey)
        {
            int finest = survey.FinestCellLog2(Sizes, out int cells);
            bool isLeaf = Sizes.IsLeaf(survey.PointCount, cells);
            if (Tops.Length > 0)
            {
                int first = TopOf(range.First), last = TopOf(range.End - 1);
                if (first == last)
                {
                    range.Kind = SampledCubeKind.Top;
                    range.SideLog2 = Tops[first].SideLog2;
                    range.CellLog2 = Tops[first].CellLog2;
                    return;
                }
                isLeaf &= !HasNodes(range);
            }
            range.Kind = isLeaf ? SampledCubeKind.Leaf : survey.SideLog2 == 0 ? SampledCubeKind.Chain : SampledCubeKind.Sampled;
            if (isLeaf)
            {
                range.CellLog2 = (byte)math.max(0, range.SideLog2 - Sizes.CellsLog2);
                return;
            }
            range.SideLog2 = (byte)survey.SideLog2;
            range.CellLog2 = (byte)finest;
            if (range.Kind == SampledCubeKind.Chain)
            {
                range.CellLog2 = 0;
            }
            else if (range.Parent >= 0 && Scratch.Ranges[range.Parent].CellLog2 <= finest)
            {
                range.Kind = SampledCubeKind.Passed;
                range.CellLog2 = Scratch.Ranges[range.Parent].CellLog2;
            }
        }

        void AddChildren(int number)
        {
            var range = Scratch.Ranges[number];
            range.FirstChild = Scratch.Ranges.Length;
            range.ChildCount = m_state.Ends + 1;
            Scratch.Ranges[number] = range;
            int first = range.First;
            for (int child = 0; child <= m_state.Ends; child++)
            {
                int end = child < m_state.Ends ? m_state.EndOfOctant[child] : range.End;
                Scratch.Ranges.Add(new SampledCube
                {
                    First = first,
                    End = end,
                    Parent = range.Kind == SampledCubeKind.Sampled ? number : range.Parent,
                    SideLog2 = (byte)(range.SideLog2 - 1),
                    Offered = -1,
                });
                first = end;
            }
        }

        /// <summary>All points of a range that has no parts are its own until one above takes them. Of a chain's points, one is
        /// offered.</summary>
        void Fill()
        {
            ref var range = ref Scratch.Ranges.ElementAt(m_state.Range);
            int end = Spend(m_state.Point, range.End, CostOfFill);
            for (int i = m_state.Point; i < end; i++)
            {
                m_rangeOfPoint[i] = m_state.Range;
                m_state.Best = math.max(m_state.Best, RankOf(i));
            }
            m_state.Point = end;
            if (end < range.End)
                return;
            if (range.Kind == SampledCubeKind.Chain)
            {
                range.Offered = 1;
                Scratch.Offered[range.First] = PointOf(m_state.Best);
                if (IsRandom)
                    Scratch.OfferedCommon[range.First] = m_common[range.First];
            }
            BeginPlan(m_state.Range + 1);
        }

        void NextSpacing()
        {
            var ranges = Scratch.Ranges.GetUnsafePtr();
            int next = int.MaxValue, count = Scratch.Ranges.Length;
            for (int r = 0; r < count; r++)
                if (ranges[r].Kind == SampledCubeKind.Sampled && ranges[r].CellLog2 > m_state.CellLog2)
                    next = math.min(next, ranges[r].CellLog2);
            m_budget -= count;
            m_state.CellLog2 = next;
            m_state.Point = 0;
            m_state.Stage = Stage.Count;
            if (next == int.MaxValue)
                return;
            for (int r = count - 1; r >= 0; r--)
                if (ranges[r].Kind == SampledCubeKind.Passed && ranges[r].CellLog2 == next)
                    OfferToParent(ranges, r);
            if (!IsRandom)
                Scratch.Grid.Clear(Count);
            m_state.IsFixing = !IsRandom && Tops.Length > 0;
            BeginRange(-1);
        }

        void OfferToParent(SampledCube* ranges, int number)
        {
            ref var range = ref ranges[number];
            int to = range.First;
            for (int child = range.FirstChild; child < range.FirstChild + range.ChildCount; child++)
            {
                int first = ranges[child].First, count = ranges[child].OfferedCount;
                for (int k = first; k < first + count; k++, to++)
                {
                    if (IsRandom)
                        Scratch.OfferedCommon[to] = ranges[child].OffersAll ? m_common[k] : Scratch.OfferedCommon[k];
                    // Excluded ones as well: gathering checks them.
                    Scratch.Offered[to] = ranges[child].OffersAll ? k : Scratch.Offered[k];
                }
            }
            range.Offered = to - range.First;
            m_budget -= (long)range.Offered * CostOfSurvey;
        }

        /// <summary>Begins the next range of the current spacing, or what follows the last one.</summary>
        void BeginRange(int number)
        {
            var ranges = Scratch.Ranges.GetUnsafePtr();
            for (number++; ; number++)
            {
                if (number < Scratch.Ranges.Length)
                {
                    if (m_state.IsFixing ? IsFixed(ranges, number) : IsOfSpacing(ranges[number]))
                        break;
                    continue;
                }
                if (!m_state.IsFixing)
                {
                    BeginExclusion(-1);
                    return;
                }
                m_state.IsFixing = false;
                number = -1;
            }
            m_state.Range = number;
            m_state.Child = m_state.IsFixing ? number : ranges[number].FirstChild;
            m_state.Candidate = m_state.Taken = m_state.Darts = 0;
            m_state.Stage = IsRandom ? Stage.ChooseCells : Stage.Gather;
        }

        bool IsOfSpacing(in SampledCube range) => range.Kind == SampledCubeKind.Sampled && range.CellLog2 == m_state.CellLog2;

        /// <summary>Whether remaining points of a chunk's top bar others at this spacing.</summary>
        bool IsFixed(SampledCube* ranges, int number)
        {
            ref var range = ref ranges[number];
            return range.Kind == SampledCubeKind.Top && range.CellLog2 >= m_state.CellLog2 && range.Parent >= 0 &&
                ranges[range.Parent].CellLog2 > m_state.CellLog2 && !Tops[TopOf(range.First)].IsLeaf;
        }
    }

    /// <summary>What a sampler knows of a range's points before it decides how to handle them.</summary>
    internal unsafe struct CubeSurvey
    {
        // There is one for each side from a step's to the largest cube's, and one beyond all.
        public const int Sides = GridCube.MaxSideLog2 + 3;

        public int PointCount;
        public int SideLog2; // log2 of the side of the smallest cube with all of them.
        public int CellsOfAnySize; // Number of cells of any size, apart from those below.

        /// <summary>For each log2 of a side: how many more such cells there are if cells are smaller than this.</summary>
        public fixed int CellsBelow[Sides];

        /// <summary>The finest cells with which a node does not become too large: those that the sizes give, or coarser ones in a
        /// filled volume.</summary>
        /// <param name="cells">The number of cells with points.</param>
        public readonly int FinestCellLog2(in NodeSizes sizes, out int cells)
        {
            int finest = SideLog2 > sizes.CellsLog2 ? SideLog2 - sizes.CellsLog2 : 0;
            int best = SideLog2, more = CellsOfAnySize;
            for (int side = Sides - 1; side > SideLog2; side--)
                more += CellsBelow[side];
            cells = more;
            for (int cell = SideLog2 - 1; cell >= finest; cell--)
            {
                more += CellsBelow[cell + 1];
                if (more > sizes.MaxPointsPerNode)
                    break;
                best = cell;
                cells = more;
            }
            return best;
        }
    }
}
