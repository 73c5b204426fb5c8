using FastPoints.Core;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // The cloud's grid is the source's own: its whole numbers stay the same. Blittable, for jobs.
    internal struct TreeGrid
    {
        public CloudGrid Grid;

        // From stored numbers to the grid's.
        public SourceGrid Source;

        // The smallest cube with a power-of-two side that contains the source's.
        public GridCube Root;

        // Packed positions count from it in all nodes: no number that the source can hold lies below it. A block has its own
        // minimum, so this costs nothing.
        public Grid3 Corner;

        // Packed positions have 64 bits.
        public bool IsWide;

        // Georeferenced.
        public double3 CubeMin;
        public double3 CubeSize;

        // As the source claims, georeferenced; the cube if it claims none.
        public BoundsGeo Bounds;

        // Of the root, in CRS units.
        public double Spacing;

        // Unsupported if no grid holds the source's numbers.
        public TreeGrid(SourceInfo info, SourceTree tree)
        {
            var cube = tree.Cube;
            CubeMin = cube.Min;
            CubeSize = cube.Size;
            Spacing = tree.Spacing;
            Bounds = info.HasBoundsClaimed && info.BoundsClaimed.IsFinite ? info.BoundsClaimed : cube;

            // Floats get steps that 31 bits of the cube have room for.
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
            if (!(math.cmax(math.abs(first)) < SourceGrid.Limit) || !(math.cmax(steps) < SourceGrid.Limit))
                throw PointCloudException.Wanted(FailureCode.Unsupported, info.Path, -1, "the octree's cube",
                    "less than 2^60 steps", math.cmax(steps));
            var corner = new Grid3((long)first.x, (long)first.y, (long)first.z);
            Root = new GridCube(corner, math.max(1, BitsFor(math.cmax(steps))));
            IsWide = choice.Records.IsWide && math.cmax(steps) * 1.5 >= uint.MaxValue;
            long margin = Root.Side / 4;
            Corner = choice.Records.IsWide ? corner - new Grid3(margin, margin, margin) : choice.Records.Base;
        }

        public NodeCubes Cubes => new NodeCubes { Corner = CubeMin - Grid.ToGeo(Root.Corner), Size = CubeSize };

        // Around a node's points and all below: from the corner of the root cube, in CRS units.
        public void BoxOf(int4 key, out double3 center, out float3 half)
        {
            double3 size = SizeOf(key.w), min = MinOf(key), max = min + size;
            double3 low = math.max(min, Bounds.Min), high = math.min(max, Bounds.Max);
            // A claim that leaves nothing of the node is ignored.
            bool isEmpty = math.any(low > high);
            var origin = Grid.ToGeo(Root.Corner);
            HierarchyGrid.Box((isEmpty ? min : low) - Grid.Step - origin, (isEmpty ? max : high) + Grid.Step - origin, out center,
                out half);
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
}
