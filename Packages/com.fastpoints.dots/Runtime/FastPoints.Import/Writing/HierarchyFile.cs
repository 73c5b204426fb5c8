using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Writing
{
    /// <summary>Puts hierarchy.bin together: the upper nodes' table and one record a chunk.</summary>
    internal static unsafe class HierarchyFile
    {
        /// <summary>The whole file; the caller disposes it. The manifest gets its size and hash.</summary>
        /// <param name="table">The upper nodes, then their planes' ranges in upper.bin.</param>
        /// <param name="chunks">Sorted here by the node they hang on.</param>
        public static NativeArray<byte> Create(NativeArray<byte> table, int nodeCount, int planeCount, List<ChunkRecord> chunks,
            CloudManifest manifest)
        {
            chunks.Sort((a, b) => a.AttachNode != b.AttachNode ? a.AttachNode.CompareTo(b.AttachNode)
                : a.Number.CompareTo(b.Number));
            int chunkBytes = chunks.Count * ChunkRecord.SizeBytes;
            var file = new NativeArray<byte>(FileHeader.SizeBytes + table.Length + chunkBytes, Allocator.Persistent);
            var start = (byte*)file.GetUnsafePtr();
            byte* tableStart = start + FileHeader.SizeBytes;
            UnsafeUtility.MemCpy(tableStart, table.GetUnsafeReadOnlyPtr(), table.Length);
            var nodes = (NodeRecord*)tableStart;
            var records = (ChunkRecord*)(tableStart + table.Length);
            for (int i = 0; i < chunks.Count; i++)
            {
                records[i] = chunks[i];
                var node = nodes + chunks[i].AttachNode;
                if (node->ChunkCount++ == 0)
                    node->FirstChunk = i;
            }

            var header = new FileHeader
            {
                Magic = StoreFormat.HierarchyMagic,
                Version = StoreFormat.Version,
                PlaneCount = planeCount,
                NodeCount = nodeCount,
                ChunkCount = chunks.Count,
                PointCount = manifest.Points,
                TableOffset = FileHeader.SizeBytes,
                TableHash = ContentHash.Of(tableStart, table.Length + chunkBytes),
                FileBytes = file.Length,
                CloudId = manifest.CloudId,
            };
            header.HeaderHash = ContentHash.Of(&header, FileHeader.SizeBytes - sizeof(ulong));
            *(FileHeader*)start = header;
            manifest.HierarchyBytes = file.Length;
            manifest.HierarchyHash = ContentHash.Of(start, file.Length);
            return file;
        }
    }
}
