using System;
using FastPoints.Core;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Reading
{
    /// <summary>The octree that a source contains (COPC, Potree, EPT), as far as its hierarchy has been read: additive levels,
    /// each node's points in a block of their own.</summary>
    /// <remarks>Nodes are only ever added, a parent before its children, so indices stay valid while pages are read. A node takes
    /// 24 bytes.</remarks>
    internal sealed class SourceTree : IDisposable
    {
        NativeList<SourceNode> m_nodes;

        /// <param name="cube">The root's cube, CRS units.</param>
        /// <param name="spacing">Distance between points of the root in CRS units; it halves from level to level.</param>
        public SourceTree(BoundsGeo cube, double spacing, Allocator allocator)
        {
            Cube = cube;
            Spacing = spacing;
            m_nodes = new NativeList<SourceNode>(64, allocator);
        }

        public BoundsGeo Cube { get; }

        public double Spacing { get; }

        public int NodeCount => m_nodes.Length;

        /// <summary>Number of levels among the known nodes.</summary>
        public int LevelCount { get; private set; }

        /// <summary>Pages (or files) of the hierarchy that were read so far.</summary>
        public int PageCount { get; set; }

        /// <summary>Whether all pages of the hierarchy were read (or abandoned with a warning).</summary>
        public bool IsWhole { get; set; }

        public SourceNode this[int node] => m_nodes[node];

        /// <summary>The known nodes, for jobs: none may be added before these have ended.</summary>
        public NativeArray<SourceNode> AsArray() => m_nodes.AsArray();

        public void Add(SourceNode node)
        {
            m_nodes.Add(node);
            LevelCount = Math.Max(LevelCount, node.Level + 1);
        }

        /// <summary>Edge of a level's nodes, CRS units.</summary>
        public double EdgeOfLevel(int level) => Cube.Size.x / Math.Pow(2, level);

        /// <summary>Number of nodes that only hold others together, or whose points are missing.</summary>
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

    /// <summary>A node of a source's own octree. One with more points than a block exists several times, once for each
    /// block.</summary>
    internal struct SourceNode
    {
        /// <summary>0 for the root; a node of level L has the cube's edge divided by 2^L.</summary>
        public int Level;

        /// <summary>Its position among the 2^Level nodes of each axis.</summary>
        public int3 Cell;

        /// <summary>The block that holds its points, or -1 for a node without points.</summary>
        public int Block;

        /// <summary>Points of the block, as the hierarchy claims.</summary>
        public int PointCount;

        /// <summary>The key that identifies a node of an octree.</summary>
        public int4 Key => new int4(Cell, Level);
    }
}
