using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Store;

namespace FastPoints.Reading
{
    // All attributes of all files, with types that hold every file's values, and one transform for all positions.
    sealed class TileSchema
    {
        readonly List<Tile> m_tiles;
        readonly SourceInfo m_info;
        readonly List<PointSchema> m_schemas = new List<PointSchema>();
        readonly List<string> m_missing = new List<string>();
        readonly Dictionary<PointSchema, List<Tile>> m_tilesOfSchema = new Dictionary<PointSchema, List<Tile>>();

        // Equal schemas of tiles must be one object. The info receives schema, transform, and a warning for each change.
        public TileSchema(List<Tile> tiles, SourceInfo info)
        {
            m_tiles = tiles;
            m_info = info;
            foreach (var tile in tiles)
            {
                if (!m_tilesOfSchema.TryGetValue(tile.Schema, out var with))
                {
                    m_schemas.Add(tile.Schema);
                    m_tilesOfSchema[tile.Schema] = with = new List<Tile>();
                }
                with.Add(tile);
            }
        }

        public void MergeSchemas()
        {
            var transform = PositionTransform.Identity;
            var attributes = new List<PointAttribute>();
            var seen = new HashSet<string>();
            foreach (var schema in m_schemas)
                foreach (var attribute in schema)
                    if (seen.Add(attribute.Name))
                    {
                        int axis = AttributeNames.AxisOf(attribute.Name);
                        attributes.Add(axis < 0
                            ? MergeAttribute(attribute.Name)
                            : new PointAttribute(attribute.Name, UnitePosition(axis, attribute.Name, ref transform)));
                    }
            if (m_missing.Count > 0)
                m_info.Warn(-1, "attributes that some of the " + m_tiles.Count + " files have none of, zeros there: " +
                    string.Join("; ", m_missing));
            m_info.Schema = new PointSchema(attributes);
            m_info.Transform = transform;
        }

        // The plan without the columns' offsets. The tile's attribute is null if it has none.
        public static TileColumn Convert(Tile tile, PointAttribute from, PointAttribute to, in PositionTransform cloud)
        {
            var column = new TileColumn { Kind = TileColumnKind.Copy, Factor = 1, Scale = 1 };
            if (from == null)
            {
                column.Kind = TileColumnKind.Zero;
                return column;
            }
            int axis = AttributeNames.AxisOf(from.Name);
            if (axis >= 0)
            {
                double scale = tile.Transform.Scale[axis], offset = tile.Transform.Offset[axis];
                bool isSame = scale.Equals(cloud.Scale[axis]) && offset.Equals(cloud.Offset[axis]);
                if (isSame && from.Type == to.Type)
                    return column;
                column.Kind = to.Type.IsFloat() ? TileColumnKind.Real : TileColumnKind.Position;
                if (column.Kind == TileColumnKind.Position)
                {
                    CommonGrid.TryRescale(scale, offset, cloud.Scale[axis], cloud.Offset[axis], out var placed);
                    (column.Factor, column.Shift, _) = placed;
                }
                else if (!isSame)
                {
                    column.Scale = scale;
                    column.Offset = offset;
                }
                return column;
            }
            if (from.Equals(to))
                return column;
            column.Kind = to.Type.IsFloat() ? TileColumnKind.Real : TileColumnKind.Integer;
            if (AttributeNames.IsColor(from.Name) && from.Type == AttributeType.UInt8 && to.Type == AttributeType.UInt16)
                column.Factor = 257;
            // LAS: whole degrees in point formats 0 to 5, steps of 0.006 degrees from 6 on.
            if (from.Name == AttributeNames.ScanAngle && from.Type == AttributeType.Int16)
                column.Scale = 0.006;
            if (!SameScale(from, to))
            {
                column.Scale = from.Scale;
                column.Offset = from.Offset;
            }
            return column;
        }

