using System.Collections.Generic;
using System.Globalization;
using System.IO;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Partition;
using FastPoints.Points;
using FastPoints.Records;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Convert
{
    /// <summary>Puts what a build has found out about its points into the cloud's manifest, and what is odd about them into the
    /// sources' warnings.</summary>
    internal static class CloudDescription
    {
        /// <summary>One entry a file, tiles of a reader apart.</summary>
        /// <param name="findings">By reader.</param>
        public static void AddSources(IReadOnlyList<PointReader> readers, IReadOnlyList<PointStatistics> statistics,
            CloudManifest manifest)
        {
            for (int i = 0; i < readers.Count; i++)
            {
                if (readers[i] is TiledReader tiles)
                {
                    for (int t = 0; t < tiles.TileCount; t++)
                    {
                        tiles.DescribeTile(t, out string path, out long bytes, out long points);
                        AddSource(path, bytes, points, manifest);
                    }
                }
                else
                {
                    var info = readers[i].Info;
                    AddSource(info.Path, info.FileBytes, statistics[i].Count + statistics[i].LeftOut, manifest);
                }
            }
        }

        /// <summary>Says of each source what is missing or inexact in the cloud.</summary>
        /// <param name="findings">By reader.</param>
        public static void Warn(IReadOnlyList<PointReader> readers, IReadOnlyList<PointStatistics> statistics, in CloudGrid grid)
        {
            for (int i = 0; i < readers.Count; i++)
            {
                var info = readers[i].Info;
                var found = statistics[i];
                if (found.LeftOut > 0)
                    info.Warn(-1, string.Format(CultureInfo.InvariantCulture, "{0} points without a finite position are left out",
                        found.LeftOut));
                if (found.WorstLossSteps > 0)
                {
                    info.Warn(-1, "positions were rounded, by up to " +
                        NumberText.Of(found.WorstLossSteps * math.cmax(grid.Step)) + ", to the grid's steps");
                }
            }
        }

        /// <summary>Counts, bounds, attributes, and where on Earth the first source says that the cloud lies.</summary>
        /// <param name="found">Of all points.</param>
        /// <param name="values">By attribute: what its values are.</param>
        public static void Describe(in PointStatistics found, in CloudGrid grid, PointSchema attributes, AttributeStatistics[] values,
            CoordinateSystem crs, CloudManifest manifest)
        {
            manifest.Points = found.Count;
            manifest.PointsLeftOut = found.LeftOut;
            manifest.Checksum = found.Checksum;
            manifest.Grid = grid;
            manifest.BoundsMin = found.Count > 0 ? found.Min : default;
            manifest.BoundsMax = found.Count > 0 ? found.Max : default;
            manifest.Attributes = attributes;
            AttributeSummary.Describe(attributes, values, manifest);
            manifest.CrsName = crs.Summary;
            manifest.CrsWkt = crs.Wkt;
            manifest.CrsEpsg = crs.Epsg;
            manifest.CrsVerticalEpsg = crs.VerticalEpsg;
            manifest.MetresPerUnit = crs.MetresPerUnit;
        }

        static void AddSource(string path, long fileBytes, long points, CloudManifest manifest) =>
            manifest.Sources.Add(new CloudManifest.Source
            {
                Name = Path.GetFileName(path),
                FileBytes = fileBytes,
                Points = points
            });
    }
}
