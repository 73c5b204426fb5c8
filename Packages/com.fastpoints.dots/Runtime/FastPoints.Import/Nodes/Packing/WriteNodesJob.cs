using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;
using Stage = FastPoints.Nodes.WriteScratch.Stage;

namespace FastPoints.Nodes
{
    /// <summary>Writes the file of a chunk or of the upper levels in memory: position and colour of every node, so that one read
    /// gets what siblings show, then their other planes, then the table. A chunk's top node is not written: its points go to the
    /// merge of the upper levels.</summary>
    /// <remarks>A run is a slice: it goes on where the last one ended. A plane of a node is written in one slice.</remarks>
    [BurstCompile]
    internal unsafe struct WriteNodesJob : IJob
    {
        public const int CostOfSlice = 500000; // A slice takes about 2 ms.

        const int CostOfPosition = 4;
        const int CostOfAverage = 16;
        const int BytesPerCost = 8; // Copied to pages that are new, these take as long as a value.

        public const int InlinedLeafPoints = PlaneShape.MaxPointsPerBlock;

        public int Count;
        public RecordLayout Layout;

        public Grid3 Corner;
        public ulong CloudId;
        public ContainerRecord Container; // What the file is; the job adds its size and hash.
        public bool OmitsTop; // Whether the first node goes to Top instead of the file.
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<int> NodeOfPoint;
        [ReadOnly] public NativeList<NodeDraft> Drafts;
        [ReadOnly] public NativeArray<StoredColumn> Columns;

        /// <summary>For each attribute plane, the first of its columns, and one more entry.</summary>
        [ReadOnly] public NativeArray<int> FirstColumnOfPlane;

        [ReadOnly] public NativeArray<PlaneShape> Shapes;

        /// <summary>For each attribute plane, the one whose values it averages, or a negative number.</summary>
        [ReadOnly] public NativeArray<int> AverageOf;
        public int ColorPlane; // The attribute plane that lies with the positions, or a negative number.
        [ReadOnly] public AveragedColumns Averaged; // The points as the sampler left them.
        public NativeArray<uint> Points; // Scratch: points, grouped by draft.
        public WriteScratch Scratch; // Its WriteScratch.Progress is reset before the first slice.
        public int CostPerSlice; // About this many values are written in one slice; grouping a point costs as much as one.
        public NativeList<byte> File; // Out: the container. Empty if a chunk has no node except its top.
        public NativeList<byte> Table; // Out: the nodes, then their planes' ranges.
        public NativeList<byte> Top; // Out: the top's points as records, in order.
        public NativeList<int> NodeOfDraft; // Out: the table index of each draft, or -1.
        public NativeArray<long> BytesOfPlane; // Out: bytes of each plane, position first.

        [NativeDisableUnsafePtrRestriction] NodeDraft* m_drafts;
        [NativeDisableUnsafePtrRestriction] uint* m_points;
        PlanePacker m_packer;
        WriteScratch.State m_state;
        long m_budget;

        public SliceTimes SliceTimes;

        public void Execute()
        {
            if (Scratch.IsDone)
                return;
            long begin = SliceTimes.Begin();
            Run();
            SliceTimes.End(begin);
        }

        public long Cost
        {
            get
            {
                long ofPoint = 1 + CostOfPosition + BytesBehind / BytesPerCost;
                for (int p = 0; p < Shapes.Length; p++)
                    ofPoint += CostOf(p);
                return Count * ofPoint;
            }
        }

        void Run()
        {
            m_state = Scratch.Progress.Value;
            m_budget = CostPerSlice;
            m_drafts = (NodeDraft*)Drafts.GetUnsafeReadOnlyPtr();
            m_points = (uint*)Points.GetUnsafePtr();
            m_packer = new PlanePacker
            {
                Records = (byte*)Records.GetUnsafeReadOnlyPtr(),
                Layout = Layout,
                Columns = (StoredColumn*)Columns.GetUnsafeReadOnlyPtr(),
            };
            if (m_state.Stage == Stage.Start)
                Start();
            if (m_state.Stage == Stage.SortPoints)
                SortPoints();
            if (m_state.Stage == Stage.Plan && m_budget > 0)
                Plan();
            if (m_state.Stage == Stage.Write)
                WritePlanes();
            if (m_state.Stage == Stage.Append && m_budget > 0)
                AppendBehind();
            Scratch.Progress.Value = m_state;
        }