        AttributeType UnitePosition(int axis, string name, ref PositionTransform transform)
        {
            bool isInteger = true, isFloat = true, isSame = true;
            var first = m_tiles[0].Transform;
            AttributeType? type = null;
            foreach (var schema in m_schemas)
            {
                int column = schema.IndexOf(name);
                if (column < 0)
                    continue;
                isInteger &= !schema[column].Type.IsFloat();
                isFloat &= schema[column].Type.IsFloat();
                type = type == null ? schema[column].Type : AttributeTypes.Common(type.Value, schema[column].Type);
            }
            var scales = new double[m_tiles.Count];
            var offsets = new double[m_tiles.Count];
            for (int i = 0; i < scales.Length; i++)
            {
                scales[i] = m_tiles[i].Transform.Scale[axis];
                offsets[i] = m_tiles[i].Transform.Offset[axis];
                isSame &= scales[i].Equals(first.Scale[axis]) && offsets[i].Equals(first.Offset[axis]);
            }
            if (isSame && (isInteger || isFloat) && !(isInteger && type.Value.IsFloat()))
            {
                transform.Scale[axis] = first.Scale[axis];
                transform.Offset[axis] = first.Offset[axis];
                // Whole numbers of different types go through the same conversion as those of different grids.
                return isInteger && IsMixed(name) ? AttributeType.Int64 : type.Value;
            }
            if (!isInteger)
            {
                if (!isFloat)
                    m_info.Warn(-1, name + ": some files have whole numbers, others floats: all are read as floats of 64 bits");
                return AttributeType.Float64;
            }
            double step = CommonGrid.StepOf(scales, offsets), worst = 0;
            for (int i = 0; i < scales.Length; i++)
            {
                if (!CommonGrid.TryRescale(scales[i], offsets[i], step, offsets[0], out var placed))
                {
                    m_info.Warn(-1, name + ": no grid holds the scale and offset of " + m_tiles[i].Path +
                        " together with the other files': all are read as floats of 64 bits");
                    return AttributeType.Float64;
                }
                worst = Math.Max(worst, placed.Loss);
            }
            if (worst > 0)
                m_info.Warn(-1, name + ": scales and offsets of the files have no common step: moved by up to " +
                    NumberText.Of(worst));
            transform.Scale[axis] = step;
            transform.Offset[axis] = offsets[0];
            return AttributeType.Int64;
        }

        PointAttribute MergeAttribute(string name)
        {
            PointAttribute united = null;
            long missing = 0;
            Tile firstMissing = null, firstOther = null;
            foreach (var schema in m_schemas)
            {
                int column = schema.IndexOf(name);
                var tiles = m_tilesOfSchema[schema];
                if (column < 0)
                {
                    missing += tiles.Count;
                    firstMissing ??= tiles[0];
                    continue;
                }
                var attribute = schema[column];
                if (united == null)
                {
                    united = attribute;
                }
                else if (!united.Equals(attribute))
                {
                    firstOther ??= tiles[0];
                    united = name == AttributeNames.ScanAngle ? new PointAttribute(name, AttributeType.Float32)
                        : SameScale(united, attribute)
                        ? new PointAttribute(name, AttributeTypes.Common(united.Type, attribute.Type), united.Scale,
                            united.Offset)
                        : new PointAttribute(name, AttributeType.Float64);
                }
            }
            if (missing > 0)
                m_missing.Add(name + " in " + missing + " (" + SourcePath.NameOf(firstMissing.Path) +
                    (missing > 1 ? ", ...)" : ")"));
            if (firstOther != null)
                m_info.Warn(-1, name + ": its type differs from file to file (first in " + firstOther.Path + "): read as " +
                    united.Type + (AttributeNames.IsColor(name) && united.Type == AttributeType.UInt16 ? ", 8 bits times 257"
                    : name == AttributeNames.ScanAngle ? ", in degrees" : ""));
            return united;
        }

