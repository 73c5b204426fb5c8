using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Store
{
    // Operations on one cloud: what is read of its nodes for them, and what they change.
    internal sealed class EditPlan
    {
        readonly List<string> m_changed = new List<string>();
        readonly EditShape[] m_bounds; // Of each operation's balls, or else of its boxes.

        public EditPlan(IReadOnlyList<EditOperation> operations, CloudManifest manifest)
        {
            Operations = operations;
            Manifest = manifest;
            PointsChanged = new long[operations.Count];
            m_bounds = new EditShape[operations.Count];
            for (int i = 0; i < m_bounds.Length; i++)
                m_bounds[i] = EditShape.Around(operations[i].Balls.Count > 0 ? operations[i].Balls : operations[i].Boxes);
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
        public CloudManifest Manifest { get; }

        // The position in whole steps, and the attributes that operations read or change.
        public PointSchema Schema { get; }

        public PointSchema Changed => Manifest.Attributes.Select(m_changed.ToArray());

        // By operation, of all nodes whose slots have ended. Points that were deleted before do not count.
        public long[] PointsChanged { get; }

        // Differs between plans that make different points.
        public unsafe ulong Hash
        {
            get
            {
                string text = string.Concat(new List<EditOperation>(Operations).ConvertAll(o => o.ToJson()));
                fixed (char* first = text)
                    return ContentHash.Of(first, text.Length * sizeof(char));
            }
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

        // Whether the last operation may change points of a cube.
        public bool MayReach(GridCube cube) => Operations[Operations.Count - 1].MayReach(BoxOf(cube));

        // Whether any operation may.
        public bool MayReachAny(GridCube cube)
        {
            var box = BoxOf(cube);
            for (int i = 0; i < m_bounds.Length; i++)
                if (m_bounds[i].ReachOf(box) != EditReach.None && Operations[i].MayReach(box))
                    return true;
            return false;
        }

        static EditShape BoxOf(GridCube cube)
        {
            long last = cube.Side - 1;
            return new EditShape { A = cube.Corner, B = cube.Corner + new Grid3(last, last, last) };
        }

        // What keeps an operation from being applied to a cloud, or null.
        public static string FindProblem(EditOperation operation, CloudManifest manifest)
        {
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

    // The edits of one node in flight.
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
                Points = Array(new EditedBlock[maxBlocks]),
                Values = Values.Bytes,
                Changed = Array(new long[steps.Count]),
            };
        }

        // By block, when the jobs are complete: its points as they are after the operations.
        public NativeArray<EditedBlock> Points => m_job.Points;

        // By block and point: the attributes that operations change. Undefined for blocks of which none did.
        public PointBatch Values { get; }

        // The job has the node.
        public JobHandle Schedule(EditNodeJob node, JobHandle inputDeps)
        {
            var job = m_job;
            (job.File, job.Planes, job.Places, job.PlaneShapes) = (node.File, node.Planes, node.Places, node.PlaneShapes);
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
            m_job.Points.Dispose();
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
