using System;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>What remains of a chunk when its nodes are written: its top node's points, and what the merge and the hierarchy
    /// need to know. Until the merge it is kept in memory, or in a file that also shows, after a kill, that the chunk is
    /// done.</summary>
    internal sealed unsafe class ChunkResult : IDisposable
    {
        struct Header
        {
            public ulong Hash;
            public ulong CloudId;
            public ulong Checksum;
            public ContainerRecord Container;
            public long FilePointCount;
            public int FileNodeCount;
            public int MinSideLog2;
            public TopNode Top;
            public int TopPoints;
            public int PlaneCount;
        }

        public int Number;
        public ContainerRecord Container; // The chunk's file; of 0 bytes if all points are in its top.

        public int FileNodeCount;
        public long FilePointCount;
        public NativeArray<byte> Table; // The file's nodes, as the indexer left them; not created where they are in a file.
        public TopNode Top;
        public int TopPoints; // These are not in the file.

        public ulong Checksum;

        public int MinSideLog2;
        public long[] BytesOfPlane;

        public static ChunkResult Of(ChunkIndexer indexer)
        {
            var result = OfTop(indexer);
            result.Checksum = indexer.Checksum;
            result.BytesOfPlane = indexer.BytesOfPlane.ToArray();
            result.Top.HasNodes = indexer.File.Length > 0;
            foreach (var draft in indexer.Drafts.AsArray())
                result.MinSideLog2 = Math.Min(result.MinSideLog2, draft.SideLog2);
            if (!result.Top.HasNodes)
                return result;
            var header = *(FileHeader*)indexer.File.GetUnsafeReadOnlyPtr();
            result.Container = header.Container;
            result.FilePointCount = header.PointCount;
            result.FileNodeCount = indexer.Table.Length / BytesPerNode(result.BytesOfPlane.Length);
            return result;
        }

        /// <summary>The result of the chunk's top alone; the caller fills in the checksum.</summary>
        public static ChunkResult OfTop(ChunkIndexer indexer)
        {
            var top = indexer.Drafts[0];
            return new ChunkResult
            {
                TopPoints = top.OwnCount,
                MinSideLog2 = top.SideLog2,
                BytesOfPlane = new long[indexer.BytesOfPlane.Length],
                Top = TopNode.Of(top, false),
                Number = indexer.Number,
                Container = new ContainerRecord { Cube = indexer.Cube, Kind = ContainerKind.Chunk },
            };
        }

        public static int BytesPerNode(int planeCount) => NodeRecord.SizeBytes + planeCount * sizeof(PlaneRange);

        /// <summary>The bytes of its file; the caller disposes them.</summary>
        public NativeArray<byte> ToBytes(NativeArray<byte> table, NativeArray<byte> topRecords, ulong cloudId)
        {
            var file = new NativeArray<byte>(RecordsOffset + topRecords.Length, Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            var start = (byte*)file.GetUnsafePtr();
            var header = (Header*)start;
            *header = new Header
            {
                CloudId = cloudId,
                Checksum = Checksum,
                Container = Container,
                FilePointCount = FilePointCount,
                FileNodeCount = FileNodeCount,
                Top = Top,
                MinSideLog2 = MinSideLog2,
                TopPoints = TopPoints,
                PlaneCount = BytesOfPlane.Length,
            };
            for (int p = 0; p < BytesOfPlane.Length; p++)
                ((long*)(start + sizeof(Header)))[p] = BytesOfPlane[p];
            UnsafeUtility.MemCpy(start + TableOffset, table.GetUnsafeReadOnlyPtr(), TableBytes);
            UnsafeUtility.MemCpy(start + RecordsOffset, topRecords.GetUnsafeReadOnlyPtr(), topRecords.Length);
            header->Hash = ContentHash.Of(start + sizeof(ulong), file.Length - sizeof(ulong));
            return file;
        }

        /// <summary>Reads the file of a finished chunk.</summary>
        /// <param name="strideBytes">Bytes of a record.</param>
        /// <returns>Null if the bytes are not such a file, or belong to another cloud.</returns>
        public static ChunkResult FromBytes(NativeArray<byte> file, int number, ulong cloudId, int planeCount, int strideBytes)
        {
            var start = (byte*)file.GetUnsafeReadOnlyPtr();
            var header = (Header*)start;
            if (file.Length < sizeof(Header) || header->Hash != ContentHash.Of(start + sizeof(ulong),
                file.Length - sizeof(ulong)) ||
                header->CloudId != cloudId || header->PlaneCount != planeCount || header->TopPoints < 0)
                return null;
            var result = new ChunkResult
            {
                Number = number,
                Container = header->Container,
                FileNodeCount = header->FileNodeCount,
                FilePointCount = header->FilePointCount,
                Top = header->Top,
                TopPoints = header->TopPoints,
                Checksum = header->Checksum,
                MinSideLog2 = header->MinSideLog2,
                BytesOfPlane = new long[planeCount],
            };
            if (file.Length != result.RecordsOffset + (long)header->TopPoints * strideBytes)
                return null;
            for (int p = 0; p < planeCount; p++)
                result.BytesOfPlane[p] = ((long*)(start + sizeof(Header)))[p];
            return result;
        }

        public int TableOffset => sizeof(Header) + BytesOfPlane.Length * sizeof(long);
        public int TableBytes => FileNodeCount * BytesPerNode(BytesOfPlane.Length);

        public int RecordsOffset => TableOffset + TableBytes;

        public void Dispose()
        {
            if (Table.IsCreated)
                Table.Dispose();
            Table = default;
        }
    }
}
