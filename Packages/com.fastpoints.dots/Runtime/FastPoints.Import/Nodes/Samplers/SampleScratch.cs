using System;
using FastPoints.Core;
using Unity.Collections;

namespace FastPoints.Nodes
{
    /// <summary>The progress of a <see cref="SampleNodesJob"/> between two slices, and its working memory, which is reused for
    /// the next chunk.</summary>
    internal unsafe struct SampleScratch : IDisposable
    {
        /// <summary>What the next slice continues.</summary>
        public enum Stage
        {
            Start,
            Plan,
            Fill,
            NextSpacing,
            ChooseCells,
            Gather,
            Throw,
            Bar,
            Average,
            Count,
            Renumber,
            Done,
        }

        /// <summary>The progress of the sampler.</summary>
        public struct State
        {
            public Stage Stage;

            /// <summary>The current range, and the next of its points.</summary>
            public int Range;
            public int Point;

            /// <summary>While ranges are planned: log2 of the side of the smallest cube with the points so far, and where its
            /// octants end.</summary>
            public int Largest;
            public int Ends;
            public fixed int EndOfPart[8];

            /// <summary>log2 of the spacing.</summary>
            public int Cell;

            /// <summary>The part whose candidates are read, the next of them, and how many the range has taken.</summary>
            public int Part;
            public int Candidate;
            public int Taken;

            /// <summary>While chunks' tops are put into the grid before anything is sampled.</summary>
            public bool IsFixing;

            /// <summary>The current tile, whether no sample is in it or beside it, the number of its darts, and the next to
            /// throw.</summary>
            public Grid3 Tile;
            public bool IsEmpty;
            public int Darts;
            public int Dart;

            /// <summary>The best candidate of the current cell: its priority above its number.</summary>
            public long Best;
        }

        public NativeReference<State> Progress;
        public NativeList<SampledRange> Ranges;

        /// <summary>While ranges are planned: how many neighbours have a cube of each side in common, in four tables that take
        /// turns, so that no count waits for the one before.</summary>
        public NativeArray<int> Counts;

        /// <summary>From a range's first place on: the points that it offers to the range above, in order.</summary>
        public NativeList<int> Offered;

        /// <summary>The random sampler's: for each of these, log2 of the side of the smallest cube with the one before.</summary>
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
            Ranges = new NativeList<SampledRange>(64, allocator);
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

    /// <summary>What becomes of the points of a range.</summary>
    internal enum RangeKind : byte
    {
        /// <summary>All that nothing above takes are one node.</summary>
        Leaf,

        /// <summary>A node takes some of what the parts offer, and offers these to the range above.</summary>
        Sampled,

        /// <summary>The spacing would be no finer than that above: what the parts offer goes on to it.</summary>
        Passed,

        /// <summary>All points are at one place: a chain of nodes, which offers one of them.</summary>
        Chain,

        /// <summary>A chunk's top.</summary>
        Top,
    }

    /// <summary>The points of one cube while a sampler works on them: a range of the ordered points. Blittable.</summary>
    internal struct SampledRange
    {
        public int First;
        public int End;

        /// <summary>The nearest range above that is sampled, or -1.</summary>
        public int Parent;
        public int FirstPart;
        public int PartCount;

        /// <summary>How many points it offers; negative for all of them. In the end, how many of a chain's points have their
        /// node.</summary>
        public int Offered;

        /// <summary>The node's points, and its draft; without points, that of the range above.</summary>
        public int Count;
        public int Node;

        /// <summary>At first any cube with the points; then the smallest of the octree.</summary>
        public byte SideLog2;

        /// <summary>log2 of the edge of the sampling cells: the spacing.</summary>
        public byte CellLog2;
        public RangeKind Kind;

        public readonly bool OffersAll => Offered < 0;
        public readonly int OfferedCount => Offered < 0 ? End - First : Offered;
    }
}