        bool IsMixed(string name)
        {
            foreach (var schema in m_schemas)
                if (schema.IndexOf(name) is var column && column >= 0 &&
                    schema[column].Type != m_schemas[0][m_schemas[0].IndexOf(name)].Type)
                    return true;
            return false;
        }

        static bool SameScale(PointAttribute a, PointAttribute b) => a.Scale.Equals(b.Scale) && a.Offset.Equals(b.Offset);
    }

    enum TileColumnKind : byte
    {
        Copy,
        Zero,
        Integer, // Integers to wider ones: stored * Factor.
        Position, // Places on the common grid: stored * Factor + Shift, as int64.
        Real, // Any numbers to floats: stored * Scale + Offset.
    }

    struct TileColumn
    {
        public TileColumnKind Kind;
        public PointColumn From;
        public PointColumn To;
        public long Factor;
        public long Shift;
        public double Scale;
        public double Offset;
    }

    sealed class Tile
    {
        public string Path;
        public long FileBytes;
        public ulong HeadHash;
        public BoundsGeo Bounds;
        public PointSchema Schema; // Shared by all tiles with equal schemas.

        public PositionTransform Transform;
        public bool IsKnown; // A header gave the blocks: the reader can be closed and reopened.

        public bool HasCheapRanges;
        public int RecordBytes;
        public int FirstBlock;
        public int BlockCount;
        public int MaxPointsPerBlock;
        public long FirstPoint;
        public long Points;
        public long[] Starts; // Of its blocks; null if all but the last are as long as the longest.
        public PointReader Reader;
        public CloudCrs Crs; // Tiles of one system share the object.

        // It may hold a file's handle.
        public bool IsOpen;
        public int Users;
        public long LastUse;
        public List<int> Warnings;

        // The first point of a block of it, or behind the last, from its own first.
        public long StartOf(int block) => block == BlockCount ? Points : Starts?[block] ?? (long)block * MaxPointsPerBlock;
    }

    sealed class TileSummary
    {
        readonly SourceInfo m_info;
        readonly SortedDictionary<string, int> m_formats = new SortedDictionary<string, int>(StringComparer.Ordinal);
        readonly List<(CoordinateSystem Source, CloudCrs Crs)> m_systems = new List<(CoordinateSystem, CloudCrs)>();
        string m_firstPath;
        string m_pathOfCrs;
        string m_pathOfOtherCrs;
        int m_otherCrs;
        int m_withoutCrs;
        string m_pathOfTime;
        bool m_hasBounds = true;

        public TileSummary(SourceInfo info)
        {
            m_info = info;
            m_info.PointsReadable = -1;
        }

        public void Include(SourceInfo tile)
        {
            bool isFirst = m_firstPath == null;
            m_firstPath ??= tile.Path;
            m_formats.TryGetValue(tile.Format, out int with);
            m_formats[tile.Format] = with + 1;
            m_info.FileBytes += tile.FileBytes;
            m_info.PointsClaimed = m_info.PointsClaimed <= ulong.MaxValue - tile.PointsClaimed
                ? m_info.PointsClaimed + tile.PointsClaimed
                : ulong.MaxValue;
            m_info.HasPointsClaimed &= tile.HasPointsClaimed;
            if (isFirst)
            {
                m_info.Version = tile.Version;
                m_info.PointFormat = tile.PointFormat;
                m_info.RecordBytes = tile.RecordBytes;
            }
            if (m_info.Version != tile.Version)
                m_info.Version = null;
            if (m_info.PointFormat != tile.PointFormat)
                m_info.PointFormat = -1;
            if (m_info.RecordBytes != tile.RecordBytes)
                m_info.RecordBytes = 0;

            if (tile.HasBoundsClaimed && !tile.BoundsClaimed.IsEmpty)
                m_info.BoundsClaimed.Include(tile.BoundsClaimed);
            m_hasBounds &= tile.HasBoundsClaimed || tile.PointsReadable == 0;
            IncludeMeaning(tile);
        }