        void Start()
        {
            File.Clear();
            // A list that grows is copied whole, in one slice. Only written pages take memory.
            if (File.Capacity < Count * Layout.StrideBytes)
                File.SetCapacity(Count * Layout.StrideBytes);
            Scratch.Behind.Clear();
            if (Scratch.Behind.Capacity < Count * BytesBehind)
                Scratch.Behind.SetCapacity(Count * BytesBehind);
            Table.Clear();
            Top.Clear();
            for (int p = 0; p < BytesOfPlane.Length; p++)
                BytesOfPlane[p] = 0;
            var firstPoint = Scratch.FirstPointOfDraft;
            firstPoint.ResizeUninitialized(Drafts.Length);
            int sum = 0;
            for (int d = 0; d < Drafts.Length; d++)
            {
                firstPoint[d] = sum;
                sum += m_drafts[d].OwnCount;
            }
            m_state = new WriteScratch.State { Stage = Stage.SortPoints };
        }

        /// <summary>Groups the points of each node, in their order along the curve.</summary>
        void SortPoints()
        {
            int* next = Scratch.FirstPointOfDraft.GetUnsafePtr();
            var nodeOfPoint = (int*)NodeOfPoint.GetUnsafeReadOnlyPtr();
            int end = (int)math.min(Count, m_state.At + m_budget);
            for (int i = m_state.At; i < end; i++)
                m_points[next[nodeOfPoint[i]]++] = (uint)i;
            m_budget -= end - m_state.At;
            m_state.At = end;
            if (end < Count)
                return;
            for (int d = 0; d < Drafts.Length; d++)
                next[d] -= m_drafts[d].OwnCount;
            m_state.Stage = Stage.Plan;
        }

        /// <summary>Plans the nodes, and the table except for fields that are only known after writing.</summary>
        void Plan()
        {
            NodeOfDraft.ResizeUninitialized(Drafts.Length);
            Scratch.DraftOfNode.ResizeUninitialized(Drafts.Length);
            Scratch.FirstChild.ResizeUninitialized(Drafts.Length);
            Scratch.ChildCount.ResizeUninitialized(Drafts.Length);
            NumberNodes();
            if (OmitsTop && Drafts.Length > 0)
                CopyTop();
            m_state.At = 0;
            m_state.Stage = Stage.Done;
            if (m_state.NodeCount == 0)
                return;
            Scratch.Nodes.ResizeUninitialized(m_state.NodeCount);
            for (int node = 0; node < m_state.NodeCount; node++)
                Scratch.Nodes[node] = NewRecord(node, Scratch.FirstChild[node], Scratch.ChildCount[node]);
            Scratch.Ranges.ResizeUninitialized(m_state.NodeCount * (Shapes.Length + 1));
            UnsafeUtility.MemClear(Scratch.Ranges.GetUnsafePtr(), (long)Scratch.Ranges.Length * sizeof(PlaneRange));
            File.ResizeUninitialized(FileHeader.SizeBytes);
            m_state.Stage = Stage.Write;
        }

