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
    internal sealed unsafe class ChunkResult
    {
        struct Header
        {
            public ulong Hash;
            public ulong CloudId;
            public ulong Checksum;
            public ChunkRecord Record;
            public ChunkTop Top;
            public int LowestSideLog2;
            public int TopPoints;
            public int PlaneCount;
        }

        /// <summary>The chunk's cube, its number and its file, if it has one.</summary>
        public ChunkRecord Record;
        public ChunkTop Top;

        public int TopPoints;

        public ulong Checksum;

        /// <summary>Side of the smallest node.</summary>
        public int LowestSideLog2;
        public long[] BytesOfPlane;

        public static ChunkResult Of(ChunkIndexer indexer)
        {
            var result = OfTop(indexer);
            result.Checksum = indexer.Checksum;
            result.BytesOfPlane = indexer.BytesOfPlane.ToArray();
            result.Top.HasNodes = indexer.File.Length > 0;
            foreach (var draft in indexer.Drafts.AsArray())
                result.LowestSideLog2 = Math.Min(result.LowestSideLog2, draft.SideLog2);
            if (!result.Top.HasNodes)
                return result;
            var header = *(FileHeader*)indexer.File.GetUnsafeReadOnlyPtr();
            result.Record.NodeCount = header.NodeCount;
            result.Record.PointCount = header.PointCount;
            result.Record.FileBytes = header.FileBytes;
            result.Record.TableOffset = header.TableOffset;
            result.Record.TableHash = header.TableHash;
            return result;
        }

        /// <summary>The result of the chunk's top alone; the caller fills in the checksum.</summary>
        public static ChunkResult OfTop(ChunkIndexer indexer)
        {
            var top = indexer.Drafts[0];
            return new ChunkResult
            {
                TopPoints = top.Count,
                LowestSideLog2 = top.SideLog2,
                BytesOfPlane = new long[indexer.BytesOfPlane.Length],
                Top = new ChunkTop
                {
                    SideLog2 = top.SideLog2,
                    CellLog2 = top.CellLog2,
                    IsLeaf = top.IsLeaf,
                    AttachNode = -1,
                },
                Record = new ChunkRecord
                {
                    Corner = indexer.Cube.Corner,
                    SideLog2 = indexer.Cube.SideLog2,
                    Number = indexer.Number,
                },
            };
        }

        /// <summary>The bytes of its file; the caller disposes them.</summary>
        public NativeArray<byte> ToBytes(NativeArray<byte> topRecords, ulong cloudId)
        {
            int planeBytes = BytesOfPlane.Length * sizeof(long);
            var file = new NativeArray<byte>(sizeof(Header) + planeBytes + topRecords.Length, Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            var start = (byte*)file.GetUnsafePtr();
            var header = (Header*)start;
            *header = new Header
            {
                CloudId = cloudId,
                Checksum = Checksum,
                Record = Record,
                Top = Top,
                LowestSideLog2 = LowestSideLog2,
                TopPoints = TopPoints,
                PlaneCount = BytesOfPlane.Length,
            };
            for (int p = 0; p < BytesOfPlane.Length; p++)
                ((long*)(start + sizeof(Header)))[p] = BytesOfPlane[p];
            UnsafeUtility.MemCpy(start + sizeof(Header) + planeBytes, topRecords.GetUnsafeReadOnlyPtr(), topRecords.Length);
            header->Hash = ContentHash.Of(start + sizeof(ulong), file.Length - sizeof(ulong));
            return file;
        }

        /// <summary>Reads the file of a finished chunk.</summary>
        /// <param name="strideBytes">Bytes of a record.</param>
        /// <returns>Null if the bytes are not such a file, or belong to another cloud.</returns>
        public static ChunkResult FromBytes(NativeArray<byte> file, ulong cloudId, int planeCount, int strideBytes)
        {
            var start = (byte*)file.GetUnsafeReadOnlyPtr();
            var header = (Header*)start;
            if (file.Length < sizeof(Header) || header->Hash != ContentHash.Of(start + sizeof(ulong),
                file.Length - sizeof(ulong)) ||
                header->CloudId != cloudId || header->PlaneCount != planeCount || header->TopPoints < 0 ||
                file.Length != RecordsOffset(planeCount) + (long)header->TopPoints * strideBytes)
                return null;
            var result = new ChunkResult
            {
                Record = header->Record,
                Top = header->Top,
                TopPoints = header->TopPoints,
                Checksum = header->Checksum,
                LowestSideLog2 = header->LowestSideLog2,
                BytesOfPlane = new long[planeCount],
            };
            for (int p = 0; p < planeCount; p++)
                result.BytesOfPlane[p] = ((long*)(start + sizeof(Header)))[p];
            return result;
        }

        /// <summary>Where the top's records begin in the file.</summary>
        public static int RecordsOffset(int planeCount) => sizeof(Header) + planeCount * sizeof(long);
    }
}
