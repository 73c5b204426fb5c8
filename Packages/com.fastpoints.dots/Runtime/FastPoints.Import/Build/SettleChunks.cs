using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>Finds the root cube by the points that came, and makes chunks that are neither too large nor needlessly
    /// small.</summary>
    internal sealed class SettleChunks
    {
        readonly BuildContext m_build;
        readonly ScatterPoints m_scatter;
        readonly ChunkSet m_chunks;
        readonly BuildCheckpoints m_checkpoints;

        public SettleChunks(BuildContext build, ScatterPoints scatter, ChunkSet chunks, BuildCheckpoints checkpoints)
        {
            m_build = build;
            m_scatter = scatter;
            m_chunks = chunks;
            m_checkpoints = checkpoints;
        }

        /// <summary>Work for a pump.</summary>
        public IEnumerator<Work> Run()
        {
            var journal = m_checkpoints.Journal;
            var found = m_scatter.Statistics;
            if (found.Count == 0)
                yield break;
            if (journal.At == BuildJournal.Stage.Read)
            {
                yield return Work.Of(TakeChunks());
                journal.At = BuildJournal.Stage.Split;
                yield return Work.Of(m_checkpoints.Write());
            }
            else
            {
                foreach (var chunk in journal.Chunks)
                    m_chunks.Add(chunk.Cube, chunk.Runs);
            }
            m_chunks.Settled = m_checkpoints.Write;
            if (journal.At == BuildJournal.Stage.Split)
            {
                long target = m_build.Plan.PointsPerChunk;
                yield return Work.Of(m_chunks.SplitLarge(2 * target, target));
                // The pump looks at its budget.
                yield return default;
                journal.Root = RootCube.Shrink(journal.Root, found.Min, found.Max);
                m_chunks.MergeSmall(journal.Root, target);
                journal.At = BuildJournal.Stage.Index;
                yield return Work.Of(m_checkpoints.Write());
            }
            m_chunks.Settled = null;
            if (m_build.Files != null)
                RecordPagePool.Of(m_build.Pool).FreeAll();
        }

        /// <summary>Takes over the partition's chunks. Where there are points outside, the root grows until it has
        /// them.</summary>
        IEnumerator<Work> TakeChunks()
        {
            var map = m_build.Map;
            var lists = m_scatter.Chunks;
            for (int c = 0; c < map.Chunks.Length; c++)
                TakeChunk(map.Chunks[c], lists, c);
            int inside = m_chunks.Chunks.Count;
            TakeChunk(map.Cube, lists, map.Outside);
            var root = map.Cube;
            if (m_chunks.Chunks.Count > inside)
            {
                var shells = RootCube.Grow(root, m_scatter.Statistics.Min, m_scatter.Statistics.Max);
                root = shells[shells.Length - 1];
                yield return Work.Of(m_chunks.SplitOutside(shells, m_chunks.Chunks[inside]));
            }
            m_checkpoints.Journal.Root = root;
        }

        void TakeChunk(GridCube cube, NativeArray<RecordPages> lists, int chunk)
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
