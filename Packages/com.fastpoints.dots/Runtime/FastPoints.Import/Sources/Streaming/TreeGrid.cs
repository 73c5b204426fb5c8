using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // The cloud's grid is the source's own: its whole numbers stay the same. Blittable, for jobs.
    internal struct TreeGrid
    {
        public CloudGrid Grid;
        public SourceToGrid Source;
        public GridCube Root; // The smallest cube with a power-of-two side that contains the source's.

        // Packed positions count from it in all nodes: no number that the source can hold lies below it. A block has its own
        // minimum, so this costs nothing.
        public Grid3 Corner;
        public bool IsWide; // Packed positions have 64 bits.

        // Georeferenced.
        public double3 CubeMin;
        public double3 CubeSize;
        public BoundsGeo Bounds; // As the source claims, georeferenced; the cube if it claims none.
        public double Spacing; // Spacing of the root, in CRS units.

        // Unsupported if no grid holds the source's numbers.
        public TreeGrid(SourceInfo info, SourceTree tree)
        {
            var cube = tree.Cube;
            CubeMin = cube.Min;
            CubeSize = cube.Size;
            Spacing = tree.Spacing;
            Bounds = info.HasBoundsClaimed && info.BoundsClaimed.IsFinite ? info.BoundsClaimed : cube;

            // Floats get steps such that the cube fits 31 bits.
            double3 a = (cube.Min - info.Transform.Offset) / info.Transform.Scale;
            double3 b = (cube.Max - info.Transform.Offset) / info.Transform.Scale;
            var statistics = new SampleStatistics
            {
                Min = math.min(a, b),
                Max = math.max(a, b),
                LowestDigit = new int3(int.MinValue),
            };
            var choice = GridChoice.Choose(new[] { info }, new[] { statistics }, 0);
            Grid = choice.Grid;
            Source = choice.Sources[0];

            double3 first = math.floor((CubeMin - Grid.Origin) / Grid.Step), steps = math.ceil(CubeSize / Grid.Step) + 1;
            if (!(math.cmax(math.abs(first)) < SourceToGrid.Limit) || !(math.cmax(steps) < SourceToGrid.Limit))
                throw PointCloudException.Wanted(FailureCode.Unsupported, info.Path, -1, "the octree's cube",
                    "less than 2^60 steps", math.cmax(steps));
            var corner = new Grid3((long)first.x, (long)first.y, (long)first.z);
            Root = new GridCube(corner, math.max(1, BitsFor(math.cmax(steps))));
            IsWide = choice.RecordLayout.IsWide && math.cmax(steps) * 1.5 >= uint.MaxValue;
            long margin = Root.Side / 4;
            Corner = choice.RecordLayout.IsWide ? corner - new Grid3(margin, margin, margin) : choice.RecordLayout.Base;
        }

        public NodeCubes Cubes => new NodeCubes { Corner = CubeMin - Grid.ToGeo(Root.Corner), Size = CubeSize };

        // Around a node's points and all below: from the corner of the root cube, in CRS units.
        public void BoxOf(int4 key, out double3 center, out float3 half)
        {
            double3 size = SizeOf(key.w), min = MinOf(key), max = min + size;
            double3 low = math.max(min, Bounds.Min), high = math.min(max, Bounds.Max);
            // Claimed bounds outside the node are ignored.
            bool isEmpty = math.any(low > high);
            var origin = Grid.ToGeo(Root.Corner);
            CloudLocalSpace.Box((isEmpty ? min : low) - Grid.Step - origin, (isEmpty ? max : high) + Grid.Step - origin,
                out center, out half);
        }

        // Relative to Corner.
        public Grid3 PositionOf(int4 key)
        {
            var steps = math.floor((MinOf(key) - Grid.Origin) / Grid.Step);
            return new Grid3((long)steps.x, (long)steps.y, (long)steps.z) - Corner;
        }

        // Along each axis, of positions within a node's cube.
        public int3 BitsOf(int level)
        {
            var steps = SizeOf(level) / Grid.Step + 2;
            return new int3(BitsFor(steps.x), BitsFor(steps.y), BitsFor(steps.z));
        }

        public double SpacingOf(int level) => Spacing / math.pow(2.0, level);

        double3 SizeOf(int level) => CubeSize / math.pow(2.0, level);

        double3 MinOf(int4 key) => CubeMin + new double3(key.xyz) * SizeOf(key.w);

        static int BitsFor(double steps) => 64 - math.lzcnt((ulong)math.max(0, steps));
    }

    sealed class TreePlanes : IDisposable
    {
        static readonly string[] s_position = { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };

        readonly StoreLayout m_layout;
        NativeArray<int> m_indices;
        NativeArray<PlaneShape> m_shapes;
        NativeArray<int> m_bits;

        // layout: without the position; names: besides the position's; those that the source lacks are left out.
        public TreePlanes(PointSchema schema, StoreLayout layout, IReadOnlyList<string> names)
        {
            m_layout = layout;
            var wanted = new SortedSet<int> { StoreLayout.PositionPlane };
            foreach (string name in names)
                if (layout.PlaneOf(name) >= 0)
                    wanted.Add(layout.PlaneOf(name));
            var indices = new int[wanted.Count];
            wanted.CopyTo(indices);
            m_indices = new NativeArray<int>(indices, Allocator.Persistent);
            m_bits = new NativeArray<int>(indices.Length, Allocator.Persistent);
            m_shapes = new NativeArray<PlaneShape>(indices.Length, Allocator.Persistent);
            var attributes = new List<string>(s_position);
            for (int p = 0; p < indices.Length; p++)
            {
                var plane = layout.Planes[indices[p]];
                m_shapes[p] = plane.Shape;
                for (int c = plane.FirstColumn; p > 0 && c < plane.FirstColumn + plane.ColumnCount; c++)
                {
                    m_bits[p] += 8 * layout.Columns[c].Type.SizeOf();
                    attributes.Add(layout.Attributes[layout.AttributeOfColumn[c]].Name);
                }
            }
            Decoded = schema.Select(attributes.ToArray());
        }

        public int Count => m_indices.Length;
        public NativeArray<int> Indices => m_indices; // Rising; position is the first.
        public NativeArray<PlaneShape> Shapes => m_shapes; // The position's is that of nodes that are not wide.
        public NativeArray<int> Bits => m_bits; // Bits of a point in each plane. The position's depend on the node.

        public PointSchema Decoded { get; }

        public static StoreLayout LayoutOf(PointSchema schema)
        {
            var attributes = new List<PointAttribute>();
            foreach (var attribute in schema)
                if (Array.IndexOf(s_position, attribute.Name) < 0)
                    attributes.Add(attribute);
            return new StoreLayout(new PointSchema(attributes));
        }

        public string AttributeOf(int plane, int column)
        {
            int of = m_layout.AttributeOfColumn[m_layout.Planes[m_indices[plane]].FirstColumn + column];
            return m_layout.Attributes[of].Name;
        }

        public void Dispose()
        {
            if (!m_indices.IsCreated)
                return;
            m_indices.Dispose();
            m_shapes.Dispose();
            m_bits.Dispose();
        }
    }
}
