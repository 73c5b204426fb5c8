using System;
using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Laz
{
    internal enum LazCompressor
    {
        None = 0, // Uncompressed records in a file that says LAZ.

        Pointwise = 1, // One stream from the first point to the last (LASzip 1.x).

        PointwiseChunked = 2, // Chunks, each a stream of its own.

        LayeredChunked = 3, // Chunks of layers, for point formats 6 to 10.
    }

    internal sealed class LazFormat
    {
        public const string UserId = LasVlr.CompressionUser;
        public const ushort RecordId = 22204;

        // Each chunk has its own number, in the chunk table; 0 has been written for it as well.
        public const uint VariableChunkPoints = uint.MaxValue;
        public const int MaxExtraBytes = 4096; // More than any file has: a decoder's state takes 1.6 KB for each.
        public const int ItemCountOffset = 32; // Of the number of items in the VLR's data; the items follow it.

        const int FixedBytes = ItemCountOffset + 2;
        public const int ItemEntryBytes = 6;

        public LazCompressor Compressor;
        public uint ChunkPoints; // Of each chunk except the last, or VariableChunkPoints.

        public LazItem[] Items;
        public int RecordBytes;
        public string WriterVersion;
        public LazLayer[] Layers; // Of layered chunks; otherwise empty.

        public bool IsLayered => Compressor == LazCompressor.LayeredChunked;
        public bool HasVariableChunks => ChunkPoints == VariableChunkPoints;

        public static LazFormat Read(LasFile las)
        {
            string path = las.Info.Path;
            LasVlr record = null;
            foreach (var vlr in las.Vlrs.Records)
                if (vlr.RecordId == RecordId && vlr.UserId == UserId)
                    record = vlr;
            if (record == null)
                throw new PointCloudException(FailureCode.BadInput, path, LasHeader.At.PointFormat,
                    "the points are compressed, but there is no LASzip VLR that says how");

            var bytes = las.Vlrs.Payload(record);
            long at = bytes.FileOffset;
            int compressor = bytes.UInt16(0, "LASzip compressor");
            if (compressor > (int)LazCompressor.LayeredChunked)
                throw PointCloudException.Wanted(FailureCode.Unsupported, path, at, "LASzip compressor", "0 to 3", compressor);
            int coder = bytes.UInt16(2, "LASzip coder");
            if (coder != 0)
                throw PointCloudException.Wanted(FailureCode.Unsupported, path, at + 2, "LASzip entropy coder", 0, coder);
            int count = bytes.UInt16(32, "LASzip items");
            if (count == 0 || count > PointwiseChunk.MaxItems)
                throw PointCloudException.Wanted(FailureCode.BadInput, path, at + 32, "LASzip items",
                    "1 to " + NumberText.Of(PointwiseChunk.MaxItems), count);

            var format = new LazFormat
            {
                Compressor = (LazCompressor)compressor,
                ChunkPoints = bytes.UInt32(12, "LASzip chunk size"),
                WriterVersion = NumberText.Of(bytes.UInt8(4, "LASzip version")) + "."
                    + NumberText.Of(bytes.UInt8(5, "LASzip version")) + "."
                    + NumberText.Of(bytes.UInt16(6, "LASzip version")),
                Items = new LazItem[count],
                RecordBytes = las.Header.RecordBytes,
            };
            if (format.ChunkPoints == 0)
                format.ChunkPoints = VariableChunkPoints;
            int end = 0;
            for (int i = 0; i < count; i++)
            {
                format.Items[i] = ReadItem(bytes, FixedBytes + i * ItemEntryBytes, end, format.Compressor);
                end += format.Items[i].Bytes;
            }
            format.Layers = format.IsLayered ? LazLayer.Of(format.Items) : new LazLayer[0];
            CheckItems(format, las, at + 32);
            return format;
        }

        // isWanted: by layer.
        public unsafe NativeArray<byte> CreateDecoder(bool[] isWanted, Allocator allocator)
        {
            long bytes = IsLayered ? LayeredChunk.StateBytes(Layers, isWanted, RecordBytes) : PointwiseChunk.StateBytes(Items);
            var state = new NativeArray<byte>((int)bytes, allocator, NativeArrayOptions.UninitializedMemory);
            if (IsLayered)
                LayeredChunk.Configure((LayeredChunk*)state.GetUnsafePtr(), Layers, isWanted, RecordBytes);
            else
                PointwiseChunk.Configure((PointwiseChunk*)state.GetUnsafePtr(), Items, RecordBytes);
            return state;
        }

        public void AddFacts(SourceInfo info)
        {
            info.AddFact("LASzip version", WriterVersion);
            info.AddFact("LASzip compressor", Compressor.ToString());
            info.AddFact("LASzip chunk points", Compressor == LazCompressor.Pointwise ? "none"
                : HasVariableChunks ? "variable" : NumberText.Of(ChunkPoints));
            info.AddFact("LASzip items", string.Join(", ", Array.ConvertAll(Items, item => item.Type + " v"
                + NumberText.Of(item.Version))));
        }

        static LazItem ReadItem(ByteReader bytes, int at, int recordOffset, LazCompressor compressor)
        {
            int type = bytes.UInt16(at, "LASzip item type");
            int size = bytes.UInt16(at + 2, "LASzip item size");
            int version = bytes.UInt16(at + 4, "LASzip item version");
            var item = new LazItem { Type = (LazItemType)type, Bytes = size, Version = version, RecordOffset = recordOffset };
            long offset = bytes.FileOffset + at;
            bool isKnown = type == (int)LazItemType.Bytes || type >= (int)LazItemType.Point10 && type <= (int)LazItemType.Bytes14;
            if (!isKnown)
                throw PointCloudException.Wanted(FailureCode.Unsupported, bytes.Path, offset, "LASzip item type",
                    "0 or 6 to 14", type);
            int wanted = LazItem.FixedBytes(item.Type);
            if (wanted != 0 && size != wanted)
                throw PointCloudException.Wanted(FailureCode.BadInput, bytes.Path, offset + 2, "bytes of LASzip item "
                    + item.Type, wanted, size);
            if (wanted == 0 && (size == 0 || size > MaxExtraBytes))
                throw PointCloudException.Wanted(FailureCode.Unsupported, bytes.Path, offset + 2, "bytes of LASzip item "
                    + item.Type, "1 to " + NumberText.Of(MaxExtraBytes), size);
            if (compressor != LazCompressor.None && !LazItem.IsVersionKnown(item.Type, version))
                throw PointCloudException.Wanted(FailureCode.Unsupported, bytes.Path, offset + 4, "version of LASzip item "
                    + item.Type, "a known one", version);
            return item;
        }

        // They must be those of the point format, in the record's order, and as long as the record.
        static void CheckItems(LazFormat format, LasFile las, long at)
        {
            var got = new List<string>();
            int bytes = 0;
            bool isExtraLast = true;
            for (int i = 0; i < format.Items.Length; i++)
            {
                var item = format.Items[i];
                bytes += item.Bytes;
                bool isExtra = item.Type == LazItemType.Bytes || item.Type == LazItemType.Bytes14;
                isExtraLast &= !isExtra || i == format.Items.Length - 1;
                if (!isExtra)
                    got.Add(item.Type.ToString());
                if (format.Compressor != LazCompressor.None && item.IsLayered != format.IsLayered)
                    throw new PointCloudException(FailureCode.BadInput, las.Info.Path, at, "LASzip item " + item.Type
                        + " does not go with compressor " + format.Compressor);
            }
            string wanted = string.Join(" + ", LazItems.TypesOf(las.Header.PointFormat));
            string items = string.Join(" + ", got);
            if (items != wanted || !isExtraLast)
                throw PointCloudException.Wanted(FailureCode.BadInput, las.Info.Path, at,
                    "LASzip items of point format " + NumberText.Of(las.Header.PointFormat), wanted, items);
            if (bytes != format.RecordBytes)
                throw PointCloudException.Wanted(FailureCode.BadInput, las.Info.Path, at, "bytes of the LASzip items",
                    NumberText.Of(format.RecordBytes) + " (the record length)", bytes);
        }
    }

    // The parts of a record, each of which is compressed in its own way.
    internal static class LazItems
    {
        // version: 1 or 2 for point formats 0 to 5, 3 or 4 above.
        public static LazItem[] Of(int pointFormat, int version, int extraBytes)
        {
            var types = TypesOf(pointFormat);
            if (extraBytes > 0)
                types.Add(pointFormat >= LasPointFormat.FirstExtended ? LazItemType.Bytes14 : LazItemType.Bytes);
            var items = new LazItem[types.Count];
            int recordOffset = 0;
            for (int i = 0; i < items.Length; i++)
            {
                int fixedBytes = LazItem.FixedBytes(types[i]);
                items[i] = new LazItem
                {
                    Type = types[i],
                    // Wave packets of pointwise chunks have one version only.
                    Version = types[i] == LazItemType.WavePacket13 ? 1 : version,
                    Bytes = fixedBytes != 0 ? fixedBytes : extraBytes,
                    RecordOffset = recordOffset,
                };
                recordOffset += items[i].Bytes;
            }
            return items;
        }

        // Without extra bytes.
        public static List<LazItemType> TypesOf(int pointFormat)
        {
            bool isExtended = pointFormat >= LasPointFormat.FirstExtended;
            var types = new List<LazItemType> { isExtended ? LazItemType.Point14 : LazItemType.Point10 };
            if (pointFormat == 1 || pointFormat >= 3 && pointFormat <= 5)
                types.Add(LazItemType.GpsTime11);
            if (pointFormat == 2 || pointFormat == 3 || pointFormat == 5)
                types.Add(LazItemType.Rgb12);
            if (pointFormat == 7)
                types.Add(LazItemType.Rgb14);
            if (pointFormat == 8 || pointFormat == 10)
                types.Add(LazItemType.RgbNir14);
            if (pointFormat == 4 || pointFormat == 5)
                types.Add(LazItemType.WavePacket13);
            if (pointFormat == 9 || pointFormat == 10)
                types.Add(LazItemType.WavePacket14);
            return types;
        }

        public static byte[] Vlr(LazItem[] items, LazCompressor compressor, uint chunkPoints)
        {
            var list = ToBytes(items);
            var payload = new byte[LazFormat.ItemCountOffset + list.Length];
            LasHeader.Put(payload, 0, 2, (ulong)compressor);
            // As LASzip 3.4 writes it.
            payload[4] = 3;
            payload[5] = 4;
            LasHeader.Put(payload, 12, 4, chunkPoints);
            // The number of special EVLRs, and where they begin: none.
            LasHeader.Put(payload, 16, 8, ulong.MaxValue);
            LasHeader.Put(payload, 24, 8, ulong.MaxValue);
            list.CopyTo(payload, LazFormat.ItemCountOffset);
            return LasVlr.ToBytes(LazFormat.UserId, LazFormat.RecordId, "", payload);
        }

        // As in the VLR, from their number on.
        public static byte[] ToBytes(LazItem[] items)
        {
            var bytes = new byte[2 + items.Length * LazFormat.ItemEntryBytes];
            LasHeader.Put(bytes, 0, 2, (ulong)items.Length);
            for (int i = 0; i < items.Length; i++)
            {
                int at = 2 + i * LazFormat.ItemEntryBytes;
                LasHeader.Put(bytes, at, 2, (ulong)items[i].Type);
                LasHeader.Put(bytes, at + 2, 2, (ulong)items[i].Bytes);
                LasHeader.Put(bytes, at + 4, 2, (ulong)items[i].Version);
            }
            return bytes;
        }
    }
}
