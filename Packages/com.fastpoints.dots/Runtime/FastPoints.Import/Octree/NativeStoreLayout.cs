using System;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Octree
{
    /// <summary>A cloud's planes and columns as jobs read them.</summary>
    public sealed class NativeStoreLayout : IDisposable
    {
        public NativeStoreLayout(StoreLayout layout)
        {
            Layout = layout;
            Columns = new NativeArray<StoredColumn>(layout.Columns, Allocator.Persistent);
            int planes = layout.Planes.Count - 1;
            FirstColumnOfPlane = new NativeArray<int>(planes + 1, Allocator.Persistent);
            Shapes = new NativeArray<PlaneShape>(planes, Allocator.Persistent);
            for (int p = 0; p < planes; p++)
            {
                var first = FirstColumnOfPlane;
                first[p] = layout.Planes[p + 1].FirstColumn;
                var shapes = Shapes;
                shapes[p] = layout.Planes[p + 1].Shape;
            }
            var last = FirstColumnOfPlane;
            last[planes] = layout.Columns.Length;
        }

        public StoreLayout Layout { get; }
        public NativeArray<StoredColumn> Columns { get; private set; }

        /// <summary>By attribute plane, and one more.</summary>
        public NativeArray<int> FirstColumnOfPlane { get; private set; }

        /// <summary>By attribute plane.</summary>
        public NativeArray<PlaneShape> Shapes { get; private set; }

        public void Dispose()
        {
            if (!Columns.IsCreated)
                return;
            Columns.Dispose();
            FirstColumnOfPlane.Dispose();
            Shapes.Dispose();
            Columns = default;
        }
    }
}
