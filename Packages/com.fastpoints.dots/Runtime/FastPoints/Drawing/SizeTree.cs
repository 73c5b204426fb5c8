using System;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>Finds how far apart points are at any position, among all that a frame draws: a node's points are as far apart as
    /// those of the deepest node that is drawn there (Schuetz, "Potree: Rendering Large Point Clouds in Web Browsers",
    /// 2016, ch. 4.3.3). Main thread.</summary>
    public sealed unsafe class SizeTree : IDisposable
    {
        /// <summary>The most levels below a node that are searched: a float cannot resolve more.</summary>
        public const int MaxLevels = 22;

        NativeList<SizeTreeCloud> m_clouds = new NativeList<SizeTreeCloud>(Allocator.Persistent);
        NativeList<GpuSizeNode> m_nodes = new NativeList<GpuSizeNode>(1024, Allocator.Persistent);
        NativeList<int> m_nodeOfDrawn = new NativeList<int>(1024, Allocator.Persistent);
        NativeList<SizeTreeLink> m_links = new NativeList<SizeTreeLink>(1024, Allocator.Persistent);
        NativeList<int> m_order = new NativeList<int>(1024, Allocator.Persistent);
        StreamContext m_stream;
        uint m_frame;

        internal NativeArray<GpuSizeNode> Nodes => m_nodes.AsArray();

        /// <summary>Indexed by node in the stream's list of what to draw.</summary>
        public NativeArray<int> NodeOfDrawn => m_nodeOfDrawn.AsArray();

        /// <summary>Takes what the stream's last frame listed; calling it again for that frame does nothing.</summary>
        public void Build(StreamContext stream)
        {
            if (m_stream == stream && m_frame == stream.Selector.Frame)
                return;
            m_stream = stream;
            m_frame = stream.Selector.Frame;
            m_clouds.Clear();
            for (int c = 0; c < stream.Clouds.Count; c++)
            {
                var cloud = stream.Clouds[c];
                if (cloud == null)
                    m_clouds.Add(default);
                else
                    m_clouds.Add(CloudOf(cloud));
            }
            new BuildSizeTreeJob
            {
                Drawn = stream.Drawn.AsArray(),
                Clouds = m_clouds.AsArray(),
                Links = m_links,
                Order = m_order,
                Nodes = m_nodes,
                NodeOfDrawn = m_nodeOfDrawn,
            }.Run();
        }

        static SizeTreeCloud CloudOf(StreamedCloud cloud)
        {
            var axisScale = CloudView.AxisScaleOf(cloud.Placement);
            return new SizeTreeCloud
            {
                Pages = cloud.Pages,
                Cubes = cloud.Source.Cubes,
                AxisScale = (float3)axisScale,
                SpacingScale = (float)CloudView.SpacingScaleOf(axisScale, cloud.Source.Cubes.Size),
            };
        }

        /// <summary>Clears the tree, so that nothing is adaptive.</summary>
        public void Clear()
        {
            m_stream = null;
            m_nodes.Clear();
            m_nodeOfDrawn.Clear();
        }

        public void Dispose()
        {
            if (!m_nodes.IsCreated)
                return;
            m_clouds.Dispose();
            m_nodes.Dispose();
            m_nodeOfDrawn.Dispose();
            m_links.Dispose();
            m_order.Dispose();
        }
    }
}
