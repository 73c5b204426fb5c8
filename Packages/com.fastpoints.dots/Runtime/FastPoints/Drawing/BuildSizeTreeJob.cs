using System.Runtime.InteropServices;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // Builds a SizeTree from the nodes to draw. If a node is several levels below its parent because those between had no
    // points, the levels between get nodes with the parent's gap. A node with its parent's own cube gets no link.
    [BurstCompile]
    internal unsafe struct BuildSizeTreeJob : IJob
    {
        [ReadOnly] public NativeArray<DrawnNode> Drawn;
        [ReadOnly] public NativeArray<SizeTreeCloud> Clouds;
        public NativeList<SizeTreeLink> Links; // Scratch; the first entry stands for nothing.
        public NativeList<int> Order; // Scratch: links in the order of their nodes.
        public NativeList<GpuSizeNode> Nodes;
        public NativeList<int> NodeOfDrawn; // Holds the links while the job works.

        public void Execute()
        {
            Links.Clear();
            Links.Add(default);
            NodeOfDrawn.ResizeUninitialized(Drawn.Length);
            for (int i = 0; i < Drawn.Length; i++)
                NodeOfDrawn[i] = Link(i);
            Number();
            for (int i = 0; i < Drawn.Length; i++)
                NodeOfDrawn[i] = Links[NodeOfDrawn[i]].Node;
        }

        // Finds or creates the link of a node below its parent's.
        int Link(int i)
        {
            var drawn = Drawn[i];
            var link = new SizeTreeLink { Gap = GapOf(i), IsDrawn = true };
            if (drawn.Parent < 0)
                return AddRoot(link);
            float share = drawn.DrawnFraction / Drawn[drawn.Parent].DrawnFraction;
            if (share < 1)
                link.Gap = FadedGap(Links[NodeOfDrawn[drawn.Parent]].Gap, link.Gap, share);
            var above = Drawn[drawn.Parent];
            var cloud = (SizeTreeCloud*)Clouds.GetUnsafeReadOnlyPtr() + drawn.Cloud;
            int level = cloud->Pages[drawn.Page].Addresses[drawn.Node].Level;
            int levelAbove = cloud->Pages[above.Page].Addresses[above.Node].Level;
            var position = cloud->Cubes.PositionInCube(cloud->Pages + drawn.Page, drawn.Node);
            var inAbove = cloud->Cubes.IndexAt(cloud->Cubes.PositionInCube(cloud->Pages + above.Page, above.Node), levelAbove);
            if (level <= levelAbove || math.any(cloud->Cubes.IndexAt(position, levelAbove) != inAbove))
                return AddRoot(link);
            int at = NodeOfDrawn[drawn.Parent];
            for (int between = levelAbove + 1; ; between++)
            {
                var octant = cloud->Cubes.IndexAt(position, between) - 2 * cloud->Cubes.IndexAt(position, between - 1);
                int child = (int)math.csum(math.clamp(octant, 0, 1) * new double3(1, 2, 4));
                int below = Links.GetUnsafePtr()[at].Children[child];
                if (between == level && below != 0 && Links[below].IsDrawn)
                    return AddRoot(link);
                if (below == 0)
                {
                    below = Links.Length;
                    Links.Add(between == level ? link : new SizeTreeLink { Gap = Links[at].Gap });
                    Links.GetUnsafePtr()[at].Children[child] = below;
                }
                if (between == level)
                {
                    Links.GetUnsafePtr()[below].Gap = link.Gap;
                    Links.GetUnsafePtr()[below].IsDrawn = true;
                    return below;
                }
                at = below;
            }
        }

        int AddRoot(SizeTreeLink link)
        {
            link.IsRoot = true;
            Links.Add(link);
            return Links.Length - 1;
        }

        // Breadth-first, so that the children of a node follow one another.
        void Number()
        {
            Order.Clear();
            for (int i = 1; i < Links.Length; i++)
                if (Links[i].IsRoot)
                    Order.Add(i);
            Nodes.ResizeUninitialized(Links.Length - 1);
            for (int node = 0; node < Order.Length; node++)
            {
                var link = Links.GetUnsafePtr() + Order[node];
                uint mask = 0;
                int first = Order.Length;
                for (int octant = 0; octant < 8; octant++)
                {
                    if (link->Children[octant] == 0)
                        continue;
                    mask |= 1u << octant;
                    Order.Add(link->Children[octant]);
                }
                link->Node = node;
                Nodes[node] = new GpuSizeNode { Children = (uint)first << 8 | mask, Gap = link->Gap };
            }
        }

        float GapOf(int i)
        {
            var drawn = Drawn[i];
            var cloud = (SizeTreeCloud*)Clouds.GetUnsafeReadOnlyPtr() + drawn.Cloud;
            return GapOf(cloud->Pages[drawn.Page].Nodes[drawn.Node], *cloud);
        }

        // Points for each area of a surface rise from the parent's number to the node's own with the node's share of what is
        // drawn of the parent: so much of the surface is covered as of the parent, whatever fades.
        static float FadedGap(float gapAbove, float gap, float share) => gap <= 0 || gapAbove <= 0 ? gap
            : 1 / math.sqrt(math.lerp(1 / (gapAbove * gapAbove), 1 / (gap * gap), share));

        // A node with others below it has one point in each cell. The last node at its place has all remaining points, most
        // often on a surface or a line; its gap is the larger of what the box's largest face and longest edge give.
        static float GapOf(in StreamNode node, in SizeTreeCloud cloud)
        {
            if (node.ChildCount + node.PageCount > 0 || node.PointCount == 0)
                return node.Spacing * cloud.SpacingScale;
            var edges = 2 * node.Half * cloud.AxisScale;
            float area = math.max(edges.x * edges.y, math.max(edges.y * edges.z, edges.z * edges.x));
            float gap = math.max(math.sqrt(area / node.PointCount), math.cmax(edges) / node.PointCount);
            return math.min(node.Spacing * cloud.SpacingScale, gap);
        }
    }

    internal unsafe struct SizeTreeCloud
    {
        public HierarchyPage* Pages;
        public NodeCubes Cubes;
        public float3 AxisScale; // World units of a CRS unit along each axis.
        public float SpacingScale; // See CloudView.
    }

    internal unsafe struct SizeTreeLink
    {
        public fixed int Children[8]; // For each octant; 0 for none, since no link is below the first.
        public float Gap; // World units.
        public bool IsDrawn; // Not only a level between two nodes that are drawn.
        public bool IsRoot;
        public int Node;
    }

    [GenerateHlsl]
    [StructLayout(LayoutKind.Sequential)]
    internal struct GpuSizeNode
    {
        // Bits 0-7: octants with a node of their own, X lowest; bits 8-31: the first of these nodes, in the octants' order.
        public uint Children;
        public float Gap; // World units between points where no deeper node is drawn.
    }
}
