using System;
using System.Collections.Generic;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Store
{
    internal static class LoadNodes
    {
        /// <summary>The most bytes of a file that are read at once, unless the planes of one node lie farther apart. The nodes of
        /// a few points may be scattered over a file.</summary>
        public const long MaxBytesPerRead = 4 << 20;

        const int PartsInFlight = 4;
        const int RemotePartsInFlight = 24; // Those of a web server wait for it, not for a disk.

        /// <summary>The schema of the batch: positions, and those of the wanted attributes that the cloud has.</summary>
        public static PointSchema SchemaFor(CloudFolder folder, params string[] wanted)
        {
            var attributes = new List<PointAttribute>(PositionColumns.Attributes(AttributeType.Float64));
            attributes.AddRange(folder.Manifest.Attributes.Select(wanted));
            return new PointSchema(attributes);
        }

        /// <summary>The same with the two columns of the cloud's normals, if it has some.</summary>
        public static PointSchema WithNormals(PointSchema schema, CloudFolder folder)
        {
            var attributes = new List<PointAttribute>(schema);
            foreach (string column in StoreLayout.NormalColumns)
                if (folder.Layout.ComputedPlaneCount > 0)
                    attributes.Add(new PointAttribute(column, AttributeType.UInt8));
            return new PointSchema(attributes);
        }

        /// <summary>Reads the nodes as a coroutine. Positions come as grid steps from the root's corner: see
        /// <see cref="CloudGrid.TransformFromCorner"/>.</summary>
        /// <param name="batch">A batch with the schema of <see cref="SchemaFor"/> and capacity for all points of the
        /// selection.</param>
        /// <exception cref="PointCloudException">A file cannot be read, or a node is damaged.</exception>
        public static IEnumerator<JobStep> Run(CloudFolder folder, CloudSelection selection, PointBatch batch,
            StageProgress progress, long maxBytes = MaxBytesPerRead)
        {
            yield return JobStep.Of(Run(folder, selection, batch, progress, maxBytes, false));
            // They lie in files of their own.
            if (batch.Schema.Has(StoreLayout.NormalColumns[0]))
                yield return JobStep.Of(Run(folder, selection, batch, null, maxBytes, true));
        }

        static IEnumerator<JobStep> Run(CloudFolder folder, CloudSelection selection, PointBatch batch,
            StageProgress progress, long maxBytes, bool isComputed)
        {
            var fetched = new Queue<(PageLoad Load, int Segment, StoreRead Read)>();
            var inFlight = new Queue<(PageLoad Load, int Segment, StoreRead Read, JobHandle Decoded)>();
            int max = folder.RemoteOfTable(0) != null ? RemotePartsInFlight : PartsInFlight;
            var loads = new List<PageLoad>();
            var decoded = default(JobHandle);

            bool TryScheduleFetched()
            {
                while (fetched.Count > 0 && fetched.Peek().Read.IsFetched)
                {
                    var (load, segment, read) = fetched.Dequeue();
                    decoded = load.Schedule(segment, read.Bytes, JobHandle.CombineDependencies(decoded, read.Done));
                    inFlight.Enqueue((load, segment, read, decoded));
                }
                return inFlight.Count > 0;
            }

            try
            {
                int points = 0;
                foreach (int page in selection.Pages)
                {
                    var load = new PageLoad(selection, page, batch, points, maxBytes, isComputed);
                    loads.Add(load);
                    points += load.Points;
                    for (int segment = 0; segment < load.Segments.Count; segment++)
                    {
                        StoreRead read = null;
                        if (inFlight.Count + fetched.Count == max)
                        {
                            while (!TryScheduleFetched())
                                yield return default;
                            yield return inFlight.Peek().Decoded;
                            read = Complete(inFlight, selection, progress);
                        }
                        read ??= new StoreRead();
                        load.Begin(segment, read);
                        fetched.Enqueue((load, segment, read));
                        TryScheduleFetched();
                    }
                }
                while (inFlight.Count + fetched.Count > 0)
                {
                    while (!TryScheduleFetched())
                        yield return default;
                    yield return inFlight.Peek().Decoded;
                    Complete(inFlight, selection, progress).Dispose();
                }
                batch.Count = points;
            }
            finally
            {
                decoded.Complete();
                foreach (var left in fetched)
                    left.Read.Dispose();
                foreach (var left in inFlight)
                    left.Read.Dispose();
                foreach (var load in loads)
                    load.Dispose();
            }
        }

        /// <summary>Ends the oldest segment.</summary>
        /// <returns>Its read, which is free.</returns>
        static StoreRead Complete(Queue<(PageLoad Load, int Segment, StoreRead Read, JobHandle Decoded)> inFlight,
            CloudSelection selection, StageProgress progress)
        {
            // It stays in the queue, whose reads are disposed, until it has been checked.
            var (load, segment, read, decoded) = inFlight.Peek();
            decoded.Complete();
            read.Complete();
            load.Check(segment);
            inFlight.Dequeue();
            if (segment == load.Segments.Count - 1)
            {
                load.Dispose();
                progress?.Report(load.EndPoint / (double)Math.Max(1, selection.Points), load.EndPoint, 0);
            }
            return read;
        }

        struct Segment
        {
            public int FirstNode;
            public int NodeCount;
            public long FirstByte;
            public long ByteCount;
        }

        sealed class PageLoad : IDisposable
        {
            readonly CloudSelection m_selection;
            readonly int m_page;
            readonly PointBatch m_batch;
            readonly bool m_isComputed; // Reads planes that were computed, else positions and those of the source.
            readonly int[] m_order; // Index among the chosen nodes, in the order of their bytes.
            NativeArray<ChosenNode> m_nodes;
            NativeArray<PlaneRange> m_ranges;
            NativeArray<PlaneShape> m_shapes;
            NativeArray<StoredColumn> m_columns;
            NativeArray<PointColumn> m_targets;

            readonly NativeArray<bool>[] m_isDamaged;

            public PageLoad(CloudSelection selection, int page, PointBatch batch, int firstPoint, long maxBytes, bool isComputed)
            {
                var folder = selection.Folder;
                m_isComputed = isComputed;
                m_selection = selection;
                m_page = page;
                m_batch = batch;
                var planes = ListPlanes(folder.Layout);
                var table = selection.TableOf(page);
                var chosen = selection.NodesOf(page);
                var nodes = new ChosenNode[chosen.Count];
                var ranges = new PlaneRange[chosen.Count * planes.Count];
                var begins = new long[nodes.Length];
                var ends = new long[nodes.Length];
                for (int i = 0; i < nodes.Length; i++)
                {
                    begins[i] = long.MaxValue;
                    var node = table.Nodes[chosen[i]];
                    var planeNode = table.Nodes[node.PlaneNode];
                    nodes[i] = new ChosenNode
                    {
                        FirstBlock = node.FirstBlock,
                        BlockCount = node.BlockCount,
                        PlaneBlocks = planeNode.PlaneBlocks,
                        IsWide = planeNode.IsWide,
                        Corner = planeNode.Corner - folder.Manifest.Root.Corner,
                        FirstPoint = firstPoint + Points,
                        FirstRange = i * planes.Count,
                    };
                    Points += node.PointCount;
                    // Points that represent others show their average, which has the same shape and types.
                    bool isRefined = selection.IsRefined(page, chosen[i]);
                    for (int p = 0; p < planes.Count; p++)
                    {
                        int average = isRefined ? -1 : folder.Layout.AveragePlaneOf(planes[p]);
                        var range = table.PlaneRanges[node.PlaneNode * table.PlaneCount + (average >= 0 ? average : planes[p])];
                        ranges[i * planes.Count + p] = range;
                        begins[i] = Math.Min(begins[i], range.OffsetBytes);
                        ends[i] = Math.Max(ends[i], range.OffsetBytes + range.LengthBytes);
                    }
                }
                EndPoint = firstPoint + Points;
                m_order = new int[nodes.Length];
                for (int i = 0; i < m_order.Length; i++)
                    m_order[i] = i;
                Array.Sort(m_order, (a, b) => begins[a].CompareTo(begins[b]));
                Segments = Cut(m_order, begins, ends, maxBytes);
                m_nodes = new NativeArray<ChosenNode>(Array.ConvertAll(m_order, i => nodes[i]), Allocator.Persistent);
                m_ranges = new NativeArray<PlaneRange>(ranges, Allocator.Persistent);
                m_isDamaged = new NativeArray<bool>[Segments.Count];
            }

            // Those whose attributes are all in the batch, and the positions; or those that were computed.
            List<int> ListPlanes(StoreLayout layout)
            {
                var planes = new List<int>();
                var shapes = new List<PlaneShape>();
                if (!m_isComputed)
                    planes.Add(StoreLayout.PositionPlane);
                var columns = new List<StoredColumn>();
                var targets = new List<PointColumn>();
                for (int p = 1; p < layout.Planes.Count; p++)
                {
                    var plane = layout.Planes[p];
                    if (m_isComputed ? !plane.IsComputed : !plane.IsSource)
                        continue;
                    int first = targets.Count;
                    for (int c = plane.FirstColumn; c < plane.FirstColumn + plane.ColumnCount; c++)
                    {
                        int column = m_batch.Schema.IndexOf(layout.NameOfColumn(plane, c));
                        if (column >= 0)
                            targets.Add(m_batch.Column(column));
                    }
                    if (targets.Count - first < plane.ColumnCount)
                    {
                        targets.RemoveRange(first, targets.Count - first);
                        continue;
                    }
                    planes.Add(p);
                    shapes.Add(plane.Shape);
                    for (int c = plane.FirstColumn; c < plane.FirstColumn + plane.ColumnCount; c++)
                        columns.Add(layout.Columns[c]);
                }
                m_shapes = new NativeArray<PlaneShape>(shapes.ToArray(), Allocator.Persistent);
                m_columns = new NativeArray<StoredColumn>(columns.ToArray(), Allocator.Persistent);
                m_targets = new NativeArray<PointColumn>(targets.ToArray(), Allocator.Persistent);
                return planes;
            }

            public List<Segment> Segments { get; }
            public int Points { get; }

            public int EndPoint { get; }

            public void Begin(int number, StoreRead read)
            {
                var segment = Segments[number];
                var remote = m_selection.RemoteOf(m_page, m_isComputed);
                if (remote == null)
                {
                    read.Begin(m_selection.PathOf(m_page, m_isComputed), segment.FirstByte, segment.ByteCount);
                    return;
                }
                // What lies between the planes stays on the server.
                var pieces = new List<PlaneRange>();
                int planes = (m_isComputed ? 0 : 1) + m_shapes.Length;
                for (int i = segment.FirstNode; i < segment.FirstNode + segment.NodeCount; i++)
                    for (int p = 0; p < planes; p++)
                        pieces.Add(m_ranges[m_nodes[i].FirstRange + p]);
                read.Begin(remote, segment.FirstByte, segment.ByteCount, pieces);
            }

            public JobHandle Schedule(int number, NativeArray<byte> bytes, JobHandle inputDeps)
            {
                var segment = Segments[number];
                m_isDamaged[number] = new NativeArray<bool>(segment.NodeCount, Allocator.Persistent);
                return new DecodeNodesJob
                {
                    File = bytes,
                    FileOffset = segment.FirstByte,
                    FirstPlane = m_isComputed ? 1 : 0,
                    Nodes = m_nodes.GetSubArray(segment.FirstNode, segment.NodeCount),
                    Ranges = m_ranges,
                    Shapes = m_shapes,
                    Columns = m_columns,
                    Targets = m_targets,
                    Positions = PositionColumns.Of(m_batch),
                    Batch = m_batch.Bytes,
                    IsDamaged = m_isDamaged[number],
                }.Schedule(segment.NodeCount, 1, inputDeps);
            }

            /// <exception cref="PointCloudException">A node of the segment is damaged.</exception>
            public void Check(int number)
            {
                var segment = Segments[number];
                for (int i = 0; i < segment.NodeCount; i++)
                    if (m_isDamaged[number][i])
                        throw new PointCloudException(FailureCode.BadInput, m_selection.PathOf(m_page, m_isComputed),
                            m_ranges[m_nodes[segment.FirstNode + i].FirstRange].OffsetBytes,
                            "node " + m_selection.NodesOf(m_page)[m_order[segment.FirstNode + i]] + " is damaged");
            }

            public void Dispose()
            {
                if (!m_nodes.IsCreated)
                    return;
                m_nodes.Dispose();
                m_ranges.Dispose();
                m_shapes.Dispose();
                m_columns.Dispose();
                m_targets.Dispose();
                foreach (var isDamaged in m_isDamaged)
                    if (isDamaged.IsCreated)
                        isDamaged.Dispose();
            }

            static List<Segment> Cut(int[] order, long[] begins, long[] ends, long maxBytes)
            {
                var segments = new List<Segment>();
                for (int i = 0; i < order.Length; i++)
                {
                    long begin = begins[order[i]], end = ends[order[i]];
                    var segment = segments.Count > 0 ? segments[segments.Count - 1] : default;
                    // A node whose planes lie apart would have what is between them read again.
                    bool isFar = end - (segment.FirstByte + segment.ByteCount) > (end - begin) / 2;
                    if (segments.Count == 0 || (isFar && end > segment.FirstByte + Math.Max(segment.ByteCount, maxBytes)))
                        segments.Add(segment = new Segment { FirstNode = i, FirstByte = begin });
                    segment.NodeCount++;
                    segment.ByteCount = Math.Max(segment.ByteCount, end - segment.FirstByte);
                    segments[segments.Count - 1] = segment;
                }
                return segments;
            }
        }
    }

    /// <summary>Unpacks chosen nodes into a batch: positions as doubles in grid steps from the batch's corner, attributes as they
    /// are. Planes are checked before they are read; a damaged node is marked and not unpacked.</summary>
    [BurstCompile]
    internal unsafe struct DecodeNodesJob : IJobParallelFor
    {
        [ReadOnly] public NativeArray<byte> File;

        public long FileOffset;
        public int FirstPlane; // 1 where positions are not unpacked.
        [ReadOnly] public NativeArray<ChosenNode> Nodes;

        /// <summary>Indexed by node times planes, plus plane: position first if there, then the wanted ones.</summary>
        [ReadOnly] public NativeArray<PlaneRange> Ranges;
        [ReadOnly] public NativeArray<PlaneShape> Shapes; // Indexed by wanted plane, without the position.
        [ReadOnly] public NativeArray<StoredColumn> Columns; // Indexed by column of the wanted planes.

        /// <summary>Where the values of each column of the wanted planes go in the batch.</summary>
        [ReadOnly] public NativeArray<PointColumn> Targets;
        public PositionColumns Positions;

        /// <summary>The batch; each node has its own part of every column.</summary>
        [NativeDisableParallelForRestriction] public NativeArray<byte> Batch;

        public NativeArray<bool> IsDamaged;

        public void Execute(int index)
        {
            var node = Nodes[index];
            var file = (byte*)File.GetUnsafeReadOnlyPtr();
            for (int p = FirstPlane; p <= Shapes.Length; p++)
            {
                var range = RangeOf(node, p);
                byte* plane = file + (range.OffsetBytes - FileOffset);
                if (ContentHash.Of(plane, range.LengthBytes) != range.Hash ||
                    !PlaneView.IsValid(plane, range.LengthBytes, ShapeOf(p, node.IsWide), node.PlaneBlocks))
                {
                    IsDamaged[index] = true;
                    return;
                }
            }
            if (FirstPlane == 0)
                WritePositions(node, file);
            int column = 0;
            for (int p = 1; p <= Shapes.Length; p++)
                for (int c = 0; c < Shapes[p - 1].ColumnCount; c++)
                    WriteColumn(node, file, p, c, Columns[column], Targets[column++]);
        }

        PlaneRange RangeOf(in ChosenNode node, int plane) => Ranges[node.FirstRange + plane - FirstPlane];

        PlaneShape ShapeOf(int plane, bool isWide) => plane == 0 ? PlaneShape.OfPositions(isWide) : Shapes[plane - 1];

        PlaneView ViewOf(in ChosenNode node, byte* file, int plane) =>
            new PlaneView(file + (RangeOf(node, plane).OffsetBytes - FileOffset), ShapeOf(plane, node.IsWide),
                node.PlaneBlocks);

        void WritePositions(in ChosenNode node, byte* file)
        {
            var batch = (byte*)Batch.GetUnsafePtr();
            var plane = ViewOf(node, file, 0);
            ulong* values = stackalloc ulong[PlaneShape.MaxPointsPerBlock];
            for (int axis = 0; axis < 3; axis++)
            {
                var column = axis == 0 ? Positions.X : axis == 1 ? Positions.Y : Positions.Z;
                var to = (double*)column.At(batch, node.FirstPoint);
                long corner = axis == 0 ? node.Corner.X : axis == 1 ? node.Corner.Y : node.Corner.Z;
                for (int b = node.FirstBlock; b < node.FirstBlock + node.BlockCount; b++)
                {
                    int count = plane.PointsOf(b);
                    plane.UnpackWide(b, axis, values);
                    for (int i = 0; i < count; i++)
                        to[i] = corner + (long)values[i];
                    to += count;
                }
            }
        }

        void WriteColumn(in ChosenNode node, byte* file, int planeIndex, int columnInPlane, in StoredColumn column,
            PointColumn target)
        {
            var plane = ViewOf(node, file, planeIndex);
            int size = target.Type.SizeOf();
            byte* to = (byte*)Batch.GetUnsafePtr() + target.OffsetBytes + (long)node.FirstPoint * size;
            ulong* values = stackalloc ulong[PlaneShape.MaxPointsPerBlock];
            for (int b = node.FirstBlock; b < node.FirstBlock + node.BlockCount; b++)
            {
                int count = plane.PointsOf(b);
                plane.UnpackWide(b, columnInPlane, values);
                for (int i = 0; i < count; i++, to += size)
                    OrderedBits.Store(values[i] * (ulong)column.Divisor, column.Type, to);
            }
        }
    }

    /// <summary>One node to decode: where its blocks lie in a file's bytes, and where its points go. Blittable.</summary>
    internal struct ChosenNode
    {
        public int FirstBlock;
        public int BlockCount;
        public int PlaneBlocks;
        public bool IsWide;
        public Grid3 Corner; // The corner that its positions count from, relative to the batch's corner.

        public int FirstPoint;
        public int FirstRange; // Index of its first plane among the job's ranges.
    }
}
