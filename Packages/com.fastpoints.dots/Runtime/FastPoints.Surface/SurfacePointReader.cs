using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Surface
{
    internal sealed class SurfacePointReader : CloudSelection
    {
        const int NodesPerStep = 256, NoPage = -1;
        const int MaxTables = 500; // Of 64 KiB each: a long way would collect all of a cloud's.

        readonly SurfaceGrid m_grid;
        readonly ClassMask m_hidden;
        readonly PointSchema m_schema;
        EditedNodes m_edited;
        EditedTranscoder m_transcoder;

        /// <param name="hidden">Points of these classes are left out.</param>
        /// <param name="metresOfUnit">Along each axis; null for the cloud's own.</param>
        /// <param name="attributes">To read beside positions, for <see cref="Prepare"/>.</param>
        public SurfacePointReader(CloudFolder folder, in SurfaceGrid grid, ClassMask hidden, double3? metresOfUnit = null,
            params string[] attributes) : base(folder)
        {
            m_grid = grid;
            m_hidden = hidden;
            var manifest = folder.Manifest;
            Metres = (metresOfUnit ?? manifest.Crs.Units.MetresAt(manifest.BoundsGeo.Center, UpAxis.Z)) * manifest.Grid.Step;
            var names = new List<string>(attributes);
            if (!hidden.IsEmpty)
                names.Add(AttributeNames.Classification);
            m_schema = LoadNodes.SchemaFor(folder, names.ToArray());
        }

        /// <summary>So many points of a cell are read at once, or the points of a node.</summary>
        public long PointsPerBatch { get; set; } = 1_000_000;

        public double3 Metres { get; }

        /// <summary>A coroutine that may leave out points of each batch before it is taken; null for none.</summary>
        public Func<PointBatch, IEnumerator<JobStep>> Prepare { get; set; }

        /// <summary>Points are taken as these leave them; null as stored. To be set while none are read.</summary>
        public EditPlan Edits
        {
            set
            {
                var planes = new List<int> { StoreLayout.PositionPlane };
                for (int p = 1; p < Folder.Layout.Planes.Count; p++)
                    if (Folder.Layout.Planes[p].IsSource && ColumnsOf(p).Count > 0)
                        planes.Add(p);
                m_transcoder?.Dispose();
                m_transcoder = null;
                using var streamed = new NativeArray<int>(planes.ToArray(), Allocator.Persistent);
                m_edited = value == null ? null : new EditedNodes(value, Folder, streamed);
            }
        }

        /// <summary>Around all points that a cell's surface may depend on. Any thread.</summary>
        public EditShape BoxOf(int3 cell)
        {
            double margin = m_grid.Margin * m_grid.VoxelMetres;
            var min = new double3(cell.x, cell.y, cell.z) * m_grid.CellMetres - margin;
            return new EditShape { A = StepsOf(min, false), B = StepsOf(min + m_grid.CellMetres + 2 * margin, true) };
        }

        /// <summary>Coroutine: adds the points in a cell and around it to its surface.</summary>
        /// <exception cref="PointCloudException">The cloud cannot be read.</exception>
        public IEnumerator<JobStep> Add(SurfaceBuilder builder, int3 cell)
        {
            var box = BoxOf(cell);
            return Read(box.A, box.B, batch => builder.Add(cell, batch, Metres, m_hidden));
        }

        /// <summary>Coroutine: all points of the cloud, batch by batch, in grid steps from the root's corner.</summary>
        public IEnumerator<JobStep> ReadAll(Func<PointBatch, IEnumerator<JobStep>> take)
        {
            var root = Folder.Manifest.Root;
            return Read(root.Corner, EndOf(root), take);
        }

        IEnumerator<JobStep> Read(Grid3 min, Grid3 end, Func<PointBatch, IEnumerator<JobStep>> take)
        {
            Clear();
            DropTables(MaxTables);
            // Pages are loaded on the way: what is chosen is complete before it is read.
            var nodes = new List<(int Page, int Node)>();
            var edited = new HashSet<EditedNode>();
            int missing = NoPage, seen = 0;
            foreach (var (page, index) in NodesIn(min, end, page => missing = page))
            {
                if (missing != NoPage)
                {
                    yield return JobStep.Of(LoadPage(missing));
                    missing = NoPage;
                }
                else if (Intersects(TableOf(page).Nodes[index], min, end))
                {
                    // A leaf that is inlined is read with its parent.
                    var table = TableOf(page);
                    if (m_edited?.Find(page, table.Nodes[index].PlaneNode, table.View) is EditedNode node)
                        edited.Add(node);
                    else
                        nodes.Add((page, index));
                }
                if (++seen % NodesPerStep == 0)
                    yield return default;
            }
            for (int n = 0; n < nodes.Count; n++)
            {
                var (page, index) = nodes[n];
                Add(page, index, TableOf(page).Nodes[index].PointCount);
                if (Points < PointsPerBatch && n < nodes.Count - 1)
                    continue;
                SortNodes();
                using (var batch = new PointBatch(m_schema, Math.Max(1, PointCountOrThrow), Allocator.Persistent))
                {
                    yield return JobStep.Of(LoadNodes.Run(Folder, this, batch, null));
                    if (Prepare != null)
                        yield return JobStep.Of(Prepare(batch));
                    yield return JobStep.Of(take(batch));
                }
                Clear();
            }
            foreach (var node in edited)
                yield return JobStep.Of(ReadEdited(node, take));
        }

        IEnumerator<JobStep> ReadEdited(EditedNode node, Func<PointBatch, IEnumerator<JobStep>> take)
        {
            m_transcoder ??= new EditedTranscoder(m_edited);
            PointBatch batch = null;
            var unpacked = default(JobHandle);
            m_transcoder.Begin(node);
            try
            {
                yield return m_transcoder.Done;
                m_transcoder.EndOrThrow();
                int blocks = 0, points = 0;
                m_transcoder.CorrectCounts(ref blocks, ref points);
                batch = new PointBatch(m_schema, Math.Max(1, points), Allocator.Persistent) { Count = points };
                unpacked = Unpack(node, blocks, batch);
                yield return unpacked;
                if (Prepare != null)
                    yield return JobStep.Of(Prepare(batch));
                yield return JobStep.Of(take(batch));
            }
            finally
            {
                m_transcoder.End(out _);
                unpacked.Complete();
                batch?.Dispose();
            }
        }

        JobHandle Unpack(EditedNode node, int blocks, PointBatch batch)
        {
            var corner = node.Corner - Folder.Manifest.Root.Corner;
            var unpacked = default(JobHandle);
            for (int p = 0; p < m_edited.StreamedPlanes; p++)
                foreach (var (column, to) in ColumnsOf(m_edited.Planes[p]))
                    unpacked = new UnpackColumnJob
                    {
                        Values = new ColumnUnpacker
                        {
                            Column = column,
                            Stored = p == 0 ? default
                            : Folder.Layout.Columns[Folder.Layout.Planes[m_edited.Planes[p]].FirstColumn + column]
                        },
                        Plane = m_transcoder.PlaneOf(p),
                        Shape = Folder.Layout.ShapeOf(m_edited.Planes[p], node.IsWide),
                        BlockCount = blocks,
                        IsPosition = p == 0,
                        Corner = column == 0 ? corner.X : column == 1 ? corner.Y : corner.Z,
                        To = batch.Column(to),
                        Batch = batch.Bytes,
                    }.Schedule(unpacked);
            return unpacked;
        }

        // Of a plane, and where they are in a batch.
        List<(int Column, int To)> ColumnsOf(int plane)
        {
            var columns = new List<(int, int)>();
            var of = Folder.Layout.Planes[plane];
            for (int c = 0; c < of.ColumnCount; c++)
                if (m_schema.IndexOf(Folder.Layout.NameOfColumn(of, of.FirstColumn + c)) is int to && to >= 0)
                    columns.Add((c, to));
            for (int axis = 0; plane == StoreLayout.PositionPlane && axis < 3; axis++)
                columns.Add((axis, axis));
            return columns;
        }

        public override void Dispose()
        {
            m_transcoder?.Dispose();
            base.Dispose();
        }

        public override bool IsRefined(int page, int node) => true;

        Grid3 StepsOf(double3 metres, bool isEnd)
        {
            var steps = math.clamp(metres / Metres, -(1L << 60), 1L << 60);
            steps = isEnd ? math.ceil(steps) + 1 : math.floor(steps);
            return Folder.Manifest.Root.Corner + new Grid3((long)steps.x, (long)steps.y, (long)steps.z);
        }
    }

    /// <summary>A column of what edits leave of a node.</summary>
    [BurstCompile]
    internal unsafe struct UnpackColumnJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Plane;
        public PlaneShape Shape;
        public ColumnUnpacker Values; // Without its view.
        public int BlockCount;
        public bool IsPosition;
        public long Corner;
        public PointColumn To;
        public NativeArray<byte> Batch;

        public void Execute()
        {
            var values = Values;
            values.View = new PlaneView(Plane.GetUnsafeReadOnlyPtr(), Shape, BlockCount);
            long* steps = stackalloc long[PlaneShape.MaxPointsPerBlock];
            for (int b = 0, at = 0; b < BlockCount; b++)
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
