using System.Collections.Generic;
using System.Linq;
using FastPoints.Laz;
using Unity.Collections;

namespace FastPoints.Tests
{
    static class LazEncoder
    {
        /// <summary>By the package's own writer, which hashes of an independent one hold.</summary>
        public static byte[] Chunk(LazItem[] items, IReadOnlyList<byte[]> records)
        {
            using var writer = new LazChunkWriter(new LazChunkFormat(items, records[0].Length));
            using var bytes = new NativeArray<byte>(records.SelectMany(r => r).ToArray(), Allocator.Persistent);
            writer.Schedule(bytes, records.Count).Complete();
            return writer.Chunk.ToArray();
        }
    }
}
