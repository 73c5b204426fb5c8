using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    // Reads what edits leave of stored nodes, with their inlined leaves, into batches. Main thread.
    internal sealed class EditedPoints : IDisposable
    {
        readonly CloudFolder m_folder;
        readonly PointSchema m_schema;
        readonly EditedNodes m_nodes;
        EditedTranscoder m_transcoder;

        // The batches have this schema: see LoadNodes.SchemaFor.
        public EditedPoints(EditPlan plan, CloudFolder folder, PointSchema schema)
        {
            (m_folder, m_schema) = (folder, schema);
            var planes = new List<int> { StoreLayout.PositionPlane };
            for (int p = 1; p < folder.Layout.Planes.Count; p++)
                if (folder.Layout.Planes[p].AverageOf < 0 && ColumnsOf(p).Count > 0)
                    planes.Add(p);
            using var streamed = new NativeArray<int>(planes.ToArray(), Allocator.Persistent);
            m_nodes = new EditedNodes(plan, folder, streamed);
        }

        // Null if it is as it is stored. Of an inlined leaf it is the node that has its planes.
        public EditedNode? Find(int page, int node, NodeTable table) =>
            m_nodes.Find(page, table.Nodes[node].PlaneNode, table.View);

        // Coroutine: appends to a batch that has room for MaxPoints, or for the points that are stored.
        public IEnumerator<JobStep> Add(EditedNode node, PointBatch batch)
        {
            m_transcoder ??= new EditedTranscoder(m_nodes);
            var unpacked = default(JobHandle);
            m_transcoder.Begin(node);
            try
            {
                yield return m_transcoder.Done;
                m_transcoder.EndOrThrow();
                int blocks = 0, points = 0, first = batch.Count;
                m_transcoder.CorrectCounts(ref blocks, ref points);
                batch.Count += points;
                unpacked = Unpack(node, blocks, batch, first);
                yield return unpacked;
            }
            finally
            {
                m_transcoder.End(out _);
                unpacked.Complete();
            }
        }

        public void Dispose() => m_transcoder?.Dispose();

        JobHandle Unpack(EditedNode node, int blocks, PointBatch batch, int first)
        {
            var corner = node.Corner - m_folder.Manifest.Root.Corner;
            var unpacked = default(JobHandle);
            for (int p = 0; p < m_nodes.StreamedPlanes; p++)
                foreach (var (column, to) in ColumnsOf(m_nodes.Planes[p]))
                    unpacked = new UnpackColumnJob
                    {
                        Values = new ColumnUnpacker
                        {
                            Column = column,
                            Stored = p == 0 ? default
                            : m_folder.Layout.Columns[m_folder.Layout.Planes[m_nodes.Planes[p]].FirstColumn + column]
                        },
                        Plane = m_transcoder.PlaneOf(p),
                        Shape = m_folder.Layout.ShapeOf(m_nodes.Planes[p], node.IsWide),
                        BlockCount = blocks,
                        IsPosition = p == 0,
                        Corner = column == 0 ? corner.X : column == 1 ? corner.Y : corner.Z,
                        First = first,
                        To = batch.Column(to),
                        Batch = batch.Bytes,
                    }.Schedule(unpacked);
            return unpacked;
        }

        // Of a plane, and where they are in a batch.
        List<(int Column, int To)> ColumnsOf(int plane)
        {
            var columns = new List<(int, int)>();
            var of = m_folder.Layout.Planes[plane];
            for (int c = 0; c < of.ColumnCount; c++)
                if (m_schema.IndexOf(m_folder.Layout.NameOfColumn(of, of.FirstColumn + c)) is int to && to >= 0)
                    columns.Add((c, to));
            for (int axis = 0; plane == StoreLayout.PositionPlane && axis < 3; axis++)
                columns.Add((axis, axis));
            return columns;
        }
    }

    // A column of what edits leave of a node.
    [BurstCompile]
    internal unsafe struct UnpackColumnJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Plane;
        public PlaneShape Shape;
        public ColumnUnpacker Values; // Without its view.
        public int BlockCount;
        public bool IsPosition;
        public long Corner;
        public int First; // Point of the batch.
        public PointColumn To;
        public NativeArray<byte> Batch;

        public void Execute()
        {
            var values = Values;
            values.View = new PlaneView(Plane.GetUnsafeReadOnlyPtr(), Shape, BlockCount);
            long* steps = stackalloc long[PlaneShape.MaxPointsPerBlock];
            for (int b = 0, at = First; b < BlockCount; b++)
            {
                int count = values.View.PointsOf(b);
                byte* to = To.At((byte*)Batch.GetUnsafePtr(), at);
                if (IsPosition)
                    values.View.UnpackPositions(b, values.Column, Corner, 0, count, steps);
                else
                    values.Unpack(b, 0, count, to);
                for (int i = 0; i < count && IsPosition; i++)
                    ((double*)to)[i] = steps[i];
                at += count;
            }
        }
    }
}
