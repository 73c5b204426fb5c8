using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Store
{
    internal sealed class EditPlan
    {
        readonly List<string> m_changed = new List<string>();
        EditReaches m_before; // Of all operations but the last.
        List<(ulong Hash, EditReaches Reaches)> m_each; // By operation.

        public EditPlan(IReadOnlyList<EditOperation> operations, CloudManifest manifest)
        {
            Operations = operations;
            Manifest = manifest;
            PointsChanged = new long[operations.Count];
            Reaches = new EditReaches(operations);
            var names = new List<string>();
            foreach (var operation in operations)
            {
                m_changed.AddRange(operation.ChangedAttributes);
                names.AddRange(NamesOf(operation));
            }
            var attributes = new List<PointAttribute>();
            foreach (string axis in new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z })
                attributes.Add(new PointAttribute(axis, AttributeType.Int64));
            attributes.AddRange(manifest.Attributes.Select(names.ToArray()));
            Schema = new PointSchema(attributes);
        }

        public IReadOnlyList<EditOperation> Operations { get; }
        public EditOperation Last => Operations[Operations.Count - 1];
        public CloudManifest Manifest { get; }

        public PointSchema Schema { get; } // The position in whole steps, and the attributes that operations read or change.

        public PointSchema Changed => Manifest.Attributes.Select(m_changed.ToArray());

        // By operation, of all nodes whose slots have ended. Points that were deleted before do not count.
        public long[] PointsChanged { get; }

        // Differs between plans that make different points.
        public ulong Hash => HashOf(string.Concat(new List<EditOperation>(Operations).ConvertAll(o => o.ToJson())));

        // Differs between plans that make different points in a box: that of the operations, in their order, that may reach it.
        // 0 if none may.
        public unsafe ulong HashIn(in EditShape box)
        {
            ulong* hashes = stackalloc ulong[] { 0, 0 };
            int tries = int.MaxValue;
            if (!Reaches.Any(box, ref tries))
                return 0;
            m_each ??= new List<EditOperation>(Operations).ConvertAll(o => (HashOf(o.ToJson()), new EditReaches(new[] { o })));
            foreach (var (hash, reaches) in m_each)
                if (reaches.Any(box, ref tries))
                {
                    hashes[1] = hash;
                    hashes[0] = ContentHash.Of(hashes, 2 * sizeof(ulong));
                }
            return hashes[0];
        }

        static unsafe ulong HashOf(string text)
        {
            fixed (char* first = text)
                return ContentHash.Of(first, text.Length * sizeof(char));
        }

        // The edits of a cloud, and perhaps one more; null if there are none. Throws if they are damaged, another's, or for
        // attributes that it lacks. Not for a main thread.
        public static EditPlan Of(string path, CloudManifest manifest, EditOperation added = null)
        {
            var operations = EditJournal.Read(path, manifest.CloudId).Applied;
            if (added != null)
                operations.Add(added);
            foreach (var operation in operations)
                if (FindProblem(operation, manifest) is string problem)
                    throw new PointCloudException(FailureCode.Unsupported, path, -1, problem);
            return operations.Count > 0 ? new EditPlan(operations, manifest) : null;
        }

        // Those of a finished cloud; null too where they are refused: then it is shown as stored.
        public static EditPlan Of(CloudFolder folder, out PointCloudException refused, EditOperation draft = null)
        {
            refused = null;
            try
            {
                bool hasDraft = draft != null && FindProblem(draft, folder.Manifest) == null;
                return folder.IsUnfinished ? null : Of(folder.FolderPath, folder.Manifest, hasDraft ? draft : null);
            }
            catch (PointCloudException e)
            {
                refused = e;
                return null;
            }
        }

        public EditReaches Reaches { get; }

        // How many points of a node and its inlined leaves the last operation surely changes: none or all, or perhaps some.
        public EditReach ReachOf(in NodeRecord node)
        {
            var last = Last;
            if (!last.MayReach(EditShape.Of(node.Cube)))
                return EditReach.None;
            if (last.ChangedAttributes.Length > 0 || last.Conditions.Count > 0 || last.Prism.IsUsed)
                return EditReach.Some;
            var box = node.PlaneBlocks == node.BlockCount ? EditShape.OfPoints(node) : EditShape.Of(node.Cube);
            (box.A, box.B) = (Grid3.Max(box.A, Manifest.BoundsMin), Grid3.Min(box.B, Manifest.BoundsMax));
            m_before ??= new EditReaches(new List<EditOperation>(Operations).GetRange(0, Operations.Count - 1));
            int tries = int.MaxValue;
            return EditOperation.Reach(last.Boxes, box, EditReach.All) && EditOperation.Reach(last.Balls, box, EditReach.All) &&
                !m_before.Any(box, ref tries) ? EditReach.All : EditReach.Some;
        }

        // What keeps an operation from being applied to a cloud, or null.
        public static string FindProblem(EditOperation operation, CloudManifest manifest)
        {
            if (operation.CloudId is ulong id && id != manifest.CloudId)
                return "the edit is of another conversion of this cloud, or of a preview";
            foreach (string name in NamesOf(operation))
                if (AttributeNames.AxisOf(name) < 0 && !manifest.Attributes.Has(name))
                    return "the cloud has no " + name;
            foreach (var attribute in manifest.Attributes.Select(operation.ChangedAttributes))
                if (attribute.Type != AttributeType.UInt8 && attribute.Type != AttributeType.UInt16)
                    return "the cloud's " + attribute.Name + " is " + attribute.Type + ": wanted UInt8 or UInt16";
            return operation.FindProblem();
        }

        static List<string> NamesOf(EditOperation operation)
        {
            var names = new List<string>(operation.ChangedAttributes);
            foreach (var condition in operation.Conditions)
                foreach (var (left, right) in condition.Names)
                    names.AddRange(new[] { left, right });
            names.RemoveAll(name => name == null);
            return names;
        }

        // Colours of eight bits fill fields of 16, unless the cloud's do not.
        public int ScaleOf(EditOperation operation)
        {
            double max = 0;
            foreach (string name in operation.ChangedAttributes)
                max = Math.Max(max, Manifest.Ranges[Manifest.Attributes.IndexOf(name)].Max);
            bool isNarrow = operation.Action != EditAction.Color || max > 0 && max <= byte.MaxValue ||
                Manifest.Attributes[Manifest.Attributes.IndexOf(AttributeNames.Red)].Type == AttributeType.UInt8;
            return isNarrow ? 1 : 257;
        }
    }

    // Which boxes any of the operations may reach: a tree over the bounds of their balls, or else of their boxes, in the order in
    // which they were drawn, where neighbours follow one another. Operations that have neither are tried one by one.
    internal sealed class EditReaches
    {
        const int LeafLength = 4;

        readonly (EditShape Shape, EditOperation Of)[] m_shapes; // Those of a leaf follow one another.
        readonly EditShape[] m_bounds; // Node n's halves are 2 n + 1 and 2 n + 2.
        readonly List<EditOperation> m_others = new List<EditOperation>();

        public EditReaches(IReadOnlyList<EditOperation> operations)
        {
            var shapes = new List<(EditShape, EditOperation)>();
            foreach (var operation in operations)
            {
                var of = operation.Balls.Count > 0 ? operation.Balls : operation.Boxes;
                shapes.AddRange(of.ConvertAll(shape => (shape, operation)));
                if (of.Count == 0)
                    m_others.Add(operation);
            }
            m_shapes = shapes.ToArray();
            m_bounds = new EditShape[2 * math.ceilpow2((m_shapes.Length + LeafLength - 1) / LeafLength)];
            if (m_shapes.Length > 0)
                Build(0, 0, m_shapes.Length);
        }

        // Without garbage. So many prisms are tried; then it may be any box.
        public bool Any(in EditShape box, ref int tries)
        {
            if (m_shapes.Length > 0 && Any(box, 0, 0, m_shapes.Length))
                return true;
            foreach (var other in m_others)
                if (tries-- <= 0 || other.MaySee(box))
                    return true;
            return false;
        }

        bool Any(in EditShape box, int node, int from, int to)
        {
            if (m_bounds[node].ReachOf(box) == EditReach.None)
                return false;
            int half = (from + to) / 2;
            if (to - from > LeafLength)
                return Any(box, 2 * node + 1, from, half) || Any(box, 2 * node + 2, half, to);
            for (int s = from; s < to; s++)
            {
                var (shape, of) = m_shapes[s];
                if (shape.ReachOf(box) != EditReach.None && of.MaySee(box) &&
                    (!shape.IsBall || EditOperation.Reach(of.Boxes, box, EditReach.Some)))
                    return true;
            }
            return false;
        }

        void Build(int node, int from, int to)
        {
            var around = m_shapes[from].Shape.Bounds;
            for (int s = from + 1; s < to; s++)
            {
                var bounds = m_shapes[s].Shape.Bounds;
                (around.A, around.B) = (Grid3.Min(around.A, bounds.A), Grid3.Max(around.B, bounds.B));
            }
            m_bounds[node] = around;
            int half = (from + to) / 2;
            for (int child = 0; child < 2 && to - from > LeafLength; child++)
                Build(2 * node + 1 + child, child == 0 ? from : half, child == 0 ? half : to);
        }
    }

    internal sealed class EditSlot : IDisposable
    {
        const int BlocksPerSlice = 64;

        readonly EditPlan m_plan;
        readonly PointBatch m_block;
        EditNodeJob m_job;

        // For nodes with these planes, the position's first.
        public EditSlot(EditPlan plan, StoreLayout layout, IReadOnlyList<int> planes, int maxBlocks)
        {
            m_plan = plan;
            m_block = new PointBatch(plan.Schema, PlaneShape.MaxPointsPerBlock, Allocator.Persistent);
            Values = new PointBatch(plan.Changed, maxBlocks * PlaneShape.MaxPointsPerBlock, Allocator.Persistent);
            var steps = new List<EditStep>();
            var shapes = new List<EditShape>();
            var edges = new List<EditEdge>();
            var conditions = new List<FilterStep>();
            foreach (var operation in plan.Operations)
                steps.Add(StepOf(operation, shapes, edges, conditions));
            m_job = new EditNodeJob
            {
                Steps = Array(steps.ToArray()),
                Shapes = Array(shapes.ToArray()),
                Edges = Array(edges.ToArray()),
                Conditions = Array(conditions.ToArray()),
                Columns = Array(ColumnsOf(layout, planes)),
                Axes = Array(new[] { m_block.Column(0), m_block.Column(1), m_block.Column(2) }),
                Block = m_block.Bytes,
                Near = Array(new int[Math.Max(shapes.Count, edges.Count)]),
                EditedBlocks = Array(new EditedBlock[maxBlocks]),
                Values = Values.Bytes,
                Changed = Array(new long[steps.Count]),
            };
        }

        // By block, when the jobs are complete: its points as they are after the operations.
        public NativeArray<EditedBlock> EditedBlocks => m_job.EditedBlocks;

        // By block and point: the attributes that operations change. Undefined for blocks of which none did.
        public PointBatch Values { get; }

        // The job has the node.
        public JobHandle Schedule(EditNodeJob node, JobHandle inputDeps)
        {
            var job = m_job;
            (job.File, job.Planes, job.PlaneOffsets, job.PlaneShapes) =
                (node.File, node.Planes, node.PlaneOffsets, node.PlaneShapes);
            (job.Corner, job.BlockCount) = (node.Corner, node.BlockCount);
            for (job.First = 0; job.First < node.BlockCount; job.First = job.End)
            {
                job.End = Math.Min(node.BlockCount, job.First + BlocksPerSlice);
                inputDeps = job.Schedule(inputDeps);
            }
            return inputDeps;
        }

        // Adds to the plan's counts. Main thread, when the jobs are complete.
        public void Count()
        {
            for (int s = 0; s < m_job.Changed.Length; s++)
            {
                m_plan.PointsChanged[s] += m_job.Changed[s];
                m_job.Changed[s] = 0;
            }
        }

        public void Dispose()
        {
            if (!m_job.Steps.IsCreated)
                return;
            m_block.Dispose();
            Values.Dispose();
            m_job.Steps.Dispose();
            m_job.Shapes.Dispose();
            m_job.Edges.Dispose();
            m_job.Conditions.Dispose();
            m_job.Columns.Dispose();
            m_job.Axes.Dispose();
            m_job.Near.Dispose();
            m_job.EditedBlocks.Dispose();
            m_job.Changed.Dispose();
            m_job = default;
        }

        static NativeArray<T> Array<T>(T[] values) where T : unmanaged => new NativeArray<T>(values, Allocator.Persistent);

        EditStep StepOf(EditOperation operation, List<EditShape> shapes, List<EditEdge> edges, List<FilterStep> conditions)
        {
            var step = new EditStep
            {
                Action = operation.Action,
                FirstShape = shapes.Count,
                BoxCount = operation.Boxes.Count,
                BallCount = operation.Balls.Count,
                FirstEdge = edges.Count,
                Prism = operation.Prism,
                FirstCondition = conditions.Count,
                ChangeCount = operation.ChangedAttributes.Length,
            };
            shapes.AddRange(operation.Boxes);
            shapes.AddRange(operation.Balls);
            foreach (var (polygon, at) in operation.Rings)
                for (int i = 0; i < at.Length; i += 2)
                    edges.Add(new EditEdge
                    {
                        FromU = at[i],
                        FromV = at[i + 1],
                        ToU = at[(i + 2) % at.Length],
                        ToV = at[(i + 3) % at.Length],
                        Polygon = polygon,
                    });
            conditions.AddRange(FilterSteps.Of(operation.Conditions, m_block, new PositionTransform
            {
                Scale = m_plan.Manifest.Grid.Step,
                Offset = m_plan.Manifest.Grid.Origin,
            }));
            for (int c = 0; c < step.ChangeCount; c++)
            {
                step.Columns[c] = m_plan.Schema.IndexOf(operation.ChangedAttributes[c]) - 3;
                step.Values[c] = operation.Value[c] * m_plan.ScaleOf(operation);
            }
            (step.EdgeCount, step.ConditionCount) = (edges.Count - step.FirstEdge, conditions.Count - step.FirstCondition);
            return step;
        }

        EditColumn[] ColumnsOf(StoreLayout layout, IReadOnlyList<int> planes)
        {
            var columns = new EditColumn[m_plan.Schema.Count - 3];
            for (int n = 1; n < planes.Count; n++)
            {
                var plane = layout.Planes[planes[n]];
                for (int c = 0; c < plane.ColumnCount; c++)
                {
                    string name = layout.NameOfColumn(plane, plane.FirstColumn + c);
                    int column = m_plan.Schema.IndexOf(name), changed = Values.Schema.IndexOf(name);
                    if (column >= 0)
                        columns[column - 3] = new EditColumn
                        {
                            Plane = n,
                            Column = c,
                            Stored = layout.Columns[plane.FirstColumn + c],
                            Block = m_block.Column(column),
                            IsChanged = changed >= 0,
                            Values = changed >= 0 ? Values.Column(changed) : default,
                        };
                }
            }
            return columns;
        }
    }
}
