using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Store
{
    /// <summary>The contents of cloud.json. Parses and writes text, without I/O.</summary>
    public sealed class CloudManifest
    {
        const string FormatName = "fastpoints";

        /// <summary>Smallest and largest value of an attribute, scaled as <see cref="PointAttribute"/> says.</summary>
        public struct ValueRange
        {
            public double Min;
            public double Max;
        }

        /// <summary>In every file of the cloud, so that files of two builds are not mixed unnoticed.</summary>
        public ulong CloudId;

        /// <summary>Rises by one each time the file is replaced.</summary>
        public long Generation = 1;

        /// <summary>The cloud is unfinished: the values cover finished chunks only.</summary>
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
        public ValueRange[] Ranges;
        internal StoredDisplayRanges? DisplayRanges; // Null in unfinished clouds, and in those of older versions.

        public long NodeCount;
        public long ChunkCount;
        public string Sampler = "random";

        /// <summary>Planes with averages follow the others: see <see cref="StoreLayout"/>.</summary>
        public bool HasAverages => Sampler == "average";

        // The layer of computed normals, 0 for none, and which way they point: see NormalOrientation.
        internal ushort NormalLayer;
        internal string NormalOrientation;

        /// <summary>For people: the coordinate system's one-line summary, its well-known text and codes, where known.</summary>
        public string CrsName;
        public string CrsWkt;
        public int CrsEpsg;
        public int CrsVerticalEpsg;

        /// <summary>Metres of a horizontal unit; 0 where unknown, NaN for degrees.</summary>
        public double MetresPerUnit;

        /// <summary>Metres of a vertical unit; 0 if nothing says it.</summary>
        public double VerticalMetresPerUnit;
        internal byte[][] CrsGeoKeys; // GeoTIFF keys as LAS has them: directory, doubles, text; null without keys.

        internal GpsTime GpsTime;
        internal double3[] Scanners; // Where the scans were made, by PointSourceId from 1, or the only one; null where unknown.

        public CloudCrs Crs
        {
            get => new CloudCrs
            {
                Name = CrsName,
                Wkt = CrsWkt,
                Epsg = CrsEpsg,
                VerticalEpsg = CrsVerticalEpsg,
                MetresPerUnit = MetresPerUnit,
                VerticalMetresPerUnit = VerticalMetresPerUnit,
                GeoKeys = CrsGeoKeys,
            };
            internal set => (CrsName, CrsWkt, CrsEpsg, CrsVerticalEpsg, MetresPerUnit, VerticalMetresPerUnit, CrsGeoKeys) =
                (value.Name, value.Wkt, value.Epsg, value.VerticalEpsg, value.MetresPerUnit, value.VerticalMetresPerUnit,
                    value.GeoKeys);
        }

        /// <summary>Sizes and place of the hierarchy: of its file, and of the page that all others are below.</summary>
        public long HierarchyFileBytes;
        public long RootOffset;
        public int RootBytes;

        /// <summary>Covers all that the cloud consists of: pages have the hashes of what is below them.</summary>
        public ulong RootHash;

        /// <summary>Planes and pages are one file, for hosts that limit the number of objects.</summary>
        public bool IsSingleFile;

        /// <summary>A generation of an unfinished cloud, or of one with computed planes, has its own, so that none changes under
        /// a reader.</summary>
        public string HierarchyName => IsSingleFile ? StoreFormat.SingleFileName
            : IsBuilding || NormalLayer > 0 ? StoreFormat.GenerationName(StoreFormat.HierarchyName, Generation)
            : StoreFormat.HierarchyName;

        internal CloudLocalSpace LocalSpace => new CloudLocalSpace
        {
            CloudId = CloudId,
            Corner = Root.Corner,
            Step = Grid.Step,
            RootSideLog2 = Root.SideLog2,
            BoundsMin = BoundsMin,
            BoundsMax = BoundsMax,
        };

        internal PageLink RootPage => new PageLink
        {
            Corner = Root.Corner,
            SideLog2 = Root.SideLog2,
            AttachNode = -1,
            SubtreePointCount = Points,
            SubtreeNodeCount = NodeCount,
            OffsetBytes = RootOffset,
            LengthBytes = RootBytes,
            Container = -1,
            Hash = RootHash,
        };

        public BoundsGeo BoundsGeo => Points == 0 ? BoundsGeo.Empty : new BoundsGeo(Grid.ToGeo(BoundsMin), Grid.ToGeo(BoundsMax));

        internal CloudManifest Clone() => (CloudManifest)MemberwiseClone();

        public StoreLayout CreateLayout() =>
            new StoreLayout(Attributes, Divisors, HasAverages, NormalLayer > 0);

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

            if (DisplayRanges is StoredDisplayRanges shown)
            {
                var of = shown.BoundsGeo;
                json.BeginObject("shown").Add("min", of.Min.x, of.Min.y, of.Min.z).Add("max", of.Max.x, of.Max.y, of.Max.z)
                    .Add("elevationMin", shown.Elevation.Min).Add("elevationMax", shown.Elevation.Max)
                    .Add("intensityMin", shown.Intensity.Min).Add("intensityMax", shown.Intensity.Max)
                    .Add("color", shown.HasColor).Add("classes", shown.HasMeaningfulClasses).EndObject();
            }
            json.BeginArray("planes");
            foreach (var plane in CreateLayout().Planes)
            {
                json.BeginObject().Add("name", plane.Name).Add("kind", KindOf(plane));
                if (plane.IsComputed)
                    json.Add("layer", NormalLayer).Add("orientation", NormalOrientation);
                json.EndObject();
            }
            json.EndArray();
            Write(json.BeginObject("crs"), Crs);
            if (GpsTime.Kind != GpsTimeKind.Unknown)
                json.BeginObject("gpsTime").Add("kind", GpsTime.Kind.ToString()).Add("offsetMegaseconds",
                    GpsTime.OffsetMegaseconds).EndObject();
            if (Scanners != null)
            {
                json.BeginArray("scanners");
                foreach (var at in Scanners)
                    json.BeginObject().Add("at", at.x, at.y, at.z).EndObject();
                json.EndArray();
            }
            json.BeginObject("settings").Add("sampler", Sampler).EndObject();
            json.BeginObject("hierarchy").Add("whole", IsSingleFile).Add("bytes", HierarchyFileBytes)
                .Add("rootOffset", RootOffset).Add("rootBytes", RootBytes).AddHex("rootHash", RootHash).EndObject();
            return json.EndObject().ToString();
        }

        internal static void Write(JsonWriter json, CloudCrs crs)
        {
            json.Add("name", crs.Name).Add("epsg", crs.Epsg).Add("verticalEpsg", crs.VerticalEpsg)
                .Add("metresPerUnit", crs.MetresPerUnit).Add("wkt", crs.Wkt);
            if (crs.VerticalMetresPerUnit != 0)
                json.Add("verticalMetresPerUnit", crs.VerticalMetresPerUnit);
            if (crs.GeoKeys != null)
                json.Add("geoKeys", Convert.ToBase64String(crs.GeoKeys[0]))
                    .Add("geoDoubles", Convert.ToBase64String(crs.GeoKeys[1]))
                    .Add("geoText", Convert.ToBase64String(crs.GeoKeys[2]));
            json.EndObject();
        }

        internal static CloudCrs ReadCrs(JsonMembers crs) => new CloudCrs
        {
            Name = crs.TextOrNull("name"),
            Wkt = crs.TextOrNull("wkt"),
            Epsg = crs.Int("epsg"),
            VerticalEpsg = crs.Int("verticalEpsg"),
            MetresPerUnit = crs.NumberOrNaN("metresPerUnit"),
            VerticalMetresPerUnit = crs.Has("verticalMetresPerUnit") ? crs.NumberOrNaN("verticalMetresPerUnit") : 0,
            GeoKeys = !crs.Has("geoKeys") ? null
                : new[] { Base64(crs, "geoKeys"), Base64(crs, "geoDoubles"), Base64(crs, "geoText") },
        };

        /// <summary>Throws a <see cref="PointCloudException"/> that names the missing or invalid member.</summary>
        public static CloudManifest FromJson(string text, string path)
        {
            var json = JsonMembers.Parse(text, path);
            if (json.Text("format") != FormatName)
                throw json.Wanted("format", "\"" + FormatName + "\"");
            if (json.Long("version") == StoreFormat.UpgradableVersion)
                throw new PointCloudException(FailureCode.Unsupported, path, -1, "is of version " +
                    StoreFormat.UpgradableVersion + ": fastpoints upgrade " +
                    SourcePath.WithoutQuery(SourcePath.FolderOf(path)) + " makes version " + StoreFormat.Version + " of it");
            json.RequireVersion(StoreFormat.Version);
            var hierarchy = json.Object("hierarchy");
            var result = new CloudManifest
            {
                CloudId = json.Hex("id"),
                Generation = json.Long("generation"),
                IsBuilding = json.Flag("building"),
                Points = json.NonNegative("points"),
                PointsLeftOut = json.NonNegative("pointsLeftOut"),
                Checksum = json.Hex("checksum"),
                NodeCount = json.NonNegative("nodes"),
                ChunkCount = json.NonNegative("chunks"),
                IsSingleFile = hierarchy.Flag("whole"),
                HierarchyFileBytes = hierarchy.NonNegative("bytes"),
                RootOffset = hierarchy.NonNegative("rootOffset"),
                RootBytes = (int)hierarchy.NonNegative("rootBytes", StoreFormat.MaxPageBytesToRead),
                RootHash = hierarchy.Hex("rootHash"),
            };
            result.ReadGridAndBounds(json);
            result.ReadAttributes(json.Objects("attributes"));
            if (json.Has("shown"))
                result.DisplayRanges = ReadDisplayRanges(json.Object("shown"));
            result.ReadProvenance(json);
            if (json.Has("planes"))
                result.CheckPlanes(json);
            return result;
        }

        // What is wrong with the place of the hierarchy, or null. What is read of it is bounded by the size of its file, which is
        // known once the root's page was read.
        internal string FindProblem()
        {
            if (RootOffset < FileHeader.SizeBytes || RootOffset != HierarchyFileBytes - RootBytes)
                return "\"rootOffset\": wanted that the root's page ends " + HierarchyName + ", got " + RootOffset;
            long bytesPerNode = NodeRecord.SizeBytes + (long)CreateLayout().Planes.Count * PackedRange.SizeBytes;
            return NodeCount <= HierarchyFileBytes / bytesPerNode ? null
                : "\"nodes\": wanted at most " + HierarchyFileBytes / bytesPerNode + ", got " + NodeCount;
        }

        void ReadGridAndBounds(JsonMembers json)
        {
            var grid = json.Object("grid");
            Grid = new CloudGrid { Origin = grid.Vector("origin"), Step = grid.Vector("step") };
            if (!math.all(Grid.Step > 0))
                throw grid.Wanted("step", "positive steps");
            var root = json.Object("root");
            Root = new GridCube(ReadGrid3(root, "corner"), (int)root.NonNegative("sideLog2", GridCube.MaxSideLog2));
            var bounds = json.Object("boundsGrid");
            BoundsMin = ReadGrid3(bounds, "min");
            BoundsMax = ReadGrid3(bounds, "max");
        }

        void ReadAttributes(List<JsonMembers> attributes)
        {
            var schema = new List<PointAttribute>();
            Divisors = new int[attributes.Count];
            Ranges = new ValueRange[attributes.Count];
            for (int i = 0; i < attributes.Count; i++)
            {
                var attribute = attributes[i];
                string typeName = attribute.Text("type");
                if (!Enum.TryParse(typeName, false, out AttributeType type) || type.ToString() != typeName)
                    throw attribute.Wanted("type", "a type of attribute");
                schema.Add(new PointAttribute(attribute.Text("name"), type, attribute.Number("scale"),
                    attribute.Number("offset")));
                long divisor = attribute.Long("divisor");
                if (divisor < 1 || divisor > ushort.MaxValue || (divisor > 1 && type != AttributeType.UInt16))
                    throw attribute.Wanted("divisor", "1, or up to 65535 for UInt16");
                Divisors[i] = (int)divisor;
                Ranges[i] = new ValueRange { Min = attribute.NumberOrNaN("min"), Max = attribute.NumberOrNaN("max") };
            }
            Attributes = new PointSchema(schema);
        }

        static string KindOf(StoreLayout.Plane plane) => plane.IsComputed ? StoreLayout.NormalName
            : plane.AverageOf < 0 ? "source" : "average";

        // Kinds that are computed later come behind these.
        void CheckPlanes(JsonMembers json)
        {
            var planes = json.Objects("planes");
            if (planes.Count > 0 && planes[planes.Count - 1] is var last && last.Text("kind") == StoreLayout.NormalName)
            {
                NormalLayer = (ushort)last.NonNegative("layer", ushort.MaxValue);
                NormalOrientation = last.Text("orientation");
                if (NormalLayer == 0)
                    throw last.Wanted("layer", "1 or more");
            }
            var known = CreateLayout().Planes;
            for (int p = 0; p < Math.Max(known.Count, planes.Count); p++)
            {
                string got = p < planes.Count ? planes[p].Text("kind") + " " + planes[p].Text("name") : "none";
                string wanted = p < known.Count ? KindOf(known[p]) + " " + known[p].Name : "none";
                if (got != wanted)
                    throw json.Failure("planes", "wanted plane " + p + " to be " + wanted + ", got " + got);
            }
        }

        static StoredDisplayRanges ReadDisplayRanges(JsonMembers shown) => new StoredDisplayRanges
        {
            BoundsGeo = new BoundsGeo(shown.Vector("min"), shown.Vector("max")),
            Elevation = new ValueRange { Min = shown.Number("elevationMin"), Max = shown.Number("elevationMax") },
            Intensity = new ValueRange { Min = shown.Number("intensityMin"), Max = shown.Number("intensityMax") },
            HasColor = shown.Flag("color"),
            HasMeaningfulClasses = shown.Has("classes") && shown.Flag("classes"),
        };

        void ReadProvenance(JsonMembers json)
        {
            Crs = ReadCrs(json.Object("crs"));
            if (json.ObjectOrNull("gpsTime") is JsonMembers time)
            {
                if (!Enum.TryParse(time.Text("kind"), out GpsTimeKind kind))
                    throw time.Wanted("kind", "a kind of GPS time");
                GpsTime = new GpsTime(kind, (int)time.NonNegative("offsetMegaseconds", ushort.MaxValue));
            }
            if (json.Has("scanners"))
                Scanners = json.Objects("scanners").ConvertAll(scan => scan.Vector("at")).ToArray();
            Sampler = json.Object("settings").Text("sampler");
        }

        static byte[] Base64(JsonMembers json, string name)
        {
            try
            {
                return Convert.FromBase64String(json.Text(name));
            }
            catch (FormatException)
            {
                throw json.Wanted(name, "bytes in base 64");
            }
        }

        static Grid3 ReadGrid3(JsonMembers json, string name)
        {
            long[] steps = json.Longs(name, 3);
            var position = new Grid3(steps[0], steps[1], steps[2]);
            const long limit = 1L << GridCube.MaxSideLog2;
            if (position != Grid3.Max(Grid3.Min(position, new Grid3(limit, limit, limit)), new Grid3(-limit, -limit, -limit)))
                throw json.Wanted(name, "numbers within 2^" + GridCube.MaxSideLog2);
            return position;
        }
    }

    // Where nearly all points and their values are, outliers apart: what displays frame and colour by. From a sample of the
    // octree's upper levels.
    internal struct StoredDisplayRanges
    {
        public BoundsGeo BoundsGeo;
        public CloudManifest.ValueRange Elevation; // Along Z, in CRS units.
        public CloudManifest.ValueRange Intensity; // Stored values; both 0 if there is no intensity.
        public bool HasColor; // More than outliers have it.
        public bool HasMeaningfulClasses; // Several, and most points are of one that means something.
    }

    internal struct SourceEntry
    {
        // Without its folder.
        public string Name;
        public long FileBytes;
        public long Points;
        public ulong HeadHash; // See SourceInfo.

        // The file's own coordinate system, where files of several make one cloud; null if it is the cloud's.
        public CloudCrs Crs;
    }

    // The contents of sources.json: a country has a million of them, and whoever shows it needs none.
    internal static class StoredSources
    {
        public const int MaxSystems = 64; // Sources with more coordinate systems than this share the last one.
        const int MaxTextBytes = 512 << 20; // A million sources take about 100 MB.
        const int SourcesOfPart = 1000;

        public static string ToJson(IEnumerable<SourceEntry> sources) => string.Concat(ToParts(sources));

        // The text in parts: that of a million sources is held nowhere as a whole. Goes through the sources twice.
        public static IEnumerable<string> ToParts(IEnumerable<SourceEntry> sources)
        {
            var json = new JsonWriter().BeginObject().Add("version", StoreFormat.Version);
            var systems = new List<CloudCrs>();
            int Find(CloudCrs crs) => systems.FindIndex(s => s == crs || s != null && s.IsSameEntryAs(crs));
            foreach (var source in sources)
                if (systems.Count <= MaxSystems && Find(source.Crs) < 0)
                    systems.Add(source.Crs);
            if (systems.Count > 1)
            {
                json.BeginArray("systems");
                foreach (var system in systems)
                    CloudManifest.Write(json.BeginObject(), system ?? new CloudCrs());
                json.EndArray();
            }
            json.BeginArray("sources");
            int written = 0;
            foreach (var source in sources)
            {
                json.BeginObject().Add("name", source.Name).Add("bytes", source.FileBytes).Add("points", source.Points);
                if (source.HeadHash != 0)
                    json.AddHex("head", source.HeadHash);
                if (systems.Count > 1)
                    json.Add("system", Find(source.Crs) is var system && system >= 0 ? system : systems.Count - 1);
                json.EndObject();
                if (++written % SourcesOfPart == 0)
                    yield return json.Take();
            }
            yield return json.EndArray().EndObject().ToString();
        }

        /// <exception cref="PointCloudException">The file is damaged.</exception>
        public static List<SourceEntry> Read(string folder)
        {
            string path = SourcePath.Combine(folder, StoreFormat.SourcesName);
            return StoreFile.TryReadText(path, out string text, MaxTextBytes) ? FromJson(text, path) : new List<SourceEntry>();
        }

        public static List<SourceEntry> FromJson(string text, string path)
        {
            var json = JsonMembers.Parse(text, path);
            json.RequireVersion(StoreFormat.Version);
            var systems = json.Has("systems") ? json.Objects("systems").ConvertAll(CloudManifest.ReadCrs) : null;
            return json.Objects("sources").ConvertAll(source => new SourceEntry
            {
                Name = source.Text("name"),
                FileBytes = source.NonNegative("bytes"),
                Points = source.NonNegative("points"),
                HeadHash = source.Has("head") ? source.Hex("head") : 0,
                Crs = systems?[(int)source.NonNegative("system", systems.Count - 1)],
            });
        }
    }
}
