using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Store
{
    /// <summary>What cloud.json says: everything that is true of the cloud as a whole. Text in, text out, no I/O.</summary>
    public sealed class CloudManifest
    {
        const string FormatName = "fastpoints";

        /// <summary>One file that the cloud was made from.</summary>
        public struct Source
        {
            /// <summary>The file's name, without its folder.</summary>
            public string Name;
            public long FileBytes;
            public long Points;
        }

        /// <summary>Smallest and largest value of an attribute, scaled as <see cref="PointAttribute"/> says.</summary>
        public struct Range
        {
            public double Min;
            public double Max;
        }

        /// <summary>One cloud's files carry one id: files of two builds never mix unseen.</summary>
        public ulong CloudId;

        /// <summary>Rises by one each time the file is replaced.</summary>
        public long Generation = 1;

        /// <summary>The cloud is in the making: what is told here is of the chunks that are finished.</summary>
        public bool IsBuilding;

        public long Points;

        /// <summary>Points of the sources without a finite position on the grid.</summary>
        public long PointsLeftOut;

        /// <summary>Sum of all records' hashes, modulo 2^64: see RecordHash.</summary>
        public ulong Checksum;

        public CloudGrid Grid;
        public GridCube Root;

        /// <summary>Grid bounds of the points, both ends included. Meaningless for a cloud without points.</summary>
        public Grid3 BoundsMin;
        public Grid3 BoundsMax;

        /// <summary>All attributes but the position.</summary>
        public PointSchema Attributes;

        /// <summary>By attribute: see <see cref="StoredColumn.Divisor"/>.</summary>
        public int[] Divisors;

        /// <summary>By attribute.</summary>
        public Range[] Ranges;

        /// <summary>Null where nobody has looked: of clouds in the making, and of those that were converted before there were
        /// such.</summary>
        internal ShownRanges? Shown;

        public int NodeCount;
        public int ChunkCount;
        public string Sampler = "random";

        /// <summary>Planes with averages follow the others: see <see cref="StoreLayout"/>.</summary>
        public bool HasAverages => Sampler == "average";

        /// <summary>For people: the coordinate system's one-line summary, its well-known text and codes, where known.</summary>
        public string CrsName;
        public string CrsWkt;
        public int CrsEpsg;
        public int CrsVerticalEpsg;

        /// <summary>Metres of a horizontal unit; 0 where unknown, NaN where it is an angle.</summary>
        public double MetresPerUnit;

        public CloudCrs Crs => new CloudCrs
        {
            Name = CrsName,
            Wkt = CrsWkt,
            Epsg = CrsEpsg,
            VerticalEpsg = CrsVerticalEpsg,
            MetresPerUnit = MetresPerUnit,
        };

        public readonly List<Source> Sources = new List<Source>();

        /// <summary>Sizes of the two files beside the chunks, and the hash of all of hierarchy.bin.</summary>
        public long HierarchyBytes;
        public ulong HierarchyHash;
        public long UpperBytes;

        /// <summary>Names of the two files: a generation of a cloud in the making has its own, so that none changes under a
        /// reader.</summary>
        public string HierarchyName => IsBuilding ? StoreFormat.GenerationName(StoreFormat.HierarchyName, Generation)
            : StoreFormat.HierarchyName;
        public string UpperName => IsBuilding ? StoreFormat.GenerationName(StoreFormat.UpperName, Generation)
            : StoreFormat.UpperName;

        public BoundsGeo BoundsGeo => Points == 0 ? BoundsGeo.Empty : new BoundsGeo(Grid.ToGeo(BoundsMin), Grid.ToGeo(BoundsMax));

        public StoreLayout CreateLayout() => new StoreLayout(Attributes, Divisors, HasAverages);

        public string ToJson()
        {
            var json = new JsonWriter().BeginObject().Add("format", FormatName).Add("version", StoreFormat.Version)
                .AddHex("id", CloudId).Add("generation", Generation).Add("building", IsBuilding)
                .Add("points", Points).Add("pointsLeftOut", PointsLeftOut).AddHex("checksum", Checksum)
                .Add("nodes", NodeCount).Add("chunks", ChunkCount);

            json.BeginObject("grid").Add("origin", Grid.Origin.x, Grid.Origin.y, Grid.Origin.z)
                .Add("step", Grid.Step.x, Grid.Step.y, Grid.Step.z).EndObject();
            json.BeginObject("root").Add("corner", Root.Corner.X, Root.Corner.Y, Root.Corner.Z)
                .Add("sideLog2", Root.SideLog2).EndObject();
            json.BeginObject("boundsGrid").Add("min", BoundsMin.X, BoundsMin.Y, BoundsMin.Z)
                .Add("max", BoundsMax.X, BoundsMax.Y, BoundsMax.Z).EndObject();
            var geo = BoundsGeo;
            json.BeginObject("bounds").Add("min", geo.Min.x, geo.Min.y, geo.Min.z).Add("max", geo.Max.x, geo.Max.y, geo.Max.z)
                .EndObject();

            json.BeginArray("attributes");
            for (int i = 0; i < Attributes.Count; i++)
            {
                json.BeginObject().Add("name", Attributes[i].Name).Add("type", Attributes[i].Type.ToString())
                    .Add("scale", Attributes[i].Scale).Add("offset", Attributes[i].Offset).Add("divisor", Divisors[i])
                    .Add("min", Ranges[i].Min).Add("max", Ranges[i].Max).EndObject();
            }
            json.EndArray();

            if (Shown is ShownRanges shown)
            {
                var of = shown.BoundsGeo;
                json.BeginObject("shown").Add("min", of.Min.x, of.Min.y, of.Min.z).Add("max", of.Max.x, of.Max.y, of.Max.z)
                    .Add("elevationMin", shown.Elevation.Min).Add("elevationMax", shown.Elevation.Max)
                    .Add("intensityMin", shown.Intensity.Min).Add("intensityMax", shown.Intensity.Max)
                    .Add("color", shown.HasColor).EndObject();
            }
            json.BeginObject("crs").Add("name", CrsName).Add("epsg", CrsEpsg).Add("verticalEpsg", CrsVerticalEpsg)
                .Add("metresPerUnit", MetresPerUnit).Add("wkt", CrsWkt).EndObject();
            json.BeginObject("settings").Add("sampler", Sampler).EndObject();
            json.BeginArray("sources");
            foreach (var source in Sources)
                json.BeginObject().Add("name", source.Name).Add("bytes", source.FileBytes).Add("points",
                    source.Points).EndObject();
            json.EndArray();
            json.BeginObject("files").Add("hierarchyBytes", HierarchyBytes).AddHex("hierarchyHash", HierarchyHash)
                .Add("upperBytes", UpperBytes).EndObject();
            return json.EndObject().ToString();
        }

        /// <exception cref="PointCloudException">It is no cloud's JSON, or a member is missing or senseless: it names
        /// it.</exception>
        public static CloudManifest FromJson(string text, string path)
        {
            var members = new Members();
            try
            {
                return Read((Dictionary<string, object>)JsonReader.Parse(text), members);
            }
            catch (Exception e) when (e is FormatException || e is InvalidCastException || e is KeyNotFoundException ||
                e is OverflowException)
            {
                throw new PointCloudException(FailureCode.BadInput, path, -1,
                    (members.Last.Length > 0 ? "\"" + members.Last + "\": " : "") + (e is FormatException ? e.Message
                        : "missing or of the wrong kind"), e);
            }
            catch (NotSupportedException e)
            {
                throw new PointCloudException(FailureCode.Unsupported, path, -1, e.Message, e);
            }
        }

        /// <summary>Looks up members, and remembers the last one: that is at fault where reading fails.</summary>
        sealed class Members
        {
            public string Last = "";

            public object Get(Dictionary<string, object> of, string name)
            {
                Last = name;
                return of[name];
            }

            public Dictionary<string, object> Object(Dictionary<string, object> of, string name) =>
                (Dictionary<string, object>)Get(of, name);
        }

        static CloudManifest Read(Dictionary<string, object> json, Members members)
        {
            if (!"fastpoints".Equals(members.Get(json, "format")))
                throw new FormatException("wanted \"" + FormatName + "\"");
            long version = JsonReader.ToLong(members.Get(json, "version"));
            if (version != StoreFormat.Version)
            {
                throw new NotSupportedException(string.Format(CultureInfo.InvariantCulture,
                    "cloud format version: wanted {0}, got {1}", StoreFormat.Version, version));
            }

            var result = new CloudManifest
            {
                CloudId = JsonReader.ToHex(members.Get(json, "id")),
                Generation = JsonReader.ToLong(members.Get(json, "generation")),
                IsBuilding = json.TryGetValue("building", out object building) && true.Equals(building),
                Points = Count(members.Get(json, "points")),
                PointsLeftOut = Count(members.Get(json, "pointsLeftOut")),
                Checksum = JsonReader.ToHex(members.Get(json, "checksum")),
                NodeCount = checked((int)Count(members.Get(json, "nodes"))),
                ChunkCount = checked((int)Count(members.Get(json, "chunks"))),
            };
            result.ReadPlace(json, members);
            result.ReadAttributes((List<object>)members.Get(json, "attributes"), members);
            if (json.TryGetValue("shown", out object shown))
                result.Shown = ReadShown((Dictionary<string, object>)shown, members);
            result.ReadOrigin(json, members);
            var files = members.Object(json, "files");
            result.HierarchyBytes = Count(members.Get(files, "hierarchyBytes"));
            result.HierarchyHash = JsonReader.ToHex(members.Get(files, "hierarchyHash"));
            result.UpperBytes = Count(members.Get(files, "upperBytes"));
            return result;
        }

        void ReadPlace(Dictionary<string, object> json, Members members)
        {
            var grid = members.Object(json, "grid");
            Grid.Origin = Double3(members.Get(grid, "origin"));
            Grid.Step = Double3(members.Get(grid, "step"));
            if (!math.all(Grid.Step > 0) || !math.all(math.isfinite(Grid.Step)) || !math.all(math.isfinite(Grid.Origin)))
                throw new FormatException("wanted finite origins and positive steps");
            var root = members.Object(json, "root");
            Root.Corner = Place(members.Get(root, "corner"));
            long side = Count(members.Get(root, "sideLog2"));
            if (side > GridCube.MaxSideLog2)
                throw new FormatException("wanted at most " + GridCube.MaxSideLog2 + ", got " + side);
            Root.SideLog2 = (int)side;
            var bounds = members.Object(json, "boundsGrid");
            BoundsMin = Place(members.Get(bounds, "min"));
            BoundsMax = Place(members.Get(bounds, "max"));
        }

        void ReadAttributes(List<object> attributes, Members members)
        {
            var schema = new List<PointAttribute>();
            Divisors = new int[attributes.Count];
            Ranges = new Range[attributes.Count];
            for (int i = 0; i < attributes.Count; i++)
            {
                var attribute = (Dictionary<string, object>)attributes[i];
                string name = (string)members.Get(attribute, "name");
                string typeName = (string)members.Get(attribute, "type");
                if (!Enum.TryParse(typeName, false, out AttributeType type) || type.ToString() != typeName)
                    throw new FormatException("no such type: \"" + typeName + "\"");
                schema.Add(new PointAttribute(name, type, JsonReader.ToDouble(members.Get(attribute, "scale")),
                    JsonReader.ToDouble(members.Get(attribute, "offset"))));
                long divisor = JsonReader.ToLong(members.Get(attribute, "divisor"));
                if (divisor < 1 || divisor > ushort.MaxValue || (divisor > 1 && type != AttributeType.UInt16))
                    throw new FormatException("wanted 1, or up to 65535 for UInt16, got " + divisor);
                Divisors[i] = (int)divisor;
                Ranges[i].Min = DoubleOrNaN(members.Get(attribute, "min"));
                Ranges[i].Max = DoubleOrNaN(members.Get(attribute, "max"));
            }
            Attributes = new PointSchema(schema);
        }

        static ShownRanges ReadShown(Dictionary<string, object> shown, Members members) => new ShownRanges
        {
            BoundsGeo = new BoundsGeo(Double3(members.Get(shown, "min")), Double3(members.Get(shown, "max"))),
            Elevation = new Range
            {
                Min = JsonReader.ToDouble(members.Get(shown, "elevationMin")),
                Max = JsonReader.ToDouble(members.Get(shown, "elevationMax")),
            },
            Intensity = new Range
            {
                Min = JsonReader.ToDouble(members.Get(shown, "intensityMin")),
                Max = JsonReader.ToDouble(members.Get(shown, "intensityMax")),
            },
            HasColor = (bool)members.Get(shown, "color"),
        };

        void ReadOrigin(Dictionary<string, object> json, Members members)
        {
            var crs = members.Object(json, "crs");
            CrsName = (string)members.Get(crs, "name");
            CrsWkt = (string)members.Get(crs, "wkt");
            CrsEpsg = checked((int)JsonReader.ToLong(members.Get(crs, "epsg")));
            CrsVerticalEpsg = checked((int)JsonReader.ToLong(members.Get(crs, "verticalEpsg")));
            MetresPerUnit = DoubleOrNaN(members.Get(crs, "metresPerUnit"));
            Sampler = (string)members.Get(members.Object(json, "settings"), "sampler");
            foreach (object item in (List<object>)members.Get(json, "sources"))
            {
                var source = (Dictionary<string, object>)item;
                Sources.Add(new Source
                {
                    Name = (string)members.Get(source, "name"),
                    FileBytes = Count(members.Get(source, "bytes")),
                    Points = Count(members.Get(source, "points")),
                });
            }
        }

        static long Count(object value)
        {
            long count = JsonReader.ToLong(value);
            return count >= 0 ? count : throw new FormatException("wanted at least 0, got " + count);
        }

        static double DoubleOrNaN(object value) => value == null ? double.NaN : JsonReader.ToDouble(value);

        static List<object> Three(object value) =>
            value is List<object> list && list.Count == 3 ? list : throw new FormatException("wanted three numbers");

        static double3 Double3(object value)
        {
            var three = Three(value);
            return new double3(JsonReader.ToDouble(three[0]), JsonReader.ToDouble(three[1]), JsonReader.ToDouble(three[2]));
        }

        static Grid3 Place(object value)
        {
            var three = Three(value);
            var place = new Grid3(JsonReader.ToLong(three[0]), JsonReader.ToLong(three[1]), JsonReader.ToLong(three[2]));
            const long limit = 1L << GridCube.MaxSideLog2;
            if (place != Grid3.Max(Grid3.Min(place, new Grid3(limit, limit, limit)), new Grid3(-limit, -limit, -limit)))
                throw new FormatException("wanted numbers within 2^" + GridCube.MaxSideLog2);
            return place;
        }
    }

    /// <summary>Where nearly all points of a cloud and their values are, strays apart: what displays frame and colour by. From a
    /// sample of the octree's upper levels.</summary>
    internal struct ShownRanges
    {
        /// <summary>Georeferenced.</summary>
        public BoundsGeo BoundsGeo;

        /// <summary>Along Z, in CRS units.</summary>
        public CloudManifest.Range Elevation;

        /// <summary>Stored values; both 0 where there is no intensity.</summary>
        public CloudManifest.Range Intensity;

        /// <summary>Whether there is colour, and more than strays have it.</summary>
        public bool HasColor;
    }
}
