using System;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Nodes
{
    /// <summary>Turns one chunk at a time into nodes: orders and samples its points, and writes them into memory. It
    /// owns a chunk's result; temporary memory is the workspace's.</summary>
    internal sealed class ChunkIndexer : IDisposable
    {
        readonly RecordLayout m_records;
        readonly NativeStoreLayout m_store;
        readonly Grid3 m_rootCorner;
        readonly ulong m_cloudId;
        readonly Sampler m_sampler;
        readonly NodeSizes m_sizes;
        IndexWorkspace m_workspace;

        NativeArray<TopNode> m_tops;
        NativeReference<ulong> m_checksum;
        NativeArray<long> m_bytesOfPlane;
        SliceTimes m_sliceTimes;

        public ChunkIndexer(RecordLayout records, NativeStoreLayout store, Grid3 rootCorner, ulong cloudId, Sampler sampler,
            NodeSizes sizes)
        {
            m_records = records;
            m_store = store;
            m_rootCorner = rootCorner;
            m_cloudId = cloudId;
            m_sampler = sampler;
            m_sizes = sizes;
            m_sliceTimes = new SliceTimes(Allocator.Persistent);
            m_tops = new NativeArray<TopNode>(0, Allocator.Persistent);
            m_checksum = new NativeReference<ulong>(Allocator.Persistent);
            m_bytesOfPlane = new NativeArray<long>(store.Layout.Planes.Count, Allocator.Persistent);
            Drafts = new NativeList<NodeDraft>(64, Allocator.Persistent);
            File = new NativeList<byte>(1024, Allocator.Persistent);
            Table = new NativeList<byte>(64, Allocator.Persistent);
            Top = new NativeList<byte>(1024, Allocator.Persistent);
            NodeOfDraft = new NativeList<int>(64, Allocator.Persistent);
        }

        public GridCube Cube { get; private set; }
        public RecordPages Pages { get; private set; }
        public int Number { get; private set; }
        public JobHandle Job { get; private set; }

        /// <summary>The chunk's file after the job, empty if all points are in the top. A caller that takes it supplies
        /// another list for the next chunk.</summary>
        public NativeList<byte> File { get; set; }

        public NativeList<byte> Table { get; }

        public NativeList<byte> Top { get; } // The records of the top node in the layout of tops, after the job.
        public NativeList<NodeDraft> Drafts { get; }
        public NativeList<int> NodeOfDraft { get; }

        public ulong Checksum => m_checksum.Value; // Sum of the hashes of all processed points.
        public SliceTimes SliceTimes => m_sliceTimes; // Times of the jobs so far; taking them clears them.

        public NativeArray<long> BytesOfPlane => m_bytesOfPlane;

        /// <summary>Begins a chunk after the others of the workspace. The caller owns its pages again when the job is
        /// done.</summary>
        /// <param name="container">The chunk's file and, with it, its cube.</param>
        /// <param name="ready">Completes when the pages have their records.</param>
        public void Begin(ContainerRecord container, RecordPages pages, int number, IndexWorkspace workspace, JobHandle ready)
        {
            var cube = container.Cube;
            Cube = cube;
            Pages = pages;
            Number = number;
            m_workspace = workspace;
            int count = checked((int)pages.RecordCount);
            var ordered = Order(count, pages, cube, workspace.Begin(count, ready));
            var sampled = Sample(count, cube, m_records, workspace.Sorted, m_tops, ordered);
            Job = Write(new WriteNodesJob
            {
                Count = count,
                Layout = m_records,
                Corner = cube.Corner,
                Container = container,
                OmitsTop = true,
                Records = workspace.Sorted,
            }, sampled);
            JobHandle.ScheduleBatchedJobs();
        }

        /// <summary>The same where only the top is kept: <see cref="Checksum"/> is the top's.</summary>
        public void BeginTop(GridCube cube, RecordPages pages, int number, IndexWorkspace workspace)
        {
            Begin(new ContainerRecord { Cube = cube, Kind = ContainerKind.Chunk }, pages, number, workspace, default);
            Job = workspace.Last = new SumTopJob
            {
                Records = Top,
                Layout = m_records.ForTops(m_store.HasAverages),
                Sum = m_checksum,
            }.Schedule(Job);
            JobHandle.ScheduleBatchedJobs();
        }

        /// <summary>Begins upper nodes: those above some tops, which come in Morton order.</summary>
        /// <param name="tops">One for each chunk or region; receives the attach nodes as drafts.</param>
        /// <param name="isRoot">Whether it is the root; otherwise the top node goes to <see cref="Top"/>, as a chunk's
        /// does.</param>
        public void BeginUpper(NativeArray<byte> records, NativeArray<TopNode> tops, ContainerRecord container, bool isRoot,
            IndexWorkspace workspace)
        {
            var cube = container.Cube;
            m_workspace = workspace;
            Number = 0;
            Cube = cube;
            Pages = default;
            var layout = m_records.ForTops(m_store.HasAverages);
            int count = records.Length / layout.StrideBytes;
            var prepared = workspace.Begin(count, default);
            var prepare = new PrepareUpperJob
            {
                SliceTimes = m_sliceTimes,
                Layout = layout,
                Corner = m_rootCorner,
                Records = records,
                CommonCubeLog2 = m_workspace.Common,
                Priority = m_workspace.Priority,
            };
            while (prepare.End < count)
            {
                prepare.First = prepare.End;
                prepare.End = Math.Min(count, prepare.First + PrepareUpperJob.PointsPerSlice);
                prepared = prepare.Schedule(prepared);
            }
            var sampled = Sample(count, cube, layout, records, tops, prepared);
            Job = Write(new WriteNodesJob
            {
                Count = count,
                Layout = layout,
                Corner = m_rootCorner,
                Container = container,
                OmitsTop = !isRoot,
                Records = records,
            }, sampled);
            JobHandle.ScheduleBatchedJobs();
        }

        public void Dispose()
        {
            Job.Complete();
            if (!m_checksum.IsCreated)
                return;
            m_tops.Dispose();
            m_checksum.Dispose();
            m_sliceTimes.Dispose();
            m_bytesOfPlane.Dispose();
            Drafts.Dispose();
            File.Dispose();
            Table.Dispose();
            Top.Dispose();
            NodeOfDraft.Dispose();
        }

        JobHandle Order(int count, RecordPages pages, GridCube cube, JobHandle inputDeps)
        {
            var job = new OrderChunkJob
            {
                SliceTimes = m_sliceTimes,
                Pages = pages,
                Layout = m_records,
                Cube = cube,
                Scratch = m_workspace.Ordering,
                BucketOfPoint = m_workspace.Numbers,
                Records = m_workspace.Sorted,
                CommonCubeLog2 = m_workspace.Common,
                Priority = m_workspace.Priority,
                Checksum = m_checksum,
                CostPerSlice = OrderChunkJob.CostOfSlice,
            };
            for (long done = 0; done < job.Cost; done += job.CostPerSlice)
                inputDeps = job.Schedule(inputDeps);
            // Slices may end early, at pages and buckets: the last one has no limit.
            job.CostPerSlice = int.MaxValue;
            return job.Schedule(inputDeps);
        }

        JobHandle Sample(int count, GridCube cube, RecordLayout layout, NativeArray<byte> records, NativeArray<TopNode> tops,
            JobHandle inputDeps)
        {
            bool isRandom = m_sampler == Sampler.Random;
            var job = new SampleNodesJob
            {
                SliceTimes = m_sliceTimes,
                Count = count,
                RootSideLog2 = cube.SideLog2,
                Sizes = m_sizes,
                Layout = layout,
                IsRandom = isRandom,
                Corner = cube.Corner,
                Records = records,
                CommonCubeLog2 = m_workspace.Common,
                Priority = m_workspace.Priority,
                Tops = tops,
                NodeOfPoint = m_workspace.NodeOfPoint,
                Nodes = Drafts,
                Averaged = Averaged,
                Scratch = m_workspace.Sampling,
                CostPerSlice = SampleNodesJob.CostOfSlice,
            };
            // Slices after the end do nothing; with many levels one slice does the rest.
            long typical = (long)count * (isRandom ? SampleNodesJob.CostPerPoint : SampleNodesJob.CostPerPointOfDarts) +
                (Averaged.HasColumns ? (long)count * SampleNodesJob.CostPerPointOfAverages : 0);
            for (long done = 0; done < typical; done += job.CostPerSlice)
                inputDeps = job.Schedule(inputDeps);
            job.CostPerSlice = int.MaxValue;
            return job.Schedule(inputDeps);
        }

        JobHandle Write(WriteNodesJob job, JobHandle inputDeps)
        {
            job.SliceTimes = m_sliceTimes;
            job.CloudId = m_cloudId;
            job.NodeOfPoint = m_workspace.NodeOfPoint;
            job.Drafts = Drafts;
            job.Columns = m_store.Columns;
            job.FirstColumnOfPlane = m_store.FirstColumnOfPlane;
            job.Shapes = m_store.Shapes;
            job.File = File;
            job.Table = Table;
            job.Top = Top;
            job.NodeOfDraft = NodeOfDraft;
            job.AverageOf = m_store.AverageOf;
            job.ColorPlane = m_store.ColorPlane;
            job.Averaged = Averaged;
            job.BytesOfPlane = m_bytesOfPlane;
            job.Points = m_workspace.Numbers;
            job.Scratch = m_workspace.Writing;
            job.CostPerSlice = WriteNodesJob.CostOfSlice;
            for (long done = 0; done < job.Cost; done += job.CostPerSlice)
                inputDeps = job.Schedule(inputDeps);
            // Slices may end early, at planes: the last one has no limit.
            job.CostPerSlice = int.MaxValue;
            return m_workspace.Last = job.Schedule(inputDeps);
        }

        AveragedColumns Averaged => new AveragedColumns
        {
            Columns = m_store.AveragedColumns,
            AverageOfPoint = m_workspace.AverageOfPoint,
            Sums = m_workspace.AverageSums,
        };
    }

    [BurstCompile]
    internal unsafe struct PrepareUpperJob : IJob
    {
        public const int PointsPerSlice = 100000; // A slice takes about 4 ms.
        public int First; // The points of this slice. The slices of one cloud run in order.
        public int End;
        public RecordLayout Layout;
        public Grid3 Corner;
        [ReadOnly] public NativeArray<byte> Records;
        public NativeArray<byte> CommonCubeLog2;
        public NativeArray<uint> Priority;

        public SliceTimes SliceTimes;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            new SampleInputs { CommonCubeLog2 = (byte*)CommonCubeLog2.GetUnsafePtr(), Priority = (uint*)Priority.GetUnsafePtr() }
                .Prepare((byte*)Records.GetUnsafeReadOnlyPtr(), First, End, Layout, Corner);
            SliceTimes.End(begin);
        }
    }

    /// <summary>Adds up the hashes of a top's points: the checksum of a cloud that has nothing below them.</summary>
    [BurstCompile]
    internal unsafe struct SumTopJob : IJob
    {
        [ReadOnly] public NativeList<byte> Records;

        public RecordLayout Layout;
        public NativeReference<ulong> Sum;

        public void Execute()
        {
            var records = (byte*)Records.GetUnsafeReadOnlyPtr();
            ulong sum = 0;
            for (int at = 0; at < Records.Length; at += Layout.StrideBytes)
                sum += Layout.HashOf(records + at, RecordHash.ChecksumSeed);
            Sum.Value = sum;
        }
    }
}
