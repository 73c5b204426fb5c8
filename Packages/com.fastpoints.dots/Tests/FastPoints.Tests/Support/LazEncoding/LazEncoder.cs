using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Laz;
using static FastPoints.Tests.RecordFields;

namespace FastPoints.Tests
{
    public static class LazEncoder
    {
        internal static byte[] Chunk(LazItem[] items, IReadOnlyList<byte[]> records) =>
            items[0].Type == LazItemType.Point14 ? LayeredChunk(items, records) : PointwiseChunk(items, records);

        static byte[] PointwiseChunk(LazItem[] items, IReadOnlyList<byte[]> records)
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
            bool isV1 = item.Version == 1;
            int at = item.RecordOffset;
            return item.Type switch
            {
                LazItemType.Point10 => isV1 ? (IItemEncoder)new Point10EncoderV1(first) : new Point10Encoder(first),
                LazItemType.GpsTime11 => isV1 ? (IItemEncoder)new GpsTimeEncoderV1(Int64(first, at), at)
                    : new GpsTimeEncoder(Int64(first, at), at, false),
                LazItemType.Rgb12 => isV1 ? (IItemEncoder)new RgbEncoderV1(first, at) : new RgbEncoder(first, at),
                LazItemType.WavePacket13 => new WavePacketEncoder(first, at),
                LazItemType.Bytes => new BytesEncoder(first, at, item.Bytes, isV1),
                _ => throw new ArgumentException(item.Type + " does not go into pointwise chunks"),
            };
        }

        static byte[] LayeredChunk(LazItem[] items, IReadOnlyList<byte[]> records)
        {
            var first = records[0];
            var point = new Point14Encoder(first);
            var others = new List<ILayeredItemEncoder>();
            foreach (var item in items)
                AddEncoders(others, item, first, point.Channel);
            for (int i = 1; i < records.Count; i++)
            {
                point.Encode(records[i]);
                foreach (var other in others)
                    other.Encode(records[i], point.Channel, point.ChannelChanged);
            }
            var layers = new List<byte[]>();
            point.Finish(layers);
            foreach (var other in others)
                other.Finish(layers);

            var chunk = new BinaryWriter(new MemoryStream());
            chunk.Write(first);
            chunk.Write((uint)records.Count);
            foreach (var layer in layers)
                chunk.Write((uint)layer.Length);
            foreach (var layer in layers)
                chunk.Write(layer);
            return ((MemoryStream)chunk.BaseStream).ToArray();
        }

        static void AddEncoders(List<ILayeredItemEncoder> encoders, LazItem item, byte[] first, int channel)
        {
            bool isV4 = item.Version == 4;
            int at = item.RecordOffset;
            switch (item.Type)
            {
                case LazItemType.Point14:
                    break;
                case LazItemType.Rgb14:
                    encoders.Add(new RgbLayerEncoder(first, at, channel, isV4));
                    break;
                case LazItemType.RgbNir14:
                    encoders.Add(new RgbLayerEncoder(first, at, channel, isV4));
                    encoders.Add(new InfraredLayerEncoder(first, at + 6, channel, isV4));
                    break;
                case LazItemType.WavePacket14:
                    encoders.Add(new WaveLayerEncoder(first, at, channel, isV4));
                    break;
                case LazItemType.Bytes14:
                    for (int i = 0; i < item.Bytes; i++)
                        encoders.Add(new ByteLayerEncoder(first, at + i, channel, isV4));
                    break;
                default:
                    throw new ArgumentException(item.Type + " does not go into layered chunks");
            }
        }

        /// <param name="points">Of each chunk; null where all are of the size that the VLR names.</param>
        public static byte[] Table(IReadOnlyList<int> bytes, IReadOnlyList<int> points)
        {
            var table = new BinaryWriter(new MemoryStream());
            table.Write(0u);
            table.Write((uint)bytes.Count);
            if (bytes.Count > 0)
            {
                var stream = new RangeEncoder();
                var model = new IntegerEncoder(32, 2);
                for (int i = 0; i < bytes.Count; i++)
                {
                    if (points != null)
                        model.Encode(stream, i > 0 ? points[i - 1] : 0, points[i], 0);
                    model.Encode(stream, i > 0 ? bytes[i - 1] : 0, bytes[i], 1);
                }
                table.Write(stream.Finish());
            }
            return ((MemoryStream)table.BaseStream).ToArray();
        }
    }
}
