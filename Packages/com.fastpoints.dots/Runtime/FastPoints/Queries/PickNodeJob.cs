using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // Finds the first hits of a query among the points of one node and its inlined leaves, at most a few times 50,000, block by
    // block. It checks what was read before unpacking it.
    [BurstCompile]
    internal unsafe struct PickNodeJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Positions; // The position plane as read; PositionShape and PositionHash describe it.
        public PlaneShape PositionShape;
        public ulong PositionHash;

        // The plane of classes if some are Hidden; otherwise undefined.
        [ReadOnly] public NativeArray<byte> Classes;
        public PlaneShape ClassShape;
        public ulong ClassHash;
        public ClassMask Hidden;

        // The plane of normals if hits have some; otherwise undefined. They are unknown where it is damaged.
        [ReadOnly] public NativeArray<byte> Normals;
        public PlaneShape NormalShape;
        public ulong NormalHash;
        public bool HasNormals;
        public int BlockCount;
        public bool IsTranscoded; // Made in memory, so that there are no hashes.

        public QuerySpace Space;
        public BlockFilter Filter;
        [ReadOnly] public NativeArray<LocalClip> Clips;
        public double3 Step; // CRS units.
        public Grid3 RootCorner;
        public NodeAddress Address;
        public int Cloud;
        public int Page;
        public int Node;

        // The hit that others must come before, unless all are counted.
        public PickHit Bound;
        public bool CountsAll;
        [WriteOnly] public NativeArray<PickHit> Hits; // Room for as many as are wanted.
        public NativeReference<HitTotals> Totals;
        public NativeReference<bool> IsDamaged;

        public void Execute()
        {
            var search = new NodeSearch
            {
                Space = Space,
                Filter = Filter,
                Positions = View(Positions, PositionShape, PositionHash, out bool isValid),
                Step = Step,
                RootCorner = RootCorner,
                Corner = Address.Corner,
                Cloud = Cloud,
                Page = Page,
                Node = Node,
                Hidden = Hidden,
                Clips = (LocalClip*)Clips.GetUnsafeReadOnlyPtr(),
                ClipCount = Clips.Length,
            };
            if (!Hidden.IsEmpty && isValid)
                search.Classes = View(Classes, ClassShape, ClassHash, out isValid);
            var normals = HasNormals ? View(Normals, NormalShape, NormalHash, out HasNormals) : default;
            search.Normals = HasNormals ? normals : default;
            IsDamaged.Value = !isValid;
            Totals.Value = default;
            if (!isValid)
                return;
            var hits = new HitHeap((PickHit*)Hits.GetUnsafePtr(), Hits.Length, CountsAll, Bound);
            ulong* scratch = stackalloc ulong[NodeSearch.ScratchCount];
            for (int block = 0; block < BlockCount; block++)
                if (Space.Intersects(search.BoxOf(block, out var half), half, out double distance) && distance <= hits.Limit)
                    search.Search(block, 0, search.Positions.PointsOf(block), scratch, ref hits);
            Totals.Value = hits.Totals;
        }

        PlaneView View(NativeArray<byte> bytes, PlaneShape shape, ulong hash, out bool isValid)
        {
            void* start = bytes.GetUnsafeReadOnlyPtr();
            isValid = (IsTranscoded || ContentHash.Of(start, bytes.Length) == hash) &&
                PlaneView.IsValid(start, bytes.Length, shape, BlockCount);
            return new PlaneView(start, shape, BlockCount);
        }
    }
}
