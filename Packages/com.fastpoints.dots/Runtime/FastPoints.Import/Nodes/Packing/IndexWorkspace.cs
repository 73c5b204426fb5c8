using System;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Nodes
{
    /// <summary>The working memory of chunks that become nodes one after another: the jobs of one workspace never
    /// overlap. It has the size that its largest chunk needs.</summary>
    internal sealed class IndexWorkspace : IDisposable
    {
        readonly int m_strideBytes;
        readonly bool m_hasAverages;
        int m_capacity;

        internal OrderScratch Ordering;
        internal NativeArray<uint> Numbers;
        internal NativeArray<byte> Sorted;
        internal NativeArray<byte> Common;
        internal NativeArray<uint> Priority;
        internal NativeArray<int> NodeOfPoint;
        internal NativeArray<int> AverageOfPoint;
        internal NativeList<AverageSums> AverageSums;
        internal WriteScratch Writing;
        internal SampleScratch Sampling;

        public IndexWorkspace(RecordLayout records, NativeStoreLayout store)
        {
            m_strideBytes = records.StrideBytes;
            m_hasAverages = store.HasAverages;
            Ordering = new OrderScratch(Allocator.Persistent);
            Sampling = new SampleScratch(Allocator.Persistent);
            Writing = new WriteScratch(Allocator.Persistent);
            AverageSums = new NativeList<AverageSums>(16, Allocator.Persistent);
        }

        public JobHandle Last { get; internal set; }

        public long Points { get; set; }

        /// <summary>Reserves memory for chunks of this many points. Waits for the jobs so far if there is too little: the largest
        /// comes first.</summary>
        public void Reserve(int count)
        {
            if (count <= m_capacity && Numbers.IsCreated)
                return;
            Last.Complete();
            FreePoints();
            m_capacity = Math.Max(1, count);
            const NativeArrayOptions raw = NativeArrayOptions.UninitializedMemory;
            Numbers = new NativeArray<uint>(m_capacity, Allocator.Persistent, raw);
            Sorted = new NativeArray<byte>(checked(m_capacity * m_strideBytes), Allocator.Persistent, raw);
            Common = new NativeArray<byte>(m_capacity, Allocator.Persistent, raw);
            Priority = new NativeArray<uint>(m_capacity, Allocator.Persistent, raw);
            NodeOfPoint = new NativeArray<int>(m_capacity, Allocator.Persistent, raw);
            AverageOfPoint = new NativeArray<int>(m_hasAverages ? m_capacity : 0, Allocator.Persistent, raw);
        }

        public JobHandle Begin(int count, JobHandle ready)
        {
            Reserve(count);
            return new ResetWorkspaceJob
            {
                Ordering = Ordering.Progress,
                Sampling = Sampling.Progress,
                Writing = Writing.Progress,
            }.Schedule(JobHandle.CombineDependencies(ready, Last));
        }

        public void Dispose()
        {
            Last.Complete();
            if (!AverageSums.IsCreated)
                return;
            FreePoints();
            Ordering.Dispose();
            AverageSums.Dispose();
            Writing.Dispose();
            Sampling.Dispose();
        }

        void FreePoints()
        {
            if (!Numbers.IsCreated)
                return;
            Numbers.Dispose();
            Sorted.Dispose();
            Common.Dispose();
            Priority.Dispose();
            NodeOfPoint.Dispose();
            AverageOfPoint.Dispose();
        }

        [BurstCompile]
        struct ResetWorkspaceJob : IJob
        {
            public NativeReference<OrderScratch.State> Ordering;
            public NativeReference<SampleScratch.State> Sampling;
            public NativeReference<WriteScratch.State> Writing;

            public void Execute()
            {
                Ordering.Value = default;
                Sampling.Value = default;
                Writing.Value = default;
            }
        }
    }

    /// <summary>The progress of a <see cref="WriteNodesJob"/> between two slices, and its working memory.</summary>
    internal struct WriteScratch : IDisposable
    {
        public enum Stage
        {
            Start,
            SortPoints,
            Plan,
            Write,
            Append,
            Done,
        }

        public struct State
        {
            public Stage Stage;

            public int At; // The next point, node or byte, and the node's next plane.
            public int Plane;
            public int NodeCount;

            /// <summary>For the current node: whether any of its points represents others, and the next averaged
            /// column.</summary>
            public bool HasAverages;
            public int AveragedColumn;
        }

        public NativeReference<State> Progress;

        public NativeList<int> FirstPointOfDraft;

        public NativeList<int> DraftOfNode;
        public NativeList<int> FirstChild;
        public NativeList<int> ChildCount;

        public NativeList<NodeRecord> Nodes;
        public NativeList<PlaneRange> Ranges;
        public NativeList<byte> Behind; // The planes that lie behind those of position and colour, until these are written.

        public WriteScratch(Allocator allocator)
        {
            Progress = new NativeReference<State>(allocator);
            FirstPointOfDraft = new NativeList<int>(64, allocator);
            DraftOfNode = new NativeList<int>(64, allocator);
            FirstChild = new NativeList<int>(64, allocator);
            ChildCount = new NativeList<int>(64, allocator);
            Nodes = new NativeList<NodeRecord>(64, allocator);
            Ranges = new NativeList<PlaneRange>(64, allocator);
            Behind = new NativeList<byte>(64, allocator);
        }

        public bool IsDone => Progress.Value.Stage == Stage.Done;

        public void Dispose()
        {
            if (!Progress.IsCreated)
                return;
            Progress.Dispose();
            FirstPointOfDraft.Dispose();
            DraftOfNode.Dispose();
            FirstChild.Dispose();
            ChildCount.Dispose();
            Nodes.Dispose();
            Ranges.Dispose();
            Behind.Dispose();
        }
    }

    /// <summary>The progress of an <see cref="OrderChunkJob"/> between two slices, and its working memory.</summary>
    internal struct OrderScratch : IDisposable
    {
        const int KeptPoints = 1 << 16; // Most buckets have fewer points: memory for more is freed.

        public enum Stage
        {
            Start,
            Touch,
            Count,
            Distribute,
            Keys,
            Sort,
            Emit,
            Done,
        }

        public unsafe struct State
        {
            public Stage Stage;

            [NativeDisableUnsafePtrRestriction] public RecordPages.Page* Page;
            public int Bucket;
            public int Point;

            public long Touched; // Bytes of the ordered records whose pages are touched.

            public ulong AnyBits; // Bits that any of the bucket's keys has, and those that all have.
            public ulong CommonBits;

            public bool IsSwapped; // Which half of the keys is sorted.
        }

        public NativeReference<State> Progress;
        public NativeArray<int> FirstOfBucket; // First record of each bucket, with one more entry.
        public NativeList<ulong> Keys; // Keys of the current bucket, twice, and its records.
        public NativeList<byte> Bucket;

        public OrderScratch(Allocator allocator)
        {
            Progress = new NativeReference<State>(allocator);
            FirstOfBucket = new NativeArray<int>(OrderChunkJob.MaxBuckets + 1, allocator);
            Keys = new NativeList<ulong>(64, allocator);
            Bucket = new NativeList<byte>(64, allocator);
        }

        public bool IsDone => Progress.Value.Stage == Stage.Done;

        public void Reserve(int points, int strideBytes)
        {
            if (Keys.Length < 2 * points)
                Keys.ResizeUninitialized(2 * points);
            if (Bucket.Length < points * strideBytes)
                Bucket.ResizeUninitialized(points * strideBytes);
        }

        /// <summary>Frees the memory of an unusual bucket before the chunk's nodes need theirs.</summary>
        public void Trim()
        {
            if (Keys.Length <= 2 * KeptPoints)
                return;
            Keys.Clear();
            Keys.SetCapacity(64);
            Bucket.Clear();
            Bucket.SetCapacity(64);
        }

        public void Dispose()
        {
            if (!Progress.IsCreated)
                return;
            Progress.Dispose();
            FirstOfBucket.Dispose();
            Keys.Dispose();
            Bucket.Dispose();
        }
    }

    internal unsafe struct SampleScratch : IDisposable
    {
        public enum Stage
        {
            Start,
            Plan,
            Fill,
            NextSpacing,
            ChooseCells,
            Gather,
            Throw,
            Exclude,
            Average,
            Count,
            Renumber,
            Done,
        }

        public struct State
        {
            public Stage Stage;

            public int Range;
            public int Point;

            /// <summary>While ranges are planned: log2 of the side of the smallest cube with the points so far, and where its
            /// octants end.</summary>
            public int SideLog2;
            public int Ends;
            public fixed int EndOfOctant[8];

            public int CellLog2; // log2 of the spacing.

            public int Child; // The part whose candidates are read, the next of them, and how many the range has taken.
            public int Candidate;
            public int Taken;

            public bool IsFixing; // While chunks' tops are put into the grid before anything is sampled.

            /// <summary>The current tile, whether it and its neighbours have no samples, the number of its darts, and
            /// the next to throw.</summary>
            public Grid3 Tile;
            public bool IsEmpty;
            public int Darts;
            public int Dart;

            public bool HasTile; // While points are compared with samples, without darts: whether a tile has begun.

            public long Best; // The best candidate of the current cell: its rank.
        }

        public NativeReference<State> Progress;
        public NativeList<SampledCube> Ranges;

        /// <summary>While ranges are planned: how many neighbours have a cube of each side in common, in four tables
        /// used in turn, so that no count depends on the previous one.</summary>
        public NativeArray<int> Counts;
        public NativeList<int> Offered; // From a range's first index on: the points that it offers to the range above, in order.

        /// <summary>For the random sampler: for each of these, log2 of the side of the smallest cube with the previous
        /// one.</summary>
        public NativeList<byte> OfferedCommon;

        /// <summary>The darts of the current tile along the curve, their points, and the order in which they are
        /// thrown.</summary>
        public NativeList<ulong> Darts;
        public NativeList<int> PointOfDart;
        public NativeList<int> Order;
        public DartGrid Grid;

        public SampleScratch(Allocator allocator)
        {
            Progress = new NativeReference<State>(allocator);
            Ranges = new NativeList<SampledCube>(64, allocator);
            Counts = new NativeArray<int>(SampleNodesJob.CountTables * SampleNodesJob.CountsOfTable, allocator);
            Offered = new NativeList<int>(64, allocator);
            OfferedCommon = new NativeList<byte>(64, allocator);
            Darts = new NativeList<ulong>(64, allocator);
            PointOfDart = new NativeList<int>(64, allocator);
            Order = new NativeList<int>(64, allocator);
            Grid = new DartGrid(allocator);
        }

        public bool IsDone => Progress.Value.Stage == Stage.Done;

        public void Dispose()
        {
            if (!Progress.IsCreated)
                return;
            Progress.Dispose();
            Ranges.Dispose();
            Counts.Dispose();
            Offered.Dispose();
            OfferedCommon.Dispose();
            Darts.Dispose();
            PointOfDart.Dispose();
            Order.Dispose();
            Grid.Dispose();
        }
    }

    internal enum SampledCubeKind : byte
    {
        Leaf, // All points that no node above takes are one node.

        Sampled, // A node takes some of what the parts offer, and offers these to the range above.

        Passed, // The spacing would be no finer than that above: the parts' samples are passed on to it.

        Chain, // All points are at one position: a chain of nodes, which offers one of them.

        Top,
    }

    /// <summary>The points of one cube while a sampler works on them: a range of the ordered points. Blittable.</summary>
    internal struct SampledCube
    {
        public int First;
        public int End;
        public int Parent; // The nearest range above that is sampled, or -1.
        public int FirstChild;
        public int ChildCount;

        /// <summary>How many points it offers; negative for all of them. In the end, how many of a chain's points have their
        /// node.</summary>
        public int Offered;
        public int Count; // The node's points, and its draft; without points, that of the range above.
        public int Node;
        public byte SideLog2; // At first any cube with the points; then the smallest of the octree.
        public byte CellLog2; // log2 of the edge of the sampling cells: the spacing.
        public SampledCubeKind Kind;

        public readonly bool OffersAll => Offered < 0;
        public readonly int OfferedCount => Offered < 0 ? End - First : Offered;
    }
}
