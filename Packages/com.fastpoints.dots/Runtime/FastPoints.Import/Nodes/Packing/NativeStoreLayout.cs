using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Nodes
{
    internal sealed class NativeStoreLayout : IDisposable
    {
        public NativeStoreLayout(StoreLayout layout)
        {
            Layout = layout;
            Columns = new NativeArray<StoredColumn>(layout.Columns, Allocator.Persistent);
            int planes = layout.Planes.Count - 1;
            ColorPlane = layout.PlaneOf(StoreLayout.ColorName) - 1;
            AverageOf = new NativeArray<int>(planes, Allocator.Persistent);
            var averaged = new List<StoredColumn>();
            FirstColumnOfPlane = new NativeArray<int>(planes + 1, Allocator.Persistent);
            Shapes = new NativeArray<PlaneShape>(planes, Allocator.Persistent);
            for (int p = 0; p < planes; p++)
            {
                var first = FirstColumnOfPlane;
                first[p] = layout.Planes[p + 1].FirstColumn;
                var shapes = Shapes;
                shapes[p] = layout.Planes[p + 1].Shape;
                var averageOf = AverageOf;
                // What is computed is no attribute either.
                averageOf[p] = layout.Planes[p + 1].IsComputed ? p : layout.Planes[p + 1].AverageOf - 1;
                if (layout.Planes[p + 1].AverageOf >= 0)
                    for (int c = 0; c < layout.Planes[p + 1].ColumnCount; c++)
                        averaged.Add(layout.Columns[first[p] + c]);
            }
            AveragedColumns = new NativeArray<StoredColumn>(averaged.ToArray(), Allocator.Persistent);
            var last = FirstColumnOfPlane;
            last[planes] = layout.Columns.Length;
        }

        public StoreLayout Layout { get; }
        public NativeArray<StoredColumn> Columns { get; private set; }

        public NativeArray<int> FirstColumnOfPlane { get; private set; } // Indexed by attribute plane, with one more entry.

        public NativeArray<PlaneShape> Shapes { get; private set; }

        /// <summary>For each attribute plane, the one whose values it averages, or a negative number; itself if it was
        /// computed.</summary>
        public NativeArray<int> AverageOf { get; private set; }

        public int ColorPlane { get; } // The attribute plane that lies with the positions, or a negative number.

        public NativeArray<StoredColumn> AveragedColumns { get; private set; }

        public bool HasAverages => AveragedColumns.Length > 0;

        public void Dispose()
        {
            if (!Columns.IsCreated)
                return;
            Columns.Dispose();
            FirstColumnOfPlane.Dispose();
            Shapes.Dispose();
            AverageOf.Dispose();
            AveragedColumns.Dispose();
            Columns = default;
        }
    }
}
