using System;
using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Reading
{
    /// <summary>The common attributes and positions of several files: all attributes of all of them, with types that hold every
    /// file's values, and one transform for all positions.</summary>
    sealed class TileSchema
    {
        readonly List<Tile> m_tiles;
        readonly SourceInfo m_info;
        readonly List<PointSchema> m_schemas = new List<PointSchema>();
        readonly List<string> m_missing = new List<string>();
        readonly Dictionary<PointSchema, List<Tile>> m_tilesOfSchema = new Dictionary<PointSchema, List<Tile>>();

        /// <param name="tiles">At least one tile; equal schemas must be one object.</param>
        /// <param name="info">Receives schema, transform, and a warning for each change.</param>
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

        public void Unite()
        {
            var transform = PositionTransform.Identity;
            var attributes = new List<PointAttribute>();
            var seen = new HashSet<string>();
            foreach (var schema in m_schemas)
                foreach (var attribute in schema)
                    if (seen.Add(attribute.Name))
                    {
                        int axis = AxisOf(attribute.Name);
                        attributes.Add(axis < 0
                            ? UniteAttribute(attribute.Name)
                            : new PointAttribute(attribute.Name, UnitePosition(axis, attribute.Name, ref transform)));
                    }
            if (m_missing.Count > 0)
                m_info.Warn(-1, "attributes that some of the " + m_tiles.Count + " files have none of, zeros there: " +
                    string.Join("; ", m_missing));
            m_info.Schema = new PointSchema(attributes);
            m_info.Transform = transform;
        }

        /// <summary>Plans how a tile's column becomes that of the cloud.</summary>
        /// <param name="from">The tile's attribute, or null if it has none.</param>
        /// <param name="to">The cloud's.</param>
        /// <returns>The plan without the columns' offsets.</returns>
        public static TileColumn Convert(Tile tile, PointAttribute from, PointAttribute to, in PositionTransform cloud)
        {
            var column = new TileColumn { Kind = TileColumnKind.Copy, Factor = 1, Scale = 1 };
            if (from == null)
            {
                column.Kind = TileColumnKind.Zero;
                return column;
            }
            int axis = AxisOf(from.Name);
            if (axis >= 0)
            {
                double scale = tile.Transform.Scale[axis], offset = tile.Transform.Offset[axis];
                bool isSame = scale.Equals(cloud.Scale[axis]) && offset.Equals(cloud.Offset[axis]);
                if (isSame && from.Type == to.Type)
                    return column;
                column.Kind = to.Type.IsFloat() ? TileColumnKind.Real : TileColumnKind.Place;
                if (column.Kind == TileColumnKind.Place)
                {
                    CommonGrid.TryPlace(scale, offset, cloud.Scale[axis], cloud.Offset[axis], out var placed);
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
            if (IsColor(from.Name) && from.Type == AttributeType.UInt8 && to.Type == AttributeType.UInt16)
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
                if (!CommonGrid.TryPlace(scales[i], offsets[i], step, offsets[0], out var placed))
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

        PointAttribute UniteAttribute(string name)
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
                m_missing.Add(name + " in " + missing + " (" + System.IO.Path.GetFileName(firstMissing.Path) +
                    (missing > 1 ? ", ...)" : ")"));
            if (firstOther != null)
                m_info.Warn(-1, name + ": its type differs from file to file (first in " + firstOther.Path + "): read as " +
                    united.Type + (IsColor(name) && united.Type == AttributeType.UInt16 ? ", 8 bits times 257"
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

        static int AxisOf(string name) =>
            name == AttributeNames.X ? 0 : name == AttributeNames.Y ? 1 : name == AttributeNames.Z ? 2 : -1;

        static bool IsColor(string name) => name == AttributeNames.Red || name == AttributeNames.Green ||
            name == AttributeNames.Blue || name == AttributeNames.Alpha || name == AttributeNames.NearInfrared;

        static bool SameScale(PointAttribute a, PointAttribute b) => a.Scale.Equals(b.Scale) && a.Offset.Equals(b.Offset);
    }

    enum TileColumnKind : byte
    {
        /// <summary>Copies values unchanged.</summary>
        Copy,
        /// <summary>The tile has no such attribute.</summary>
        Zero,
        /// <summary>Converts integers to wider ones: stored * Factor.</summary>
        Integer,
        /// <summary>Converts positions to places on the common grid: stored * Factor + Shift, as int64.</summary>
        Place,
        /// <summary>Converts any numbers to floats: stored * Scale + Offset.</summary>
        Real,
    }

    /// <summary>How one column of a tile becomes that of the whole cloud. Blittable: jobs carry arrays of these.</summary>
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
}
