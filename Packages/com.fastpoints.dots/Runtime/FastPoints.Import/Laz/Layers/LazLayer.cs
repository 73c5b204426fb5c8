using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Laz
{
    internal enum LazLayerKind
    {
        ReturnsAndXY,
        Z,
        Classification,
        Flags,
        Intensity,
        ScanAngle,
        UserData,
        PointSource,
        GpsTime,
        Rgb,
        NearInfrared,
        WavePacket,
        ExtraByte,
    }

    /// <summary>One layer of layered chunks (point formats 6 to 10): a stream of its own, so that a reader skips unwanted ones.
    /// All but the first hold some bytes of the record; the first also says what the others' contexts are.</summary>
    internal struct LazLayer
    {
        public const int StartBytes = 4;

        public LazLayerKind Kind;

        /// <summary>Offset of the layer's first byte in a record; the first layer also has bytes 14 and 15 (in part).</summary>
        public int RecordOffset;

        public int RecordBytes;

        /// <summary>Whether the scanner channel of the point is the context. In version 3 of all items but POINT14 it is only
        /// so where the channel changes, and 0 elsewhere: LASzip's bug, kept by its files.</summary>
        public bool FollowsChannel;

        /// <summary>Bytes of input that a point takes at most: 15 bits a modelled symbol, and the raw bits.</summary>
        public int MaxInputBytesPerPoint;

        public static LazLayer[] Of(LazItem[] items)
        {
            var layers = new List<LazLayer>();
            foreach (var item in items)
            {
                int at = item.RecordOffset;
                bool isV4 = item.Version >= 4;
                switch (item.Type)
                {
                    case LazItemType.Point14:
                        layers.Add(Layer(LazLayerKind.ReturnsAndXY, at, 8, 24, true));
                        layers.Add(Layer(LazLayerKind.Z, at + 8, 4, 8, true));
                        layers.Add(Layer(LazLayerKind.Classification, at + 16, 1, 2, true));
                        layers.Add(Layer(LazLayerKind.Flags, at + 15, 1, 2, true));
                        layers.Add(Layer(LazLayerKind.Intensity, at + 12, 2, 5, true));
                        layers.Add(Layer(LazLayerKind.ScanAngle, at + 18, 2, 5, true));
                        layers.Add(Layer(LazLayerKind.UserData, at + 17, 1, 2, true));
                        layers.Add(Layer(LazLayerKind.PointSource, at + 20, 2, 5, true));
                        layers.Add(Layer(LazLayerKind.GpsTime, at + 22, 8, 24, true));
                        break;
                    case LazItemType.Rgb14:
                        layers.Add(Layer(LazLayerKind.Rgb, at, 6, 14, isV4));
                        break;
                    case LazItemType.RgbNir14:
                        layers.Add(Layer(LazLayerKind.Rgb, at, 6, 14, isV4));
                        layers.Add(Layer(LazLayerKind.NearInfrared, at + 6, 2, 6, isV4));
                        break;
                    case LazItemType.WavePacket14:
                        layers.Add(Layer(LazLayerKind.WavePacket, at, 29, 50, isV4));
                        break;
                    case LazItemType.Bytes14:
                        for (int i = 0; i < item.Bytes; i++)
                            layers.Add(Layer(LazLayerKind.ExtraByte, at + i, 1, 2, isV4));
                        break;
                }
            }
            return layers.ToArray();
        }

        static LazLayer Layer(LazLayerKind kind, int at, int bytes, int maxInputBytes, bool followsChannel) =>
            new LazLayer
            {
                Kind = kind,
                RecordOffset = at,
                RecordBytes = bytes,
                FollowsChannel = followsChannel,
                MaxInputBytesPerPoint = maxInputBytes,
            };

        /// <summary>Bytes of input that <paramref name="points"/> points of a chunk take at most, header and all
        /// layers.</summary>
        public static long MaxInputBytes(LazLayer[] layers, int recordBytes, long points)
        {
            long bytes = ChunkHeaderBytes(recordBytes, layers.Length);
            foreach (var layer in layers)
                bytes += StartBytes + layer.MaxInputBytesPerPoint * points;
            return bytes;
        }

        /// <summary>Bytes at the start of a chunk in front of the layers: the first point, the point count, the layers'
        /// sizes.</summary>
        public static int ChunkHeaderBytes(int recordBytes, int layerCount) => recordBytes + 4 + 4 * layerCount;
    }

    static class LazLayerChoice
    {
        const int ReturnByte = 14;
        const int FlagByte = 15;
        const int ScannerChannelShift = 4;

        /// <summary>Whether each layer is wanted. The first always is: the others' contexts come from it.</summary>
        /// <exception cref="ArgumentException">The records lack an attribute.</exception>
        public static bool[] Choose(LazLayer[] layers, PointFields fields, PointSchema wanted)
        {
            var isWanted = new bool[layers.Length];
            isWanted[0] = true;
            foreach (var attribute in wanted)
            {
                var field = fields[fields.IndexOf(attribute)];
                // Return counts and the scanner channel come with the first layer.
                if (field.ByteOffset == ReturnByte || field.ByteOffset == FlagByte && field.BitShift == ScannerChannelShift)
                    continue;
                int end = field.ByteOffset + field.Type.SizeOf();
                for (int i = 0; i < layers.Length; i++)
                    isWanted[i] |= field.ByteOffset < layers[i].RecordOffset + layers[i].RecordBytes
                        && end > layers[i].RecordOffset;
            }
            return isWanted;
        }
    }
}
