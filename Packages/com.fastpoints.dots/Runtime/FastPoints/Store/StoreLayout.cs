using System;
using System.Collections.Generic;
using FastPoints.Points;

namespace FastPoints.Store
{
    /// <summary>
    /// The planes of a cloud: position first, then colour (red, green, blue as one), then each other attribute alone, so that a
    /// scene reads and keeps only what it draws.
    /// </summary>
    public sealed class StoreLayout
    {
        public const int PositionPlane = 0;
        public const string PositionName = "position";
        public const string ColorName = "color";

        readonly List<Plane> m_planes = new List<Plane>();

        /// <summary>One plane: its attributes are columns.</summary>
        public sealed class Plane
        {
            public string Name;

            /// <summary>Columns of <see cref="StoreLayout.Columns"/>; none for the position plane.</summary>
            public int FirstColumn;
            public int ColumnCount;

            /// <summary>Shape of its blocks; the position plane's depends on the node.</summary>
            public PlaneShape Shape;
        }

        /// <param name="attributes">All attributes but X, Y, Z.</param>
        /// <param name="divisors">By attribute; null for 1 everywhere.</param>
        public StoreLayout(PointSchema attributes, int[] divisors = null)
        {
            Attributes = attributes;
            Columns = new StoredColumn[attributes.Count];
            AttributeOfColumn = new int[attributes.Count];
            m_planes.Add(new Plane { Name = PositionName, Shape = new PlaneShape(3, 0) });

            var offsets = new int[attributes.Count];
            for (int i = 0; i < attributes.Count; i++)
            {
                offsets[i] = AttributeBytes;
                AttributeBytes += attributes[i].Type.SizeOf();
            }
            int columns = 0;
            void AddPlane(string name, params int[] members)
            {
                int wide = 0;
                for (int c = 0; c < members.Length; c++)
                    if (attributes[members[c]].Type.SizeOf() == 8)
                        wide |= 1 << c;
                m_planes.Add(new Plane
                {
                    Name = name,
                    FirstColumn = columns,
                    ColumnCount = members.Length,
                    Shape = new PlaneShape(members.Length, wide),
                });
                foreach (int member in members)
                {
                    AttributeOfColumn[columns] = member;
                    Columns[columns++] = new StoredColumn
                    {
                        Type = attributes[member].Type,
                        Divisor = divisors != null ? divisors[member] : 1,
                        RecordOffset = offsets[member],
                    };
                }
            }

            if (attributes.HasColor)
            {
                AddPlane(ColorName, attributes.IndexOf(AttributeNames.Red), attributes.IndexOf(AttributeNames.Green),
                    attributes.IndexOf(AttributeNames.Blue));
            }
            for (int i = 0; i < attributes.Count; i++)
                if (Array.IndexOf(AttributeOfColumn, i, 0, columns) < 0)
                    AddPlane(attributes[i].Name, i);
        }

        /// <summary>All attributes but the position, in the order of the source.</summary>
        public PointSchema Attributes { get; }

        public IReadOnlyList<Plane> Planes => m_planes;

        /// <summary>The columns of all planes but the first, plane by plane.</summary>
        public StoredColumn[] Columns { get; }

        /// <summary>Index in <see cref="Attributes"/> of each column.</summary>
        public int[] AttributeOfColumn { get; }

        /// <summary>Bytes of a record's attributes.</summary>
        public int AttributeBytes { get; }

        /// <returns>The plane of that name, or -1.</returns>
        public int PlaneOf(string name) => m_planes.FindIndex(p => p.Name == name);

        /// <summary>Shape of one plane of one node.</summary>
        public PlaneShape ShapeOf(int plane, bool isWide) =>
            plane == PositionPlane ? new PlaneShape(3, isWide ? 7 : 0) : m_planes[plane].Shape;
    }
}
