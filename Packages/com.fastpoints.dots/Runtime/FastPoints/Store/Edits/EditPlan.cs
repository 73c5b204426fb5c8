using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Store
{
    // Operations on one cloud, as jobs apply them to its nodes. It outlives its slots.
    internal sealed class EditPlan : IDisposable
    {
        readonly List<string> m_changed = new List<string>();
        readonly CloudManifest m_manifest;
        readonly IReadOnlyList<EditOperation> m_operations;
        NativeArray<EditStep> m_steps;
        NativeArray<EditBox> m_boxes;
        NativeArray<EditBall> m_balls;
        NativeArray<EditEdge> m_edges;

        public EditPlan(IReadOnlyList<EditOperation> operations, CloudManifest manifest)
        {
            m_operations = operations;
            m_manifest = manifest;
            PointsChanged = new long[operations.Count];
            var names = new List<string> { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            foreach (var operation in operations)
            {
                foreach (string name in operation.ChangedAttributes)
                    AddOnce(m_changed, name);
                foreach (var condition in operation.Conditions)
                    foreach (var (left, right) in condition.Names)
                    {
                        AddOnce(names, left);
                        AddOnce(names, right);
                    }
            }
            foreach (string name in m_changed)
                AddOnce(names, name);
            Schema = SchemaOf(names);
            var steps = new List<EditStep>();
            var boxes = new List<EditBox>();
            var balls = new List<EditBall>();
            var edges = new List<EditEdge>();
            foreach (var operation in operations)
            {
                steps.Add(StepOf(operation, boxes.Count, balls.Count, edges.Count));
                boxes.AddRange(operation.Boxes);
                balls.AddRange(operation.Balls);
                AddEdges(operation, edges);
                LongestList = Math.Max(LongestList, Math.Max(operation.Boxes.Count, operation.Balls.Count));
            }
            LongestList = Math.Max(LongestList, edges.Count);
            m_steps = new NativeArray<EditStep>(steps.ToArray(), Allocator.Persistent);
            m_boxes = new NativeArray<EditBox>(boxes.ToArray(), Allocator.Persistent);
            m_balls = new NativeArray<EditBall>(balls.ToArray(), Allocator.Persistent);
            m_edges = new NativeArray<EditEdge>(edges.ToArray(), Allocator.Persistent);
        }

        // The position in whole steps, and the attributes that operations read or change.
        public PointSchema Schema { get; }

        public IReadOnlyList<string> Changed => m_changed;

        // By operation, of all nodes whose slots have ended. Points that were deleted before do not count.
        public long[] PointsChanged { get; }

        // Differs between plans that make different points.
        public unsafe ulong Hash
        {
            get
            {
                ulong hash = 1;
                foreach (var operation in m_operations)
                    fixed (char* text = operation.ToJson())
                        hash = hash * 31 ^ ContentHash.Of(text, operation.ToJson().Length * sizeof(char));
                return hash;
            }
        }

        public void Dispose()
        {
            if (!m_steps.IsCreated)
                return;
            m_steps.Dispose();
            m_boxes.Dispose();
            m_balls.Dispose();
            m_edges.Dispose();
        }

        // What keeps an operation from being applied to a cloud, or null.
        public static string FindProblem(EditOperation operation, CloudManifest manifest)
        {
            foreach (string name in operation.ChangedAttributes)
            {
                int attribute = manifest.Attributes.IndexOf(name);
                if (attribute < 0)
                    return "the cloud has no " + name;
                var type = manifest.Attributes[attribute].Type;
                if (type != AttributeType.UInt8 && type != AttributeType.UInt16)
                    return "the cloud's " + name + " is " + type + ": wanted UInt8 or UInt16";
            }
            foreach (var condition in operation.Conditions)
                foreach (var (left, right) in condition.Names)
                    foreach (string name in new[] { left, right })
                        if (name != null && AttributeNames.AxisOf(name) < 0 && !manifest.Attributes.Has(name))
                            return "the cloud has no " + name;
            return operation.FindProblem();
        }

        // Whether an operation may change points of a cube.
        public bool MayReach(int operation, GridCube cube)
        {
            long last = cube.Side - 1;
            return m_operations[operation].MayReach(new EditBox
            {
                Min = cube.Corner,
                Max = cube.Corner + new Grid3(last, last, last),
            });
        }

        public EditSlot CreateSlot(StoreLayout layout, IReadOnlyList<int> planes, int maxBlocks) => new EditSlot(this,
            new EditNodeJob { Steps = m_steps, Boxes = m_boxes, Balls = m_balls, Edges = m_edges }, layout, planes, maxBlocks);

        internal PositionTransform Transform =>
            new PositionTransform { Scale = m_manifest.Grid.Step, Offset = m_manifest.Grid.Origin };

        internal IReadOnlyList<EditOperation> Operations => m_operations;

        internal int LongestList { get; }

        static void AddOnce(List<string> names, string name)
        {
            if (name != null && !names.Contains(name))
                names.Add(name);
        }

        PointSchema SchemaOf(List<string> names)
        {
            var attributes = new List<PointAttribute>();
            for (int i = 0; i < names.Count; i++)
                attributes.Add(i < 3 ? new PointAttribute(names[i], AttributeType.Int64)
                    : m_manifest.Attributes[m_manifest.Attributes.IndexOf(names[i])]);
            return new PointSchema(attributes);
        }

        EditStep StepOf(EditOperation operation, int firstBox, int firstBall, int firstEdge)
        {
            int edges = 0;
            foreach (var (_, vertices) in operation.Rings)
                edges += vertices.Length / 2;
            var step = new EditStep
            {
                Action = operation.Action,
                FirstBox = firstBox,
                BoxCount = operation.Boxes.Count,
                FirstBall = firstBall,
                BallCount = operation.Balls.Count,
                FirstEdge = firstEdge,
                EdgeCount = edges,
                Prism = operation.Prism,
            };
            foreach (string name in operation.ChangedAttributes)
            {
                int value = name == AttributeNames.Red ? operation.Red : name == AttributeNames.Green ? operation.Green
                    : name == AttributeNames.Blue ? operation.Blue : operation.Class;
                step.Add(Schema.IndexOf(name) - 3, operation.Action == EditAction.Color ? value * ScaleOfColors : value);
            }
            return step;
        }

        // Colours of eight bits fill fields of 16, unless the cloud's do not.
        int ScaleOfColors
        {
            get
            {
                double max = 0;
                foreach (string name in new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue })
                    max = Math.Max(max, m_manifest.Ranges[m_manifest.Attributes.IndexOf(name)].Max);
                int red = m_manifest.Attributes.IndexOf(AttributeNames.Red);
                return m_manifest.Attributes[red].Type == AttributeType.UInt8 || max > 0 && max <= byte.MaxValue ? 1 : 257;
            }
        }

        static void AddEdges(EditOperation operation, List<EditEdge> edges)
        {
            foreach (var (polygon, at) in operation.Rings)
                for (int i = 0; i + 1 < at.Length; i += 2)
                {
                    int next = (i + 2) % at.Length;
                    edges.Add(new EditEdge
                    {
                        FromU = at[i],
                        FromV = at[i + 1],
                        ToU = at[next],
                        ToV = at[next + 1],
                        Polygon = polygon,
                    });
                }
        }
    }

    // Memory for the edits of one node in flight.
    internal sealed class EditSlot : IDisposable
    {
        // Points of a slice are as many as those of other jobs on columns.
        const int BlocksPerSlice = 64;

        readonly EditPlan m_plan;
        readonly PointBatch m_block;
        EditNodeJob m_job;

        internal EditSlot(EditPlan plan, EditNodeJob job, StoreLayout layout, IReadOnlyList<int> planes, int maxBlocks)
        {
            m_plan = plan;
            m_block = new PointBatch(plan.Schema, PlaneShape.MaxPointsPerBlock, Allocator.Persistent);
            Values = new PointBatch(plan.Schema.Select(Names(plan.Changed)), maxBlocks * PlaneShape.MaxPointsPerBlock,
                Allocator.Persistent);
            var steps = new NativeArray<EditStep>(job.Steps.Length, Allocator.Persistent);
            var conditions = new List<FilterStep>();
            for (int s = 0; s < steps.Length; s++)
            {
                var step = job.Steps[s];
                var bound = FilterSteps.Of(plan.Operations[s].Conditions, m_block, plan.Transform);
                (step.FirstCondition, step.ConditionCount) = (conditions.Count, bound.Length);
                conditions.AddRange(bound);
                steps[s] = step;
            }
            job.Steps = steps;
            job.Conditions = new NativeArray<FilterStep>(conditions.ToArray(), Allocator.Persistent);
            job.Columns = new NativeArray<EditColumn>(ColumnsOf(layout, planes), Allocator.Persistent);
            job.X = m_block.Column(0);
            job.Y = m_block.Column(1);
            job.Z = m_block.Column(2);
            job.Block = m_block.Bytes;
            job.Values = Values.Bytes;
            job.Near = new NativeArray<int>(plan.LongestList, Allocator.Persistent);
            job.Points = new NativeArray<EditedBlock>(maxBlocks, Allocator.Persistent);
            job.Changed = new NativeArray<long>(steps.Length, Allocator.Persistent);
            m_job = job;
        }

        // By block, when the jobs are complete: its points as they are after the operations.
        public NativeArray<EditedBlock> Points => m_job.Points;

        // By block and point: the attributes that operations change. Undefined for blocks of which none did.
        public PointBatch Values { get; }

        // The node's planes, as the slot was made for.
        public JobHandle Schedule(in EditNode node, JobHandle inputDeps)
        {
            var job = m_job;
            job.File = node.File;
            job.Ranges = node.Ranges;
            job.Places = node.Places;
            job.Shapes = node.Shapes;
            job.Corner = node.Corner;
            job.BlockCount = node.BlockCount;
            for (job.First = 0; job.First < node.BlockCount; job.First += BlocksPerSlice)
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
            if (!m_block.IsCreated)
                return;
            m_block.Dispose();
            Values.Dispose();
            m_job.Steps.Dispose();
            m_job.Conditions.Dispose();
            m_job.Columns.Dispose();
            m_job.Near.Dispose();
            m_job.Points.Dispose();
            m_job.Changed.Dispose();
        }

        static string[] Names(IReadOnlyList<string> names) => new List<string>(names).ToArray();

        EditColumn[] ColumnsOf(StoreLayout layout, IReadOnlyList<int> planes)
        {
            var columns = new EditColumn[m_plan.Schema.Count - 3];
            for (int n = 0; n < planes.Count; n++)
            {
                var plane = layout.Planes[planes[n]];
                for (int c = 0; c < plane.ColumnCount && planes[n] != StoreLayout.PositionPlane; c++)
                {
                    int column = m_plan.Schema.IndexOf(layout.NameOfColumn(plane, plane.FirstColumn + c));
                    if (column < 3)
                        continue;
                    int changed = Values.Schema.IndexOf(m_plan.Schema[column].Name);
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

    // The planes of a node in memory: the position's first.
    internal struct EditNode
    {
        public NativeArray<byte> File;
        public NativeArray<PlaneRange> Ranges;

        // Where each lies in the memory.
        public NativeArray<long> Places;
        public NativeArray<PlaneShape> Shapes;
        public Grid3 Corner;
        public int BlockCount;
    }
}
