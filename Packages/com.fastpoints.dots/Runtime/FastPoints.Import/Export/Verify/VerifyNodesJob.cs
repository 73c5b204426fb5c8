using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>A slice of checking a file's nodes, whose table must have been checked: first the planes' hashes and shapes, then
    /// every point's cube, bounds and sums.</summary>
    /// <remarks>Slices of either kind run side by side and write to different elements.</remarks>
    [BurstCompile]
    internal unsafe struct VerifyNodesJob : IJob
    {
        /// <summary>Points of a slice: about 2 ms. A node may have some times as many.</summary>
        public const int PointsPerSlice = 64 * PlaneShape.MaxPointsPerBlock;

        public bool ChecksPlanes;

        public int First;
        public int End;

        [ReadOnly] public NativeArray<byte> File;
        public long FileOffset;
        [ReadOnly] public NativeArray<byte> Computed; // The bytes of the last planes, if these were computed.
        public long ComputedOffset;
        public int ComputedPlaneCount;
        [ReadOnly] public NativeArray<NodeRecord> Nodes;
        [ReadOnly] public NativeArray<PlaneRange> Planes;
        public int PlaneCount;
        [ReadOnly] public NativeArray<StoredColumn> Columns;
        [ReadOnly] public NativeArray<int> FirstColumnOfPlane;
        [ReadOnly] public NativeArray<PlaneShape> Shapes;

        /// <summary>For each attribute plane, the one whose values it averages, or a negative number.</summary>
        [ReadOnly] public NativeArray<int> AverageOf;
        public int AttributeBytes;
        [ReadOnly] public NativeArray<NodeBlockRange> Ranges; // Of nodes in their order; none has more points than a slice.

        /// <summary>Indexed by node: what its own planes showed.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<NodeCheckResult> PlaneResults;

        [NativeDisableContainerSafetyRestriction] public NativeArray<NodeCheckResult> Results;

        public void Execute()
        {
            for (int i = First; i < End; i++)
                if (ChecksPlanes)
                    PlaneResults[i] = CheckPlanes(i);
                else
                    Results[i] = CheckPoints(Ranges[i], PlaneResults[Nodes[Ranges[i].Node].PlaneNode]);
        }

        PlaneShape ShapeOf(int plane, bool isWide) => plane == 0 ? PlaneShape.OfPositions(isWide) : Shapes[plane - 1];

        PlaneView ViewOf(int planeNode, int plane)
        {
            var node = Nodes[planeNode];
            var range = Planes[planeNode * PlaneCount + plane];
            return new PlaneView(FileOf(plane) + range.OffsetBytes, ShapeOf(plane, node.IsWide), node.PlaneBlocks);
        }

        byte* FileOf(int plane) => plane >= PlaneCount - ComputedPlaneCount
            ? (byte*)Computed.GetUnsafeReadOnlyPtr() - ComputedOffset : (byte*)File.GetUnsafeReadOnlyPtr() - FileOffset;

        NodeCheckResult CheckPlanes(int index)
        {
            var result = NodeCheckResult.Empty;
            if (Nodes[index].PlaneNode != index)
                return result;
            for (int p = 0; p < PlaneCount && result.Fault == NodeFault.None; p++)
            {
                var range = Planes[index * PlaneCount + p];
                result.Plane = p;
                result.Hash = ContentHash.Of(FileOf(p) + range.OffsetBytes, range.LengthBytes);
                if (result.Hash != range.Hash)
                    result.Fault = NodeFault.PlaneHash;
                else if (!PlaneView.IsValid(FileOf(p) + range.OffsetBytes, range.LengthBytes, ShapeOf(p, Nodes[index].IsWide),
                    Nodes[index].PlaneBlocks))
                    result.Fault = NodeFault.PlaneShape;
            }
            return result;
        }

        NodeCheckResult CheckPoints(NodeBlockRange part, NodeCheckResult result)
        {
            int index = part.Node;
            if (result.Fault != NodeFault.None)
                return result;
            var node = Nodes[index];
            var planeNode = Nodes[node.PlaneNode];
            ulong* offsets = stackalloc ulong[3 * PlaneShape.MaxPointsPerBlock];
            ulong* values = stackalloc ulong[PlaneShape.MaxPointsPerBlock];
            int recordBytes = RecordHash.PaddedBytes(AttributeBytes);
            var records = (byte*)UnsafeUtility.Malloc(math.max(4, recordBytes) * PlaneShape.MaxPointsPerBlock, 16,
                Allocator.Temp);
            UnsafeUtility.MemClear(records, math.max(4, recordBytes) * PlaneShape.MaxPointsPerBlock);
            // Blocks before are full, or their part has the fault.
            int done = (part.FirstBlock - node.FirstBlock) * PlaneShape.MaxPointsPerBlock;
            for (int b = part.FirstBlock; b < part.EndBlock && result.Fault == NodeFault.None; b++)
            {
                var position = ViewOf(node.PlaneNode, 0);
                int count = position.PointsOf(b);
                if (count != math.min(PlaneShape.MaxPointsPerBlock, node.PointCount - done))
                {
                    result.Fault = NodeFault.BlockCounts;
                    result.Plane = 0;
                    break;
                }
                for (int c = 0; c < 3; c++)
                    position.UnpackWide(b, c, offsets + c * PlaneShape.MaxPointsPerBlock);
                LoadAttributes(node.PlaneNode, b, count, values, records, ref result);
                if (result.Fault != NodeFault.None)
                    break;
                for (int i = 0; i < count; i++)
                {
                    var point = planeNode.Corner + new Grid3((long)offsets[i], (long)offsets[PlaneShape.MaxPointsPerBlock + i],
                        (long)offsets[2 * PlaneShape.MaxPointsPerBlock + i]);
                    if (!node.Cube.Contains(point))
                    {
                        result.Fault = NodeFault.OutsideCube;
                        result.Plane = 0;
                        break;
                    }
                    var offset = point - node.Corner;
                    result.Min = Grid3.Min(result.Min, offset);
                    result.Max = Grid3.Max(result.Max, offset);
                    result.FirstSum += RecordHash.Of(point, records + i * recordBytes, recordBytes, RecordHash.ChecksumSeed);
                    result.SecondSum += RecordHash.Of(point, records + i * recordBytes, recordBytes, RecordHash.SecondSeed);
                }
                done += count;
            }
            UnsafeUtility.Free(records, Allocator.Temp);
            return result;
        }

        void LoadAttributes(int planeNode, int block, int count, ulong* values, byte* records, ref NodeCheckResult result)
        {
            int recordBytes = RecordHash.PaddedBytes(AttributeBytes);
            for (int p = 1; p < PlaneCount; p++)
            {
                var plane = ViewOf(planeNode, p);
                result.Plane = p;
                if (plane.PointsOf(block) != count)
                {
                    result.Fault = NodeFault.BlockCounts;
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
                            result.Fault = NodeFault.Value;
                        // Averages are not part of the point.
                        if (AverageOf[p - 1] < 0)
                            OrderedBits.Store(value, column.Type, records + i * recordBytes + column.RecordOffset);
                    }
                }
            }
        }
    }

    internal struct NodeBlockRange
    {
        public int Node;
        public int FirstBlock;
        public int EndBlock;
    }

    internal enum NodeFault
    {
        None,
        PlaneHash,
        PlaneShape,
        BlockCounts,
        OutsideCube,
        Bounds,
        Value,
    }

    internal struct NodeCheckResult
    {
        public NodeFault Fault;

        public int Plane;
        public ulong Hash; // What the plane has, if it is another than it should be.

        public ulong FirstSum;
        public ulong SecondSum;
        public Grid3 Min; // Bounds of the points from the node's corner.
        public Grid3 Max;

        public static NodeCheckResult Empty => new NodeCheckResult
        {
            Min = Grid3.MaxValue,
            Max = Grid3.MinValue,
        };

        public void Include(in NodeCheckResult part)
        {
            if (Fault == NodeFault.None)
            {
                Fault = part.Fault;
                Plane = part.Plane;
                Hash = part.Hash;
            }
            FirstSum += part.FirstSum;
            SecondSum += part.SecondSum;
            Min = Grid3.Min(Min, part.Min);
            Max = Grid3.Max(Max, part.Max);
        }

        public bool HasBoundsOf(in NodeRecord node)
        {
            int shift = node.BoundsShift;
            return node.MinX == Min.X >> shift && node.MinY == Min.Y >> shift && node.MinZ == Min.Z >> shift &&
                node.MaxX == Max.X >> shift && node.MaxY == Max.Y >> shift && node.MaxZ == Max.Z >> shift;
        }
    }
}
