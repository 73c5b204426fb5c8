using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    // Finds the points of one node's blocks that a query asks for: the same arithmetic for what is in memory and what was read.
    internal unsafe struct NodeSearch
    {
        public const int ScratchCount = 3 * PlaneShape.MaxPointsPerBlock; // Values that Search needs room for with a whole block.
        const int MaxNarrowWidth = 31; // Of offsets that are int, too.

        public QuerySpace Space;
        public BlockFilter Filter; // Undefined without one.
        public PlaneView Positions;
        public PlaneView Normals; // No words if hits need none.
        public double3 Step; // CRS units.
        public Grid3 RootCorner;
        public Grid3 Corner; // Of the node, from the root's.
        public int Cloud;
        public int Page;
        public int Node;

        // Points of these classes, which have a plane if there are any, and outside of these boxes do not exist.
        public ClassMask Hidden;
        public PlaneView Classes;
        public LocalClip* Clips;
        public int ClipCount;

        // Of the runs that are searched one after the other many are of one block.
        uint* m_words;
        SearchedBlock m_block;

        // The box that the columns' minima and widths allow: its centre in CRS units from the root's corner.
        public readonly double3 BoxOf(int block, out double3 half)
        {
            half = (math.exp2((double3)WidthsOf(block)) - 1) * 0.5 * Step;
            return ToDouble(CornerOf(block, out _)) * Step + half;
        }

        public void Search(int block, int first, int count, ulong* scratch, ref HitHeap hits)
        {
            int stride = (count + EightBoxes.Count - 1) & -EightBoxes.Count;
            if (Positions.Words != m_words || block != m_block.Index)
                Begin(block, hits.Limit);
            if (m_block.IsWide)
            {
                for (int axis = 0; axis < 3; axis++)
                    Positions.UnpackWide(block, axis, first, count, scratch + axis * stride);
                for (int i = 0; i < count; i++)
                {
                    var position = new Grid3((long)scratch[i], (long)scratch[stride + i], (long)scratch[2 * stride + i]);
                    Test(position - m_block.Min, first + i, ref hits);
                }
                return;
            }
            uint* x = (uint*)scratch, y = x + stride, z = y + stride;
            Positions.UnpackOffsets(block, first, count, x, stride);
            for (int i = 0; i < count; i += EightBoxes.Count)
            {
                uint held = 0xFFu >> math.max(0, i + EightBoxes.Count - count);
                if (Filter.IsUsed)
                    held &= (uint)Filter.MayHold(x + i, y + i, z + i);
                for (; held != 0; held &= held - 1)
                {
                    int n = i + math.tzcnt(held);
                    Test(new Grid3(x[n], y[n], z[n]), first + n, ref hits);
                }
            }
        }

        // The corner's position is computed in full, and offsets from it in the cloud's own units: nothing is lost far from the
        // origin.
        void Begin(int block, double limit)
        {
            m_words = Positions.Words;
            var corner = CornerOf(block, out var min);
            m_block = new SearchedBlock { Index = block, Min = min, Corner = corner, Local = ToDouble(corner) * Step };
            m_block.FromOriginWorld = Space.RelativeToOrigin(m_block.Local);
            m_block.IsWide = math.cmax(WidthsOf(block)) > MaxNarrowWidth;
            if (Filter.IsUsed)
            {
                var extent = new float3(ExtentOf(block, 0), ExtentOf(block, 1), ExtentOf(block, 2));
                Filter.Begin(m_block.FromOriginWorld, extent, limit);
            }
        }

        readonly int3 WidthsOf(int block) =>
            new int3(Positions.WidthOf(block, 0), Positions.WidthOf(block, 1), Positions.WidthOf(block, 2));

        readonly void Test(Grid3 steps, int index, ref HitHeap hits)
        {
            var offset = ToDouble(steps) * Step;
            var fromOrigin = m_block.FromOriginWorld + Space.ToWorldVector(offset);
            if (!Space.Holds(fromOrigin, out double distance, out double rayDistanceSq) || distance > hits.Limit)
                return;
            if (!Hidden.IsEmpty && Hidden.Has((byte)Classes.ValueAt(m_block.Index, 0, index)) ||
                ClipCount > 0 && !LocalClip.MayKeep(Clips, ClipCount, m_block.Local + offset, 0))
                return;
            hits.Add(new PickHit
            {
                Distance = distance,
                RayDistanceSq = rayDistanceSq,
                Position = RootCorner + m_block.Corner + steps,
                Cloud = Cloud,
                Page = Page,
                Node = Node,
                Block = m_block.Index,
                Index = index,
                Normal = NormalAt(Normals, m_block.Index, index),
            });
        }

        // None of a plane without words.
        public static ushort NormalAt(in PlaneView normals, int block, int index) => normals.Words == null
            ? OctahedralNormal.None : (ushort)(normals.ValueAt(block, 0, index) | normals.ValueAt(block, 1, index) << 8);

        // In steps, at most.
        readonly float ExtentOf(int block, int axis) => math.asfloat((127u + (uint)Positions.WidthOf(block, axis)) << 23);

        // Of the smallest position that a block's columns can have, from the root's corner.
        readonly Grid3 CornerOf(int block, out Grid3 min)
        {
            min = new Grid3((long)Positions.MinimumOf(block, 0), (long)Positions.MinimumOf(block, 1),
                (long)Positions.MinimumOf(block, 2));
            return Corner + min;
        }

        static double3 ToDouble(Grid3 position) => new double3(position.X, position.Y, position.Z);

        struct SearchedBlock
        {
            public int Index;
            public bool IsWide;
            public Grid3 Min; // From the node's corner.
            public Grid3 Corner; // From the root's.
            public double3 Local;
            public double3 FromOriginWorld;
        }
    }
}
