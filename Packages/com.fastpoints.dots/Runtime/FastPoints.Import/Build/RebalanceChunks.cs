using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>Finds the root cube by the points that came, and makes chunks that are neither too large nor needlessly
    /// small.</summary>
    internal sealed class RebalanceChunks
    {
        readonly BuildContext m_build;
        readonly ScatterPoints m_scatter;
        readonly ChunkSet m_chunks;
        readonly BuildCheckpoints m_checkpoints;

        public RebalanceChunks(BuildContext build, ScatterPoints scatter, ChunkSet chunks, BuildCheckpoints checkpoints)
        {
            m_build = build;
            m_scatter = scatter;
            m_chunks = chunks;
            m_checkpoints = checkpoints;
        }

        /// <summary>Coroutine.</summary>
        public IEnumerator<JobStep> Run()
        {
            var journal = m_checkpoints.Journal;
            var found = m_scatter.Statistics;
            if (found.Count == 0)
                yield break;
            if (journal.At == BuildJournal.Stage.Read)
            {
                yield return JobStep.Of(AddChunks());
                journal.At = BuildJournal.Stage.Split;
                yield return JobStep.Of(m_checkpoints.Write());
            }
            else
            {
                foreach (var chunk in journal.Chunks)
                    m_chunks.Add(chunk.Cube, chunk.Runs);
            }
            m_chunks.Rebalanced = m_checkpoints.Write;
            if (journal.At == BuildJournal.Stage.Split)
            {
                long target = m_build.Plan.PointsPerChunk;
                yield return JobStep.Of(m_chunks.SplitLarge(2 * target, target));
                // The coroutine checks its budget.
                yield return default;
                journal.Root = RootCube.Shrink(journal.Root, found.Min, found.Max);
                m_chunks.MergeSmall(journal.Root, target);
                journal.At = BuildJournal.Stage.Index;
                yield return JobStep.Of(m_checkpoints.Write());
            }
            m_chunks.Rebalanced = null;
            if (m_build.Files != null)
                RecordPagePool.Of(m_build.Pool).FreeAll();
        }

        /// <summary>Takes over the partition's chunks. Where there are points outside, the root grows until it has
        /// them.</summary>
        IEnumerator<JobStep> AddChunks()
        {
            var map = m_build.Map;
            var lists = m_scatter.Chunks;
            for (int c = 0; c < map.Chunks.Length; c++)
                AddChunk(map.Chunks[c], lists, c);
            int inside = m_chunks.Chunks.Count;
            AddChunk(map.Cube, lists, map.Outside);
            var root = map.Cube;
            if (m_chunks.Chunks.Count > inside)
            {
                var shells = RootCube.Grow(root, m_scatter.Statistics.Min, m_scatter.Statistics.Max);
                root = shells[shells.Length - 1];
                yield return JobStep.Of(m_chunks.SplitOutside(shells, m_chunks.Chunks[inside]));
            }
            m_checkpoints.Journal.Root = root;
        }

        void AddChunk(GridCube cube, NativeArray<RecordPages> lists, int chunk)
        {
            if (m_build.Files != null)
            {
                m_chunks.Add(cube, chunk);
                return;
            }
            var pages = lists[chunk];
            lists[chunk] = default;
            m_chunks.Add(cube, ref pages);
        }
    }
}
