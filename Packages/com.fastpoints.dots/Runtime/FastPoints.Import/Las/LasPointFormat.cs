using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Las
{
    // The point data record formats of LAS 1.0 to 1.5, composed of the specification's parts: a core, then GPS time, colour, near
    // infrared, wave packet.
    internal sealed class LasPointFormat
    {
        // Consecutive fields with offsets from their own start.
        sealed class Part
        {
            public readonly int Bytes;
            public readonly PointField[] Fields;

            public Part(int bytes, params PointField[] fields)
            {
                Bytes = bytes;
                Fields = fields;
            }
        }

        public const int Count = 11;

        // Formats from this one on have the 30-byte core.
        public const int FirstExtended = 6;

        // Byte 14: return number 0-2, number of returns 3-5, scan direction 6, edge of flight line 7.
        // Byte 15: class 0-4, synthetic 5, key point 6, withheld 7.
        static readonly Part s_core = new Part(20,
            new PointField(AttributeNames.X, AttributeType.Int32, 0),
            new PointField(AttributeNames.Y, AttributeType.Int32, 4),
            new PointField(AttributeNames.Z, AttributeType.Int32, 8),
            new PointField(AttributeNames.Intensity, AttributeType.UInt16, 12),
            new PointField(AttributeNames.ReturnNumber, 14, 0, 3),
            new PointField(AttributeNames.NumberOfReturns, 14, 3, 3),
            new PointField(AttributeNames.ScanDirectionFlag, 14, 6, 1),
            new PointField(AttributeNames.EdgeOfFlightLine, 14, 7, 1),
            new PointField(AttributeNames.Classification, 15, 0, 5),
            new PointField(AttributeNames.Synthetic, 15, 5, 1),
            new PointField(AttributeNames.KeyPoint, 15, 6, 1),
            new PointField(AttributeNames.Withheld, 15, 7, 1),
            new PointField(AttributeNames.ScanAngle, AttributeType.Int8, 16),
            new PointField(AttributeNames.UserData, AttributeType.UInt8, 17),
            new PointField(AttributeNames.PointSourceId, AttributeType.UInt16, 18));

        // Byte 14: return number 0-3, number of returns 4-7.
        // Byte 15: synthetic 0, key point 1, withheld 2, overlap 3, scanner channel 4-5, scan direction 6, edge of flight line 7.
        static readonly Part s_extendedCore = new Part(30,
            new PointField(AttributeNames.X, AttributeType.Int32, 0),
            new PointField(AttributeNames.Y, AttributeType.Int32, 4),
            new PointField(AttributeNames.Z, AttributeType.Int32, 8),
            new PointField(AttributeNames.Intensity, AttributeType.UInt16, 12),
            new PointField(AttributeNames.ReturnNumber, 14, 0, 4),
            new PointField(AttributeNames.NumberOfReturns, 14, 4, 4),
            new PointField(AttributeNames.Synthetic, 15, 0, 1),
            new PointField(AttributeNames.KeyPoint, 15, 1, 1),
            new PointField(AttributeNames.Withheld, 15, 2, 1),
            new PointField(AttributeNames.Overlap, 15, 3, 1),
            new PointField(AttributeNames.ScannerChannel, 15, 4, 2),
            new PointField(AttributeNames.ScanDirectionFlag, 15, 6, 1),
            new PointField(AttributeNames.EdgeOfFlightLine, 15, 7, 1),
            new PointField(AttributeNames.Classification, AttributeType.UInt8, 16),
            new PointField(AttributeNames.UserData, AttributeType.UInt8, 17),
            new PointField(AttributeNames.ScanAngle, AttributeType.Int16, 18),
            new PointField(AttributeNames.PointSourceId, AttributeType.UInt16, 20),
            new PointField(AttributeNames.GpsTime, AttributeType.Float64, 22));

        static readonly Part s_time = new Part(8, new PointField(AttributeNames.GpsTime, AttributeType.Float64, 0));

        static readonly Part s_color = new Part(6,
            new PointField(AttributeNames.Red, AttributeType.UInt16, 0),
            new PointField(AttributeNames.Green, AttributeType.UInt16, 2),
            new PointField(AttributeNames.Blue, AttributeType.UInt16, 4));

        static readonly Part s_nearInfrared = new Part(2, new PointField(AttributeNames.NearInfrared, AttributeType.UInt16, 0));

        static readonly Part s_wave = new Part(29,
            new PointField(AttributeNames.WavePacketDescriptorIndex, AttributeType.UInt8, 0),
            new PointField(AttributeNames.ByteOffsetToWaveformData, AttributeType.UInt64, 1),
            new PointField(AttributeNames.WaveformPacketSize, AttributeType.UInt32, 9),
            new PointField(AttributeNames.ReturnPointWaveformLocation, AttributeType.Float32, 13),
            new PointField(AttributeNames.ParametricDx, AttributeType.Float32, 17),
            new PointField(AttributeNames.ParametricDy, AttributeType.Float32, 21),
            new PointField(AttributeNames.ParametricDz, AttributeType.Float32, 25));

        static readonly LasPointFormat[] s_formats =
        {
            new LasPointFormat(0, s_core),
            new LasPointFormat(1, s_core, s_time),
            new LasPointFormat(2, s_core, s_color),
            new LasPointFormat(3, s_core, s_time, s_color),
            new LasPointFormat(4, s_core, s_time, s_wave),
            new LasPointFormat(5, s_core, s_time, s_color, s_wave),
            new LasPointFormat(6, s_extendedCore),
            new LasPointFormat(7, s_extendedCore, s_color),
            new LasPointFormat(8, s_extendedCore, s_color, s_nearInfrared),
            new LasPointFormat(9, s_extendedCore, s_wave),
            new LasPointFormat(10, s_extendedCore, s_color, s_nearInfrared, s_wave),
        };

        LasPointFormat(int id, params Part[] parts)
        {
            Id = id;
            var fields = new List<PointField>();
            foreach (var part in parts)
            {
                foreach (var field in part.Fields)
                {
                    var moved = field;
                    moved.ByteOffset += RecordBytes;
                    fields.Add(moved);
                }
                RecordBytes += part.Bytes;
            }
            Fields = fields.ToArray();
        }

        public int Id { get; }
        public int RecordBytes { get; }
        public IReadOnlyList<PointField> Fields { get; }
        public bool IsExtended => Id >= FirstExtended;

        public static LasPointFormat Of(int id) => s_formats[id];
    }

    internal sealed class LasRecordLayout
    {
        // recordBytes: according to the header, at least the format's own; extra: described bytes, with offsets from the record's
        // start. The rest of the record becomes columns of single bytes named ExtraBytes[i], so that no part of a record is lost.
        public LasRecordLayout(LasPointFormat format, int recordBytes, IEnumerable<PointField> extra)
        {
            Format = format;
            RecordBytes = recordBytes;
            foreach (var field in format.Fields)
                Fields.Add(field);
            int end = format.RecordBytes;
            foreach (var field in extra)
            {
                Fields.Add(field);
                end = field.ByteOffset + field.Type.SizeOf();
            }
            DescribedBytes = end;
            for (int i = end; i < recordBytes; i++)
                Fields.Add(new PointField("ExtraBytes[" + NumberText.Of(i - end) + "]", AttributeType.UInt8, i));

            Schema = Fields.ToSchema();
        }

        public LasPointFormat Format { get; }
        public int RecordBytes { get; }

        // End of the last byte that the format or a description covers.
        public int DescribedBytes { get; }

        public PointFields Fields { get; } = new PointFields();
        public PointSchema Schema { get; }
    }
}
