using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Las
{
    // The point data record formats of LAS 1.0 to 1.5, composed of the specification's parts: a core, then GPS time, colour, near
    // infrared, wave packet.
    internal sealed class LasPointFormat
    {
        // Consecutive fields with offsets from their own start.
        sealed class FieldGroup
        {
            public readonly int Bytes;
            public readonly PointField[] Fields;

            public FieldGroup(int bytes, params PointField[] fields)
            {
                Bytes = bytes;
                Fields = fields;
            }
        }

        public const int Count = 11;
        public const int FirstExtended = 6; // Formats from this one on have the 30-byte core.

        // Byte 14: return number 0-2, number of returns 3-5, scan direction 6, edge of flight line 7.
        // Byte 15: class 0-4, synthetic 5, key point 6, withheld 7.
        static readonly FieldGroup s_core = new FieldGroup(20,
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
        static readonly FieldGroup s_extendedCore = new FieldGroup(30,
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

        static readonly FieldGroup s_time = new FieldGroup(8, new PointField(AttributeNames.GpsTime, AttributeType.Float64, 0));

        static readonly FieldGroup s_color = new FieldGroup(6,
            new PointField(AttributeNames.Red, AttributeType.UInt16, 0),
            new PointField(AttributeNames.Green, AttributeType.UInt16, 2),
            new PointField(AttributeNames.Blue, AttributeType.UInt16, 4));

        static readonly FieldGroup s_nearInfrared = new FieldGroup(2,
            new PointField(AttributeNames.NearInfrared, AttributeType.UInt16, 0));

        static readonly FieldGroup s_wave = new FieldGroup(29,
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

        LasPointFormat(int id, params FieldGroup[] groups)
        {
            Id = id;
            var fields = new List<PointField>();
            foreach (var group in groups)
            {
                foreach (var field in group.Fields)
                {
                    var moved = field;
                    moved.ByteOffset += RecordBytes;
                    fields.Add(moved);
                }
                RecordBytes += group.Bytes;
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
                Fields.Add(new PointField(UndescribedName + NumberText.Of(i - end) + "]", AttributeType.UInt8, i));

            Schema = Fields.ToSchema();
        }

        public const string UndescribedName = "ExtraBytes[";

        public LasPointFormat Format { get; }
        public int RecordBytes { get; }

        public int DescribedBytes { get; } // End of the last byte that the format or a description covers.

        public PointFields Fields { get; } = new PointFields();
        public PointSchema Schema { get; }
    }

    // The Extra Bytes record (LASF_Spec/4): 192 bytes for each described field that follows the standard ones in a point. Read in
    // any version if present; real files have it from LAS 1.2 on.
    internal static class LasExtraBytes
    {
        public const int EntryBytes = 192;

        const int TypeAt = 2;
        const int OptionsAt = 3;
        const int NameAt = 4;
        const int NameBytes = 32;
        const int ScaleAt = 112;
        const int OffsetAt = 136;
        const int DescriptionAt = 160;
        const int DescriptionBytes = 32;
        const int ScaleOption = 1 << 3;
        const int OffsetOption = 1 << 4;

        // Data types 1 to 10; 11 to 20 are the same as pairs, 21 to 30 as triples (deprecated in LAS 1.4 R14, but still in use).
        static readonly AttributeType[] s_types =
        {
            AttributeType.UInt8, AttributeType.Int8, AttributeType.UInt16, AttributeType.Int16, AttributeType.UInt32,
            AttributeType.Int32, AttributeType.UInt64, AttributeType.Int64, AttributeType.Float32, AttributeType.Float64,
        };

        // One field for each component (Name[0], Name[1], ... of several). first: offset of the extra bytes in the record of
        // recordBytes; descriptions that do not fit are left out with a warning.
        public static List<PointField> Read(ByteReader entries, int first, int recordBytes, SourceInfo info)
        {
            var fields = new List<PointField>();
            int at = first;
            for (int entry = 0; entries.Has(entry, EntryBytes); entry += EntryBytes)
            {
                long fileOffset = entries.FileOffset + entry;
                int type = entries.UInt8(entry + TypeAt, "extra bytes type");
                int options = entries.UInt8(entry + OptionsAt, "extra bytes options");
                string name = entries.Text(entry + NameAt, NameBytes, "extra bytes name");
                if (name.Length == 0)
                    name = "ExtraBytes";
                if (type > 3 * s_types.Length)
                {
                    info.Warn(fileOffset + TypeAt, "extra bytes \"" + name + "\": wanted a data type of 0 to 30, got "
                        + NumberText.Of(type) + ": it and what follows are read as single bytes");
                    return fields;
                }
                // Type 0 means untyped: its options field holds its length in bytes.
                var component = type == 0 ? AttributeType.UInt8 : s_types[(type - 1) % s_types.Length];
                int components = type == 0 ? options : 1 + (type - 1) / s_types.Length;
                int bytes = components * component.SizeOf();
                if (bytes > recordBytes - at)
                {
                    info.Warn(fileOffset, "extra bytes \"" + name + "\": wanted " + NumberText.Of(bytes)
                        + " bytes of the record, got "
                        + NumberText.Of(recordBytes - at) + ": what is left is read as single bytes");
                    return fields;
                }
                for (int i = 0; i < components; i++)
                {
                    double scale = type != 0 && (options & ScaleOption) != 0 ? Number(entries, entry, ScaleAt, i, 1, info) : 1;
                    double offset = type != 0 && (options & OffsetOption) != 0 ? Number(entries, entry, OffsetAt, i, 0, info) : 0;
                    string fieldName = components == 1 && type != 0 ? name : name + "[" + NumberText.Of(i) + "]";
                    fields.Add(new PointField(fieldName, component, at, scale, offset));
                    at += component.SizeOf();
                }
                string description = entries.Text(entry + DescriptionAt, DescriptionBytes, "extra bytes description");
                info.AddFact("extra bytes " + name, (components == 1 ? "" : NumberText.Of(components) + " x ") + component
                    + (description.Length > 0 ? ", " + description : ""));
            }
            return fields;
        }

        // Each description with its fields; the layout's names are unique, as those of descriptions need not be.
        public static IEnumerable<(byte[] Entry, List<PointField> Fields)> Split(byte[] entries, LasRecordLayout layout)
        {
            var fields = new List<PointField>(layout.Fields);
            int at = layout.Format.Fields.Count;
            for (int from = 0; from + EntryBytes <= entries?.Length; from += EntryBytes)
            {
                var entry = new byte[EntryBytes];
                System.Array.Copy(entries, from, entry, 0, EntryBytes);
                int count = Read(new ByteReader(entry, "", 0), 0, ushort.MaxValue, new SourceInfo()).Count;
                count = System.Math.Min(count, fields.Count - at);
                yield return (entry, fields.GetRange(at, count));
                at += count;
            }
        }

        public static byte[] Entry(PointAttribute attribute)
        {
            var entry = new byte[EntryBytes];
            entry[TypeAt] = (byte)(1 + System.Array.IndexOf(s_types, attribute.Type));
            LasHeader.PutText(entry, NameAt, NameBytes, attribute.Name);
            if (attribute.Scale != 1 || attribute.Offset != 0)
            {
                entry[OptionsAt] = ScaleOption | OffsetOption;
                LasHeader.PutFloat(entry, ScaleAt, attribute.Scale);
                LasHeader.PutFloat(entry, OffsetAt, attribute.Offset);
            }
            return entry;
        }

        static double Number(ByteReader entries, int entry, int at, int component, double fallback, SourceInfo info)
        {
            int position = entry + at + 8 * component;
            double value = entries.Float64(position, "extra bytes scale or offset");
            bool isScale = at == ScaleAt;
            if (!double.IsNaN(value) && !double.IsInfinity(value) && !(isScale && value == 0))
                return value;
            info.Warn(entries.FileOffset + position, "extra bytes " + (isScale ? "scale" : "offset") + ": wanted a number, got "
                + NumberText.Of(value) + ": read as " + NumberText.Of(fallback));
            return fallback;
        }
    }
}
