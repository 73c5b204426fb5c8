using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Octrees
{
    // Some planes of a source's layout, and what must be decoded to make them.
    sealed class TreePlanes : IDisposable
    {
        static readonly string[] s_position = { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };

        readonly StoreLayout m_layout;
        NativeArray<int> m_indices;
        NativeArray<PlaneShape> m_shapes;
        NativeArray<int> m_bits;

        // layout: without the position; names: besides the position's; those that the source lacks are left out.
        public TreePlanes(PointSchema schema, StoreLayout layout, IReadOnlyList<string> names)
        {
            m_layout = layout;
            var wanted = new SortedSet<int> { StoreLayout.PositionPlane };
            foreach (string name in names)
                if (layout.PlaneOf(name) >= 0)
                    wanted.Add(layout.PlaneOf(name));
            var indices = new int[wanted.Count];
            wanted.CopyTo(indices);
            m_indices = new NativeArray<int>(indices, Allocator.Persistent);
            m_bits = new NativeArray<int>(indices.Length, Allocator.Persistent);
            m_shapes = new NativeArray<PlaneShape>(indices.Length, Allocator.Persistent);
            var attributes = new List<string>(s_position);
            for (int p = 0; p < indices.Length; p++)
            {
                var plane = layout.Planes[indices[p]];
                m_shapes[p] = plane.Shape;
                for (int c = plane.FirstColumn; p > 0 && c < plane.FirstColumn + plane.ColumnCount; c++)
                {
                    m_bits[p] += 8 * layout.Columns[c].Type.SizeOf();
                    attributes.Add(layout.Attributes[layout.AttributeOfColumn[c]].Name);
                }
            }
            Decoded = schema.Select(attributes.ToArray());
        }

        public int Count => m_indices.Length;

        // Rising; position is the first.
        public NativeArray<int> Indices => m_indices;

        // The position's is that of nodes that are not wide.
        public NativeArray<PlaneShape> Shapes => m_shapes;

        // Of a point's values in each plane. The position's depend on the node.
        public NativeArray<int> Bits => m_bits;

        public PointSchema Decoded { get; }

        public static StoreLayout LayoutOf(PointSchema schema)
        {
            var attributes = new List<PointAttribute>();
            foreach (var attribute in schema)
                if (Array.IndexOf(s_position, attribute.Name) < 0)
                    attributes.Add(attribute);
            return new StoreLayout(new PointSchema(attributes));
        }

        // Of any plane except the position's.
        public string AttributeOf(int plane, int column)
        {
            int of = m_layout.AttributeOfColumn[m_layout.Planes[m_indices[plane]].FirstColumn + column];
            return m_layout.Attributes[of].Name;
        }

        public void Dispose()
        {
            if (!m_indices.IsCreated)
                return;
            m_indices.Dispose();
            m_shapes.Dispose();
            m_bits.Dispose();
        }
    }
}
