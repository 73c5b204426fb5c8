using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Picking
{
    // Finds the first hit of a ray among the points of one node and its inlined leaves, at most a few times 50,000, block by
    // block. It checks what was read before unpacking it.
    [BurstCompile]
    internal unsafe struct PickNodeJob : IJob
    {
        /// <summary>Shape of the position plane.</summary>
        [ReadOnly] public NativeArray<byte> Positions;
        public PlaneShape PositionShape;
        public ulong PositionHash;

        // The plane of classes if some are Hidden; otherwise undefined.
        [ReadOnly] public NativeArray<byte> Classes;
        public PlaneShape ClassShape;
        public ulong ClassHash;
        public ClassMask Hidden;
        public int BlockCount;
        public bool IsTranscoded; // Made in memory, so that there are no hashes.

        public PickSpace Space;
        [ReadOnly] public NativeArray<LocalClip> Clips;
        public double3 Step; // CRS units.
        public Grid3 RootCorner;
        public NodeAddress Address;
        public int Page;
        public int Node;

        // In: the limit that a hit must beat. Out: the first hit, or the unchanged limit.
        public NativeReference<PickHit> Best;
        public NativeReference<bool> IsDamaged;

        public void Execute()
        {
            bool hides = !Hidden.IsEmpty;
            var positions = View(Positions, PositionShape, PositionHash, out bool isValid);
            var classes = hides && isValid ? View(Classes, ClassShape, ClassHash, out isValid) : default;
            IsDamaged.Value = !isValid;
            if (!isValid)
                return;
            var best = Best.Value;
            ulong* values = stackalloc ulong[3 * PlaneShape.MaxPointsPerBlock];
            for (int block = 0; block < BlockCount; block++)
                if (Space.IntersectsBox(BoxOf(positions, block, out var half), half, out double distance) &&
                    distance <= best.Distance)
                    Search(positions, classes, block, values, ref best);
            Best.Value = best;
        }

        PlaneView View(NativeArray<byte> bytes, PlaneShape shape, ulong hash, out bool isValid)
        {
            void* start = bytes.GetUnsafeReadOnlyPtr();
            isValid = (IsTranscoded || ContentHash.Of(start, bytes.Length) == hash) &&
                PlaneView.IsValid(start, bytes.Length, shape, BlockCount);
            return new PlaneView(start, shape, BlockCount);
        }

        // The centre of the box that the columns' minima and widths allow, in CRS units from the root's corner.
        double3 BoxOf(in PlaneView positions, int block, out double3 half)
        {
            var min = new double3(positions.MinimumOf(block, 0), positions.MinimumOf(block, 1), positions.MinimumOf(block, 2));
            var widths = new double3(positions.WidthOf(block, 0), positions.WidthOf(block, 1), positions.WidthOf(block, 2));
            half = (math.exp2(widths) - 1) * 0.5 * Step;
            return (ToDouble(Address.Corner) + min) * Step + half;
        }

        void Search(in PlaneView positions, in PlaneView classes, int block, ulong* values, ref PickHit best)
        {
            const int stride = PlaneShape.MaxPointsPerBlock;
            int count = positions.PointsOf(block);
            for (int axis = 0; axis < 3; axis++)
                positions.UnpackWide(block, axis, values + axis * stride);
            ulong minX = positions.MinimumOf(block, 0), minY = positions.MinimumOf(block, 1);
            ulong minZ = positions.MinimumOf(block, 2);
            var clips = (LocalClip*)Clips.GetUnsafeReadOnlyPtr();
            // The corner's position is computed in full, and offsets from it in the cloud's own units: nothing is lost far from
            // the origin.
            var corner = Address.Corner + new Grid3((long)minX, (long)minY, (long)minZ);
            var cornerLocal = ToDouble(corner) * Step;
            var fromRay = Space.FromRay(cornerLocal);
            for (int i = 0; i < count; i++)
            {
                var steps = new Grid3((long)(values[i] - minX), (long)(values[stride + i] - minY),
                    (long)(values[2 * stride + i] - minZ));
                var offset = ToDouble(steps) * Step;
                if (!Space.IntersectsPoint(fromRay + Space.Rotate(offset), out double distance, out double rayDistanceSq) ||
                    distance > best.Distance)
                    continue;
                var hit = new PickHit
                {
                    Distance = distance,
                    RayDistanceSq = rayDistanceSq,
                    Position = RootCorner + corner + steps,
                    Page = Page,
                    Node = Node,
                    Block = block,
                    Index = i,
                };
                if (!hit.IsBefore(best) || (!Hidden.IsEmpty && Hidden.Has((byte)classes.ValueAt(block, 0, i))))
                    continue;
                if (Clips.Length == 0 || LocalClip.MayKeep(clips, Clips.Length, cornerLocal + offset, 0))
                    best = hit;
            }
        }

        static double3 ToDouble(Grid3 position) => new double3(position.X, position.Y, position.Z);
    }

    internal struct PickHit
    {
        public double Distance; // World units along the ray; infinity if nothing was found.
        public double RayDistanceSq;
        public Grid3 Position; // On the cloud's grid.
        public int Page;
        public int Node; // Its planes hold the point.
        public int Block;
        public int Index; // In its block.

        public static PickHit None => new PickHit { Distance = double.PositiveInfinity };

        public readonly bool IsFound => Distance < double.PositiveInfinity;

        // Nearer to the camera, or, at equal distance, nearer to the ray. Ties are decided by position, so that no reading
        // order matters; of several points at one position, the first one wins.
        public readonly bool IsBefore(in PickHit other)
        {
            if (Distance != other.Distance)
                return Distance < other.Distance;
            if (RayDistanceSq != other.RayDistanceSq)
                return RayDistanceSq < other.RayDistanceSq;
            if (Position.X != other.Position.X)
                return Position.X < other.Position.X;
            if (Position.Y != other.Position.Y)
                return Position.Y < other.Position.Y;
            if (Position.Z != other.Position.Z)
                return Position.Z < other.Position.Z;
            if (Page != other.Page)
                return Page < other.Page;
            return Node != other.Node ? Node < other.Node : Block != other.Block ? Block < other.Block : Index < other.Index;
        }
    }
}
