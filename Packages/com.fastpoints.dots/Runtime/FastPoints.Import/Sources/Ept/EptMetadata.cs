using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    sealed class EptMetadata
    {
        const int MaxRecordBytes = 1 << 14; // Longer records than any cloud has.

        const int DefaultSpan = 128;

        static readonly string[] s_axes = { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };

        // PDAL's dimension names that differ from the usual ones.
        static readonly Dictionary<string, string> s_columnNames = new Dictionary<string, string>
        {
            { "ScanAngleRank", AttributeNames.ScanAngle }, { "Infrared", AttributeNames.NearInfrared },
            { "ScanChannel", AttributeNames.ScannerChannel },
        };

        public PointFields Fields { get; } = new PointFields();
        public SourceInfo Info { get; private set; }
        public BoundsGeo Cube { get; private set; }
        public double Spacing { get; private set; }
        public EptDataType DataType { get; private set; }
        public int RecordBytes { get; private set; }
        public string Folder { get; private set; }

        public static EptMetadata Read(JsonMembers json)
        {
            var info = new SourceInfo
            {
                Path = json.Path,
                FileBytes = json.FileBytes,
                Format = "EPT",
                Version = json.Text("version", "0.0.0"),
                PointsClaimed = (ulong)Math.Max(0, json.Long("points", 0)),
            };
            var metadata = new EptMetadata
            {
                Info = info,
                Folder = SourcePath.FolderOf(SourcePath.Full(json.Path)),
                DataType = ReadDataType(json),
            };
            string hierarchy = json.Text("hierarchyType", "json");
            if (hierarchy != "json")
                throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "hierarchyType", "json", hierarchy);
            bool isKnown = info.Version.StartsWith("0.", StringComparison.Ordinal)
                || info.Version.StartsWith("1.", StringComparison.Ordinal);
            if (!isKnown)
                info.Warn(-1, "version: wanted 0 or 1, got " + info.Version + ": read anyway");
            metadata.ReadCube(json);
            metadata.ReadSchema(json);
            ReadCrs(json, info);
            info.AddFact("data type", json.Text("dataType"));
            info.AddFact("span", NumberText.Of(json.Number("span", 0)));
            info.AddFact("spacing", NumberText.Of(metadata.Spacing));
            info.AddFact("schema bytes a point", NumberText.Of(metadata.RecordBytes));
            return metadata;
        }

        static EptDataType ReadDataType(JsonMembers json)
        {
            string name = json.Text("dataType");
            return name switch
            {
                "binary" => EptDataType.Binary,
                "zstandard" => EptDataType.Zstandard,
                "laszip" => EptDataType.Laszip,
                _ => throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "dataType",
                    "binary, laszip or zstandard", name),
            };
        }

        void ReadCube(JsonMembers json)
        {
            Cube = Box(json.Numbers("bounds", 6));
            if (Cube.IsEmpty)
                throw json.Wanted("bounds", "a box");
            double span = json.Number("span", DefaultSpan);
            if (!(span >= 1))
            {
                Info.Warn(-1, "span: wanted at least 1, got " + NumberText.Of(span) + ": taken as " + DefaultSpan);
                span = DefaultSpan;
            }
            Spacing = Cube.Size.x / span;
            if (!json.IsNumbers("boundsConforming", 6))
                return;
            Info.BoundsClaimed = Box(json.Numbers("boundsConforming", 6));
            Info.HasBoundsClaimed = !Info.BoundsClaimed.IsEmpty;
        }

        static BoundsGeo Box(double[] n) => new BoundsGeo(new double3(n[0], n[1], n[2]), new double3(n[3], n[4], n[5]));

        void ReadSchema(JsonMembers json)
        {
            var transform = PositionTransform.Identity;
            long bytes = 0;
            foreach (var dimension in json.Objects("schema"))
            {
                var type = ReadType(dimension);
                double scale = dimension.Number("scale", 1), offset = dimension.Number("offset", 0);
                if (scale == 0)
                {
                    Info.Warn(-1, "scale of " + dimension.Text("name") + ": wanted a number that is not 0, got 0: read as 1");
                    scale = 1;
                }
                string name = dimension.Text("name");
                int axis = Array.IndexOf(s_axes, name);
                if (axis >= 0 && !Fields.TryFind(name, out _))
                {
                    // Positions keep their scale and offset in the cloud's transform.
                    transform.Scale[axis] = scale;
                    transform.Offset[axis] = offset;
                    scale = 1;
                    offset = 0;
                }
                name = s_columnNames.TryGetValue(name, out string typical) ? typical : name;
                Fields.Add(new PointField(name, type, (int)bytes, scale, offset));
                bytes += type.SizeOf();
                if (bytes > MaxRecordBytes)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "bytes of a point",
                        "at most " + NumberText.Of(MaxRecordBytes), bytes);
            }
            foreach (string axis in s_axes)
                if (!Fields.TryFind(axis, out _))
                    throw PointCloudException.Wanted(FailureCode.BadInput, json.Path, -1, "schema", "X, Y and Z", "no " + axis);
            RecordBytes = (int)bytes;
            Info.Transform = transform;
            Info.Schema = Fields.ToSchema();
            Info.RecordBytes = DataType == EptDataType.Binary ? RecordBytes : 0;
        }

        static AttributeType ReadType(JsonMembers dimension)
        {
            string type = dimension.Text("type");
            long size = dimension.Long("size");
            bool isFloat = type == "float" || type == "floating", isSigned = type == "signed";
            if (!isFloat && !isSigned && type != "unsigned")
                throw dimension.Wanted("type", "signed, unsigned or float");
            if (size != 4 && size != 8 && (isFloat || size != 1 && size != 2))
                throw dimension.Wanted("size", isFloat ? "4 or 8 for a float" : "1, 2, 4 or 8");
            return !isFloat ? AttributeTypes.Integer((int)size, isSigned)
                : size == 4 ? AttributeType.Float32 : AttributeType.Float64;
        }

        static void ReadCrs(JsonMembers json, SourceInfo info)
        {
            if (!json.IsObject("srs"))
                return;
            var srs = json.Object("srs");
            string wkt = srs.Text("wkt", "");
            if (wkt.Length > 0 && !CrsText.Read(wkt, info.Crs))
                info.Warn(-1, "the CRS is no well-known text: left out");
            string vertical = srs.Text("vertical", "");
            if (!info.Crs.IsKnown && srs.Text("authority", "") == "EPSG")
                CrsText.Read("EPSG:" + srs.Text("horizontal", "") + (vertical.Length > 0 ? "+" + vertical : ""), info.Crs);
        }
    }

    internal enum EptDataType
    {
        Binary, // Records as the schema describes them, one after the other (.bin).

        Zstandard, // The same in a zstandard frame (.zst).

        Laszip, // A whole LAZ file (.laz).
    }
}
