using System;
using System.Collections.Generic;
using System.Threading;
using FastPoints.Queries;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>What a game and a measuring tool ask of a terrain: rays of four pixels from above against two million points in
    /// memory, on all workers; or one ray to full detail, of a folder in the system's cache.</summary>
    sealed class QueryWorkload : IWorkload
    {
        const long ResidentPoints = 2_000_000;

        readonly int m_rays; // 0 for one in full detail.
        readonly double m_heightMetres;
        StreamContext m_stream;
        PointCloudQueries m_queries;
        NativeArray<PointQuery> m_rayList;
        NativeArray<PointHit> m_hits;
        NativeArray<int> m_countOfRay;
        int m_next;

        QueryWorkload(int rays, double heightMetres) => (m_rays, m_heightMetres) = (rays, heightMetres);

        public static IEnumerable<IWorkload> All()
        {
            yield return new QueryWorkload(1000, 10);
            yield return new QueryWorkload(1000, 100);
            yield return new QueryWorkload(0, 10);
        }

        public string Name => (m_rays > 0 ? "query 1,000 rays" : "query a ray stored") + " from "
            + NumberText.Of(m_heightMetres) + " m";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            string path = TerrainBenchmarkFile.MakeConverted(context);
            m_stream = new StreamContext(new MemoryNodePool(1L << 30, 8 << 20));
            m_stream.Settings.Selection = new LodSettings { PointBudget = ResidentPoints, Hysteresis = 1 };
            m_stream.Settings.MaxUploadBytesPerFrame = 64 << 20;
            var folder = CloudFolder.Open(path);
            var bounds = folder.Manifest.BoundsGeo;
            var source = new FolderSource(folder, StoreLayout.ColorName);
            m_stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
            m_queries = new PointCloudQueries(m_stream);
            int rays = Math.Max(1, m_rays);
            m_rayList = new NativeArray<PointQuery>(Math.Max(64, rays), Allocator.Persistent);
            m_hits = new NativeArray<PointHit>(rays, Allocator.Persistent);
            m_countOfRay = new NativeArray<int>(rays, Allocator.Persistent);
            var random = new Unity.Mathematics.Random(context.Seed);
            for (int i = 0; i < m_rayList.Length; i++)
            {
                var target = new double3(random.NextDouble2(bounds.Min.xy, bounds.Max.xy), bounds.Min.z);
                var eye = new double3(bounds.Center.xy, bounds.Max.z + m_heightMetres);
                m_rayList[i] = PointQuery.FromEye(eye, target - eye, 1000, 4);
            }
            if (m_rays > 0)
                Fill();
        }

        public WorkloadResult Run()
        {
            if (m_rays > 0)
            {
                m_queries.Schedule(m_rayList, 1, m_hits, m_countOfRay).Complete();
                int hit = 0;
                foreach (int count in m_countOfRay)
                    hit += count;
                string note = hit + " rays hit, " + (m_queries.Bytes >> 20) + " MiB of copies";
                return new WorkloadResult { Points = m_rays, Note = note };
            }
            var found = new List<PointHit>();
            JobCoroutine.RunToEnd(m_queries.FindInFullDetail(m_rayList[m_next++ % m_rayList.Length], 1, found));
            return new WorkloadResult { Points = 1 };
        }

        public void Dispose()
        {
            m_queries.Dispose();
            m_stream.Dispose();
            m_rayList.Dispose();
            m_hits.Dispose();
            m_countOfRay.Dispose();
        }

        void Fill()
        {
            using var views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1e9) };
            _ = m_queries.Resident;
            for (bool isSettled = false; !isSettled; Thread.Yield())
            {
                isSettled = FrameStep.Run(m_stream, views).IsSettled;
                m_queries.Update();
                isSettled &= m_queries.IsComplete;
            }
        }
    }
}
