using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>Assembles hierarchy.bin: the upper nodes' table and one record for each chunk.</summary>
    internal static unsafe class HierarchyFile
    {
        /// <summary>Makes the whole file; the caller disposes it. The manifest receives its size and hash.</summary>
        /// <param name="table">The upper nodes, then their planes' ranges in upper.bin.</param>
        /// <param name="chunks">The chunks, which are sorted here by the node they are attached to.</param>
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
