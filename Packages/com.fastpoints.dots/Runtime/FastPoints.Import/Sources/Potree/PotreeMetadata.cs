using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    abstract class PotreeMetadata
    {
        private protected PotreeMetadata(JsonMembers json, string version, BoundsGeo box)
        {
            if (box.IsEmpty)
                throw PointCloudException.Wanted(FailureCode.BadInput, json.Path, -1, "\"boundingBox\"", "a box",
                    "a maximum below the minimum");
            Info = new SourceInfo
            {
                Path = json.Path,
                FileBytes = json.FileBytes,
                Format = "Potree",
                Version = version,
                PointsClaimed = (ulong)Math.Max(0, json.Long("points", 0)),
                HasBoundsClaimed = true,
            };
            Cube = box;
            // Without one, 1/128 of the cube's edge, as converters use.
            double spacing = json.Number("spacing", 0);
            Spacing = spacing > 0 ? spacing : math.cmax(box.Size) / 128;
        }

        public SourceInfo Info { get; }
        public BoundsGeo Cube { get; }
        public double Spacing { get; }

        private protected static PotreeAttribute ReadAttribute(JsonMembers item, string elementsName, SourceInfo info)
        {
            long bytes = item.Long("size");
            if (bytes < 1 || bytes > PotreeAttribute.MaxElements * 8)
                throw item.Wanted("size", "1 to " + PotreeAttribute.MaxElements * 8 + " bytes");
            long elements = item.Long(elementsName, 1);
            int numbers = (int)Math.Max(1, Math.Min(elements, PotreeAttribute.MaxElements));
            double[] scales = item.IsNumbers("scale", numbers) ? item.Numbers("scale", (int)elements) : null;
            double[] offsets = item.IsNumbers("offset", numbers) ? item.Numbers("offset", (int)elements) : null;
            if (scales != null && Array.IndexOf(scales, 0.0) >= 0)
                scales = null;
            var attribute = PotreeAttribute.Make(item.Text("name"), item.Text("type", ""), (int)bytes, scales, offsets,
                out string anomaly);
            if (anomaly != null)
                info.Warn(-1, anomaly);
            string description = item.Text("description", "");
            if (description.Length > 0)
                info.AddFact("attribute " + attribute.Name, description);
            return attribute;
        }

        // No writer produces zero or negative ones.
        private protected static double3 UsableScale(double3 scale, JsonMembers json) =>
            math.all(scale > 0) ? scale : throw PointCloudException.Wanted(FailureCode.BadInput, json.Path, -1, "\"scale\"",
                "numbers above 0", NumberText.Of(scale));

        // Any kind of text: well-known text, a PROJ string, a code.
        private protected void AddFacts(JsonMembers json)
        {
            Info.AddFact("spacing", NumberText.Of(Spacing));
            string text = json.Text("projection", "").Trim();
            if (text.Length > 0 && !CrsText.Read(text, Info.Crs))
                Info.Crs.Name = text;
        }
    }

    sealed class Potree2Metadata : PotreeMetadata
    {
        Potree2Metadata(JsonMembers json, string encoding, BoundsGeo box) : base(json, json.Text("version", "2"), box)
        {
            Info.Transform.Scale = UsableScale(json.Vector("scale"), json);
            Info.Transform.Offset = json.Vector("offset");
            Info.BoundsClaimed = box;
            IsBrotli = encoding == "BROTLI";
            FirstChunkBytes = json.Object("hierarchy").Long("firstChunkSize");
            Layout = new PotreeLayout(ReadAttributes(json), json.Path);
            Info.Schema = Layout.Schema;
            Info.RecordBytes = IsBrotli ? 0 : Layout.RecordBytes;
            Info.AddFactIfAny("name", json.Text("name", ""));
            Info.AddFactIfAny("description", json.Text("description", ""));
            Info.AddFact("encoding", encoding);
            AddFacts(json);
        }

        public PotreeLayout Layout { get; }
        public long FirstChunkBytes { get; }
        public bool IsBrotli { get; }

        public static Potree2Metadata Read(JsonMembers json)
        {
            string encoding = json.Text("encoding");
            if (encoding != "DEFAULT" && encoding != "BROTLI" && encoding != "UNCOMPRESSED")
                throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "encoding", "DEFAULT or BROTLI",
                    encoding);
            var box = json.Object("boundingBox");
            return new Potree2Metadata(json, encoding, new BoundsGeo(box.Vector("min"), box.Vector("max")));
        }

        List<PotreeAttribute> ReadAttributes(JsonMembers json)
        {
            var attributes = new List<PotreeAttribute>();
            foreach (var item in json.Objects("attributes"))
            {
                var attribute = ReadAttribute(item, "numElements", Info);
                if (attribute.IsPosition && item.IsNumbers("min", 3) && item.IsNumbers("max", 3))
                    TightenBounds(new BoundsGeo(item.Vector("min"), item.Vector("max")), Info);
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

    sealed class Potree1Metadata : PotreeMetadata
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

        public double Scale { get; }
        public string OctreeFolder { get; }
        public int StepSize { get; }

        public List<object> Hierarchy { get; } // Names and counts, in versions up to 1.4; null if it is in files.

        public string NodeFormat { get; private set; } // "LAS" or "LAZ" if each node is a file; null for BIN.

        // Attributes of BIN nodes in order; null for an unknown name, whose length is unknown too.
        public List<PotreeAttribute> Attributes { get; } = new List<PotreeAttribute>();

        public string UnknownAttribute { get; private set; }

        Potree1Metadata(JsonMembers json, string version, BoundsGeo box) : base(json, version, box)
        {
            Scale = UsableScale(json.Number("scale"), json).x;
            Info.Transform.Scale = Scale;
            Info.Transform.Offset = box.Min;
            Info.BoundsClaimed = json.IsObject("tightBoundingBox") ? Box(json.Object("tightBoundingBox")) : box;
            OctreeFolder = json.Text("octreeDir", "data");
            long stepSize = json.Long("hierarchyStepSize", PotreeReader.MaxLevels);
            StepSize = (int)Math.Max(1, Math.Min(PotreeReader.MaxLevels, stepSize));
            Hierarchy = json.IsList("hierarchy") ? json.List("hierarchy") : null;
            ReadAttributes(json);
            Info.AddFact("nodes", NodeFormat ?? "BIN");
            AddFacts(json);
        }

        public static Potree1Metadata Read(JsonMembers json)
        {
            string version = json.Text("version", "");
            if (!TryMinor(version, out int minor) || minor < 4 || minor > 8)
                throw PointCloudException.Wanted(FailureCode.Unsupported, json.Path, -1, "version of cloud.js", "1.4 to 1.8",
                    version.Length > 0 ? version : "none");
            return new Potree1Metadata(json, version, Box(json.Object("boundingBox")));
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
                    Attributes.Add(ReadAttribute(item, "elements", Info));
                return;
            }
            foreach (object item in list)
            {
                string name = JsonReader.OneLine(item as string ?? throw json.Wanted("pointAttributes", "names"));
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
