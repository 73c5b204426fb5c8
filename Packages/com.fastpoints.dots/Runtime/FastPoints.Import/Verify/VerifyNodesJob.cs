using FastPoints.Points;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Verify
{
    /// <summary>Reads every point of a file's nodes and checks hashes, shapes, cubes, bounds and sums. The table must have been
    /// checked.</summary>
    [BurstCompile]
    internal unsafe struct VerifyNodesJob : IJobParallelFor
    {
        [ReadOnly] public NativeArray<byte> File;
        [ReadOnly] public NativeArray<NodeRecord> Nodes;
        [ReadOnly] public NativeArray<PlaneRange> Planes;
        public int PlaneCount;
        [ReadOnly] public NativeArray<StoredColumn> Columns;
        [ReadOnly] public NativeArray<int> FirstColumnOfPlane;
        [ReadOnly] public NativeArray<PlaneShape> Shapes;

        /// <summary>For each attribute plane, the one whose values it averages, or a negative number.</summary>
        [ReadOnly] public NativeArray<int> AverageOf;
        public int AttributeBytes;
        public double3 Step;

        /// <summary>The origin that <see cref="Sampled"/> counts from.</summary>
        public Grid3 Origin;

        /// <summary>By node: where its points go in <see cref="Sampled"/>; -1 for leaves and points at one place, which have no
        /// spacing.</summary>
        [ReadOnly] public NativeArray<int> FirstSampled;

        /// <summary>Out: positions of the sampled points in CRS units.</summary>
        [NativeDisableParallelForRestriction] public NativeArray<double3> Sampled;

        /// <summary>Indexed by node.</summary>
        [NativeDisableParallelForRestriction] public NativeArray<NodeCheckResult> Results;

        public void Execute(int index)
        {
            if (Nodes[index].Host != index)
                return;
            var verdict = default(NodeCheckResult);
            CheckPlanes(index, ref verdict);
            var node = Nodes[index];
            Results[index] = CheckPoints(index, verdict);
            // Only the host writes its guests' results.
            for (int child = node.FirstChild; child < node.FirstChild + node.ChildCount; child++)
                if (Nodes[child].Host == index)
                    Results[child] = CheckPoints(child, verdict);
        }

        PlaneShape ShapeOf(int plane, bool isWide) => plane == 0 ? new PlaneShape(3, isWide ? 7 : 0) : Shapes[plane - 1];

        PlaneView ViewOf(int host, int plane)
        {
            var node = Nodes[host];
            return new PlaneView((byte*)File.GetUnsafeReadOnlyPtr() + Planes[host * PlaneCount + plane].OffsetBytes,
                ShapeOf(plane, node.IsWide), node.HostedBlocks);
        }

        void CheckPlanes(int index, ref NodeCheckResult verdict)
        {
            var file = (byte*)File.GetUnsafeReadOnlyPtr();
            for (int p = 0; p < PlaneCount && verdict.What == NodeCheckResult.Fault.None; p++)
            {
                var range = Planes[index * PlaneCount + p];
                verdict.Plane = p;
                if (ContentHash.Of(file + range.OffsetBytes, range.LengthBytes) != range.Hash)
                    verdict.What = NodeCheckResult.Fault.PlaneHash;
                else if (!PlaneView.IsSound(file + range.OffsetBytes, range.LengthBytes, ShapeOf(p, Nodes[index].IsWide),
                    Nodes[index].HostedBlocks))
                    verdict.What = NodeCheckResult.Fault.PlaneShape;
            }
        }

        NodeCheckResult CheckPoints(int index, NodeCheckResult verdict)
        {
            if (verdict.What != NodeCheckResult.Fault.None)
                return verdict;
            var node = Nodes[index];
            var host = Nodes[node.Host];
            var points = FirstSampled[index] >= 0 ? (double3*)Sampled.GetUnsafePtr() + FirstSampled[index] : null;
            ulong* places = stackalloc ulong[3 * PlaneShape.MaxPointsPerBlock];
            ulong* values = stackalloc ulong[PlaneShape.MaxPointsPerBlock];
            int recordBytes = RecordHash.PaddedBytes(AttributeBytes);
            var records = (byte*)UnsafeUtility.Malloc(math.max(4, recordBytes) * PlaneShape.MaxPointsPerBlock, 16,
                Allocator.Temp);
            UnsafeUtility.MemClear(records, math.max(4, recordBytes) * PlaneShape.MaxPointsPerBlock);
            var min = new Grid3(long.MaxValue, long.MaxValue, long.MaxValue);
            var max = new Grid3(long.MinValue, long.MinValue, long.MinValue);
            int done = 0;
            int end = node.FirstBlock + node.BlockCount;
            for (int b = node.FirstBlock; b < end && verdict.What == NodeCheckResult.Fault.None; b++)
            {
                var position = ViewOf(node.Host, 0);
                int count = position.PointsOf(b);
                if (count != math.min(PlaneShape.MaxPointsPerBlock, node.PointCount - done))
                {
                    verdict.What = NodeCheckResult.Fault.BlockCounts;
                    verdict.Plane = 0;
                    break;
                }
                for (int c = 0; c < 3; c++)
                    position.UnpackWide(b, c, places + c * PlaneShape.MaxPointsPerBlock);
                LoadAttributes(node.Host, b, count, values, records, recordBytes, ref verdict);
                if (verdict.What != NodeCheckResult.Fault.None)
                    break;
                for (int i = 0; i < count; i++)
                {
                    var place = host.Corner + new Grid3((long)places[i], (long)places[PlaneShape.MaxPointsPerBlock + i],
                        (long)places[2 * PlaneShape.MaxPointsPerBlock + i]);
                    if (!node.Cube.Contains(place))
                    {
                        verdict.What = NodeCheckResult.Fault.OutsideCube;
                        verdict.Plane = 0;
                        break;
                    }
                    var offset = place - node.Corner;
                    min = Grid3.Min(min, offset);
                    max = Grid3.Max(max, offset);
                    if (points != null)
                    {
                        var fromOrigin = place - Origin;
                        points[done + i] = new double3(fromOrigin.X, fromOrigin.Y, fromOrigin.Z) * Step;
                    }
                    verdict.FirstSum += RecordHash.Of(place, records + i * recordBytes, recordBytes, RecordHash.ChecksumSeed);
                    verdict.SecondSum += RecordHash.Of(place, records + i * recordBytes, recordBytes, RecordHash.SecondSeed);
                }
                done += count;
            }
            if (verdict.What == NodeCheckResult.Fault.None)
            {
                int shift = node.BoundsShift;
                if (node.MinX != min.X >> shift || node.MinY != min.Y >> shift || node.MinZ != min.Z >> shift ||
                    node.MaxX != max.X >> shift || node.MaxY != max.Y >> shift || node.MaxZ != max.Z >> shift)
                    verdict.What = NodeCheckResult.Fault.Bounds;
            }
            UnsafeUtility.Free(records, Allocator.Temp);
            return verdict;
        }

        void LoadAttributes(int host, int block, int count, ulong* values, byte* records, int recordBytes,
            ref NodeCheckResult verdict)
        {
            for (int p = 1; p < PlaneCount; p++)
            {
                var plane = ViewOf(host, p);
                verdict.Plane = p;
                if (plane.PointsOf(block) != count)
                {
                    verdict.What = NodeCheckResult.Fault.BlockCounts;
                    return;
                }
                for (int c = 0; c < plane.Shape.ColumnCount; c++)
                {
                    var column = Columns[FirstColumnOfPlane[p - 1] + c];
                    plane.UnpackWide(block, c, values);
                    int bits = column.Type.SizeOf() * 8;
                    for (int i = 0; i < count; i++)
                    {
                        ulong value = values[i] * (ulong)column.Divisor;
                        if (bits < 64 && value >> bits != 0)
                            verdict.What = NodeCheckResult.Fault.Value;
                        // Averages are not part of the point.
                        if (AverageOf[p - 1] < 0)
                            OrderedBits.Store(value, column.Type, records + i * recordBytes + column.RecordOffset);
                    }
                }
            }
        }
    }

    /// <summary>What reading one node's points showed. Blittable.</summary>
    internal struct NodeCheckResult
    {
        /// <summary>What can be wrong with a node; 0 means nothing.</summary>
        public enum Fault
        {
            None,
            PlaneHash,
            PlaneShape,
            BlockCounts,
            OutsideCube,
            Bounds,
            Value,
        }

        public Fault What;

        /// <summary>The faulty plane.</summary>
        public int Plane;

        /// <summary>Sums of the points' hashes: see <see cref="RecordHash"/>.</summary>
        public ulong FirstSum;
        public ulong SecondSum;
    }
}