        public void IncludeMeaning(SourceInfo tile)
        {
            IncludeCrs(tile);
            if (tile.GpsTime.Kind == GpsTimeKind.Unknown)
                return;
            if (m_pathOfTime == null)
                (m_pathOfTime, m_info.GpsTime) = (tile.Path, tile.GpsTime);
            else if (!m_info.GpsTime.Equals(tile.GpsTime))
                m_info.Conflict ??= "GPS times of two kinds do not go together: " + m_pathOfTime + " has " + m_info.GpsTime +
                    ", " + tile.Path + " has " + tile.GpsTime;
        }

        void IncludeCrs(SourceInfo tile)
        {
            if (!tile.Crs.IsKnown)
            {
                m_withoutCrs++;
                if (!m_info.Crs.Units.IsKnown)
                    m_info.Crs = tile.Crs;
            }
            else if (m_pathOfCrs == null)
            {
                m_pathOfCrs = tile.Path;
                m_info.Crs = tile.Crs;
            }
            else if (!IsSame(m_info.Crs, tile.Crs))
            {
                m_pathOfOtherCrs ??= tile.Path + ": " + tile.Crs.Summary;
                m_otherCrs++;
            }
        }

        /// <summary>One object for all tiles of a system; null if there are more systems than any survey has.</summary>
        public CloudCrs SharedCrs(SourceInfo tile)
        {
            int index = m_systems.FindIndex(s => s.Source.HasSameCodes(tile.Crs));
            if (index < 0 && m_systems.Count < StoredSources.MaxSystems)
            {
                index = m_systems.Count;
                m_systems.Add((tile.Crs, tile.Crs.ToCloudCrs()));
            }
            return index < 0 ? null : m_systems[index].Crs;
        }

        public string Describe(SourceInfo tile) => tile.Format + (tile.Version != null ? " " + tile.Version : "") + ", " +
            (tile.PointsReadable >= 0 ? tile.PointsReadable.ToString("N0", CultureInfo.InvariantCulture) + " points" :
                tile.FileBytes.ToString("N0", CultureInfo.InvariantCulture) + " bytes");

        public void End(int tiles)
        {
            var formats = new List<string>();
            foreach (var format in m_formats)
                formats.Add(format.Key + " (" + NumberText.Of(format.Value) + ")");
            m_info.Format = m_formats.Count == 1 ? new List<string>(m_formats.Keys)[0] : "several formats";
            m_info.Facts.Insert(0, new KeyValuePair<string, string>("files",
                tiles.ToString("N0", CultureInfo.InvariantCulture) + ": " + string.Join(", ", formats)));
            if (m_info.Conflict != null)
                m_info.Warn(-1, m_info.Conflict);
            m_info.HasBoundsClaimed = m_hasBounds && !m_info.BoundsClaimed.IsEmpty;
            if (m_otherCrs > 0)
                m_info.Warn(-1, "coordinate systems differ: " + m_info.Crs.Summary + " was taken (of " + m_pathOfCrs + "), " +
                    (m_otherCrs == 1 ? "1 file has another" : m_otherCrs + " files have others") + " (" +
                    m_pathOfOtherCrs + "): points are not moved between them");
            if (m_pathOfCrs != null && m_withoutCrs > 0)
                m_info.Warn(-1, (m_withoutCrs == 1 ? "1 file names" : m_withoutCrs + " files name") +
                    " no coordinate system: that of " + m_pathOfCrs + " was taken");
        }

        static bool IsSame(CoordinateSystem a, CoordinateSystem b)
        {
            if (a.Units.IsKnown && b.Units.IsKnown && !a.MetresPerUnit.Equals(b.MetresPerUnit))
                return false;
            if (a.Epsg != 0 && b.Epsg != 0)
                return a.Epsg == b.Epsg && a.VerticalEpsg == b.VerticalEpsg;
            return a.Wkt != null || b.Wkt != null ? a.Wkt == b.Wkt : a.Name == b.Name && a.Epsg == b.Epsg;
        }
    }
}
