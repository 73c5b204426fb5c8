using System;
using System.Collections.Generic;
using Unity.Collections;

namespace FastPoints.Store
{
    /// <summary>The planes of a cloud: position, colour (red, green, blue as one), then each other attribute on its own, so
    /// that a scene reads and keeps only what it draws.</summary>
    public sealed class StoreLayout
    {
        public const int PositionPlane = 0;
        public const string PositionName = "position";
        public const string ColorName = "color";
        internal const string NormalName = "normal";

        // Of that plane: an octahedral vector's two bytes.
        internal static readonly string[] NormalColumns = { "normal.u", "normal.v" };

        /// <summary>Suffix for the name of a plane with averages of another.</summary>
        public const string AverageSuffix = ".average";

        readonly List<Plane> m_planes = new List<Plane>();

        /// <summary>One plane, whose attributes are its columns.</summary>
        public sealed class Plane
        {
            public string Name;

            /// <summary>Index in StoreLayout.Columns; the position plane has no columns there.</summary>
            public int FirstColumn;
            public int ColumnCount;

            /// <summary>Shape of its blocks; that of the position plane depends on the node.</summary>
            public PlaneShape Shape;

            /// <summary>The plane whose values it averages over what each point stands for; -1 for plain values.</summary>
            public int AverageOf = -1;
            internal bool IsComputed; // Computed from the cloud's points, in a container of its own layer; not in its attributes.

            internal bool IsSource => AverageOf < 0 && !IsComputed;
        }

        /// <summary>All attributes except X, Y, Z, with a divisor each (null for 1). Averages come last, then
        /// normals.</summary>
        public StoreLayout(PointSchema attributes, int[] divisors = null, bool hasAverages = false, bool hasNormals = false)
        {
            Attributes = attributes;
            // The averages at most double the number; normals have two.
            var stored = new StoredColumn[2 * attributes.Count + 2];
            var attributeOfColumn = new int[2 * attributes.Count + 2];
            m_planes.Add(new Plane { Name = PositionName, Shape = PlaneShape.OfPositions(false) });

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
                    attributeOfColumn[columns] = member;
                    stored[columns++] = new StoredColumn
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
                if (Array.IndexOf(attributeOfColumn, i, 0, columns) < 0)
                    AddPlane(attributes[i].Name, i);
            int planes = m_planes.Count;
            for (int p = 1; p < planes && hasAverages; p++)
            {
                var plane = m_planes[p];
                var members = new int[plane.ColumnCount];
                Array.Copy(attributeOfColumn, plane.FirstColumn, members, 0, members.Length);
                bool isAveraged = plane.Name == ColorName || plane.Name == AttributeNames.Intensity;
                foreach (int member in members)
                    isAveraged &= CanAverage(attributes[member].Type);
                if (!isAveraged)
                    continue;
                AddPlane(plane.Name + AverageSuffix, members);
                m_planes[m_planes.Count - 1].AverageOf = p;
            }
            if (hasNormals)
                m_planes.Add(NormalsFrom(columns));
            for (int c = 0; hasNormals && c < 2; c++)
            {
                attributeOfColumn[columns] = -1;
                stored[columns++] = new StoredColumn { Type = AttributeType.UInt8, Divisor = 1 };
            }
            Array.Resize(ref stored, columns);
            Array.Resize(ref attributeOfColumn, columns);
            Columns = stored;
            AttributeOfColumn = attributeOfColumn;
        }

        /// <summary>All attributes except the position, in the order of the source.</summary>
        public PointSchema Attributes { get; }

        public IReadOnlyList<Plane> Planes => m_planes;

        /// <summary>The columns of all planes except the first, plane by plane.</summary>
        public StoredColumn[] Columns { get; }

        /// <summary>Index in <see cref="Attributes"/> of each column; -1 for what is computed.</summary>
        public int[] AttributeOfColumn { get; }

        /// <summary>Bytes of a record's attributes.</summary>
        public int AttributeBytes { get; }

        static Plane NormalsFrom(int column) => new Plane
        {
            Name = NormalName,
            FirstColumn = column,
            ColumnCount = 2,
            Shape = new PlaneShape(2, 0),
            IsComputed = true,
        };

        static bool CanAverage(AttributeType type) =>
            type == AttributeType.UInt8 || type == AttributeType.UInt16 || type == AttributeType.Float32;

        // Of an attribute, or of what was computed.
        internal string NameOfColumn(Plane plane, int column) =>
            plane.IsComputed ? NormalColumns[column - plane.FirstColumn] : Attributes[AttributeOfColumn[column]].Name;

        /// <returns>The plane with the averages of another, or -1.</returns>
        public int AverageOf(int plane) => plane == PositionPlane ? -1 : m_planes.FindIndex(p => p.AverageOf == plane);

        internal int ComputedPlanes => m_planes[m_planes.Count - 1].IsComputed ? 1 : 0;

        /// <returns>The plane of that name, or -1.</returns>
        public int PlaneOf(string name) => m_planes.FindIndex(p => p.Name == name);

        /// <summary>The shapes of all planes in nodes that are not wide; for jobs.</summary>
        public NativeArray<PlaneShape> CreateShapes(Allocator allocator)
        {
            var shapes = new NativeArray<PlaneShape>(m_planes.Count, allocator);
            for (int p = 0; p < shapes.Length; p++)
                shapes[p] = ShapeOf(p, false);
            return shapes;
        }

        /// <summary>Shape of one plane in one node.</summary>
        public PlaneShape ShapeOf(int plane, bool isWide) =>
            plane == PositionPlane ? PlaneShape.OfPositions(isWide) : m_planes[plane].Shape;
    }

    /// <summary>One column of one attribute plane: the meaning of its stored numbers. Blittable, for jobs.</summary>
    public struct StoredColumn
    {
        public AttributeType Type;

        /// <summary>Quotients are packed. 256 or 257 where 8-bit colours fill 16-bit fields, else 1.</summary>
        public int Divisor;

        /// <summary>Offset of the value in a record, which holds the values of all attributes one after the other.</summary>
        public int RecordOffset;
    }
}
