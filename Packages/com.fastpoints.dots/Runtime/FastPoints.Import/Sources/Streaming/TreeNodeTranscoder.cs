using System;
using FastPoints.Reading;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // A slot of the source's reader decodes the attributes of some planes, then slices of at most about 4 ms order and pack them.
    sealed unsafe class TreeNodeTranscoder : NodeTranscoder
    {
        const int MinCapacity = 1 << 12; // Nodes up to this size share one size of memory, which is doubled for larger ones.

        readonly PointReader m_reader;
        readonly TreeGrid m_grid;
        readonly int m_planesOfPage;
        readonly TreePlanes m_planes;
        BlockRead m_read;
        NativeArray<byte> m_offsets;
        NativeArray<uint> m_pointOfRank;
        NativeArray<ulong> m_keys;
        NativeArray<ulong> m_keyScratch;
        NativeArray<uint> m_pointScratch;
        NativeArray<byte> m_packed;
        NativeArray<long> m_lengthOfPlane;
        NativeReference<PackState> m_state;
        JobHandle m_done;
        PointCloudException m_refused;
        SourceNode m_node;

        // Of a remote source, until it is decoded.
        RemoteFetch m_fetched;
        TranscoderChain m_chain;
        int m_pointsInChain;

        // planes: the packed ones, which the source owns; planesOfPage: of a node in the source's pages.
        public TreeNodeTranscoder(PointReader reader, TreeGrid grid, TreePlanes planes, int planesOfPage)
        {
            m_reader = reader;
            m_grid = grid;
            m_planesOfPage = planesOfPage;
            m_planes = planes;
            m_lengthOfPlane = new NativeArray<long>(planes.Count, Allocator.Persistent);
            m_state = new NativeReference<PackState>(Allocator.Persistent);
        }

        // All nodes lie in one file, whose failure is then reported once.
        bool IsOneFile => m_reader is CopcReader || m_reader is Potree2Reader;

        public int Capacity { get; private set; }

        public void Join(TranscoderChain chain, int points)
        {
            (m_chain, m_pointsInChain) = (chain, points);
            chain.Points += points;
        }

        public int LeaveChain()
        {
            m_chain.Points -= m_pointsInChain;
            m_chain = null;
            return m_pointsInChain;
        }

        public override JobHandle Done => m_done;
        public override long BytesRead => m_reader.BytesOfRange(Range);
        public override NativeArray<byte> Planes => m_packed;

        public override long LengthOf(int plane) => m_lengthOfPlane[plane];

        public override void Begin(in HierarchyPage page, int node)
        {
            m_node = m_reader.Tree[(int)page.Planes[node * m_planesOfPage].OffsetBytes];
            m_refused = null;
            m_done = default;
            // Upper levels first.
            m_fetched = m_reader.IsRemote ? m_reader.Fetch(Range, m_node.Level) : null;
            if (m_fetched == null)
                ScheduleDecode();
        }

        BlockRange Range => new BlockRange(m_node.Block, 0, m_node.PointCount);

        internal override bool TryScheduleDecode()
        {
            if (m_fetched == null)
                return true;
            if (m_fetched.PollIsDone())
                ScheduleDecode();
            return m_fetched == null;
        }

        internal override void Cancel()
        {
            if (m_fetched == null)
                return;
            m_fetched.Dispose();
            m_fetched = null;
            m_refused = new PointCloudException(FailureCode.ReadFailed, m_reader.Info.Path, -1, "is no longer wanted");
        }

        void ScheduleDecode()
        {
            try
            {
                if (m_node.PointCount > Capacity)
                    Reserve(m_node.PointCount);
                m_read.Dependency = m_chain?.End ?? default;
                m_read.Fetched = m_fetched;
                m_fetched = null;
                m_read.Begin(Range);
                m_done = Schedule(m_read.Decoded);
                if (m_chain != null)
                    m_chain.End = m_done;
            }
            catch (PointCloudException refused)
            {
                m_refused = refused;
                m_done = default;
                m_fetched?.Dispose();
                m_fetched = null;
            }
        }

        internal override TranscodeResult End(out StreamFailure failure)
        {
            failure = default;
            // Who has not waited until it is near waits here.
            if (m_fetched != null)
                ScheduleDecode();
            m_done.Complete();
            m_done = default;
            try
            {
                if (m_refused != null)
                    throw m_refused;
                m_read.Complete();
            }
            catch (PointCloudException broken)
            {
                failure = new StreamFailure(broken.Path, broken.ByteOffset, broken.What);
                return broken.Code == FailureCode.ReadFailed && IsOneFile ? TranscodeResult.Unreadable : TranscodeResult.Damaged;
            }
            if (!m_state.Value.IsDamaged)
                return TranscodeResult.Done;
            var cell = m_node.Cell;
            string name = NumberText.Of(m_node.Level) + "-" + NumberText.Of(cell.x) + "-" + NumberText.Of(cell.y) + "-"
                + NumberText.Of(cell.z);
            string path = m_reader.FileOfBlock(m_node.Block, out long offset);
            failure = new StreamFailure(path, offset, "node " + name + " is damaged: wanted " + NumberText.Of(m_node.PointCount) +
                " points, got " + NumberText.Of(m_read.Points.Count));
            return TranscodeResult.Damaged;
        }

        public override void Dispose()
        {
            Cancel();
            m_done.Complete();
            m_done = default;
            FreeBuffers();
            if (m_lengthOfPlane.IsCreated)
                m_lengthOfPlane.Dispose();
            if (m_state.IsCreated)
                m_state.Dispose();
        }

        JobHandle Schedule(JobHandle decoded)
        {
            var grid = m_grid;
            int count = m_node.PointCount;
            var order = new OrderNodeJob
            {
                Columns = m_read.Points.Bytes,
                Decoded = m_read.Result,
                Positions = PositionColumns.Of(m_read.Points),
                Grid = grid.Source,
                Corner = grid.Corner,
                IsWide = grid.IsWide,
                CubeCorner = grid.PositionOf(m_node.Key),
                CubeBits = math.min(grid.BitsOf(m_node.Level), 62),
                Count = count,
                Capacity = Capacity,
                Offsets = m_offsets,
                PointOfRank = m_pointOfRank,
                State = m_state,
                Keys = m_keys,
                KeyScratch = m_keyScratch,
                PointScratch = m_pointScratch,
            };
            for (; order.First < count; order.First += OrderNodeJob.PointsPerSlice)
                decoded = order.Schedule(decoded);
            for (int p = 0; p < m_planes.Count; p++)
                decoded = SchedulePlane(p, decoded);
            return decoded;
        }

        JobHandle SchedulePlane(int plane, JobHandle inputDeps)
        {
            var pack = new PackPlaneJob
            {
                Columns = m_read.Points.Bytes,
                Offsets = m_offsets,
                PointOfRank = m_pointOfRank,
                Shape = ShapeOf(plane),
                Plane = plane,
                Count = m_node.PointCount,
                Capacity = Capacity,
                Packed = m_packed,
                LengthOfPlane = m_lengthOfPlane,
                State = m_state,
            };
            if (plane > 0)
            {
                pack.Column0 = ColumnOf(plane, 0);
                pack.Column1 = pack.Shape.ColumnCount > 1 ? ColumnOf(plane, 1) : default;
                pack.Column2 = pack.Shape.ColumnCount > 2 ? ColumnOf(plane, 2) : default;
            }
            int blocks = PlaneShape.BlocksOf(m_node.PointCount);
            for (; pack.FirstBlock < blocks; pack.FirstBlock += PackPlaneJob.BlocksPerSlice)
                inputDeps = pack.Schedule(inputDeps);
            return inputDeps;
        }

        PlaneShape ShapeOf(int plane) => plane == 0 ? PlaneShape.OfPositions(m_grid.IsWide) : m_planes.Shapes[plane];

        PointColumn ColumnOf(int plane, int column) =>
            m_read.Points.Column(m_read.Points.Schema.IndexOf(m_planes.AttributeOf(plane, column)));

        void Reserve(int points)
        {
            FreeBuffers();
            int capacity = Math.Max(MinCapacity, math.ceilpow2(points));
            int slice = Math.Min(capacity, OrderNodeJob.PointsPerSlice);
            m_read = m_reader.CreateRead(m_planes.Decoded, capacity, Allocator.Persistent);
            m_offsets = Allocate<byte>((m_grid.IsWide ? 24L : 12L) * capacity);
            m_pointOfRank = Allocate<uint>(capacity);
            m_keys = Allocate<ulong>(slice);
            m_keyScratch = Allocate<ulong>(slice);
            m_pointScratch = Allocate<uint>(slice);
            long bytes = 0;
            for (int p = 0; p < m_planes.Count; p++)
                bytes += ShapeOf(p).MaxBytes(PlaneShape.BlocksOf(capacity), capacity);
            m_packed = Allocate<byte>(bytes);
            Capacity = capacity;
        }

        static NativeArray<T> Allocate<T>(long count) where T : unmanaged =>
            new NativeArray<T>(checked((int)count), Allocator.Persistent, NativeArrayOptions.UninitializedMemory);

        void FreeBuffers()
        {
            Capacity = 0;
            m_read?.Dispose();
            m_read = null;
            if (!m_offsets.IsCreated)
                return;
            m_offsets.Dispose();
            m_pointOfRank.Dispose();
            m_keys.Dispose();
            m_keyScratch.Dispose();
            m_pointScratch.Dispose();
            m_packed.Dispose();
        }
    }

    // Transcoders whose nodes are decoded one after the other, while the next is read: the number of chains leaves
    // workers for frames' own jobs, however many nodes are begun.
    sealed class TranscoderChain
    {
        public JobHandle End;
        public long Points;
    }
}
