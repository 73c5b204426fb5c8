using System.Globalization;
using System.Threading;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;

namespace FastPoints.Benchmarks
{
    public sealed unsafe class StreamPoolWorkload : IWorkload
    {
        const int BankBytes = 8 << 20;
        const long PoolBytes = 1L << 30;

        string m_path;
        NativeArray<StreamView> m_views;
        long m_points;

        public string Name => "stream pool";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = TerrainBenchmarkFile.MakeConverted(context);
            m_points = context.Points;
            m_views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1) };
        }

        public WorkloadResult Run()
        {
            var (quarterBytes, quarter) = Fill(m_points / 4);
            var (bytes, points) = Fill(long.MaxValue);
            return new WorkloadResult
            {
                Points = quarter + points,
                Bytes = quarterBytes + bytes,
                Error = (double)bytes / points,
                ErrorUnit = "bytes a point",
                Note = string.Format(CultureInfo.InvariantCulture, "bytes of the pool a resident point: {0:0.00} of {1:N0} "
                    + "points, {2:0.00} of {3:N0}", (double)bytes / points, points, (double)quarterBytes / quarter, quarter),
            };
        }

        public void Dispose()
        {
            if (m_views.IsCreated)
                m_views.Dispose();
        }

        (long Bytes, long Points) Fill(long budget)
        {
            using var stream = new StreamContext(new MemoryNodePool(PoolBytes, BankBytes));
            stream.Settings.Selection = new LodSettings { PointBudget = budget, Hysteresis = 1 };
            stream.Settings.MaxUploadBytesPerFrame = 64 << 20;
            var source = new FolderSource(CloudFolder.Open(m_path), StoreLayout.ColorName);
            stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
            while (!FrameStep.Run(stream, m_views).IsSettled)
                Thread.Yield();
            long points = 0;
            foreach (var slot in stream.Cache.Nodes)
                if (slot.Phase == CachePhase.Resident)
                    points += stream.Clouds[slot.Cloud].Pages[slot.Page].Nodes[slot.Node].PointCount;
            return (stream.Pool.AllocatedBytes, points);
        }
    }
}
