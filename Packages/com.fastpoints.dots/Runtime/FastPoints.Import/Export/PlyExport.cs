using System;
using System.Text;
using FastPoints.Las;
using FastPoints.Reading;

namespace FastPoints.Export
{
    /// <summary>Binary little-endian PLY: georeferenced coordinates as doubles, or the source's own floats; each attribute in its
    /// type, scaled ones as their values.</summary>
    internal sealed class PlyExport : ExportFormat
    {
        const int BufferBytes = 1 << 20;

        const int CountDigits = 20;

        /// <summary>Indexed by type: PLY has no 64-bit integers.</summary>
        static readonly string[] s_types =
        {
            "uchar", "char", "ushort", "short", "uint", "int", "double", "double", "float", "double",
        };

        readonly StringBuilder m_properties = new StringBuilder();
        readonly string m_crs;

        public PlyExport(PointReader reader, string[] chosen)
        {
            var info = reader.Info;
            if (reader is ILasSource || LasRecordsOf(reader) != null)
                Losses.Add(new Loss("header and records of LAS files", info.Path, "PLY has no place for them"));
            var schema = info.Schema;
            bool isFloat = true;
            foreach (var attribute in schema)
                isFloat &= !IsAxis(attribute.Name) || attribute.Type == AttributeType.Float32;
            var transform = info.Transform;
            isFloat &= transform.Scale.Equals(PositionTransform.Identity.Scale) && transform.Offset.Equals(default);
            SetAxes(isFloat ? AttributeType.Float32 : AttributeType.Float64);
            Position = new PositionConversion { Kind = isFloat ? PositionKind.Copied : PositionKind.Geo, From = transform };
            foreach (var axis in Axes)
                AddProperty(axis, axis.Name);
            foreach (var attribute in schema)
            {
                if (IsAxis(attribute.Name) || !IsChosen(attribute.Name, chosen))
                    continue;
                bool isWide = attribute.Type == AttributeType.Int64 || attribute.Type == AttributeType.UInt64;
                bool isScaled = attribute.Scale != 1 || attribute.Offset != 0;
                var field = new PointField(attribute.Name, isWide || isScaled ? AttributeType.Float64 : attribute.Type,
                    RecordBytes);
                Columns.Add(new ExportColumn
                {
                    From = attribute.Name,
                    To = field,
                    Scale = attribute.Scale,
                    Offset = attribute.Offset,
                });
                if (isWide)
                    Losses.Add(new Loss("digits of " + attribute.Name, info.Path, "PLY has no 64-bit whole numbers: written as " +
                        "doubles, exact to 2^53"));
                AddProperty(field, attribute.Name);
            }
            BufferPoints = Math.Max(1, BufferBytes / RecordBytes);
            if (info.Crs.Wkt != null || info.Crs.GeoKeys != null)
                Losses.Add(new Loss("the definition of the coordinate system", info.Path, "PLY has a comment with its name"));
            if (info.GpsTime.Kind != GpsTimeKind.Unknown && schema.Has(AttributeNames.GpsTime))
                Losses.Add(new Loss("the kind of GPS times (" + info.GpsTime + ")", info.Path, "PLY has no place for it"));
            m_crs = info.Crs.Summary == null ? "" : "comment CRS " + ToAscii(info.Crs.Summary, ' ') + "\n";
        }

        public override byte[] MakeHeader(string path, in ExportState written, long chunksEnd, long pointsEnd)
        {
            string count = NumberText.Of(written.Written);
            return Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\ncomment written by FastPoints " +
                new string('.', CountDigits - count.Length) + "\n" + m_crs + "element vertex " + count + "\n" + m_properties +
                "end_header\n");
        }

        void AddProperty(PointField field, string name)
        {
            RecordBytes += field.Type.SizeOf();
            m_properties.Append("property ").Append(s_types[(int)field.Type]).Append(' ').Append(ToAscii(NameOf(name), '_'))
                .Append('\n');
        }

        static string NameOf(string name) => name switch
        {
            AttributeNames.X or AttributeNames.Y or AttributeNames.Z or AttributeNames.Red or AttributeNames.Green or
                AttributeNames.Blue or AttributeNames.Alpha or AttributeNames.Intensity => name.ToLowerInvariant(),
            AttributeNames.NormalX => "nx",
            AttributeNames.NormalY => "ny",
            AttributeNames.NormalZ => "nz",
            _ => name,
        };

        static string ToAscii(string text, char replacement)
        {
            var ascii = new StringBuilder();
            foreach (char c in text)
                ascii.Append(c > ' ' && c < 127 ? c : replacement);
            return ascii.ToString();
        }
    }
}
