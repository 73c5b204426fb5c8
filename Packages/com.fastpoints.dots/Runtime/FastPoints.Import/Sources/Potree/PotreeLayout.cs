using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.Sources
{
    sealed class PotreeLayout
    {
        const int MaxRecordBytes = 1 << 14; // Longer records than any cloud has.

        readonly List<PotreeAttribute> m_attributes = new List<PotreeAttribute>();
        readonly PointFields m_fields = new PointFields();

        readonly List<int> m_attributeOfField = new List<int>();

        public PotreeLayout(IEnumerable<PotreeAttribute> attributes, string path)
        {
            long bytes = 0;
            foreach (var attribute in attributes)
            {
                if (attribute.IsPackedNormal && m_attributes.Exists(other => other.IsPackedNormal))
                    attribute.SetRawBytes();
                attribute.RecordOffset = (int)bytes;
                bytes += attribute.Bytes;
                if (bytes > MaxRecordBytes)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, path, -1, "bytes of a point",
                        "at most " + NumberText.Of(MaxRecordBytes), bytes);
                for (int i = 0; i < attribute.Columns.Length; i++)
                    AddField(attribute, i);
                m_attributes.Add(attribute);
                if (attribute.IsPosition && Position == null)
                    Position = attribute;
            }
            if (Position == null)
                throw PointCloudException.Wanted(FailureCode.BadInput, path, -1, "attributes", "a position of three int32",
                    m_attributes.Count == 0 ? "none at all" : string.Join(", ", m_attributes.ConvertAll(a => a.Name)));
            RecordBytes = (int)bytes;
            Schema = m_fields.ToSchema();
        }

        public IReadOnlyList<PotreeAttribute> Attributes => m_attributes;
        public PotreeAttribute Position { get; }
        public int RecordBytes { get; }
        public PointSchema Schema { get; }

        public int AttributeOf(PointAttribute column) => m_attributeOfField[m_fields.IndexOf(column)];

        // For a normal in two bytes, of these.
        public PointField FieldOf(PointAttribute column) => m_fields[m_fields.IndexOf(column)];

        // recordStart: offset in the cloud's record at which the records begin.
        public FieldCopy[] PlanCopies(PointBatch batch, Func<PotreeAttribute, bool> isTaken, int recordStart)
        {
            var fields = new List<PointField>();
            var columns = new List<PointColumn>();
            for (int i = 0; i < batch.Schema.Count; i++)
            {
                if (!isTaken(m_attributes[AttributeOf(batch.Schema[i])]))
                    continue;
                var field = FieldOf(batch.Schema[i]);
                field.ByteOffset -= recordStart;
                fields.Add(field);
                columns.Add(batch.Column(i));
            }
            return FieldCopyPlan.Make(fields.ToArray(), columns.ToArray());
        }

        void AddField(PotreeAttribute attribute, int index)
        {
            var column = attribute.Columns[index];
            int offset = attribute.RecordOffset + (attribute.IsPackedNormal ? 0 : index * column.Type.SizeOf());
            var field = m_fields.Add(new PointField(column.Name, column.Type, offset, column.Scale, column.Offset));
            m_attributeOfField.Add(m_attributes.Count);
            attribute.Columns[index] = field.ToAttribute();
        }
    }

    sealed class PotreeAttribute
    {
        public const int MaxElements = 256;

        static readonly Dictionary<string, AttributeType> s_types = new Dictionary<string, AttributeType>
        {
            { "uint8", AttributeType.UInt8 }, { "int8", AttributeType.Int8 }, { "uint16", AttributeType.UInt16 },
            { "int16", AttributeType.Int16 }, { "uint32", AttributeType.UInt32 }, { "int32", AttributeType.Int32 },
            { "uint64", AttributeType.UInt64 }, { "int64", AttributeType.Int64 }, { "float", AttributeType.Float32 },
            { "double", AttributeType.Float64 },
        };

        // Names of Potree 1 (1.x: capitals; 1.8: some in lower case) and 2, in capitals with '_' for blanks and '-'.
        static readonly Dictionary<string, string> s_columnNames = new Dictionary<string, string>
        {
            { "INTENSITY", AttributeNames.Intensity }, { "CLASSIFICATION", AttributeNames.Classification },
            { "RETURN_NUMBER", AttributeNames.ReturnNumber }, { "NUMBER_OF_RETURNS", AttributeNames.NumberOfReturns },
            { "SOURCE_ID", AttributeNames.PointSourceId }, { "POINT_SOURCE_ID", AttributeNames.PointSourceId },
            { "GPS_TIME", AttributeNames.GpsTime }, { "SCAN_ANGLE_RANK", AttributeNames.ScanAngle },
            { "SCAN_ANGLE", AttributeNames.ScanAngle }, { "USER_DATA", AttributeNames.UserData },
            { "NORMALX", AttributeNames.NormalX }, { "NORMALY", AttributeNames.NormalY }, { "NORMALZ", AttributeNames.NormalZ },
        };

        static readonly string[] s_axes = { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
        static readonly string[] s_colors =
            { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue, AttributeNames.Alpha };
        static readonly string[] s_normals = { AttributeNames.NormalX, AttributeNames.NormalY, AttributeNames.NormalZ };

        public string Name;
        public PotreeAttributeKind Kind;
        public AttributeType Type; // For a normal in two bytes, that of its column.

        public PointAttribute[] Columns;
        public int Bytes;
        public int RecordOffset;

        public bool IsPosition => Kind == PotreeAttributeKind.Position;

        public bool IsPackedNormal =>
            Kind == PotreeAttributeKind.SphereMappedNormal || Kind == PotreeAttributeKind.OctahedralNormal;

        // If the size does not fit the type, or the type is unknown, it is read as single bytes, and "anomaly" says so. The scale
        // of each element, in value = stored * scale + offset, is 1 for null.
        public static PotreeAttribute Make(string name, string typeName, int bytes, double[] scales, double[] offsets,
            out string anomaly)
        {
            anomaly = null;
            var attribute = new PotreeAttribute { Name = name, Bytes = bytes };
            bool isKnown = s_types.TryGetValue(typeName, out attribute.Type);
            string canonical = name.ToUpperInvariant().Replace(' ', '_').Replace('-', '_');
            if (attribute.MakeSpecial(canonical))
                return attribute;
            if (!isKnown || bytes % attribute.Type.SizeOf() != 0)
            {
                anomaly = "attribute \"" + name + "\": " + NumberText.Of(bytes) + " bytes of type \"" + typeName
                    + "\": read as single bytes";
                attribute.Type = AttributeType.UInt8;
            }
            int elements = bytes / attribute.Type.SizeOf();
            if (s_columnNames.TryGetValue(canonical, out string column) && elements == 1)
            {
                // PotreeConverter 2 writes the signed scan angle of point formats 0 to 5 and says uint8.
                if (column == AttributeNames.ScanAngle && attribute.Type == AttributeType.UInt8)
                    attribute.Type = AttributeType.Int8;
                attribute.Columns = new[] { new PointAttribute(column, attribute.Type) };
                return attribute;
            }
            attribute.Columns = new PointAttribute[elements];
            for (int i = 0; i < elements; i++)
                attribute.Columns[i] = new PointAttribute(elements == 1 ? name : name + "[" + NumberText.Of(i)
                    + "]", attribute.Type,
                    At(scales, i, 1), At(offsets, i, 0));
            return attribute;
        }

        public void SetRawBytes()
        {
            Kind = PotreeAttributeKind.Plain;
            Type = AttributeType.UInt8;
            Columns = new PointAttribute[Bytes];
            for (int i = 0; i < Bytes; i++)
                Columns[i] = new PointAttribute(Name + "[" + NumberText.Of(i) + "]", Type);
        }

        // More than a list of numbers, if it has its usual form.
        bool MakeSpecial(string canonical)
        {
            switch (canonical)
            {
                case "POSITION_CARTESIAN":
                case "POSITION":
                    SetColumns(PotreeAttributeKind.Position, AttributeType.Int32, s_axes, 3);
                    if (Bytes == 12)
                        return true;
                    break;
                case "COLOR_PACKED":
                case "RGBA_PACKED":
                case "RGB_PACKED":
                case "RGBA":
                case "RGB":
                    SetColumns(PotreeAttributeKind.Color, Bytes >= 6 ? AttributeType.UInt16 : AttributeType.UInt8, s_colors,
                        Bytes == 4 || Bytes == 8 ? 4 : 3);
                    if (Bytes == 3 || Bytes == 4 || Bytes == 6 || Bytes == 8)
                        return true;
                    break;
                case "NORMAL_SPHEREMAPPED":
                    SetColumns(PotreeAttributeKind.SphereMappedNormal, AttributeType.Float32, s_normals, 3);
                    if (Bytes == 2)
                        return true;
                    break;
                case "NORMAL_OCT16":
                    SetColumns(PotreeAttributeKind.OctahedralNormal, AttributeType.Float32, s_normals, 3);
                    if (Bytes == 2)
                        return true;
                    break;
                case "NORMAL":
                case "NORMAL_FLOATS":
                    SetColumns(PotreeAttributeKind.Plain, AttributeType.Float32, s_normals, 3);
                    if (Bytes == 12)
                        return true;
                    break;
            }
            Kind = PotreeAttributeKind.Plain;
            return false;
        }

        void SetColumns(PotreeAttributeKind kind, AttributeType type, string[] names, int count)
        {
            Kind = kind;
            Type = type;
            Columns = new PointAttribute[count];
            for (int i = 0; i < count; i++)
                Columns[i] = new PointAttribute(names[i], type);
        }

        static double At(double[] values, int index, double fallback) =>
            values != null && index < values.Length ? values[index] : fallback;
    }

    enum PotreeAttributeKind
    {
        Plain, // Each element is a column of the attribute's own type.

        Position, // Three int32, relative to the node's or the cloud's corner.

        Color, // Red, green, blue of one type, possibly followed by alpha.

        SphereMappedNormal, // A unit vector in two bytes, by the sphere map of the Lambert azimuthal equal-area projection.

        OctahedralNormal, // A unit vector in two bytes, folded over an octahedron.
    }
}
