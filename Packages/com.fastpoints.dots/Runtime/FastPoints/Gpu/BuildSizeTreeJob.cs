using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Gpu
{
    /// <summary>
    /// From nodes to draw to a <see cref="SizeTree"/>. A node that is not one level below its parent (none had points in
    /// between, or both have one cube) takes no octant: the parent's points at its place stay as large as they are elsewhere.
    /// </summary>
    [BurstCompile]
    public unsafe struct BuildSizeTreeJob : IJob
    {
        /// <summary>Parents before children.</summary>
        [ReadOnly] public NativeArray<DrawnNode> Drawn;

        /// <summary>By number of the cloud.</summary>
        [ReadOnly] public NativeArray<SizeTreeCloud> Clouds;

        /// <summary>Scratch, by drawn node.</summary>
        public NativeList<SizeTreeLink> Links;
        public NativeList<GpuSizeNode> Nodes;
        public NativeList<int> NodeOfDrawn;

        public void Execute()
        {
            int count = Drawn.Length;
            Links.ResizeUninitialized(count);
            Nodes.ResizeUninitialized(count);
            NodeOfDrawn.ResizeUninitialized(count);
            int unlinked = 0;
            for (int i = 0; i < count; i++)
            {
                int octant = OctantOf(i);
                if (octant >= 0 && (Links[Drawn[i].Parent].Mask >> octant & 1) != 0)
                    octant = -1;
                Links[i] = new SizeTreeLink { Octant = octant };
                if (octant < 0)
                    NodeOfDrawn[i] = unlinked++;
                else
                    ((SizeTreeLink*)Links.GetUnsafePtr())[Drawn[i].Parent].Mask |= 1u << octant;
            }
            for (int i = 0, next = unlinked; i < count; i++)
            {
                var link = (SizeTreeLink*)Links.GetUnsafePtr() + i;
                link->First = next;
                next += math.countbits(link->Mask);
                if (link->Octant >= 0)
                {
                    var parent = Links[Drawn[i].Parent];
                    NodeOfDrawn[i] = parent.First + math.countbits(parent.Mask & ((1u << link->Octant) - 1));
                }
                Nodes[NodeOfDrawn[i]] = new GpuSizeNode { Children = (uint)link->First << 8 | link->Mask, Gap = GapOf(i) };
            }
        }

        int OctantOf(int i)
        {
            var drawn = Drawn[i];
            if (drawn.Parent < 0)
                return -1;
            var above = Drawn[drawn.Parent];
            var cloud = (SizeTreeCloud*)Clouds.GetUnsafeReadOnlyPtr() + drawn.Cloud;
            int level = cloud->Pages[drawn.Page].Places[drawn.Node].Level;
            if (level != cloud->Pages[above.Page].Places[above.Node].Level + 1)
                return -1;
            var index = cloud->Cubes.IndexAt(cloud->Pages[drawn.Page].Nodes[drawn.Node].Center, level);
            var indexAbove = cloud->Cubes.IndexAt(cloud->Pages[above.Page].Nodes[above.Node].Center, level - 1);
            var octant = index - 2 * indexAbove;
            return math.any(octant < 0) || math.any(octant > 1) ? -1 : (int)math.csum(octant * new double3(1, 2, 4));
        }

        float GapOf(int i)
        {
            var drawn = Drawn[i];
            var cloud = (SizeTreeCloud*)Clouds.GetUnsafeReadOnlyPtr() + drawn.Cloud;
            return GapOf(cloud->Pages[drawn.Page].Nodes[drawn.Node]) * cloud->WorldPerUnit;
        }

        /// <summary>A node with others below it has one point in each cell. The last one of its place has all that is left, most
        /// often on a surface, or on a line: as many points as there are, over its largest side.</summary>
        static float GapOf(in StreamNode node)
        {
            if (node.ChildCount + node.ChunkCount > 0 || node.PointCount == 0)
                return node.Spacing;
            var edges = 2 * node.Half;
            float area = math.max(edges.x * edges.y, math.max(edges.y * edges.z, edges.z * edges.x));
            float gap = math.max(math.sqrt(area / node.PointCount), math.cmax(edges) / node.PointCount);
            return math.min(node.Spacing, gap);
        }
    }
}
