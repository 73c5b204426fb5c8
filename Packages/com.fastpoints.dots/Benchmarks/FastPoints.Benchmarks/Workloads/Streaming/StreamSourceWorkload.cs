using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;

namespace FastPoints.Benchmarks
{
    /// <summary>A file with an octree (in the system's cache) into the pool as it is: read, decoded, packed and copied, with
    /// frames that follow one another without a pause, or at 60 Hz, beside a scan by as many workers that only decodes, but
    /// all attributes.</summary>
    sealed class StreamSourceWorkload : IWorkload
    {
        const int PoolBytes = 512 << 20;

        readonly Func<WorkloadContext, string> m_find;
        readonly double m_frameMs;
        string m_path;
        NativeArray<StreamView> m_views;

        StreamSourceWorkload(string kind, Func<WorkloadContext, string> find, double frameMs)
        {
            (m_find, m_frameMs) = (find, frameMs);
            (Name, LimitName) = ("stream " + kind + (frameMs > 0 ? " at 60 Hz" : ""), "scan " + kind);
        }

        public string Name { get; }
        public string LimitName { get; }

        public static IEnumerable<IWorkload> All()
        {
            foreach (var (kind, find) in new (string, Func<WorkloadContext, string>)[]
            {
                ("copc", BenchmarkSamples.FindCopc),
                ("ept", context => BenchmarkSamples.Find(context, BenchmarkSamples.EptLaszip)),
                ("potree", context => BenchmarkSamples.Find(context, BenchmarkSamples.PotreeBrotli)),
            })
            {
                yield return new StreamSourceWorkload(kind, find, 0);
                yield return new StreamSourceWorkload(kind, find, 1000.0 / 60);
                yield return new ColumnsWorkload("scan " + kind, null, find, isByWorkers: true);
            }
        }

        public void Prepare(WorkloadContext context)
        {
            m_path = m_find(context);
            m_views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1e9) };
            Run();
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            using var stream = new StreamContext(new MemoryNodePool(PoolBytes, 16 << 20));
            stream.Settings.Selection = new LodSettings { PointBudget = long.MaxValue, Hysteresis = 1 };
            stream.Settings.MaxUploadBytesPerFrame = PoolBytes;
            var reader = PointReaders.Open(m_path);
            JobCoroutine.RunToEnd(TreeSource.ReadTop(reader));
            var source = new TreeSource(reader, StoreLayout.ColorName, AttributeNames.Intensity);
            stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
            long bytes = 0;
            while (true)
            {
                var frame = Stopwatch.StartNew();
                var stats = FrameStep.Run(stream, m_views);
                bytes += stats.UploadedBytes;
                if (stats.IsSettled)
                    return new WorkloadResult { Points = stats.DrawnPoints, Bytes = bytes };
                if (m_frameMs > 0)
                    FrameLoop.Rest(frame, m_frameMs);
                else
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
