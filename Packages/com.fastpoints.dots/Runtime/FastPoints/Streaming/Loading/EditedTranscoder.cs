using System;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    // Makes what edits leave of a stored node: reads its planes, applies the operations and packs what is left, block by block,
    // without points that were deleted or hidden. Blocks of which nothing is left are left out.
    internal sealed unsafe class EditedTranscoder : NodeTranscoder
    {
        const int MinBlocks = 64;

        readonly EditedNodes m_nodes;
        readonly RepackedColumn[] m_columns; // By streamed plane and column.
        NativeArray<PlaneRange> m_ranges;
        NativeArray<long> m_places;
        NativeArray<PlaneShape> m_shapes;
        NativeArray<long> m_lengths;
        NativeReference<RepackState> m_state;
        NativeArray<ReadCommand> m_commands;
        NativeArray<byte> m_file;
        NativeArray<byte> m_packed;
        EditSlot m_slot;
        int m_maxBlocks;
        EditedNode m_node;
        ReadHandle m_main;
        ReadHandle m_computed;
        bool m_isReading;
        bool m_readsComputed;
        long m_bytesRead;
        JobHandle m_done;

        public EditedTranscoder(EditedNodes nodes)
        {
            m_nodes = nodes;
            int planes = nodes.Planes.Count;
            m_ranges = new NativeArray<PlaneRange>(planes, Allocator.Persistent);
            m_places = new NativeArray<long>(planes, Allocator.Persistent);
            m_shapes = new NativeArray<PlaneShape>(planes, Allocator.Persistent);
            m_commands = new NativeArray<ReadCommand>(planes, Allocator.Persistent);
            m_lengths = new NativeArray<long>(nodes.StreamedPlanes, Allocator.Persistent);
            m_state = new NativeReference<RepackState>(Allocator.Persistent);
            m_columns = new RepackedColumn[nodes.StreamedPlanes * PlaneShape.MaxColumns];
        }

        public override JobHandle Done => m_done;
        public override long BytesRead => m_bytesRead;
        public override NativeArray<byte> Planes => m_packed;

        public override long LengthOf(int plane) => m_lengths[plane];

        internal override void CorrectCounts(ref int blocks, ref int points) =>
            (blocks, points) = (m_state.Value.Blocks, m_state.Value.Points);

        public override void Begin(in HierarchyPage page, int node) =>
            Begin(m_nodes[(int)page.Planes[node * m_nodes.StreamedPlanes].OffsetBytes]);

        public void Begin(in EditedNode node)
        {
            m_node = node;
            Reserve();
            m_state.Value = default;
            var read = BeginRead();
            var check = new CheckPlanesJob
            {
                File = m_file,
                Optional = m_nodes.MayLackNormals && IsComputed(m_nodes.StreamedPlanes - 1) ? m_nodes.StreamedPlanes - 1 : -1,
                Ranges = m_ranges,
                Places = m_places,
                Shapes = m_shapes,
                BlockCount = m_node.BlockCount,
                State = m_state,
            }.Schedule(read);
            m_done = Pack(m_slot.Schedule(new EditNodeJob
            {
                File = m_file,
                Planes = m_ranges,
                PlaneOffsets = m_places,
                PlaneShapes = m_shapes,
                Corner = m_node.Corner,
                BlockCount = m_node.BlockCount,
            }, check));
        }

        internal override TranscodeResult End(out StreamFailure failure)
        {
            failure = default;
            m_done.Complete();
            m_done = default;
            var status = EndRead();
            int damaged = m_state.Value.DamagedPlane;
            if (status == ReadStatus.Complete && damaged == 0)
                return TranscodeResult.Done;
            bool isComputed = damaged > 0 && IsComputed(damaged - 1);
            failure = status != ReadStatus.Complete
                ? new StreamFailure(m_nodes.PathOf(m_node, false), -1, "cannot be read: the read ended as " + status)
                : new StreamFailure(m_nodes.PathOf(m_node, isComputed), m_ranges[damaged - 1].OffsetBytes, "the node is damaged");
            return status != ReadStatus.Complete ? TranscodeResult.Unreadable : TranscodeResult.Damaged;
        }

        public override void Dispose()
        {
            if (!m_commands.IsCreated)
                return;
            m_done.Complete();
            EndRead();
            m_slot?.Dispose();
            if (m_file.IsCreated)
                m_file.Dispose();
            if (m_packed.IsCreated)
                m_packed.Dispose();
            m_ranges.Dispose();
            m_places.Dispose();
            m_shapes.Dispose();
            m_commands.Dispose();
            m_lengths.Dispose();
            m_state.Dispose();
        }

        bool IsComputed(int plane) => m_nodes.Layout.Planes[m_nodes.Planes[plane]].IsComputed;

        void Reserve()
        {
            long bytes = 0, packed = 0;
            for (int p = 0; p < m_ranges.Length; p++)
            {
                m_ranges[p] = m_nodes.RangeOf(m_node, p);
                m_shapes[p] = m_nodes.Layout.ShapeOf(m_nodes.Planes[p], m_node.IsWide);
                bytes += m_ranges[p].LengthBytes;
                if (p < m_nodes.StreamedPlanes)
                    packed += m_nodes.MaxBytesOf(m_node, p, m_node.BlockCount * PlaneShape.MaxPointsPerBlock);
            }
            Reserve(ref m_file, bytes);
            Reserve(ref m_packed, packed);
            if (m_node.BlockCount <= m_maxBlocks)
                return;
            m_slot?.Dispose();
            m_maxBlocks = math.max(MinBlocks, math.ceilpow2(m_node.BlockCount));
            m_slot = new EditSlot(m_nodes.Plan, m_nodes.Layout, m_nodes.Planes, m_maxBlocks);
            for (int p = 1; p < m_nodes.StreamedPlanes; p++)
                FindColumns(p);
        }

        static void Reserve(ref NativeArray<byte> memory, long bytes)
        {
            if (memory.IsCreated && memory.Length >= bytes)
                return;
            if (memory.IsCreated)
                memory.Dispose();
            memory = new NativeArray<byte>(checked((int)Math.Max(1 << 16, bytes)), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
        }

        void FindColumns(int plane)
        {
            var of = m_nodes.Layout.Planes[m_nodes.Planes[plane]];
            for (int c = 0; c < of.ColumnCount; c++)
            {
                int column = of.FirstColumn + c, changed = -1;
                if (m_nodes.IsChanged(plane))
                    changed = m_slot.Values.Schema.IndexOf(m_nodes.Layout.NameOfColumn(of, column));
                m_columns[plane * PlaneShape.MaxColumns + c] = new RepackedColumn
                {
                    IsChanged = changed >= 0,
                    From = changed >= 0 ? m_slot.Values.Column(changed) : default,
                    Divisor = m_nodes.Layout.Columns[column].Divisor,
                };
            }
        }

        // Computed planes lie in a file of their own, and come last.
        JobHandle BeginRead()
        {
            var to = (byte*)m_file.GetUnsafePtr();
            int main = 0, computed = m_commands.Length;
            m_bytesRead = 0;
            for (int p = 0; p < m_ranges.Length; p++)
            {
                m_places[p] = m_bytesRead;
                var command = new ReadCommand
                {
                    Buffer = to + m_bytesRead,
                    Offset = m_ranges[p].OffsetBytes,
                    Size = m_ranges[p].LengthBytes,
                };
                m_bytesRead += command.Size;
                m_commands[IsComputed(p) ? --computed : main++] = command;
            }
            var commands = (ReadCommand*)m_commands.GetUnsafePtr();
            m_main = FileReads.BeginOneShot(m_nodes.PathOf(m_node, false), commands, main);
            m_isReading = true;
            m_readsComputed = computed < m_commands.Length;
            if (!m_readsComputed)
                return m_main.JobHandle;
            m_computed = FileReads.BeginOneShot(m_nodes.PathOf(m_node, true), commands + computed, m_commands.Length - computed);
            return JobHandle.CombineDependencies(m_main.JobHandle, m_computed.JobHandle);
        }

        ReadStatus EndRead()
        {
            var status = ReadStatus.Complete;
            if (!m_isReading)
                return status;
            m_isReading = false;
            status = m_main.Status;
            m_main.Dispose();
            if (!m_readsComputed)
                return status;
            status = status == ReadStatus.Complete && !m_nodes.MayLackNormals ? m_computed.Status : status;
            m_computed.Dispose();
            return status;
        }

        JobHandle Pack(JobHandle edited)
        {
            for (int p = 0; p < m_nodes.StreamedPlanes; p++)
            {
                var pack = new RepackPlaneJob
                {
                    File = m_file,
                    Place = m_places[p],
                    Shape = m_shapes[p],
                    BlockCount = m_node.BlockCount,
                    Edited = m_slot.EditedBlocks,
                    Values = m_slot.Values.Bytes,
                    Column0 = m_columns[p * PlaneShape.MaxColumns],
                    Column1 = m_columns[p * PlaneShape.MaxColumns + 1],
                    Column2 = m_columns[p * PlaneShape.MaxColumns + 2],
                    Plane = p,
                    Packed = m_packed,
                    LengthOfPlane = m_lengths,
                    State = m_state,
                };
                for (; pack.First < m_node.BlockCount; pack.First += RepackPlaneJob.BlocksPerSlice)
                    edited = pack.Schedule(edited);
            }
            return edited;
        }
    }

    internal struct RepackState
    {
        public int DamagedPlane; // One more than its index.
        public int Blocks; // Left of the node.
        public int Points;
        public int Block; // Of the plane that is packed: blocks so far, the next packed word, and where it begins.
        public long Word;
        public long PlaneStart;
    }

    // An attribute of the plane, and the values that it has after the operations.
    internal struct RepackedColumn
    {
        public bool IsChanged;
        public PointColumn From; // By block and point.
        public int Divisor;
    }

    [BurstCompile]
    internal unsafe struct CheckPlanesJob : IJob
    {
        public NativeArray<byte> File;
        public int Optional; // The plane that is cleared if it is damaged; -1 for none.
        public NativeArray<PlaneRange> Ranges;
        [ReadOnly] public NativeArray<long> Places;
        [ReadOnly] public NativeArray<PlaneShape> Shapes;
        public int BlockCount;
        public NativeReference<RepackState> State;

        public void Execute()
        {
            var file = (byte*)File.GetUnsafePtr();
            for (int p = 0; p < Ranges.Length && State.Value.DamagedPlane == 0; p++)
            {
                if (ContentHash.Of(file + Places[p], Ranges[p].LengthBytes) == Ranges[p].Hash &&
                    PlaneView.IsValid(file + Places[p], Ranges[p].LengthBytes, Shapes[p], BlockCount))
                    continue;
                if (p == Optional)
                    Clear(file, p);
                else
                    State.Value = new RepackState { DamagedPlane = 1 + p };
            }
        }

        // A plane of zeros is shorter than any other.
        void Clear(byte* file, int plane)
        {
            var positions = new PlaneView(file + Places[0], Shapes[0], BlockCount);
            var writer = new BlockWriter((uint*)(file + Places[plane]), Shapes[plane], 0,
                (long)BlockCount * Shapes[plane].DescriptorWords);
            ulong* values = stackalloc ulong[PlaneShape.MaxColumns * PlaneShape.MaxPointsPerBlock];
            ulong* min = stackalloc ulong[PlaneShape.MaxColumns], max = stackalloc ulong[PlaneShape.MaxColumns];
            for (int b = 0; b < BlockCount; b++)
            {
                UnsafeUtility.MemClear(values, PlaneShape.MaxColumns * PlaneShape.MaxPointsPerBlock * sizeof(ulong));
                writer.Write(values, positions.PointsOf(b), min, max);
            }
            var range = Ranges[plane];
            range.LengthBytes = writer.End();
            Ranges[plane] = range;
        }
    }

    // Some blocks of a plane, after those of the slice before. The planes of a node follow one another.
    [BurstCompile]
    internal unsafe struct RepackPlaneJob : IJob
    {
        public const int BlocksPerSlice = 512; // About 1 ms.

        [ReadOnly] public NativeArray<byte> File;
        public long Place;
        public PlaneShape Shape;
        public int BlockCount;
        public int First;
        public int Plane;
        [ReadOnly] public NativeArray<EditedBlock> Edited;
        [ReadOnly] public NativeArray<byte> Values;
        public RepackedColumn Column0;
        public RepackedColumn Column1;
        public RepackedColumn Column2;
        public NativeArray<byte> Packed;
        public NativeArray<long> LengthOfPlane;
        public NativeReference<RepackState> State;

        public void Execute()
        {
            var state = State.Value;
            if (state.DamagedPlane > 0)
                return;
            var from = new PlaneView((byte*)File.GetUnsafeReadOnlyPtr() + Place, Shape, BlockCount);
            if (First == 0)
                Begin(from, ref state);
            var to = (uint*)((byte*)Packed.GetUnsafePtr() + state.PlaneStart);
            var writer = new BlockWriter(to, Shape, state.Block, state.Word);
            ulong* values = stackalloc ulong[PlaneShape.MaxColumns * PlaneShape.MaxPointsPerBlock];
            ulong* min = stackalloc ulong[PlaneShape.MaxColumns], max = stackalloc ulong[PlaneShape.MaxColumns];
            bool isChanged = Column0.IsChanged || Column1.IsChanged || Column2.IsChanged;
            int end = math.min(First + BlocksPerSlice, BlockCount);
            for (int b = First; b < end; b++)
            {
                var left = LeftOf(from, b);
                if (left.IsEmpty)
                    continue;
                state.Block++;
                if (left.Count == from.PointsOf(b) && !(isChanged && Edited[b].HasChangedValues))
                {
                    writer.Copy(from, b);
                    continue;
                }
                for (int c = 0; c < Shape.ColumnCount; c++)
                    Gather(from, b, c, left, values);
                writer.Write(values, left.Count, min, max);
            }
            state.Word = writer.Word;
            if (end == BlockCount)
            {
                LengthOfPlane[Plane] = writer.End();
                state.PlaneStart += LengthOfPlane[Plane];
            }
            State.Value = state;
        }

        PointMask LeftOf(in PlaneView from, int block) =>
            PointMask.OfFirstPoints(from.PointsOf(block)).Without(Edited[block].Deleted.With(Edited[block].Hidden));

        void Begin(in PlaneView from, ref RepackState state)
        {
            state.Blocks = state.Points = state.Block = 0;
            for (int b = 0; b < BlockCount; b++)
            {
                int left = LeftOf(from, b).Count;
                state.Points += left;
                state.Blocks += left > 0 ? 1 : 0;
            }
            state.Word = (long)state.Blocks * Shape.DescriptorWords;
        }

        void Gather(in PlaneView from, int block, int c, in PointMask left, ulong* values)
        {
            var column = c == 0 ? Column0 : c == 1 ? Column1 : Column2;
            int points = from.PointsOf(block), kept = 0;
            ulong* wide = BlockWriter.WideOf(values, c);
            uint* narrow = BlockWriter.NarrowOf(values, c);
            if (Shape.IsWide(c))
                from.UnpackWide(block, c, wide);
            else
                from.Unpack(block, c, narrow);
            if (column.IsChanged && Edited[block].HasChangedValues)
                for (int i = 0; i < points; i++)
                    narrow[i] = (uint)OrderedBits.Load(column.From.At((byte*)Values.GetUnsafeReadOnlyPtr(),
                        block * PlaneShape.MaxPointsPerBlock + i), column.From.Type) / (uint)column.Divisor;
            for (int i = 0; i < points; i++)
            {
                if (!left.Has(i))
                    continue;
                if (Shape.IsWide(c))
                    wide[kept++] = wide[i];
                else
                    narrow[kept++] = narrow[i];
            }
        }
    }
}
