using FastPoints.Records;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Samplers
{
    /// <summary>The random sampler: from the root down, each node takes the point of highest priority from each of its cells,
    /// unless a node above already has a point of that cell. Which points a node has depends only on the points
    /// themselves.</summary>
    /// <remarks>Points are in Morton order, so that cubes and cells are ranges. A point that has the highest priority of a cell
    /// has it of all finer ones that it is in, and so one number says in which cells a point wins: those smaller than the
    /// smallest cube in which it has to give way. One pass finds it for all points, and then no priority is read again: a node
    /// takes the points that win at its cells and did not at those of the node above. A node's cells are as fine as the sizes
    /// allow, and coarser if that made it too large: in a filled volume. Cubes with points in one octant only are skipped, and so
    /// is a node that gets no point: its children are attached to the node above. One run of the job is a slice; the job runs
    /// again until it is done.</remarks>
    [BurstCompile]
    internal unsafe struct SampleRandomJob : IJob
    {
        /// <summary>What the next slice continues.</summary>
        public enum Stage
        {
            Start,
            FindWinners,
            Look,
            Take,
            Done,
        }

        /// <summary>A slice takes at most about 4 ms.</summary>
        public const int PointsOfSlice = 100000;

        const byte Everywhere = byte.MaxValue;

        public int Count;
        public int RootSideLog2;
        public NodeSizes Sizes;
        [ReadOnly] public NativeArray<byte> CommonCubeLog2;
        [ReadOnly] public NativeArray<uint> Priority;

        /// <summary>Scratch: for each point, log2 of the side of the smallest cube in which another point has a higher
        /// priority.</summary>
        public NativeArray<byte> GivesWayLog2;

        /// <summary>Its <see cref="RandomScratch.Now"/> is reset before the first slice.</summary>
        public RandomScratch Scratch;

        /// <summary>About this many points are visited in one run.</summary>
        public int PointsPerSlice;

        /// <summary>The chunks' tops, if the points are these: a range within one of them becomes its node. Empty for whole
        /// points.</summary>
        public NativeArray<ChunkTop> Tops;

        /// <summary>Out: the node of each point.</summary>
        public NativeArray<int> NodeOfPoint;

        /// <summary>Out: drafts in breadth-first order, except nodes whose parent was skipped.</summary>
        public NativeList<NodeDraft> Nodes;

        public SliceTimes Slices;

        RandomScratch.State m_now;
        long m_budget;

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
            m_budget = PointsPerSlice;
            if (m_now.Stage == Stage.Start)
                Start();
            if (m_now.Stage == Stage.FindWinners)
                FindWinners();
            while (m_budget > 0 && m_now.Stage != Stage.Done)
            {
                if (m_now.Stage == Stage.Look)
                    Look();
                else
                    TakeWinners();
            }
            Scratch.Now.Value = m_now;
        }

        void Start()
        {
            Nodes.Clear();
            Scratch.Ranges.Clear();
            if (Count > 0)
                Scratch.Ranges.Add(new SampledRange
                {
                    First = 0,
                    End = Count,
                    Parent = -1,
                    SideLog2 = (byte)RootSideLog2,
                    CellLog2 = Everywhere,
                });
            m_now = new RandomScratch.State { Stage = Stage.FindWinners };
        }

        /// <summary>Finds where each point gives way: in the smaller of the cubes that it shares with the next points of a higher
        /// priority before and behind it. Of equal priorities the first in order counts as higher, so that content
        /// decides.</summary>
        void FindWinners()
        {
            var priority = (uint*)Priority.GetUnsafeReadOnlyPtr();
            var common = (byte*)CommonCubeLog2.GetUnsafeReadOnlyPtr();
            var givesWay = (byte*)GivesWayLog2.GetUnsafePtr();
            // Nodes are not known yet, so this holds the points not yet followed by one of a higher priority; their priorities
            // fall.
            var rising = (int*)NodeOfPoint.GetUnsafePtr();
            int depth = m_now.Rising, end = (int)math.min(Count, m_now.At + m_budget);
            for (int i = m_now.At; i < end; i++)
            {
                uint own = priority[i];
                byte cube = common[i];
                while (depth > 0)
                {
                    int before = rising[depth - 1];
                    if (priority[before] >= own)
                        break;
                    // The cube that it shares with the point before it is known already.
                    byte wider = givesWay[before];
                    givesWay[before] = (byte)math.min((uint)wider, cube);
                    cube = (byte)math.max((uint)wider, cube);
                    depth--;
                }
                givesWay[i] = depth == 0 ? Everywhere : cube;
                rising[depth++] = i;
            }
            m_budget -= end - m_now.At;
            m_now.At = end;
            m_now.Rising = depth;
            if (end < Count)
                return;
            UnsafeUtility.MemSet(NodeOfPoint.GetUnsafePtr(), 0xFF, (long)Count * sizeof(int));
            Begin(0);
        }

        /// <summary>Begins a range, if there is one.</summary>
        void Begin(int number)
        {
            m_now = new RandomScratch.State { Stage = Stage.Done, At = number };
            if (number == Scratch.Ranges.Length)
                return;
            m_now.Stage = Stage.Look;
            m_now.Point = Scratch.Ranges[number].First;
            m_now.CellAbove = Scratch.Ranges[number].CellLog2;
            UnsafeUtility.MemClear(Scratch.GivingWay.GetUnsafePtr(), Scratch.GivingWay.Length * sizeof(int));
        }

        NodeDrafting Drafting => new NodeDrafting
        {
            CommonCubeLog2 = (byte*)CommonCubeLog2.GetUnsafeReadOnlyPtr(),
            NodeOfPoint = (int*)NodeOfPoint.GetUnsafePtr(),
            Sizes = Sizes,
            Tops = Tops,
            Nodes = Nodes,
        };

        /// <summary>Counts cells. Points that win at the cells of the node above are in nodes; each of the others adds a cell
        /// once cells are so small that it wins.</summary>
        void Look()
        {
            var common = (byte*)CommonCubeLog2.GetUnsafeReadOnlyPtr();
            var givesWay = (byte*)GivesWayLog2.GetUnsafeReadOnlyPtr();
            var givingWay = (int*)Scratch.GivingWay.GetUnsafePtr();
            var range = Scratch.Ranges[m_now.At];
            int end = (int)math.min(range.End, m_now.Point + m_budget), largest = m_now.Largest;
            for (int i = m_now.Point; i < end; i++)
            {
                givingWay[givesWay[i]]++;
                if (i > range.First)
                    largest = math.max(largest, common[i]);
            }
            m_budget -= end - m_now.Point;
            m_now.Point = end;
            m_now.Largest = largest;
            if (end < range.End)
                return;
            var look = new RangeSurvey { Largest = largest };
            for (int side = 0; side < 256 && side <= range.CellLog2; side++)
            {
                look.Left += givingWay[side];
                look.CellsBelow[math.min(side, RangeSurvey.Sides - 1)] += givingWay[side];
            }
            if (Drafting.TakeWhole(ref range, look, out _))
            {
                Begin(m_now.At + 1);
                return;
            }
            Scratch.Ranges[m_now.At] = range;
            m_now.Point = range.First;
            m_now.Stage = Stage.Take;
        }

        void TakeWinners()
        {
            var givesWay = (byte*)GivesWayLog2.GetUnsafeReadOnlyPtr();
            var nodeOfPoint = (int*)NodeOfPoint.GetUnsafePtr();
            var range = Scratch.Ranges[m_now.At];
            int node = Nodes.Length, end = (int)math.min(range.End, m_now.Point + m_budget), cellAbove = m_now.CellAbove;
            for (int i = m_now.Point; i < end; i++)
            {
                if (givesWay[i] <= range.CellLog2 || givesWay[i] > cellAbove)
                    continue;
                nodeOfPoint[i] = node;
                range.Count++;
            }
            m_budget -= end - m_now.Point;
            m_now.Point = end;
            Scratch.Ranges[m_now.At] = range;
            if (end == range.End)
                Split(range);
        }

        void Split(in SampledRange range)
        {
            var drafting = Drafting;
            int parent = drafting.AddSampled(range);
            for (int first = range.First; first < range.End;)
            {
                int end = drafting.EndOfPart(range, first);
                Scratch.Ranges.Add(new SampledRange
                {
                    First = first,
                    End = end,
                    Parent = parent,
                    SideLog2 = (byte)(range.SideLog2 - 1),
                    CellLog2 = range.CellLog2,
                });
                first = end;
            }
            Begin(m_now.At + 1);
        }
    }
}
