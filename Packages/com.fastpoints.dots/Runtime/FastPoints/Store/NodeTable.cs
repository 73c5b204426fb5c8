using System;
using FastPoints.Points;
using Unity.Collections;

namespace FastPoints.Store
{
    /// <summary>The nodes of one file with their planes' places, as they lie in its table. Owns its memory.</summary>
    public sealed class NodeTable : IDisposable
    {
        NativeArray<NodeRecord> m_nodes;
        NativeArray<PlaneRange> m_planes;

        public NodeTable(NativeArray<NodeRecord> nodes, NativeArray<PlaneRange> planes, int planeCount)
        {
            m_nodes = nodes;
            m_planes = planes;
            PlaneCount = planeCount;
        }

        public int PlaneCount { get; }
        public NativeArray<NodeRecord> Nodes => m_nodes;

        /// <summary>By node times <see cref="PlaneCount"/>, plus plane. A guest's are empty: its host's count.</summary>
        public NativeArray<PlaneRange> Planes => m_planes;

        public void Dispose()
        {
            if (!m_nodes.IsCreated)
                return;
            m_nodes.Dispose();
            m_planes.Dispose();
        }

        /// <summary>What is wrong with the table, or null: nothing that it says is used before.</summary>
        /// <param name="region">All nodes lie inside.</param>
        /// <param name="dataBytes">Planes lie between the header and here.</param>
        /// <param name="layout">Of the cloud.</param>
        /// <param name="isChunk">Whether several nodes may have no parent.</param>
        public string FindProblem(GridCube region, long dataBytes, StoreLayout layout, bool isChunk)
        {
            long nextChild = 0;
            while (nextChild < m_nodes.Length && m_nodes[(int)nextChild].Parent == -1)
                nextChild++;
            if (m_nodes.Length > 0 && (nextChild == 0 || (!isChunk && nextChild != 1)))
                return "wanted " + (isChunk ? "nodes" : "one node") + " without a parent at the table's start, got " + nextChild;
            for (int i = 0; i < m_nodes.Length; i++)
            {
                string problem = FindProblem(i, region, ref nextChild) ?? FindPlaneProblem(i, dataBytes, layout);
                if (problem != null)
                    return "node " + i + ": " + problem;
            }
            return nextChild == m_nodes.Length ? null : "nodes " + nextChild + " and on are no node's children";
        }

        string FindProblem(int index, GridCube region, ref long nextChild)
        {
            var node = m_nodes[index];
            if (node.SideLog2 > GridCube.MaxSideLog2 || node.CellLog2 > node.SideLog2)
                return "side 2^" + node.SideLog2 + " with cells of 2^" + node.CellLog2;
            if (!region.Contains(node.Cube))
                return "cube " + node.Cube + " outside of " + region;
            if (((node.Corner.X - region.Corner.X) | (node.Corner.Y - region.Corner.Y) |
                (node.Corner.Z - region.Corner.Z)) << (64 - node.SideLog2) != 0
                && node.SideLog2 > 0)
                return "cube " + node.Cube + " is not of the octree of " + region;
            if (node.Parent >= index || node.Parent < -1)
                return "parent " + node.Parent;
            if (node.Parent >= 0)
            {
                var parent = m_nodes[node.Parent];
                if (!parent.Cube.Contains(node.Cube) || (parent.SideLog2 == node.SideLog2 && node.SideLog2 != 0))
                    return "cube " + node.Cube + " in a parent of " + parent.Cube;
                if (index < parent.FirstChild || index >= (long)parent.FirstChild + parent.ChildCount)
                    return "is none of its parent's children";
            }
            if (node.ChildCount < 0 || (node.ChildCount > 0 && node.FirstChild != nextChild) ||
                node.ChildCount > m_nodes.Length - nextChild)
                return "children " + node.FirstChild + " to " + ((long)node.FirstChild + node.ChildCount);
            nextChild += node.ChildCount;
            if (node.PointCount < 1 || node.PointCount > StoreFormat.MaxPointsPerNode)
                return "wanted 1 to " + StoreFormat.MaxPointsPerNode + " points, got " + node.PointCount;
            if (node.BlockCount != PlaneShape.BlocksOf(node.PointCount))
                return "wanted " + PlaneShape.BlocksOf(node.PointCount) + " blocks, got " + node.BlockCount;
            if (node.MinX > node.MaxX || node.MinY > node.MaxY || node.MinZ > node.MaxZ)
                return "bounds are turned round";
            return FindHostProblem(index, node);
        }

        string FindHostProblem(int index, NodeRecord node)
        {
            if (node.Host != index)
            {
                bool isGuest = node.Host == node.Parent && node.Host >= 0 && node.ChildCount == 0 && node.HostedBlocks == 0 &&
                    node.ChunkCount == 0 && m_nodes[node.Host].Host == node.Host;
                return isGuest ? null : "is no guest of node " + node.Host;
            }
            if (node.FirstBlock != 0)
                return "its own blocks begin at " + node.FirstBlock;
            // Children were checked for nothing yet, but they are in the table.
            long blocks = node.BlockCount;
            long end = Math.Min(m_nodes.Length, (long)node.FirstChild + node.ChildCount);
            for (int child = node.FirstChild; child < end; child++)
            {
                if (m_nodes[child].Host != index)
                    continue;
                if (m_nodes[child].FirstBlock != blocks)
                    return "guest " + child + ": wanted blocks from " + blocks + ", got " + m_nodes[child].FirstBlock;
                blocks += m_nodes[child].BlockCount;
            }
            return blocks == node.HostedBlocks ? null : "wanted " + blocks + " hosted blocks, got " + node.HostedBlocks;
        }

        string FindPlaneProblem(int index, long dataBytes, StoreLayout layout)
        {
            var node = m_nodes[index];
            for (int p = 0; p < PlaneCount; p++)
            {
                var range = m_planes[index * PlaneCount + p];
                if (node.Host != index)
                {
                    if (range.LengthBytes != 0)
                        return "a guest with a plane of its own";
                    continue;
                }
                long shortest = PlaneShape.LengthBytes((long)node.HostedBlocks * layout.ShapeOf(p, node.IsWide).DescriptorWords);
                if (range.OffsetBytes < FileHeader.SizeBytes || range.OffsetBytes % PlaneShape.AlignmentBytes != 0 ||
                    range.LengthBytes < shortest || range.LengthBytes % PlaneShape.AlignmentBytes != 0 ||
                    range.OffsetBytes > dataBytes - range.LengthBytes)
                    return "plane " + p + ": " + range.LengthBytes + " bytes from " + range.OffsetBytes +
                        " in a file with room to " + dataBytes;
            }
            return null;
        }
    }
}
