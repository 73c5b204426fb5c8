using System.Collections.Generic;
using System.Globalization;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Build
{
    internal static class CloudDescription
    {
        public static CloudManifest OfBuild(BuildContext build, BuildJournal journal, ScatterPoints scatter)
        {
            var found = scatter.Statistics;
            var manifest = new CloudManifest { Sampler = build.SamplerName, Root = journal.Root };
            Warn(build.Readers, journal.Statistics, build.Grid.Grid);
            Describe(found, scatter.Attributes, build, manifest);
            manifest.CloudId = build.CloudId;
            return manifest;
        }

        public static CloudManifest OfSample(BuildContext build, PlaceholderSample sample)
        {
            var found = sample.Statistics;
            var cube = build.Map.Cube;
            long last = cube.Side - 1;
            // What lies outside the first cube is not in the sample's tops.
            found.Min = Grid3.Max(found.Min, cube.Corner);
            found.Max = Grid3.Min(found.Max, cube.Corner + new Grid3(last, last, last));
            var manifest = new CloudManifest { Sampler = build.SamplerName, Root = cube };
            Describe(found, sample.StatisticsOfAttributes, build, manifest);
            manifest.PointsLeftOut = 0;
            manifest.CloudId = found.Checksum;
            return manifest;
        }

        /// <exception cref="PointCloudException">Their coordinates or values have different meanings, so that they
        /// cannot be one cloud.</exception>
        public static void Check(IReadOnlyList<PointReader> readers)
        {
            foreach (var reader in readers)
                reader.Info.ThrowIfInConflict();
            MeaningOf(readers).ThrowIfInConflict();
        }

        static SourceInfo MeaningOf(IReadOnlyList<PointReader> readers)
        {
            var all = new SourceInfo { Path = readers[0].Info.Path };
            var summary = new TileSummary(all);
            foreach (var reader in readers)
                summary.IncludeMeaning(reader.Info);
            return all;
        }

        public static List<string> PathsOf(IReadOnlyList<PointReader> readers)
        {
            var paths = new List<string>();
            foreach (var reader in readers)
                if (reader.Unfiltered is TiledReader tiles)
                    paths.AddRange(tiles.Paths);
                else
                    paths.Add(reader.Info.Path);
            return paths;
        }

        /// <summary>One entry a file, tiles of a reader apart, by what is known before it is read.</summary>
        public static IEnumerable<SourceEntry> SourcesOf(PointReader reader)
        {
            var info = reader.Info;
            var tiles = reader.Unfiltered as TiledReader;
            for (int t = 0; t < (tiles?.TileCount ?? 1); t++)
            {
                var source = tiles != null ? tiles.TileEntryOf(t) : new SourceEntry
                {
                    Name = info.Path,
                    FileBytes = info.FileBytes,
                    HeadHash = info.HeadHash,
                    Points = reader.PointCount,
                    Crs = info.Crs.ToCloudCrs(),
                };
                source.Name = SourcePath.NameOf(source.Name);
                yield return source;
            }
        }

        /// <summary>The same with the points that were found.</summary>
        public static List<SourceEntry> SourcesOf(IReadOnlyList<PointReader> readers, IReadOnlyList<PointStatistics> statistics)
        {
            var sources = new List<SourceEntry>();
            for (int i = 0; i < readers.Count; i++)
            {
                foreach (var known in SourcesOf(readers[i]))
                {
                    var source = known;
                    if (!(readers[i].Unfiltered is TiledReader))
                        source.Points = statistics[i].Count + statistics[i].LeftOut;
                    sources.Add(source);
                }
            }
            return sources;
        }

        static void Warn(IReadOnlyList<PointReader> readers, IReadOnlyList<PointStatistics> statistics, in CloudGrid grid)
        {
            for (int i = 0; i < readers.Count; i++)
            {
                var info = readers[i].Info;
                var found = statistics[i];
                if (found.LeftOut > 0)
                    info.Warn(-1, string.Format(CultureInfo.InvariantCulture, "{0} points without a finite position are left out",
                        found.LeftOut));
                if (found.MaxRoundingSteps > 0)
                {
                    info.Warn(-1, "positions were rounded, by up to " +
                        NumberText.Of(found.MaxRoundingSteps * math.cmax(grid.Step)) + ", to the grid's steps");
                }
            }
        }

        static void Describe(in PointStatistics found, AttributeStatistics[] values, BuildContext build, CloudManifest manifest)
        {
            Describe(found, manifest);
            manifest.Grid = build.Grid.Grid;
            manifest.Attributes = build.Attributes;
            AttributeSummary.Describe(build.Attributes, values, manifest);
            DescribeMeaning(build.Readers, manifest);
        }

        public static void Describe(in PointStatistics found, CloudManifest manifest)
        {
            manifest.Points = found.Count;
            manifest.PointsLeftOut = found.LeftOut;
            manifest.Checksum = found.Checksum;
            manifest.BoundsMin = found.Count > 0 ? found.Min : default;
            manifest.BoundsMax = found.Count > 0 ? found.Max : default;
        }

        public static void DescribeMeaning(IReadOnlyList<PointReader> readers, CloudManifest manifest)
        {
            manifest.Crs = readers[0].Info.Crs.ToCloudCrs();
            manifest.GpsTime = MeaningOf(readers).GpsTime;
            manifest.Scanners = readers.Count == 1 ? readers[0].Info.Scanners : null;
        }
    }

    /// <summary>Turns statistics of a cloud's attributes into the manifest's description of them.</summary>
    internal static unsafe class AttributeSummary
    {
        public static void Describe(PointSchema attributes, AttributeStatistics[] found, CloudManifest manifest)
        {
            manifest.Divisors = new int[attributes.Count];
            manifest.Ranges = new CloudManifest.ValueRange[attributes.Count];
            for (int a = 0; a < attributes.Count; a++)
            {
                var attribute = attributes[a];
                manifest.Divisors[a] = DivisorOf(found[a], attribute);
                manifest.Ranges[a] = found[a].IsEmpty
                    ? new CloudManifest.ValueRange { Min = double.NaN, Max = double.NaN }
                    : new CloudManifest.ValueRange
                    {
                        Min = ValueOf(found[a].OrderedMin, attribute.Type) * attribute.Scale + attribute.Offset,
                        Max = ValueOf(found[a].OrderedMax, attribute.Type) * attribute.Scale + attribute.Offset,
                    };
            }
        }

        /// <summary>The divisor, if values of fewer bits fill 16-bit fields in one of two ways: doubled, or shifted up. Not for
        /// numbers such as a flight line's: a plan knows divisors by a sample, and what divides all of its few numbers often does
        /// not divide all.</summary>
        public static int DivisorOf(in AttributeStatistics found, PointAttribute attribute)
        {
            if (attribute.Type != AttributeType.UInt16 || found.IsEmpty || found.Or == 0)
                return 1;
            if (found.Modulo257OrOfUInt16 == 0)
                return 257;
            int shift = math.tzcnt((uint)found.Or);
            bool isAmount = attribute.Name == AttributeNames.Intensity || AttributeNames.IsColor(attribute.Name);
            return isAmount || shift >= 8 ? 1 << shift : 1;
        }

        static double ValueOf(ulong ordered, AttributeType type)
        {
            ulong bits = 0;
            OrderedBits.Store(ordered, type, (byte*)&bits);
            return ColumnValues.ToDouble((byte*)&bits, type, 0);
        }
    }

    internal static class StoredFacts
    {
        const int MaxChars = 4 << 20;

        public static string ToJson(SourceInfo info)
        {
            var json = new JsonWriter().BeginObject().Add("tell", info.UnexportableFacts).BeginArray("facts");
            int room = MaxChars;
            foreach (var fact in info.Facts)
            {
                room -= fact.Key.Length + fact.Value.Length;
                if (room >= 0)
                    json.BeginObject().Add("name", fact.Key).Add("value", fact.Value).EndObject();
            }
            if (room < 0)
                info.Losses.Add(new Loss("facts", info.Path, "those beyond " + MaxChars + " characters are not kept"));
            return json.EndArray().EndObject().ToString();
        }

        public static void AddTo(SourceInfo info, CloudFolder folder)
        {
            string path = SourcePath.Combine(folder.FolderPath, StoreFormat.FactsName);
            if (!StoreFile.TryReadText(path, out string text))
                return;
            var json = JsonMembers.Parse(text, path);
            info.UnexportableFacts = json.TextOrNull("tell");
            foreach (var fact in json.Objects("facts"))
                info.AddFact(fact.Text("name"), fact.Text("value"));
        }
    }
}
