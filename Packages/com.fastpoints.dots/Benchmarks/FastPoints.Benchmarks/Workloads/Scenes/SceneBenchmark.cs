using System;
using System.Threading;
using FastPoints.Entities;
using FastPoints.Sources;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Entities;
using Unity.Mathematics;
using Unity.Transforms;

namespace FastPoints.Benchmarks
{
    /// <summary>A world as scenes have it, with the package's systems and memory in place of a GPU: what clouds in a
    /// scene cost the main thread, frame by frame. Frames follow one another without a pause.</summary>
    sealed class SceneBenchmark : IDisposable
    {
        public const int MinBankBytes = 1 << 20, MaxBankBytes = 8 << 20;

        readonly World m_world = new World("scene benchmark");
        readonly PointCloudSystemGroup m_group;
        Entity m_cloud;

        public SceneBenchmark(long poolBytes)
        {
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(PointCloudSystemGroup),
                typeof(ApplyBudgetSystem), typeof(OpenCloudsSystem), typeof(PlaceCloudsSystem), typeof(AddCloudsSystem),
                typeof(ClipCloudsSystem), typeof(ShowCloudsSystem), typeof(ReceiveNodesSystem), typeof(ControlNodesSystem),
                typeof(SelectNodesSystem), typeof(UploadNodesSystem), typeof(RequestNodesSystem), typeof(ListNodesSystem),
                typeof(TrackNodesSystem), typeof(ReportFailuresSystem));
            m_group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
            m_group.Begin(new MemoryNodePool(poolBytes,
                (int)math.clamp(poolBytes / 16, MinBankBytes, MaxBankBytes)));
            PointFileReaders.Register();
        }

        public SliceTimes FrameTimes { get; } = new SliceTimes(Allocator.Persistent);

        public long Garbage { get; private set; } // Managed bytes that the main thread allocated in the last frame.

        public StreamSettings Settings => m_group.Stream.Settings;
        public bool IsIdle => m_group.Stats.IsSettled && !m_group.IsOpening && IsOpen;
        public bool IsOpen => m_world.EntityManager.HasComponent<StreamedPointCloud>(m_cloud);

        public long PoolBytes
        {
            set => m_group.Stream.Pool.LimitBytes = value;
        }

        public void WantNodes() => m_world.EntityManager.CreateEntity(ComponentType.ReadWrite<PointCloudNodesWanted>());

        public void Show(string path)
        {
            var entities = m_world.EntityManager;
            m_cloud = entities.CreateEntity(ComponentType.ReadWrite<PointCloudFile>());
            new PointCloudPaths { Path = path }.WriteTo(entities.AddBuffer<PointCloudPathByte>(m_cloud));
            entities.AddComponentData(m_cloud, new LocalToWorld { Value = float4x4.identity });
        }

        public FrameStats Frame(StreamView view)
        {
            m_group.Views.Add(view);
            long garbage = GC.GetAllocatedBytesForCurrentThread();
            long begin = SliceTimes.Begin();
            m_world.Update();
            FrameTimes.End(begin);
            Garbage = GC.GetAllocatedBytesForCurrentThread() - garbage;
            Thread.Yield();
            return m_group.Stats;
        }

        /// <summary>Later quantiles are of later frames only.</summary>
        public void ResetTimes()
        {
            using var earlier = new SliceTimes(Allocator.Persistent);
            earlier.TakeFrom(FrameTimes);
        }

        public WorkloadResult Result(long points, long bytes, string note) => new WorkloadResult
        {
            Points = points,
            Bytes = bytes,
            Error = FrameTimes.QuantileMs(0.99),
            ErrorUnit = "ms p99 a frame",
            Note = note,
        };

        public void Dispose()
        {
            m_world.Dispose();
            FrameTimes.Dispose();
        }
    }
}