        /// <summary>Numbers nodes breadth first by the existing parents, so that children follow one another.</summary>
        void NumberNodes()
        {
            // Chains of children in the drafts' order.
            int drafts = Drafts.Length;
            int* firstOf = Allocate<int>(drafts);
            int* nextOf = Allocate<int>(drafts);
            for (int d = 0; d < drafts; d++)
                firstOf[d] = -1;
            for (int d = drafts - 1; d > 0; d--)
            {
                int parent = m_drafts[d].Parent;
                nextOf[d] = firstOf[parent];
                firstOf[parent] = d;
            }

            var nodeOfDraft = NodeOfDraft;
            int count = 0;
            if (drafts > 0)
            {
                nodeOfDraft[0] = -1;
                if (OmitsTop)
                    Append(firstOf[0], nextOf, ref count);
                else
                    Scratch.DraftOfNode[count++] = 0;
            }
            for (int node = 0; node < count; node++)
            {
                int draft = Scratch.DraftOfNode[node];
                nodeOfDraft[draft] = node;
                Scratch.FirstChild[node] = count;
                Append(firstOf[draft], nextOf, ref count);
                Scratch.ChildCount[node] = count - Scratch.FirstChild[node];
            }
            m_state.NodeCount = count;
            UnsafeUtility.Free(nextOf, Allocator.Temp);
            UnsafeUtility.Free(firstOf, Allocator.Temp);
        }

        static T* Allocate<T>(int count) where T : unmanaged =>
            (T*)UnsafeUtility.Malloc((long)math.max(1, count) * sizeof(T), 16, Allocator.Temp);

        void Append(int draft, int* nextOf, ref int count)
        {
            for (; draft >= 0; draft = nextOf[draft])
                Scratch.DraftOfNode[count++] = draft;
        }

        void CopyTop()
        {
            var layout = Layout.ForTops(Averaged.HasColumns);
            int stride = layout.StrideBytes, count = m_drafts[0].OwnCount;
            Top.ResizeUninitialized(count * stride);
            byte* to = Top.GetUnsafePtr();
            for (int i = 0; i < count; i++, to += stride)
            {
                int point = (int)m_points[Scratch.FirstPointOfDraft[0] + i];
                byte* record = m_packer.Records + (long)point * Layout.StrideBytes;
                UnsafeUtility.MemCpy(to, record, stride - layout.AverageBytes);
                if (!Averaged.HasColumns)
                    continue;
                var average = Averaged.Of(point, record, Layout);
                UnsafeUtility.MemCpy(to + stride - layout.AverageBytes, &average, layout.AverageBytes);
            }
        }

        void WritePlanes()
        {
            int planes = Shapes.Length + 1;
            var nodes = Scratch.Nodes.GetUnsafePtr();
            var ranges = Scratch.Ranges.GetUnsafePtr();
            for (; m_state.At < m_state.NodeCount; m_state.At++)
            {
                if (m_budget <= 0)
                    return;
                if (nodes[m_state.At].PlaneNode == m_state.At)
                    WritePlanesOf(m_state.At, nodes, ranges + (long)m_state.At * planes);
                if (m_state.Plane > 0)
                    return;
            }
            m_state.At = 0;
            m_state.Stage = Stage.Append;
        }

        void AppendBehind()
        {
            var behind = Scratch.Behind;
            int count = (int)math.min(behind.Length - m_state.At, m_budget * BytesPerCost);
            File.AddRange(behind.GetUnsafePtr() + m_state.At, count);
            m_state.At += count;
            if (m_state.At < behind.Length)
                return;
            int planes = Shapes.Length + 1;
            var ranges = Scratch.Ranges.GetUnsafePtr();
            for (int i = 0; i < m_state.NodeCount * planes; i++)
                if (ranges[i].OffsetBytes < 0)
                    ranges[i].OffsetBytes = File.Length - behind.Length + ~ranges[i].OffsetBytes;
            WriteTable(planes, Scratch.Nodes.GetUnsafePtr(), ranges);
            m_state.Stage = Stage.Done;
        }

