using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    static class PotreeIndexes
    {
        public static PotreeAttribute ReadAttribute(JsonMembers item, string elementsName, SourceInfo info)
        {
            long bytes = item.Long("size");
            if (bytes < 1 || bytes > PotreeAttribute.MaxElements * 8)
                throw item.Bad("size", "1 to " + PotreeAttribute.MaxElements * 8 + " bytes");
            long elements = item.Long(elementsName, 1);
            double[] scales = item.IsNumbers("scale", (int)Math.Max(1, Math.Min(elements, PotreeAttribute.MaxElements)))
                ? item.Numbers("scale", (int)elements) : null;
            double[] offsets = item.IsNumbers("offset", (int)Math.Max(1, Math.Min(elements, PotreeAttribute.MaxElements)))
                ? item.Numbers("offset", (int)elements) : null;
            if (scales != null && Array.IndexOf(scales, 0.0) >= 0)
                scales = null;
            var attribute = PotreeAttribute.Make(item.Text("name"), item.Text("type", ""), (int)bytes, scales, offsets,
                out string anomaly);
            if (anomaly != null)
                info.Warn(-1, anomaly);
            string description = item.Text("description", "");
            if (description.Length > 0)
                info.Fact("attribute " + attribute.Name, description);
            return attribute;
        }

        // No writer produces zero or negative ones.
        public static double3 UsableScale(double3 scale, JsonMembers json) =>
            math.all(scale > 0) ? scale : throw PointCloudException.Wanted(FailureCode.BadInput, json.Path, -1, "\"scale\"",
                "numbers above 0", NumberText.Of(scale));

        public static BoundsGeo Cube(BoundsGeo box, JsonMembers json) =>
            !box.IsEmpty ? box : throw PointCloudException.Wanted(FailureCode.BadInput, json.Path, -1, "\"boundingBox\"",
                "a box", "a maximum below the minimum");

        // Without one, 1/128 of the cube's edge, as converters use.
        public static double Spacing(JsonMembers json, BoundsGeo cube)
        {
            double spacing = json.Number("spacing", 0);
            return spacing > 0 ? spacing : math.cmax(cube.Size) / 128;
        }

        // Any kind of text: well-known text, a PROJ string, a code.
        public static void ReadProjection(JsonMembers json, SourceInfo info)
        {
            string text = json.Text("projection", "").Trim();
            if (text.Length == 0 || WktCoordinateSystem.Read(text, info.Crs))
                return;
            info.Crs.Name = text;
            if (text.StartsWith("EPSG:", StringComparison.OrdinalIgnoreCase) && int.TryParse(text.Substring(5), NumberStyles.None,
                CultureInfo.InvariantCulture, out int code))
                info.Crs.Epsg = code;
        }

        public static void AddFact(JsonMembers json, string name, SourceInfo info)
        {
            string text = json.Text(name, "");
            if (text.Length > 0)
                info.Fact(name, text);
        }
    }

    sealed class Potree2Index
    {
        public SourceInfo Info { get; private set; }
        public PotreeLayout Layout { get; private set; }
        public BoundsGeo Cube { get; private set; }
        public double Spacing { get; private set; }
        public long FirstChunkBytes { get; private set; }
        public bool IsBrotli { get; private set; }

        public static Potree2Index Read(JsonMembers json)
        {
            string encoding = json.Text("encoding");
            if (encoding != "DEFAULT" && encoding != "BROTLI" && encoding != "UNCOMPRESSED")
                throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "encoding", "DEFAULT or BROTLI",
                    encoding);
            var info = new SourceInfo
            {
                Path = json.Path,
                FileBytes = json.FileBytes,
                Format = "Potree",
                Version = json.Text("version", "2"),
                PointsClaimed = (ulong)System.Math.Max(0, json.Long("points", 0)),
            };
            info.Transform.Scale = PotreeIndexes.UsableScale(json.Vector("scale"), json);
            info.Transform.Offset = json.Vector("offset");
            var box = json.Object("boundingBox");
            var index = new Potree2Index
            {
                Info = info,
                Cube = PotreeIndexes.Cube(new BoundsGeo(box.Vector("min"), box.Vector("max")), json),
                IsBrotli = encoding == "BROTLI",
                FirstChunkBytes = json.Object("hierarchy").Long("firstChunkSize"),
            };
            index.Spacing = PotreeIndexes.Spacing(json, index.Cube);
            index.Layout = new PotreeLayout(ReadAttributes(json, info), json.Path);
            info.Schema = index.Layout.Schema;
            info.RecordBytes = index.IsBrotli ? 0 : index.Layout.RecordBytes;
            info.HasBoundsClaimed = true;
            PotreeIndexes.ReadProjection(json, info);
            PotreeIndexes.AddFact(json, "name", info);
            PotreeIndexes.AddFact(json, "description", info);
            info.Fact("encoding", encoding);
            info.Fact("spacing", NumberText.Of(index.Spacing));
            return index;
        }

        static List<PotreeAttribute> ReadAttributes(JsonMembers json, SourceInfo info)
        {
            var attributes = new List<PotreeAttribute>();
            var box = json.Object("boundingBox");
            info.BoundsClaimed = new BoundsGeo(box.Vector("min"), box.Vector("max"));
            foreach (var item in json.Objects("attributes"))
            {
                var attribute = PotreeIndexes.ReadAttribute(item, "numElements", info);
                if (attribute.IsPosition && item.IsNumbers("min", 3) && item.IsNumbers("max", 3))
                    TightenBounds(new BoundsGeo(item.Vector("min"), item.Vector("max")), info);
                attributes.Add(attribute);
            }
            return attributes;
        }

        // The position's range is that of the points, the bounding box is the cube around them.
        static void TightenBounds(BoundsGeo range, SourceInfo info)
        {
            var step = info.Transform.Scale;
            if (!range.IsEmpty && math.all(range.Max <= info.BoundsClaimed.Max + step)
                && math.all(range.Min >= info.BoundsClaimed.Min - step))
                info.BoundsClaimed = range;
        }
    }

    sealed class Potree1Index
    {
        // Elements and type of the attributes that versions before 1.8 only name.
        static readonly Dictionary<string, (int Bytes, string Type)> s_named = new Dictionary<string, (int, string)>
        {
            { "POSITION_CARTESIAN", (12, "int32") }, { "COLOR_PACKED", (4, "uint8") }, { "RGBA_PACKED", (4, "uint8") },
            { "RGB_PACKED", (3, "uint8") }, { "INTENSITY", (2, "uint16") }, { "CLASSIFICATION", (1, "uint8") },
            { "NORMAL_SPHEREMAPPED", (2, "uint8") }, { "NORMAL_OCT16", (2, "uint8") }, { "NORMAL", (12, "float") },
            { "NORMAL_FLOATS", (12, "float") }, { "RETURN_NUMBER", (1, "uint8") }, { "NUMBER_OF_RETURNS", (1, "uint8") },
            { "SOURCE_ID", (2, "uint16") }, { "GPS_TIME", (8, "double") }, { "INDICES", (4, "uint32") },
            { "SPACING", (4, "float") },
        };

        public SourceInfo Info { get; private set; }
        public BoundsGeo Cube { get; private set; }
        public double Spacing { get; private set; }
        public double Scale { get; private set; }
        public string OctreeFolder { get; private set; }
        public int StepSize { get; private set; }

        // Names and counts, in versions up to 1.4; null if it is in files.
        public List<object> Hierarchy { get; private set; }

        // Of nodes in files of their own: "LAS" or "LAZ"; null for BIN.
        public string NodeFormat { get; private set; }

        // Of BIN nodes in their order; null stands for one with an unknown name, and so unknown length.
        public List<PotreeAttribute> Attributes { get; } = new List<PotreeAttribute>();

        public string UnknownAttribute { get; private set; }

        public static Potree1Index Read(JsonMembers json)
        {
            string version = json.Text("version", "");
            if (!TryMinor(version, out int minor) || minor < 4 || minor > 8)
                throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "version of cloud.js", "1.4 to 1.8",
                    version.Length > 0 ? version : "none");
            var info = new SourceInfo
            {
                Path = json.Path,
                FileBytes = json.FileBytes,
                Format = "Potree",
                Version = version,
                PointsClaimed = (ulong)Math.Max(0, json.Long("points", 0)),
            };
            var box = Box(json.Object("boundingBox"));
            var index = new Potree1Index { Info = info, Cube = PotreeIndexes.Cube(box, json) };
            index.Spacing = PotreeIndexes.Spacing(json, index.Cube);
            index.Scale = PotreeIndexes.UsableScale(json.Number("scale"), json).x;
            info.Transform.Scale = index.Scale;
            info.Transform.Offset = box.Min;
            info.HasBoundsClaimed = true;
            info.BoundsClaimed = json.IsObject("tightBoundingBox") ? Box(json.Object("tightBoundingBox")) : box;
            index.OctreeFolder = json.Text("octreeDir", "data");
            long stepSize = json.Long("hierarchyStepSize", PotreeReader.MaxLevels);
            index.StepSize = (int)Math.Max(1, Math.Min(PotreeReader.MaxLevels, stepSize));
            index.Hierarchy = json.IsList("hierarchy") ? json.List("hierarchy") : null;
            index.ReadAttributes(json);
            PotreeIndexes.ReadProjection(json, info);
            info.Fact("nodes", index.NodeFormat ?? "BIN");
            info.Fact("spacing", NumberText.Of(index.Spacing));
            return index;
        }

        void ReadAttributes(JsonMembers json)
        {
            if (json.IsText("pointAttributes"))
            {
                NodeFormat = json.Text("pointAttributes").ToUpperInvariant();
                if (NodeFormat != "LAS" && NodeFormat != "LAZ")
                    throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "\"pointAttributes\"",
                        "a list, \"LAS\" or \"LAZ\"", NodeFormat);
                return;
            }
            var list = json.List("pointAttributes");
            if (list.Count == 0 || !(list[0] is string))
            {
                foreach (var item in json.Objects("pointAttributes"))
                    Attributes.Add(PotreeIndexes.ReadAttribute(item, "elements", Info));
                return;
            }
            foreach (object item in list)
            {
                string name = JsonReader.OneLine(item as string ?? throw json.Bad("pointAttributes", "names"));
                if (s_named.TryGetValue(name, out var known))
                {
                    Attributes.Add(PotreeAttribute.Make(name, known.Type, known.Bytes, null, null, out _));
                    continue;
                }
                if (UnknownAttribute != null)
                    throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "\"pointAttributes\"",
                        "names that are known, or one at most that is not", UnknownAttribute + " and " + name);
                UnknownAttribute = name;
                Attributes.Add(null);
            }
        }

        static BoundsGeo Box(JsonMembers json) => new BoundsGeo(
            new double3(json.Number("lx"), json.Number("ly"), json.Number("lz")),
            new double3(json.Number("ux"), json.Number("uy"), json.Number("uz")));

        static bool TryMinor(string version, out int minor)
        {
            minor = 0;
            string[] parts = version.Split('.');
            return parts.Length >= 2 && parts[0] == "1"
                && int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out minor);
        }
    }
}
