using System;
using FastPoints.Points;
using FastPoints.Records;
using FastPoints.Samplers;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Nodes
{
    /// <summary>Turns one chunk at a time into nodes: orders, gathers and samples its points, and writes them into memory. Its
    /// memory is as large as its largest chunk needs and is reused for the next.</summary>
    internal sealed class ChunkIndexer : IDisposable
    {
        // The samplers visit a point this often in most clouds.
        const int UsualLevels = 12;
        const int UsualLooks = 32;
        const int UsualLooksOfAverage = 96;

        readonly RecordLayout m_records;
        readonly NativeStoreLayout m_store;
        readonly Grid3 m_rootCorner;
        readonly ulong m_cloudId;
        readonly Sampler m_sampler;
        readonly NodeSizes m_sizes;

        OrderScratch m_ordering;
        NativeArray<uint> m_order;
        NativeArray<byte> m_sorted;
        NativeArray<byte> m_common;
        NativeArray<uint> m_priority;
        NativeArray<byte> m_givesWay;
        NativeArray<int> m_nodeOfPoint;
        NativeArray<int> m_averageOfPoint;
        NativeList<PointAverage> m_averages;
        NativeArray<ChunkTop> m_tops;
        NativeReference<ulong> m_checksum;
        NativeArray<long> m_bytesOfPlane;
        WriteScratch m_writing;
        RandomScratch m_random;
        PoissonScratch m_poisson;
        SliceTimes m_slices;
        int m_capacity;

        public ChunkIndexer(RecordLayout records, NativeStoreLayout store, Grid3 rootCorner, ulong cloudId, Sampler sampler,
            NodeSizes sizes)
        {
            m_records = records;
            m_store = store;
            m_rootCorner = rootCorner;
            m_cloudId = cloudId;
            m_sampler = sampler;
            m_sizes = sizes;
            if (sampler == Sampler.Random)
                m_random = new RandomScratch(Allocator.Persistent);
            else
                m_poisson = new PoissonScratch(Allocator.Persistent);
            m_writing = new WriteScratch(Allocator.Persistent);
            m_slices = new SliceTimes(Allocator.Persistent);
            m_tops = new NativeArray<ChunkTop>(0, Allocator.Persistent);
            m_averages = new NativeList<PointAverage>(16, Allocator.Persistent);
            m_checksum = new NativeReference<ulong>(Allocator.Persistent);
            m_bytesOfPlane = new NativeArray<long>(store.Layout.Planes.Count, Allocator.Persistent);
            Drafts = new NativeList<NodeDraft>(64, Allocator.Persistent);
            File = new NativeList<byte>(1024, Allocator.Persistent);
            Table = new NativeList<byte>(64, Allocator.Persistent);
            Top = new NativeList<byte>(1024, Allocator.Persistent);
            NodeOfDraft = new NativeList<int>(64, Allocator.Persistent);
        }

        /// <summary>The current chunk, and its records as they came.</summary>
        public GridCube Cube { get; private set; }
        public RecordPages Pages { get; private set; }
        public int Number { get; private set; }
        public JobHandle Job { get; private set; }

        /// <summary>The chunk's file after the job, empty if all points are in the top. Code that takes it gives another list for
        /// the next one.</summary>
        public NativeList<byte> File { get; set; }

        /// <summary>The upper nodes' table, after an upper job.</summary>
        public NativeList<byte> Table { get; }

        /// <summary>The records of the top node in the layout of tops, after the job.</summary>
        public NativeList<byte> Top { get; }
        public NativeList<NodeDraft> Drafts { get; }
        public NativeList<int> NodeOfDraft { get; }

        /// <summary>Sum of the hashes of all processed points.</summary>
        public ulong Checksum => m_checksum.Value;

        /// <summary>Times of the jobs so far; code that takes them empties them.</summary>
        public SliceTimes Slices => m_slices;

        /// <summary>Bytes of each plane in the last file.</summary>
        public NativeArray<long> BytesOfPlane => m_bytesOfPlane;

        /// <summary>Begins a chunk. The caller owns its pages again when the job is done.</summary>
        public void Begin(GridCube cube, RecordPages pages, int number)
        {
            Cube = cube;
            Pages = pages;
            Number = number;
            int count = checked((int)pages.Count);
            Reserve(count);
            var gathered = Gather(count, Order(count, pages, cube), cube);
            var sampled = Sample(count, cube, m_records, m_sorted, m_tops, gathered);
            Job = Write(count, m_records, cube.Corner, true, true, m_sorted, m_nodeOfPoint, sampled);
            JobHandle.ScheduleBatchedJobs();
        }

        /// <summary>Begins upper nodes: those above some tops, which come in Morton order.</summary>
        /// <param name="records">The records of all tops.</param>
        /// <param name="tops">One for each chunk or region; receives the attach nodes as drafts.</param>
        /// <param name="isRoot">Whether it is the root; otherwise the top node goes to <see cref="Top"/>, as a chunk's
        /// does.</param>
        public void BeginUpper(NativeArray<byte> records, NativeArray<ChunkTop> tops, GridCube cube, bool isRoot)
        {
            Number = 0;
            Cube = cube;
            Pages = default;
            var layout = m_records.ForTops(m_store.HasAverages);
            int count = records.Length / layout.StrideBytes;
            Reserve(count);
            var prepared = default(JobHandle);
            var prepare = new PrepareUpperJob
            {
                Slices = m_slices,
                Layout = layout,
                Corner = m_rootCorner,
                Records = records,
                CommonCubeLog2 = m_common,
                Priority = m_priority,
            };
            while (prepare.End < count)
            {
                prepare.First = prepare.End;
                prepare.End = Math.Min(count, prepare.First + PrepareUpperJob.PointsOfSlice);
                prepared = prepare.Schedule(prepared);
            }
            var sampled = Sample(count, cube, layout, records, tops, prepared);
            Job = Write(count, layout, m_rootCorner, false, !isRoot, records, m_nodeOfPoint, sampled);
            JobHandle.ScheduleBatchedJobs();
        }

        public void Dispose()
        {
            Job.Complete();
            if (!m_checksum.IsCreated)
                return;
            FreePoints();
            m_tops.Dispose();
            m_averages.Dispose();
            m_checksum.Dispose();
            m_slices.Dispose();
            m_writing.Dispose();
            m_bytesOfPlane.Dispose();
            if (m_sampler == Sampler.Random)
                m_random.Dispose();
            else
                m_poisson.Dispose();
            Drafts.Dispose();
            File.Dispose();
            Table.Dispose();
            Top.Dispose();
            NodeOfDraft.Dispose();
        }

        JobHandle Order(int count, RecordPages pages, GridCube cube)
        {
            m_ordering.Now.Value = default;
            var job = new OrderChunkJob
            {
                Slices = m_slices,
                Pages = pages,
                Layout = m_records,
                Cube = cube,
                Scratch = m_ordering,
                Order = m_order,
                PointsPerSlice = OrderChunkJob.PointsOfSlice,
            };
            var done = default(JobHandle);
            for (long looked = 0; looked < (long)count * OrderChunkJob.Looks; looked += job.PointsPerSlice)
                done = job.Schedule(done);
            // Slices end at pages and buckets: what they leave.
            job.PointsPerSlice = int.MaxValue;
            return job.Schedule(done);
        }

        JobHandle Gather(int count, JobHandle inputDeps, GridCube cube)
        {
            var job = new GatherRecordsJob
            {
                Slices = m_slices,
                PageTable = m_ordering.PageTable,
                Layout = m_records,
                Cube = cube,
                Order = m_order,
                Records = m_sorted,
                CommonCubeLog2 = m_common,
                Priority = m_priority,
                Checksum = m_checksum,
            };
            do
            {
                job.First = job.End;
                job.End = Math.Min(count, job.First + GatherRecordsJob.PointsOfSlice);
                inputDeps = job.Schedule(inputDeps);
            }
            while (job.End < count);
            return inputDeps;
        }

        JobHandle Sample(int count, GridCube cube, RecordLayout layout, NativeArray<byte> records, NativeArray<ChunkTop> tops,
            JobHandle inputDeps)
        {
            if (m_sampler == Sampler.Random)
            {
                m_random.Now.Value = default;
                var random = new SampleRandomJob
                {
                    Slices = m_slices,
                    Count = count,
                    RootSideLog2 = cube.SideLog2,
                    Sizes = m_sizes,
                    CommonCubeLog2 = m_common,
                    Priority = m_priority,
                    GivesWayLog2 = m_givesWay,
                    Scratch = m_random,
                    PointsPerSlice = SampleRandomJob.PointsOfSlice,
                    Tops = tops,
                    NodeOfPoint = m_nodeOfPoint,
                    Nodes = Drafts,
                };
                for (long looked = 0; looked < (long)count * UsualLevels; looked += random.PointsPerSlice)
                    inputDeps = random.Schedule(inputDeps);
                random.PointsPerSlice = int.MaxValue;
                return random.Schedule(inputDeps);
            }
            m_poisson.Now.Value = default;
            var job = new SamplePoissonJob
            {
                Slices = m_slices,
                Count = count,
                RootSideLog2 = cube.SideLog2,
                Sizes = m_sizes,
                Layout = layout,
                Corner = cube.Corner,
                Records = records,
                CommonCubeLog2 = m_common,
                Priority = m_priority,
                Tops = tops,
                NodeOfPoint = m_nodeOfPoint,
                Nodes = Drafts,
                Averaged = Averaged,
                Scratch = m_poisson,
                PointsPerSlice = SamplePoissonJob.PointsOfSlice,
            };
            // Slices that come after the end have nothing to do; one takes what is left where levels are many.
            int looks = m_sampler == Sampler.Average ? UsualLooksOfAverage : UsualLooks;
            for (long looked = 0; looked < (long)count * looks; looked += job.PointsPerSlice)
                inputDeps = job.Schedule(inputDeps);
            job.PointsPerSlice = int.MaxValue;
            return job.Schedule(inputDeps);
        }

        JobHandle Write(int count, RecordLayout layout, Grid3 corner, bool isChunk, bool keepsTopOut, NativeArray<byte> records,
            NativeArray<int> nodeOfPoint,
            JobHandle inputDeps)
        {
            m_writing.Now.Value = default;
            var job = new WriteNodesJob
            {
                Slices = m_slices,
                Count = count,
                Layout = layout,
                Corner = corner,
                CloudId = m_cloudId,
                Number = Number,
                IsChunk = isChunk,
                KeepsTopOut = keepsTopOut,
                Records = records,
                NodeOfPoint = nodeOfPoint,
                Drafts = Drafts,
                Columns = m_store.Columns,
                FirstColumnOfPlane = m_store.FirstColumnOfPlane,
                Shapes = m_store.Shapes,
                File = File,
                Table = Table,
                Top = Top,
                NodeOfDraft = NodeOfDraft,
                AverageOf = m_store.AverageOf,
                Averaged = Averaged,
                BytesOfPlane = m_bytesOfPlane,
                Points = m_order,
                Scratch = m_writing,
                PointsPerSlice = WriteNodesJob.PointsOfSlice,
            };
            long looks = count + count / WriteNodesJob.PointsSortedForOne;
            for (long looked = 0; looked < looks; looked += job.PointsPerSlice)
                inputDeps = job.Schedule(inputDeps);
            // Slices end at nodes: what they leave.
            job.PointsPerSlice = int.MaxValue;
            return job.Schedule(inputDeps);
        }

        AveragedColumns Averaged => new AveragedColumns
        {
            Columns = m_store.AveragedColumns,
            AverageOfPoint = m_averageOfPoint,
            Averages = m_averages,
        };

        void Reserve(int count)
        {
            if (count <= m_capacity && m_ordering.IsCreated)
                return;
            FreePoints();
            m_capacity = Math.Max(1, count);
            const NativeArrayOptions raw = NativeArrayOptions.UninitializedMemory;
            m_ordering = new OrderScratch(m_capacity, Allocator.Persistent);
            m_order = new NativeArray<uint>(m_capacity, Allocator.Persistent, raw);
            m_sorted = new NativeArray<byte>(checked(m_capacity * m_records.StrideBytes), Allocator.Persistent, raw);
            m_common = new NativeArray<byte>(m_capacity, Allocator.Persistent, raw);
            m_priority = new NativeArray<uint>(m_capacity, Allocator.Persistent, raw);
            m_givesWay = new NativeArray<byte>(m_sampler == Sampler.Random ? m_capacity : 0, Allocator.Persistent, raw);
            m_nodeOfPoint = new NativeArray<int>(m_capacity, Allocator.Persistent, raw);
            m_averageOfPoint = new NativeArray<int>(m_store.HasAverages ? m_capacity : 0, Allocator.Persistent, raw);
        }

        void FreePoints()
        {
            if (!m_ordering.IsCreated)
                return;
            m_ordering.Dispose();
            m_order.Dispose();
            m_sorted.Dispose();
            m_common.Dispose();
            m_priority.Dispose();
            m_givesWay.Dispose();
            m_nodeOfPoint.Dispose();
            m_averageOfPoint.Dispose();
        }
    }
}
