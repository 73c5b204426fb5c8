using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>
    /// The hierarchy of a source that brings its octree along, as pages of some levels each. What is below the levels that are
    /// known is read when a page of it is wanted, level by level for all of the source. Main thread; never waits.
    /// </summary>
    sealed class TreePages : IDisposable
    {
        /// <summary>Levels of a page: some hundred nodes at most where points lie on surfaces.</summary>
        public const int LevelsPerPage = 4;

        /// <summary>Levels that have to be read before the first page is built: its own, and whether there are more.</summary>
        public const int FirstLevels = LevelsPerPage + 1;

        const int NotNumbered = -1;

        readonly PointReader m_reader;
        readonly TreeGrid m_grid;
        readonly List<int4> m_rootOfPage = new List<int4> { default };
        readonly List<int> m_firstHangingOfPage = new List<int> { NotNumbered };
        NativeParallelHashMap<int4, int> m_nodeOfKey;
        IEnumerator<JobHandle> m_reading;
        JobHandle m_step;
        JobHandle m_building;
        int m_nodes;
        int m_levelsKnown;
        int m_levelsWanted;

        /// <summary>That the reading under way will have read.</summary>
        int m_levelsRead;

        /// <exception cref="PointCloudException">The octree has no root.</exception>
        public TreePages(PointReader reader, TreeGrid grid)
        {
            m_reader = reader;
            m_grid = grid;
            m_nodeOfKey = new NativeParallelHashMap<int4, int>(Math.Max(64, reader.Tree.NodeCount), Allocator.Persistent);
            m_levelsWanted = FirstLevels;
            TakeLevels(FirstLevels);
            if (m_nodeOfKey.ContainsKey(default))
                return;
            Dispose();
            throw new PointCloudException(FailureCode.BadInput, reader.Info.Path, -1, "its octree has no root");
        }

        public int Count => m_rootOfPage.Count;

        /// <summary>What <see cref="Update"/> goes on after.</summary>
        public JobHandle Step => m_step;

        /// <summary>Whether a page's levels, and what hangs below, are known; if not, they are read from now on.</summary>
        public bool IsKnown(int page)
        {
            int levels = m_rootOfPage[page].w + FirstLevels;
            m_levelsWanted = Math.Max(m_levelsWanted, levels);
            return levels <= m_levelsKnown;
        }

        /// <summary>Goes on reading, if there is something to read.</summary>
        /// <returns>What went wrong: pages that are still wanted are made of what is there. Or null.</returns>
        public PointCloudException Update()
        {
            // Jobs that build pages read what would be added to.
            if (m_reading == null && m_levelsWanted <= m_levelsKnown || !m_step.IsCompleted || !m_building.IsCompleted)
                return null;
            m_step.Complete();
            m_building.Complete();
            try
            {
                if (m_reading == null)
                {
                    m_levelsRead = m_levelsWanted;
                    m_reading = m_reader.FindLevels(m_levelsRead);
                }
                if (m_reading.MoveNext())
                {
                    m_step = m_reading.Current;
                    return null;
                }
                EndReading();
                TakeLevels(m_levelsRead);
                return null;
            }
            catch (PointCloudException failure)
            {
                EndReading();
                TakeLevels(int.MaxValue);
                return failure;
            }
        }

        /// <summary>The job that builds a page.</summary>
        public BuildTreePageJob JobFor(int page) => new BuildTreePageJob
        {
            Nodes = m_reader.Tree.AsArray(),
            NodeOfKey = m_nodeOfKey,
            Root = m_rootOfPage[page],
            LastLevel = m_rootOfPage[page].w + LevelsPerPage - 1,
            Grid = m_grid,
        };

        public JobHandle Schedule(in BuildTreePageJob job)
        {
            var building = job.Schedule();
            m_building = JobHandle.CombineDependencies(m_building, building);
            return building;
        }

        /// <summary>Numbers the pages that hang on one; each time that it is built they are the same.</summary>
        /// <param name="planeCount">Planes that are streamed.</param>
        public unsafe void Number(int page, in HierarchyPage built, int planeCount)
        {
            if (m_firstHangingOfPage[page] == NotNumbered)
            {
                m_firstHangingOfPage[page] = m_rootOfPage.Count;
                for (int n = 0; n < built.NodeCount; n++)
                    if (built.Nodes[n].ChunkCount > 0)
                        AddHanging(m_reader.Tree[(int)built.Planes[n * planeCount].OffsetBytes].Key);
            }
            int next = m_firstHangingOfPage[page];
            for (int n = 0; n < built.NodeCount; n++)
            {
                // Chunk 0 is page 1.
                built.Nodes[n].FirstChunk = next - 1;
                next += built.Nodes[n].ChunkCount;
            }
        }

        /// <summary>A page that is not built: its box.</summary>
        public HierarchyPage Empty(int page)
        {
            var empty = new HierarchyPage();
            m_grid.BoxOf(m_rootOfPage[page], out empty.Center, out empty.Half);
            return empty;
        }

        public void Dispose()
        {
            m_step.Complete();
            m_building.Complete();
            EndReading();
            if (m_nodeOfKey.IsCreated)
                m_nodeOfKey.Dispose();
        }

        void EndReading()
        {
            m_reading?.Dispose();
            m_reading = null;
        }

        void AddHanging(int4 key)
        {
            for (int octant = 0; octant < 8; octant++)
            {
                int4 child = BuildTreePageJob.ChildKey(key, octant);
                if (!m_nodeOfKey.ContainsKey(child))
                    continue;
                m_rootOfPage.Add(child);
                m_firstHangingOfPage.Add(NotNumbered);
            }
        }

        /// <param name="levels">That were read.</param>
        void TakeLevels(int levels)
        {
            var tree = m_reader.Tree;
            for (; m_nodes < tree.NodeCount; m_nodes++)
                m_nodeOfKey.TryAdd(tree[m_nodes].Key, m_nodes);
            // No nodes at the last of them: there are none below.
            m_levelsKnown = tree.IsWhole || tree.LevelCount < levels ? int.MaxValue : levels;
        }
    }
}
