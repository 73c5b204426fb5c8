using System.Threading;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;
using FastPoints.SourceFeeds;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;

namespace FastPoints.Benchmarks
{
    /// <summary>A COPC file (in the system's cache) into the pool as it is: read, decoded, packed and copied, with frames that
    /// follow one another without a pause. Compare its points a second with those of <c>stream upload</c>.</summary>
    public sealed class StreamCopcWorkload : IWorkload
    {
        const int PoolBytes = 64 << 20;

        string m_path;
        NativeArray<StreamView> m_views;

        public string Name => "stream copc";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = BenchmarkSamples.FindCopc(context);
            m_views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1e9) };
            Run();
        }

        /// <summary>A fresh stream each time: what was made once is kept by no one.</summary>
        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            using var stream = new StreamContext(new MemoryNodePool(PoolBytes, PoolBytes / 4));
            stream.Settings.Selection = new SelectionSettings { PointBudget = long.MaxValue, Hysteresis = 1 };
            stream.Settings.UploadBytesPerFrame = PoolBytes;
            var reader = PointReaders.Open(m_path);
            WorkPump.RunToEnd(TreeSource.FindTop(reader));
            var source = new TreeSource(reader, StoreLayout.ColorName, AttributeNames.Intensity);
            stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
            long bytes = 0;
            while (true)
            {
                var stats = FrameStep.Run(stream, m_views);
                bytes += stats.UploadedBytes;
                if (stats.IsSettled)
                    return new WorkloadResult { Points = stats.DrawnPoints, Bytes = bytes };
                Thread.Yield();
            }
        }

        public void Dispose()
        {
            if (m_views.IsCreated)
                m_views.Dispose();
        }
    }
}
