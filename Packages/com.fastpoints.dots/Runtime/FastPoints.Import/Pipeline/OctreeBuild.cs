using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Octree;
using FastPoints.Points;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Pipeline
{
    /// <summary>From chunks of records to a stored octree: each chunk into its file, the tops of all into the upper
    /// levels.</summary>
    public sealed class OctreeBuild : IDisposable
    {
        readonly ChunkSet m_chunks;
        readonly RecordLayout m_records;
        readonly NativeStoreLayout m_store;
        readonly GridCube m_root;
        readonly ulong m_cloudId;
        readonly CloudFolderWriter m_folder;
        readonly Sampler m_sampler;
        readonly NodeSizes m_sizes;
        readonly List<ChunkIndexer> m_indexers = new List<ChunkIndexer>();
        readonly NativeArray<byte>[] m_topRecords;
        readonly ChunkTop[] m_tops;
        readonly ChunkRecord[] m_chunkRecords;

        public OctreeBuild(ChunkSet chunks, RecordLayout records, NativeStoreLayout store, GridCube root, ulong cloudId,
            CloudFolderWriter folder, Sampler sampler, NodeSizes sizes)
        {
            m_chunks = chunks;
            m_records = records;
            m_store = store;
            m_root = root;
            m_cloudId = cloudId;
            m_folder = folder;
            m_sampler = sampler;
            m_sizes = sizes;
            m_topRecords = new NativeArray<byte>[chunks.Chunks.Count];
            m_tops = new ChunkTop[m_topRecords.Length];
            m_chunkRecords = new ChunkRecord[m_topRecords.Length];
            BytesOfPlane = new long[store.Layout.Planes.Count];
        }

        /// <summary>Sum of the hashes of all points that were written.</summary>
        public ulong Checksum { get; private set; }
        public int NodeCount { get; private set; }

        /// <summary>Chunks that have a file.</summary>
        public int ChunkCount { get; private set; }
        public int LevelCount { get; private set; }
        public long[] BytesOfPlane { get; }

        /// <summary>Work for a pump: every chunk, several at once; then the upper levels and the hierarchy.</summary>
        /// <param name="atOnce">Chunks in work: memory is theirs.</param>
        public IEnumerator<JobHandle> Run(int atOnce, CloudManifest manifest, StageProgress progress)
        {
            progress?.Begin("index");
            using (var chunks = IndexChunks(atOnce, progress))
                while (chunks.MoveNext())
                    yield return chunks.Current;
            progress?.Begin("merge");
            using (var upper = MergeUpper(manifest, progress))
                while (upper.MoveNext())
                    yield return upper.Current;
            foreach (var indexer in m_indexers)
                for (int p = 0; p < BytesOfPlane.Length; p++)
                    BytesOfPlane[p] += indexer.BytesOfPlane[p];
        }

        public void Dispose()
        {
            foreach (var indexer in m_indexers)
                indexer.Dispose();
            m_indexers.Clear();
            for (int i = 0; i < m_topRecords.Length; i++)
            {
                if (m_topRecords[i].IsCreated)
                    m_topRecords[i].Dispose();
                m_topRecords[i] = default;
            }
        }

        IEnumerator<JobHandle> IndexChunks(int atOnce, StageProgress progress)
        {
            // The largest first, so that none is left for the end alone.
            int count = m_topRecords.Length;
            var order = new int[count];
            var sizes = new long[count];
            long total = 0, done = 0;
            for (int i = 0; i < count; i++)
            {
                order[i] = i;
                sizes[i] = -m_chunks.Chunks[i].Pages.Count;
                total -= sizes[i];
            }
            Array.Sort(sizes, order);
            atOnce = Math.Max(1, Math.Min(atOnce, count));
            for (int i = 0; i < atOnce; i++)
                m_indexers.Add(new ChunkIndexer(m_records, m_store, m_root.Corner, m_cloudId, m_sampler, m_sizes));
            var written = new WriteTicket[atOnce];
            for (int i = 0; i < count + atOnce; i++)
            {
                var indexer = m_indexers[i % atOnce];
                if (i >= atOnce)
                {
                    yield return indexer.Job;
                    indexer.Job.Complete();
                    Finish(indexer);
                    written[i % atOnce] = Write(indexer);
                    done -= sizes[i - atOnce];
                    progress?.Report(done / (double)total, done, m_folder.BytesWritten);
                }
                if (i >= count)
                    continue;
                // The file's memory is the indexer's: it is written before the next chunk overwrites it.
                while (written[i % atOnce] != null && !written[i % atOnce].IsDone(1))
                    yield return default;
                indexer.Begin(m_chunks.Chunks[order[i]], order[i]);
            }
            foreach (var ticket in written)
                while (ticket != null && !ticket.IsDone(1))
                    yield return default;
        }

        WriteTicket Write(ChunkIndexer indexer) =>
            indexer.File.Length == 0 ? null : m_folder.Write(StoreFormat.ChunkPath(indexer.Number), indexer.File.AsArray());

        unsafe void Finish(ChunkIndexer indexer)
        {
            int number = indexer.Number;
            Checksum += indexer.Checksum;
            var top = indexer.Drafts[0];
            m_topRecords[number] = new NativeArray<byte>(indexer.Top.AsArray(), Allocator.Persistent);
            m_tops[number] = new ChunkTop
            {
                SideLog2 = top.SideLog2,
                CellLog2 = top.CellLog2,
                IsLeaf = top.IsLeaf,
                HasNodes = indexer.File.Length > 0,
                AttachNode = -1,
            };
            if (indexer.File.Length == 0)
                return;
            var header = *(FileHeader*)indexer.File.GetUnsafeReadOnlyPtr();
            ChunkCount++;
            NodeCount += header.NodeCount;
            foreach (var draft in indexer.Drafts.AsArray())
                LevelCount = Math.Max(LevelCount, m_root.SideLog2 - draft.SideLog2 + 1);
            m_chunkRecords[number] = new ChunkRecord
            {
                Corner = indexer.Chunk.Cube.Corner,
                SideLog2 = indexer.Chunk.Cube.SideLog2,
                Number = number,
                NodeCount = header.NodeCount,
                PointCount = header.PointCount,
                FileBytes = header.FileBytes,
                TableOffset = header.TableOffset,
                TableHash = header.TableHash,
            };
        }

        IEnumerator<JobHandle> MergeUpper(CloudManifest manifest, StageProgress progress)
        {
            int chunkCount = m_topRecords.Length;
            long bytes = 0;
            foreach (var records in m_topRecords)
                bytes += records.Length;
            var all = new NativeArray<byte>(checked((int)bytes), Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            var tops = new NativeArray<ChunkTop>(m_tops, Allocator.Persistent);
            var upper = new ChunkIndexer(m_records, m_store, m_root.Corner, m_cloudId, m_sampler, m_sizes);
            m_indexers.Add(upper);
            var hierarchy = default(NativeArray<byte>);
            WriteTicket ticket = null;
            try
            {
                int at = 0;
                for (int i = 0; i < chunkCount; i++)
                {
                    NativeArray<byte>.Copy(m_topRecords[i], 0, all, at, m_topRecords[i].Length);
                    var top = tops[i];
                    top.First = at / m_records.StrideBytes;
                    at += m_topRecords[i].Length;
                    top.End = at / m_records.StrideBytes;
                    tops[i] = top;
                    m_topRecords[i].Dispose();
                    m_topRecords[i] = default;
                    yield return default;
                }
                upper.BeginUpper(all, tops, m_root);
                yield return upper.Job;
                upper.Job.Complete();
                foreach (var draft in upper.Drafts.AsArray())
                    LevelCount = Math.Max(LevelCount, m_root.SideLog2 - draft.SideLog2 + 1);
                if (upper.File.Length > 0)
                {
                    ticket = m_folder.Write(StoreFormat.UpperName, upper.File.AsArray());
                    manifest.UpperBytes = upper.File.Length;
                }
                NodeCount += upper.Drafts.Length;
                manifest.NodeCount = NodeCount;
                manifest.ChunkCount = ChunkCount;

                var records = new List<ChunkRecord>();
                for (int i = 0; i < chunkCount; i++)
                {
                    if (!tops[i].HasNodes)
                        continue;
                    m_chunkRecords[i].AttachNode = upper.NodeOfDraft[tops[i].AttachNode];
                    records.Add(m_chunkRecords[i]);
                }
                hierarchy = HierarchyFile.Create(upper.Table.AsArray(), upper.Drafts.Length, m_store.Layout.Planes.Count, records,
                    manifest);
                while (ticket != null && !ticket.IsDone(1))
                    yield return default;
                ticket = m_folder.Write(StoreFormat.HierarchyName, hierarchy);
                while (!ticket.IsDone(1))
                    yield return default;
                progress?.Report(1, at / m_records.StrideBytes, m_folder.BytesWritten);
            }
            finally
            {
                upper.Job.Complete();
                ticket?.Wait();
                if (hierarchy.IsCreated)
                    hierarchy.Dispose();
                tops.Dispose();
                all.Dispose();
            }
        }
    }
}
