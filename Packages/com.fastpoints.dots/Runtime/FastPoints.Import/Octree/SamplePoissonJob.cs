using System.Runtime.CompilerServices;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octree
{
    /// <summary>
    /// The Poisson-disk sampler, by dart throwing (Cook 1986): from the widest spacing down, points are tried in the order of
    /// their priority, and one that has no taken point nearer than its node's spacing is taken. Cubes of one spacing are
    /// sampled together, so that the distance holds across the borders of nodes; a leaf's points keep none and ask for none.
    /// </summary>
    /// <remarks>
    /// Taken points are in a hash grid with cells of twice the spacing, so that whatever lies nearer than that is in two by two by
    /// two cells; the slots are chains without keys, as a point of another cell fails the distance anyway. Which points a node
    /// has depends on nothing but the points themselves. One run of the job is a slice: it is run until it is done.
    /// </remarks>
    [BurstCompile]
    public unsafe struct SamplePoissonJob : IJob
    {
        /// <summary>What the next slice goes on with.</summary>
        public enum Stage
        {
            Start,
            NextSpacing,
            Queue,
            Throw,
            MakeNodes,
            Average,
            Split,
            Done,
        }

        /// <summary>Takes about 4 ms.</summary>
        public const int PointsOfSlice = 200000;

        // Points that share a guess at what keeps them off.
        const int RunLog2 = 3;

        public int Count;
        public int RootSideLog2;
        public NodeSizes Sizes;
        public RecordLayout Layout;

        /// <summary>Corner of a cube that has all the points.</summary>
        public Grid3 Corner;
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<byte> CommonCubeLog2;
        [ReadOnly] public NativeArray<uint> Priority;

        /// <summary>As those of <see cref="SampleRandomJob"/>.</summary>
        public NativeArray<ChunkTop> Tops;

        /// <summary>Out, by point.</summary>
        public NativeArray<int> NodeOfPoint;

        /// <summary>Out, parents before children.</summary>
        public NativeList<NodeDraft> Nodes;

        /// <summary>Averages over what each sampled point stands for: the points that are nearer to it than to any other at its
        /// spacing. Off for the plain sampler.</summary>
        public AveragedColumns Averaged;

        /// <summary>Its <see cref="PoissonScratch.Now"/> is reset before the first slice.</summary>
        public PoissonScratch Scratch;

        /// <summary>About so many points are looked at in one run.</summary>
        public int PointsPerSlice;

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
            long begin = SliceTimes.Begin();
            Run();
            Slices.End(begin);
        }

        void Run()
        {
            m_now = Scratch.Now.Value;
            m_nodeOfPoint = (int*)NodeOfPoint.GetUnsafePtr();
            m_budget = PointsPerSlice;
            while (m_budget > 0 && m_now.Stage != Stage.Done)
            {
                switch (m_now.Stage)
                {
                    case Stage.Start:
                        Start();
                        break;
                    case Stage.NextSpacing:
                        NextSpacing();
                        break;
                    case Stage.Queue:
                        QueueRange();
                        break;
                    case Stage.Throw:
                        Throw();
                        break;
                    case Stage.MakeNodes:
                        MakeNodes();
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
            UnsafeUtility.MemClear(Scratch.PointsOfClass.GetUnsafePtr(), (long)Scratch.PointsOfClass.Length * sizeof(int));
            for (int i = 0; i <= GridCube.MaxSideLog2; i++)
                Scratch.FirstRange[i] = Scratch.LastRange[i] = -1;
            UnsafeUtility.MemSet(m_nodeOfPoint, 0xFF, (long)Count * sizeof(int));
            int runs = (Count >> RunLog2) + 1;
            Scratch.KeeperOfRun.ResizeUninitialized(runs);
            UnsafeUtility.MemSet(Scratch.KeeperOfRun.GetUnsafePtr(), 0xFF, (long)runs * sizeof(int));
            if (Averaged.IsOn)
            {
                Averaged.Averages.Clear();
                UnsafeUtility.MemSet(Averaged.AverageOfPoint.GetUnsafePtr(), 0xFF, (long)Count * sizeof(int));
            }
            if (Count > 0)
                Visit(new SampledRange { First = 0, End = Count, Parent = -1, SideLog2 = (byte)RootSideLog2 });
            m_now.Stage = Stage.NextSpacing;
        }

        /// <summary>Takes a range whole, or has it wait for its spacing's turn.</summary>
        void Visit(SampledRange range)
        {
            m_budget -= range.End - range.First;
            if (Drafting.TakeWhole(ref range, out int top))
            {
                if (top >= 0 && !Tops[top].IsLeaf)
                    AddTop(range);
                return;
            }
            int number = Scratch.Ranges.Length;
            var priority = (uint*)Priority.GetUnsafeReadOnlyPtr();
            int* pointsOfClass = PointsOfClass(range.CellLog2);
            for (int i = range.First; i < range.End; i++)
            {
                if (m_nodeOfPoint[i] >= 0)
                    continue;
                m_nodeOfPoint[i] = CodeOf(number);
                pointsOfClass[PoissonPriority.ClassOf(priority[i])]++;
            }
            Wait(range, number);
        }

        /// <summary>Ranges of one spacing wait in their order along the curve, wherever they come from.</summary>
        void Wait(SampledRange range, int number)
        {
            Scratch.Ranges.Add(range);
            var ranges = Scratch.Ranges.GetUnsafePtr();
            int after = Scratch.LastRange[range.CellLog2];
            if (after >= 0 && ranges[after].First > range.First)
            {
                int before = Scratch.FirstRange[range.CellLog2];
                after = -1;
                for (; ranges[before].First < range.First; before = ranges[before].Next)
                    after = before;
            }
            if (after >= 0)
            {
                ranges[number].Next = ranges[after].Next;
                ranges[after].Next = number;
            }
            else
            {
                ranges[number].Next = Scratch.FirstRange[range.CellLog2];
                Scratch.FirstRange[range.CellLog2] = number;
            }
            if (ranges[number].Next < 0)
                Scratch.LastRange[range.CellLog2] = number;
        }

        int* PointsOfClass(int cellLog2) =>
            (int*)Scratch.PointsOfClass.GetUnsafePtr() + cellLog2 * PoissonPriority.Classes;

        /// <summary>What stands in NodeOfPoint for a point that waits in a range; the same the other way round.</summary>
        static int CodeOf(int range) => -2 - range;

        /// <summary>What is left of a chunk's top keeps its distance from what is sampled beside it.</summary>
        void AddTop(in SampledRange range)
        {
            for (int i = range.First; i < range.End; i++)
                if (m_nodeOfPoint[i] == Nodes.Length - 1)
                    Scratch.Samples.Add(SampleAt(i));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        Grid3 PlaceAt(int point) =>
            Layout.PlaceOf((byte*)Records.GetUnsafeReadOnlyPtr() + (long)point * Layout.StrideBytes) - Corner;

        PoissonSample SampleAt(int point)
        {
            var place = PlaceAt(point);
            return new PoissonSample { X = place.X, Y = place.Y, Z = place.Z, Point = point };
        }

        /// <summary>The widest spacing that ranges wait for, and a grid for it with all points taken so far.</summary>
        void NextSpacing()
        {
            int cell = GridCube.MaxSideLog2;
            while (cell >= 0 && Scratch.FirstRange[cell] < 0)
                cell--;
            if (cell < 0)
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
            int* heads = Scratch.Heads.GetUnsafePtr();
            UnsafeUtility.MemSet(heads, 0xFF, (long)sizeof(int) << bits);
            var grid = new PoissonGrid(heads, bits, cell);
            var samples = Scratch.Samples.GetUnsafePtr();
            for (int s = 0; s < taken; s++)
            {
                // Tops of chunks may be finer than what is sampled beside them.
                if (Nodes[m_nodeOfPoint[samples[s].Point]].CellLog2 < cell)
                    continue;
                int slot = grid.SlotOf(samples[s].X >> cell + 1, samples[s].Y >> cell + 1, samples[s].Z >> cell + 1);
                samples[s].Next = heads[slot];
                heads[slot] = s;
            }
            m_budget -= taken + ((1L << bits) >> 4);

            int* next = PointsOfClass(cell);
            int sum = 0;
            for (int c = 0; c < PoissonPriority.Classes; c++)
            {
                int with = next[c];
                next[c] = sum;
                sum += with;
            }
            Scratch.Darts.ResizeUninitialized(sum);
            m_now.Stage = Stage.Queue;
            m_now.At = Scratch.FirstRange[cell];
        }

        /// <summary>The points of one range join their classes: darts of a class follow the Morton curve.</summary>
        void QueueRange()
        {
            var range = Scratch.Ranges[m_now.At];
            var priority = (uint*)Priority.GetUnsafeReadOnlyPtr();
            var darts = Scratch.Darts.GetUnsafePtr();
            int* next = PointsOfClass(m_now.CellLog2);
            for (int i = range.First; i < range.End; i++)
            {
                if (m_nodeOfPoint[i] >= 0)
                    continue;
                int at = next[PoissonPriority.ClassOf(priority[i])]++;
                darts[at].Point = i;
                if (RootSideLog2 > 32)
                    continue;
                var place = PlaceAt(i);
                darts[at].X = (uint)place.X;
                darts[at].Y = (uint)place.Y;
                darts[at].Z = (uint)place.Z;
            }
            m_budget -= range.End - range.First;
            m_now.At = range.Next;
            if (m_now.At >= 0)
                return;
            UnsafeUtility.MemClear(next, PoissonPriority.Classes * sizeof(int));
            m_now.Stage = Stage.Throw;
            m_now.At = 0;
        }

        void Throw()
        {
            var darts = Scratch.Darts.GetUnsafePtr();
            var ranges = Scratch.Ranges.GetUnsafePtr();
            var samples = Scratch.Samples.GetUnsafePtr();
            int* keeper = Scratch.KeeperOfRun.GetUnsafePtr();
            var grid = new PoissonGrid(Scratch.Heads.GetUnsafePtr(), math.tzcnt(Scratch.Heads.Length), m_now.CellLog2);
            bool isWide = RootSideLog2 > 32;
            int taken = Scratch.Samples.Length;
            int end = (int)math.min(Scratch.Darts.Length, m_now.At + m_budget);
            for (int d = m_now.At; d < end; d++)
            {
                int point = darts[d].Point;
                var sample = isWide
                    ? SampleAt(point)
                    : new PoissonSample { X = darts[d].X, Y = darts[d].Y, Z = darts[d].Z, Point = point };
                // What kept off one point keeps off most of its neighbours on the curve.
                int found = keeper[point >> RunLog2];
                if (found >= 0 && grid.IsNear(samples + found, sample, out _))
                    continue;
                found = grid.Find(samples, sample, out int slot);
                if (found >= 0)
                {
                    keeper[point >> RunLog2] = found;
                    continue;
                }
                int range = CodeOf(m_nodeOfPoint[point]);
                if (ranges[range].Count == Sizes.MaxPointsPerNode)
                    continue;
                ranges[range].Count++;
                sample.Next = grid.Heads[slot];
                grid.Heads[slot] = taken;
                keeper[point >> RunLog2] = taken++;
                Scratch.Samples.Add(sample);
                samples = Scratch.Samples.GetUnsafePtr();
            }
            m_budget -= end - m_now.At;
            m_now.At = end;
            if (end == Scratch.Darts.Length)
                m_now.Stage = Stage.MakeNodes;
        }

        /// <summary>Numbers in the order of the ranges, whatever the order their points were taken in.</summary>
        void MakeNodes()
        {
            var ranges = Scratch.Ranges.GetUnsafePtr();
            int first = Scratch.FirstRange[m_now.CellLog2];
            var drafting = Drafting;
            for (int r = first; r >= 0; r = ranges[r].Next)
                ranges[r].Parent = drafting.AddSampled(ranges[r]);
            var samples = Scratch.Samples.GetUnsafePtr();
            for (int s = m_now.FirstSample; s < Scratch.Samples.Length; s++)
                m_nodeOfPoint[samples[s].Point] = ranges[CodeOf(m_nodeOfPoint[samples[s].Point])].Parent;
            m_budget -= Scratch.Samples.Length - m_now.FirstSample;
            Scratch.FirstRange[m_now.CellLog2] = Scratch.LastRange[m_now.CellLog2] = -1;
            m_now.Stage = Averaged.IsOn ? Stage.Average : Stage.Split;
            m_now.FirstAverage = Averaged.Averages.Length;
            m_now.FirstRange = m_now.At = first;
            if (Averaged.IsOn)
                Averaged.Averages.Resize(m_now.FirstAverage + Scratch.Samples.Length - m_now.FirstSample,
                    NativeArrayOptions.ClearMemory);
        }

        /// <summary>Each point of a range adds to the new sample that is nearest to it, unless one of a wider spacing is
        /// nearer.</summary>
        void AverageRange()
        {
            var range = Scratch.Ranges[m_now.At];
            var samples = Scratch.Samples.GetUnsafePtr();
            var averages = Averaged.Averages.GetUnsafePtr() + m_now.FirstAverage;
            var records = (byte*)Records.GetUnsafeReadOnlyPtr();
            var grid = new PoissonGrid(Scratch.Heads.GetUnsafePtr(), math.tzcnt(Scratch.Heads.Length), m_now.CellLog2);
            for (int i = range.First; i < range.End; i++)
            {
                if (m_nodeOfPoint[i] >= 0 && (range.Count == 0 || m_nodeOfPoint[i] != range.Parent))
                    continue;
                int nearest = grid.Nearest(samples, SampleAt(i)) - m_now.FirstSample;
                if (nearest < 0)
                    continue;
                var own = Averaged.Of(i, records + (long)i * Layout.StrideBytes, Layout);
                averages[nearest].Points += own.Points;
                averages[nearest].Sum += own.Sum;
            }
            m_budget -= 4L * (range.End - range.First);
            m_now.At = range.Next;
            if (m_now.At >= 0)
                return;
            for (int s = m_now.FirstSample; s < Scratch.Samples.Length; s++)
                Averaged.AverageOfPoint[samples[s].Point] = m_now.FirstAverage + s - m_now.FirstSample;
            m_now.Stage = Stage.Split;
            m_now.At = m_now.FirstRange;
        }

        void Split()
        {
            var range = Scratch.Ranges[m_now.At];
            var drafting = Drafting;
            for (int first = range.First; first < range.End;)
            {
                int end = drafting.EndOfPart(range, first);
                Visit(new SampledRange { First = first, End = end, Parent = range.Parent, SideLog2 = (byte)(range.SideLog2 - 1) });
                first = end;
            }
            m_now.At = range.Next;
            if (m_now.At < 0)
                m_now.Stage = Stage.NextSpacing;
        }
    }
}
