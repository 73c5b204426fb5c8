using System.IO;
using System.Threading;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>A converted cloud from its files (in the system's cache) through reads, hashes and checks into the pool, with
    /// frames that follow one another without a pause. Two of them take turns in a pool with room for one, so that its memory is
    /// warm.</summary>
    public sealed class StreamUploadWorkload : IWorkload
    {
        StreamContext m_stream;
        NativeArray<StreamView> m_views;
        int m_shown;

        public string Name => "stream upload";
        public string LimitName => "stream memory copy";

        public void Prepare(WorkloadContext context)
        {
            string path = TerrainBenchmarkFile.MakeConverted(context);
            long bytes = 0;
            foreach (string file in Directory.GetFiles(path, "*.bin", SearchOption.AllDirectories))
                bytes += new FileInfo(file).Length;
            const int Bank = 4 << 20;
            // A node's last page is half empty, and a bank's end is not always used.
            m_stream = new StreamContext(new MemoryNodePool((bytes * 5 / 4 + 2 * Bank) / Bank * Bank, Bank));
            m_stream.Settings.Selection = new LodSettings { PointBudget = long.MaxValue, Hysteresis = 1 };
            m_stream.Settings.MaxUploadBytesPerFrame = 64 << 20;
            m_views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1) };
            for (int i = 0; i < 2; i++)
                m_stream.Add(new FolderSource(CloudFolder.Open(path), StoreLayout.ColorName), default);
            for (int i = 0; i < 6; i++)
                Run();
        }

        public WorkloadResult Run()
        {
            var hidden = m_stream.Clouds[m_shown];
            hidden.Placement = default;
            m_shown = 1 - m_shown;
            var shown = m_stream.Clouds[m_shown];
            shown.Placement = new CloudPlacement(double3x3.identity, 0);
            long bytes = 0;
            while (true)
            {
                var stats = FrameStep.Run(m_stream, m_views);
                bytes += stats.UploadedBytes;
                if (stats.IsSettled)
                    return new WorkloadResult { Points = stats.DrawnPoints, Bytes = bytes };
                Thread.Yield();
            }
        }

        public void Dispose()
        {
            m_stream?.Dispose();
            if (m_views.IsCreated)
                m_views.Dispose();
        }
    }
}
