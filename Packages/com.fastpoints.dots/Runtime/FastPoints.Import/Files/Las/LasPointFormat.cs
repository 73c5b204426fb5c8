using System.Collections.Generic;
using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>The eleven point data record formats of LAS 1.0 to 1.5, each composed of the specification's parts: a core, then
    /// GPS time, colour, near infrared, wave packet.</summary>
    internal sealed class LasPointFormat
    {
        /// <summary>Consecutive fields with offsets from their own start.</summary>
        sealed class Part
        {
            public readonly int Bytes;
            public readonly LasField[] Fields;

            public Part(int bytes, params LasField[] fields)
            {
                Bytes = bytes;
                Fields = fields;
            }
        }

        public const int Count = 11;

        /// <summary>Formats from this one on have the 30-byte core.</summary>
        public const int FirstExtended = 6;

        // Byte 14: return number 0-2, number of returns 3-5, scan direction 6, edge of flight line 7.
        // Byte 15: class 0-4, synthetic 5, key point 6, withheld 7.
        static readonly Part s_core = new Part(20,
            new LasField(AttributeNames.X, AttributeType.Int32, 0),
            new LasField(AttributeNames.Y, AttributeType.Int32, 4),
            new LasField(AttributeNames.Z, AttributeType.Int32, 8),
            new LasField(AttributeNames.Intensity, AttributeType.UInt16, 12),
            new LasField(AttributeNames.ReturnNumber, 14, 0, 3),
            new LasField(AttributeNames.NumberOfReturns, 14, 3, 3),
            new LasField(AttributeNames.ScanDirectionFlag, 14, 6, 1),
            new LasField(AttributeNames.EdgeOfFlightLine, 14, 7, 1),
            new LasField(AttributeNames.Classification, 15, 0, 5),
            new LasField(AttributeNames.Synthetic, 15, 5, 1),
            new LasField(AttributeNames.KeyPoint, 15, 6, 1),
            new LasField(AttributeNames.Withheld, 15, 7, 1),
            new LasField(AttributeNames.ScanAngle, AttributeType.Int8, 16),
            new LasField(AttributeNames.UserData, AttributeType.UInt8, 17),
            new LasField(AttributeNames.PointSourceId, AttributeType.UInt16, 18));

        // Byte 14: return number 0-3, number of returns 4-7.
        // Byte 15: synthetic 0, key point 1, withheld 2, overlap 3, scanner channel 4-5, scan direction 6, edge of flight line 7.
        static readonly Part s_extendedCore = new Part(30,
            new LasField(AttributeNames.X, AttributeType.Int32, 0),
            new LasField(AttributeNames.Y, AttributeType.Int32, 4),
            new LasField(AttributeNames.Z, AttributeType.Int32, 8),
            new LasField(AttributeNames.Intensity, AttributeType.UInt16, 12),
            new LasField(AttributeNames.ReturnNumber, 14, 0, 4),
            new LasField(AttributeNames.NumberOfReturns, 14, 4, 4),
            new LasField(AttributeNames.Synthetic, 15, 0, 1),
            new LasField(AttributeNames.KeyPoint, 15, 1, 1),
            new LasField(AttributeNames.Withheld, 15, 2, 1),
            new LasField(AttributeNames.Overlap, 15, 3, 1),
            new LasField(AttributeNames.ScannerChannel, 15, 4, 2),
            new LasField(AttributeNames.ScanDirectionFlag, 15, 6, 1),
            new LasField(AttributeNames.EdgeOfFlightLine, 15, 7, 1),
            new LasField(AttributeNames.Classification, AttributeType.UInt8, 16),
            new LasField(AttributeNames.UserData, AttributeType.UInt8, 17),
            new LasField(AttributeNames.ScanAngle, AttributeType.Int16, 18),
            new LasField(AttributeNames.PointSourceId, AttributeType.UInt16, 20),
            new LasField(AttributeNames.GpsTime, AttributeType.Float64, 22));

        static readonly Part s_time = new Part(8, new LasField(AttributeNames.GpsTime, AttributeType.Float64, 0));

        static readonly Part s_color = new Part(6,
            new LasField(AttributeNames.Red, AttributeType.UInt16, 0),
            new LasField(AttributeNames.Green, AttributeType.UInt16, 2),
            new LasField(AttributeNames.Blue, AttributeType.UInt16, 4));

        static readonly Part s_nearInfrared = new Part(2, new LasField(AttributeNames.NearInfrared, AttributeType.UInt16, 0));

        static readonly Part s_wave = new Part(29,
            new LasField(AttributeNames.WavePacketDescriptorIndex, AttributeType.UInt8, 0),
            new LasField(AttributeNames.ByteOffsetToWaveformData, AttributeType.UInt64, 1),
            new LasField(AttributeNames.WaveformPacketSize, AttributeType.UInt32, 9),
            new LasField(AttributeNames.ReturnPointWaveformLocation, AttributeType.Float32, 13),
            new LasField(AttributeNames.ParametricDx, AttributeType.Float32, 17),
            new LasField(AttributeNames.ParametricDy, AttributeType.Float32, 21),
            new LasField(AttributeNames.ParametricDz, AttributeType.Float32, 25));

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
            var fields = new List<LasField>();
            foreach (var part in parts)
            {
                foreach (var field in part.Fields)
                    fields.Add(field.MovedBy(RecordBytes));
                RecordBytes += part.Bytes;
            }
            Fields = fields.ToArray();
        }

        public int Id { get; }

        /// <summary>Bytes of a record without extra bytes.</summary>
        public int RecordBytes { get; }

        /// <summary>In the order of the record.</summary>
        public IReadOnlyList<LasField> Fields { get; }

        public bool IsExtended => Id >= FirstExtended;

        /// <param name="id">0 to 10.</param>
        public static LasPointFormat Of(int id) => s_formats[id];
    }
}
