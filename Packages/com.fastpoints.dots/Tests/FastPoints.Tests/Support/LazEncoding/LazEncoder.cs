using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Laz;
using Unity.Collections;
using static FastPoints.Tests.RecordFields;

namespace FastPoints.Tests
{
    public static class LazEncoder
    {
        /// <summary>By the package's own writer, but for version 1 of items, which it does not write.</summary>
        internal static byte[] Chunk(LazItem[] items, IReadOnlyList<byte[]> records)
        {
            if (items[0].Version == 1)
                return FirstVersion(items, records);
            using var writer = new LazChunkWriter(new LazChunkForm(items, records[0].Length));
            using var bytes = new NativeArray<byte>(records.SelectMany(r => r).ToArray(), Allocator.Persistent);
            writer.Schedule(bytes, records.Count).Complete();
            return writer.Chunk.ToArray();
        }

        static byte[] FirstVersion(LazItem[] items, IReadOnlyList<byte[]> records)
        {
            var first = records[0];
            var encoders = new List<IItemEncoder>();
            foreach (var item in items)
                encoders.Add(Encoder(item, first));
            var stream = new RangeEncoder();
            for (int i = 1; i < records.Count; i++)
                foreach (var encoder in encoders)
                    encoder.Encode(stream, records[i]);
            var chunk = new MemoryStream();
            chunk.Write(first, 0, first.Length);
            var bytes = stream.Finish();
            chunk.Write(bytes, 0, bytes.Length);
            return chunk.ToArray();
        }

        static IItemEncoder Encoder(LazItem item, byte[] first)
        {
            int at = item.RecordOffset;
            return item.Type switch
            {
                LazItemType.Point10 => new Point10EncoderV1(first),
                LazItemType.GpsTime11 => new GpsTimeEncoderV1(Int64(first, at), at),
                LazItemType.Rgb12 => new RgbEncoderV1(first, at),
                LazItemType.WavePacket13 => new WavePacketEncoder(first, at),
                LazItemType.Bytes => new BytesEncoderV1(first, at, item.Bytes),
                _ => throw new ArgumentException(item.Type + " does not go into pointwise chunks"),
            };
        }
    }
}
