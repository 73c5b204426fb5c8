using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>
    /// The octree that a source brings along (COPC, Potree, EPT), as far as its hierarchy has been read: additive levels, each
    /// node's points in a block of their own.
    /// </summary>
    /// <remarks>
    /// Nodes are only ever added, a parent before its children, so an index stays what it was while pages are read. Memory:
    /// 24 bytes a node.
    /// </remarks>
    internal sealed class SourceTree : IDisposable
    {
        NativeList<SourceNode> m_nodes;

        /// <param name="cube">The root's cube, CRS units.</param>
        /// <param name="spacing">Distance between points of the root, CRS units; halved from level to level.</param>
        public SourceTree(BoundsGeo cube, double spacing, Allocator allocator)
        {
            Cube = cube;
            Spacing = spacing;
            m_nodes = new NativeList<SourceNode>(64, allocator);
        }

        public BoundsGeo Cube { get; }

        public double Spacing { get; }

        public int NodeCount => m_nodes.Length;

        /// <summary>Levels among the nodes that are known.</summary>
        public int LevelCount { get; private set; }

        /// <summary>Pages (or files) of the hierarchy that were read so far.</summary>
        public int PageCount { get; set; }

        /// <summary>Whether all pages of the hierarchy were read (or given up with a warning).</summary>
        public bool IsWhole { get; set; }

        public SourceNode this[int node] => m_nodes[node];

        /// <summary>The nodes that are known, for jobs: no more are added before these have ended.</summary>
        public NativeArray<SourceNode> AsArray() => m_nodes.AsArray();

        public void Add(SourceNode node)
        {
            m_nodes.Add(node);
            LevelCount = Math.Max(LevelCount, node.Level + 1);
        }

        /// <summary>Edge of a level's nodes, CRS units.</summary>
        public double EdgeOfLevel(int level) => Cube.Size.x / Math.Pow(2, level);

        /// <summary>Nodes that only hold others together, or whose points are not there.</summary>
        public int NodesWithoutPoints()
        {
            int count = 0;
            for (int i = 0; i < m_nodes.Length; i++)
                if (m_nodes[i].Block < 0)
                    count++;
            return count;
        }

        public void Dispose()
        {
            if (m_nodes.IsCreated)
                m_nodes.Dispose();
        }
    }

    /// <summary>A node of a source's own octree. One whose points are more than a block's is there several times, a block
    /// each.</summary>
    internal struct SourceNode
    {
        /// <summary>0 for the root; a node of level L has an edge of the cube's over 2^L.</summary>
        public int Level;

        /// <summary>Its place among the 2^Level nodes of each axis.</summary>
        public int3 Cell;

        /// <summary>The block that holds its points, or -1 for a node without points.</summary>
        public int Block;

        /// <summary>Points of the block, as the hierarchy claims.</summary>
        public int PointCount;

        /// <summary>What nodes of an octree are told apart by.</summary>
        public int4 Key => new int4(Cell, Level);
    }
}
