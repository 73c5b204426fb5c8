using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
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
        EditedPoints m_edited;

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
                m_edited?.Dispose();
                m_edited = value == null ? null : new EditedPoints(value, Folder, m_schema);
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

        /// <summary>Coroutine: the points of nodes in a box, batch by batch, in grid steps from the root's corner.</summary>
        public IEnumerator<JobStep> Read(Grid3 min, Grid3 end, Func<PointBatch, IEnumerator<JobStep>> take)
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
                    if (m_edited?.Find(page, index, table) is EditedNode node)
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
            using var batch = new PointBatch(m_schema, node.MaxPoints, Allocator.Persistent);
            yield return JobStep.Of(m_edited.Add(node, batch));
            if (Prepare != null)
                yield return JobStep.Of(Prepare(batch));
            yield return JobStep.Of(take(batch));
        }

        public override void Dispose()
        {
            m_edited?.Dispose();
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
}