        void WriteTable(int planes, NodeRecord* nodes, PlaneRange* ranges)
        {
            long points = 0;
            for (int node = 0; node < m_state.NodeCount; node++)
                points += nodes[node].PointCount;
            Table.AddRange(nodes, m_state.NodeCount * sizeof(NodeRecord));
            Table.AddRange(ranges, m_state.NodeCount * planes * sizeof(PlaneRange));
            var container = Container;
            container.FileBytes = File.Length;
            container.Hash = ContentHash.Of(ranges, (long)m_state.NodeCount * planes * sizeof(PlaneRange));
            var header = new FileHeader
            {
                Magic = StoreFormat.PlanesMagic,
                Version = StoreFormat.Version,
                PlaneCount = planes,
                Container = container,
                PointCount = points,
                CloudId = CloudId,
            };
            header.HeaderHash = StoreFile.HashOf(header);
            *(FileHeader*)File.GetUnsafePtr() = header;
        }

        NodeRecord NewRecord(int node, int firstChild, int childCount)
        {
            var draft = m_drafts[Scratch.DraftOfNode[node]];
            int parent = draft.Parent < 0 ? -1 : NodeOfDraft[draft.Parent];
            bool isInlined = draft.IsLeaf && draft.OwnCount < InlinedLeafPoints && parent >= 0;
            var position = Layout.PositionOf(m_packer.Records + (long)draft.First * Layout.StrideBytes) - Corner;
            long whole = -1L << draft.SideLog2;
            return new NodeRecord
            {
                Corner = Corner + new Grid3(position.X & whole, position.Y & whole, position.Z & whole),
                SideLog2 = draft.SideLog2,
                CellLog2 = draft.CellLog2,
                Flags = (byte)((draft.IsLeaf ? NodeRecord.LeafFlag : 0) | (draft.IsTopRemainder ? NodeRecord.TopFlag : 0)),
                Parent = parent,
                FirstChild = childCount > 0 ? firstChild : 0,
                ChildCount = childCount,
                PointCount = draft.OwnCount,
                BlockCount = PlaneShape.BlocksOf(draft.OwnCount),
                PlaneNode = isInlined ? parent : node,
            };
        }

        void WritePlanesOf(int planeNode, NodeRecord* nodes, PlaneRange* ranges)
        {
            // These are the node's own points, then each inlined leaf's.
            int first = nodes[planeNode].FirstChild, end = first + nodes[planeNode].ChildCount;
            var groups = Allocate<PackedGroup>(1 + nodes[planeNode].ChildCount);
            int* nodeOfGroup = Allocate<int>(1 + nodes[planeNode].ChildCount);
            int groupCount = 0, blocks = 0;
            AddGroup(planeNode, nodes, groups, nodeOfGroup, ref groupCount, ref blocks);
            for (int child = first; child < end; child++)
                if (nodes[child].PlaneNode == planeNode)
                    AddGroup(child, nodes, groups, nodeOfGroup, ref groupCount, ref blocks);
            nodes[planeNode].PlaneBlocks = blocks;
            long points = 0;
            for (int r = 0; r < groupCount; r++)
                points += groups[r].Count;
            if (m_state.Plane == 0)
            {
                WritePositions(planeNode, nodes, ranges, groups, nodeOfGroup, groupCount);
                m_budget -= points * CostOfPosition;
            }
            WriteAttributes(ranges, groups, groupCount, points);
            UnsafeUtility.Free(nodeOfGroup, Allocator.Temp);
            UnsafeUtility.Free(groups, Allocator.Temp);
        }

        void WritePositions(int planeNode, NodeRecord* nodes, PlaneRange* ranges, PackedGroup* groups, int* nodeOfGroup,
            int groupCount)
        {
            ulong* min = Allocate<ulong>(3 * groupCount);
            ulong* max = Allocate<ulong>(3 * groupCount);
            ranges[0] = m_packer.WritePositions(File, groups, groupCount, nodes[planeNode], min, max);
            BytesOfPlane[0] += ranges[0].LengthBytes;
            for (int r = 0; r < groupCount; r++)
                SetBounds(ref nodes[nodeOfGroup[r]], nodes[planeNode].Corner, min + 3 * r, max + 3 * r);
            UnsafeUtility.Free(max, Allocator.Temp);
            UnsafeUtility.Free(min, Allocator.Temp);
            m_state.HasAverages = HasAverages(groups, groupCount);
            m_state.AveragedColumn = 0;
            m_state.Plane = 1;
        }

