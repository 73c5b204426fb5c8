using System.Runtime.CompilerServices;
using FastPoints.Drawing;
using FastPoints.Picture;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    [BurstCompile]
    internal unsafe struct DrawBlocksJob : IJobFor
    {
        public const int MaxBatchBytes = 16 << 10;

        [ReadOnly] public NativeArray<NodeBlocks> Nodes;

        [ReadOnly] public NativeArray<PlaneView> Planes;
        public int PlaneCount;

        [ReadOnly] public NativeArray<StoredColumn> Columns;

        [ReadOnly] public NativeArray<PointColumn> Targets;
        [ReadOnly] public NativeArray<uint> Palettes;
        [ReadOnly] public NativeArray<float> SizeOfTile;
        [ReadOnly] public NativeArray<GpuSizeNode> SizeNodes; // Nodes of a SizeTree; empty if no size is adaptive.

        [ReadOnly] public NativeArray<LocalClip> Clips;

        public PointColumn Classes;
        public ClassMask HiddenClasses;
        public PointDrawing Drawing;

        /// <summary>Written by atomic minimum, so that jobs may draw at the same time.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<ulong> Pixels;

        [NativeDisableContainerSafetyRestriction] public NativeArray<ulong> Sums;

        public void Execute(int index)
        {
            byte* batch = stackalloc byte[MaxBatchBytes];
            ulong* values = stackalloc ulong[PlaneShape.MaxPointsPerBlock];
            float* gaps = stackalloc float[PlaneShape.MaxPointsPerBlock];
            var node = Nodes[index];
            var picture = new PictureMemory(Palettes, SizeOfTile, Pixels);
            picture.Gaps = SizeNodes.Length > 0 ? gaps : null;
            picture.Sums = Sums.Length > 0 ? (ulong*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Sums) : null;
            var planes = (PlaneView*)Planes.GetUnsafeReadOnlyPtr() + (long)index * PlaneCount;
            for (int block = 0; block < node.BlockCount; block++)
            {
                int count = planes[0].PointsOf(block);
                UnpackAxis(planes[0], block, 0, node.Corner.X, values, batch + Drawing.Positions.X.OffsetBytes);
                UnpackAxis(planes[0], block, 1, node.Corner.Y, values, batch + Drawing.Positions.Y.OffsetBytes);
                UnpackAxis(planes[0], block, 2, node.Corner.Z, values, batch + Drawing.Positions.Z.OffsetBytes);
                int column = 0;
                for (int p = 1; p < PlaneCount; p++)
                    for (int c = 0; c < planes[p].Shape.ColumnCount; c++, column++)
                        UnpackColumn(planes[p], block, c, Columns[column], values, batch + Targets[column].OffsetBytes);
                if (Clips.Length > 0 || !HiddenClasses.IsEmpty || !HasAll(node.FadeBits))
                    Hide(batch, count, node.FadeBits, (uint)(block * PlaneShape.MaxPointsPerBlock));
                if (SizeNodes.Length > 0)
                    FindGaps(node, batch, count, gaps);
                Drawing.Draw(batch, 0, count, picture);
            }
        }

        void Hide(byte* batch, int count, uint fadeBits, uint firstIndex)
        {
            var x = (double*)(batch + Drawing.Positions.X.OffsetBytes);
            var y = (double*)(batch + Drawing.Positions.Y.OffsetBytes);
            var z = (double*)(batch + Drawing.Positions.Z.OffsetBytes);
            var clips = (LocalClip*)Clips.GetUnsafeReadOnlyPtr();
            for (int i = 0; i < count; i++)
            {
                bool isKept = LocalClip.MayKeep(clips, Clips.Length, new double3(x[i], y[i], z[i]), 0) &&
                    (HiddenClasses.IsEmpty || !HiddenClasses.Has(batch[Classes.OffsetBytes + i])) &&
                    IsDrawn(fadeBits, firstIndex + (uint)i);
                x[i] = isKept ? x[i] : double.NaN;
            }
        }

        void FindGaps(in NodeBlocks node, byte* batch, int count, float* gaps)
        {
            var x = (double*)(batch + Drawing.Positions.X.OffsetBytes);
            var y = (double*)(batch + Drawing.Positions.Y.OffsetBytes);
            var z = (double*)(batch + Drawing.Positions.Z.OffsetBytes);
            var nodes = (GpuSizeNode*)SizeNodes.GetUnsafeReadOnlyPtr();
            for (int i = 0; i < count; i++)
            {
                var position = (new double3(x[i], y[i], z[i]) - node.CubeCorner) * node.CubesPerStep;
                gaps[i] = GapAt(nodes, node.SizeNode, (float3)position);
            }
        }

        static bool HasAll(uint fadeBits) => ThresholdOf(fadeBits) == 1 << PointFade.ThresholdBits;

        // The twin of PointFilters.hlsl. index: of the point in its node.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static bool IsDrawn(uint fadeBits, uint index)
        {
            // After the finalizer of MurmurHash3 (Appleby, 2008): neighbours in the node are unrelated.
            uint hash = (index + (fadeBits >> PointFade.SeedBit) * 0x9E3779B9u) * 0x85EBCA6Bu;
            hash = (hash ^ hash >> 13) * 0xC2B2AE35u;
            return (hash ^ hash >> 16) >> 32 - PointFade.ThresholdBits < ThresholdOf(fadeBits);
        }

        static uint ThresholdOf(uint fadeBits) => fadeBits >> 1 & 0x1FFFu;

        // The twin of PointSizes.hlsl. node: the point's own; position: in the node's cube, from 0 to 1 along each axis.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static float GapAt(GpuSizeNode* nodes, int node, float3 position)
        {
            for (int level = 0; level < SizeTree.MaxLevels; level++)
            {
                position *= 2;
                var upper = position >= 1;
                position -= math.select(float3.zero, new float3(1), upper);
                uint octant = math.select(0u, 1u, upper.x) | math.select(0u, 2u, upper.y) | math.select(0u, 4u, upper.z);
                uint children = nodes[node].Children;
                if ((children >> (int)octant & 1) == 0)
                    break;
                node = (int)(children >> 8) + math.countbits(children & ((1u << (int)octant) - 1));
            }
            return nodes[node].Gap;
        }

        static void UnpackAxis(in PlaneView plane, int block, int axis, long corner, ulong* values, byte* to)
        {
            plane.UnpackWide(block, axis, values);
            int count = plane.PointsOf(block);
            for (int i = 0; i < count; i++)
                ((double*)to)[i] = corner + (long)values[i];
        }

        static void UnpackColumn(in PlaneView plane, int block, int columnInPlane, in StoredColumn column, ulong* values,
            byte* to)
        {
            plane.UnpackWide(block, columnInPlane, values);
            int count = plane.PointsOf(block), size = column.Type.SizeOf();
            for (int i = 0; i < count; i++, to += size)
                OrderedBits.Store(values[i] * (ulong)column.Divisor, column.Type, to);
        }
    }

    internal struct NodeBlocks
    {
        public Grid3 Corner;
        public int BlockCount;
        public uint FadeBits;
        public int SizeNode;
        public double3 CubeCorner;
        public double3 CubesPerStep;
    }
}
