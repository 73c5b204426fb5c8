using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Las
{
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

        // Data types 1 to 10; 11 to 20 are the same as pairs, 21 to 30 as triples (deprecated in LAS 1.4 R14, still met).
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
                info.Fact("extra bytes " + name, (components == 1 ? "" : NumberText.Of(components) + " x ") + component
                    + (description.Length > 0 ? ", " + description : ""));
            }
            return fields;
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

        static double Number(ByteReader entries, int entry, int at, int component, double otherwise, SourceInfo info)
        {
            int position = entry + at + 8 * component;
            double value = entries.Float64(position, "extra bytes scale or offset");
            bool isScale = at == ScaleAt;
            if (!double.IsNaN(value) && !double.IsInfinity(value) && !(isScale && value == 0))
                return value;
            info.Warn(entries.FileOffset + position, "extra bytes " + (isScale ? "scale" : "offset") + ": wanted a number, got "
                + NumberText.Of(value) + ": read as " + NumberText.Of(otherwise));
            return otherwise;
        }
    }
}