        void WriteAttributes(PlaneRange* ranges, PackedGroup* groups, int groupCount, long points)
        {
            for (; m_state.Plane <= Shapes.Length && m_budget > 0; m_state.Plane++)
            {
                int p = m_state.Plane - 1;
                // If every point represents only itself, the averages are the values: the same bytes.
                if (AverageOf[p] >= 0 && !m_state.HasAverages)
                {
                    ranges[p + 1] = ranges[AverageOf[p] + 1];
                    continue;
                }
                m_budget -= points * CostOf(p);
                var to = p == ColorPlane ? File : Scratch.Behind;
                if (AverageOf[p] >= 0)
                {
                    ranges[p + 1] = m_packer.WriteAverages(to, groups, groupCount, Shapes[p], Averaged, m_state.AveragedColumn);
                    m_state.AveragedColumn += Shapes[p].ColumnCount;
                }
                else
                {
                    ranges[p + 1] = m_packer.WriteAttributes(to, groups, groupCount, Shapes[p], FirstColumnOfPlane[p]);
                }
                // The place in the file is not known yet; averages that share the range share this.
                if (p != ColorPlane)
                    ranges[p + 1].OffsetBytes = ~ranges[p + 1].OffsetBytes;
                BytesOfPlane[p + 1] += ranges[p + 1].LengthBytes;
            }
            if (m_state.Plane > Shapes.Length)
                m_state.Plane = 0;
        }

        // The most that a point has there, but for what blocks add.
        int BytesBehind
        {
            get
            {
                int bytes = 0;
                for (int p = 0; p < Shapes.Length; p++)
                    for (int c = FirstColumnOfPlane[p]; p != ColorPlane && c < FirstColumnOfPlane[p + 1]; c++)
                        bytes += Columns[c].Type.SizeOf();
                return bytes;
            }
        }

        int CostOf(int plane) => AverageOf[plane] >= 0 ? CostOfAverage : Shapes[plane].ColumnCount;

        bool HasAverages(PackedGroup* groups, int groupCount)
        {
            for (int r = 0; r < groupCount && Averaged.HasColumns; r++)
            {
                for (int i = 0; i < groups[r].Count; i++)
                {
                    int point = (int)groups[r].Points[i];
                    if (Averaged.Of(point, m_packer.Records + (long)point * Layout.StrideBytes, Layout).Points > 1)
                        return true;
                }
            }
            return false;
        }

        void AddGroup(int node, NodeRecord* nodes, PackedGroup* groups, int* nodeOfGroup, ref int groupCount, ref int blocks)
        {
            nodes[node].FirstBlock = blocks;
            blocks += nodes[node].BlockCount;
            nodeOfGroup[groupCount] = node;
            groups[groupCount++] = new PackedGroup
            {
                Points = m_points + Scratch.FirstPointOfDraft[Scratch.DraftOfNode[node]],
                Count = nodes[node].PointCount,
            };
        }

        /// <summary>Sets bounds from the node's own corner; offsets are from the plane node's.</summary>
        static void SetBounds(ref NodeRecord node, Grid3 planeCorner, ulong* min, ulong* max)
        {
            var corner = node.Corner - planeCorner;
            int shift = node.BoundsShift;
            node.MinX = (uint)(min[0] - (ulong)corner.X >> shift);
            node.MinY = (uint)(min[1] - (ulong)corner.Y >> shift);
            node.MinZ = (uint)(min[2] - (ulong)corner.Z >> shift);
            node.MaxX = (uint)(max[0] - (ulong)corner.X >> shift);
            node.MaxY = (uint)(max[1] - (ulong)corner.Y >> shift);
            node.MaxZ = (uint)(max[2] - (ulong)corner.Z >> shift);
        }
    }
}
