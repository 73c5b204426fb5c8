using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Drawing
{
    /// <summary>What one camera's draws read, in memory that is reused from frame to frame. Main thread.</summary>
    public sealed unsafe class DrawList : IDisposable
    {
        readonly List<CloudLook> m_looks = new List<CloudLook>();
        readonly SizeTree m_sizes;
        NativeList<DrawListCloud> m_listed = new NativeList<DrawListCloud>(Allocator.Persistent);
        NativeList<GpuCloud> m_clouds = new NativeList<GpuCloud>(Allocator.Persistent);
        NativeList<GpuClipBox> m_clipBoxes = new NativeList<GpuClipBox>(Allocator.Persistent);
        NativeList<GpuNode> m_nodes = new NativeList<GpuNode>(1024, Allocator.Persistent);
        NativeList<uint> m_nodeOfInstance = new NativeList<uint>(16384, Allocator.Persistent);
        NativeList<BankDraw> m_draws = new NativeList<BankDraw>(Allocator.Persistent);
        NativeList<int> m_instanceOfBank = new NativeList<int>(Allocator.Persistent);
        NativeList<int> m_seen = new NativeList<int>(1024, Allocator.Persistent);
        NativeReference<long> m_points = new NativeReference<long>(Allocator.Persistent);
        NativeList<uint> m_previousFirstInstanceOfNode = new NativeList<uint>(Allocator.Persistent);
        NativeList<ListedSlot> m_listedOfSlot = new NativeList<ListedSlot>(Allocator.Persistent);

        /// <param name="sizes">The tree of all cameras; this list does not dispose it.</param>
        public DrawList(SizeTree sizes) => m_sizes = sizes;

        public bool IsCreated => m_nodes.IsCreated;

        // Indexed by cloud number.
        internal NativeArray<GpuCloud> Clouds => m_clouds.AsArray();
        internal NativeArray<GpuNode> Nodes => m_nodes.AsArray();

        /// <summary>Index in <see cref="Nodes"/> of each block's node.</summary>
        public NativeArray<uint> NodeOfInstance => m_nodeOfInstance.AsArray();
        internal NativeArray<BankDraw> Draws => m_draws.AsArray(); // One for each bank that has something to draw.

        internal NativeArray<GpuClipBox> ClipBoxes => m_clipBoxes.AsArray();

        // Whether points of listed nodes are left out: of hidden classes, or because a node appears or leaves.
        internal bool FiltersPoints { get; private set; }

        internal bool IgnoresNormals { get; set; } // Also clouds that have normals are lit by depths.

        // Whether points of any cloud are lit by the depths around them, or by their own normals.
        internal bool IsLitByDepths { get; private set; }
        internal bool IsLitByNormals { get; private set; }

        // Adaptive sizes are looked up in these; empty if there are none.
        internal NativeArray<GpuSizeNode> SizeNodes => m_sizes.Nodes;

        internal bool IsProgressive { get; set; } // Whether lists say where their nodes were in the one before.

        internal int ListNumber { get; private set; } // Of the last progressive list, from 1.

        // Indexed as Nodes: the node's first block in the list before, or ListedSlot.None.
        internal NativeArray<uint> PreviousFirstInstanceOfNode => m_previousFirstInstanceOfNode.AsArray();

        /// <summary>Points of the nodes that the camera sees.</summary>
        public long Points => m_points.Value;

        /// <summary>Sets how a cloud is coloured from now on. A cloud without a look is not drawn.</summary>
        public void SetLook(int cloud, CloudLook look)
        {
            // A plane of -1 is not drawn.
            while (m_looks.Count <= cloud)
                m_looks.Add(new CloudLook { Plane = -1 });
            m_looks[cloud] = look;
        }

        internal void UseLooks(DrawList other)
        {
            m_looks.Clear();
            m_looks.AddRange(other.m_looks);
        }

        /// <summary>Fills the list from the stream's last frame, relative to the view's eye. With a headset's right eye beside
        /// the left one, everything that either sees is listed.</summary>
        public void Build(StreamContext stream, in StreamView view, bool isAdaptive = false, StreamView? rightEye = null)
        {
            if (isAdaptive)
                m_sizes.Build(stream);
            else
                m_sizes.Clear();
            m_listed.Clear();
            m_clouds.Clear();
            m_clipBoxes.Clear();
            FiltersPoints = stream.IsFading;
            IsLitByDepths = IsLitByNormals = false;
            foreach (var box in stream.ClipBoxes)
                m_clipBoxes.Add(new GpuClipBox(box, view.EyeWorld));
            for (int c = 0; c < stream.Clouds.Count; c++)
            {
                var cloud = stream.Clouds[c];
                if (cloud == null || cloud.IsRemoving || c >= m_looks.Count || m_looks[c].Plane < 0)
                {
                    m_listed.Add(default);
                    m_clouds.Add(default);
                    continue;
                }
                var listed = new DrawListCloud
                {
                    Pages = cloud.Pages,
                    View = new CloudView(view, cloud.Placement, cloud.Source.Cubes.Size),
                    RightView = rightEye != null ? new CloudView(rightEye.Value, cloud.Placement, cloud.Source.Cubes.Size)
                        : default,
                    HasBothEyes = rightEye != null,
                    Placement = cloud.Placement,
                    Cubes = cloud.Source.Cubes,
                    Look = m_looks[c],
                    Step = cloud.Source.Grid.Step,
                    EyeWorld = view.EyeWorld,
                    PlaneCount = cloud.Source.Planes.Length,
                };
                if (IgnoresNormals)
                    listed.Look.NormalPlane = 0;
                m_listed.Add(listed);
                bool isLit = PointLighting.LitLevelOf(listed.Look.Light) > 0;
                IsLitByDepths |= isLit && listed.Look.NormalPlane == 0;
                IsLitByNormals |= isLit && listed.Look.NormalPlane > 0;
                FiltersPoints |= !listed.Look.HiddenClasses.IsEmpty;
                m_clouds.Add(listed.ToGpuCloud(cloud.Source.Layout, cloud.Source.Planes[listed.Look.Plane],
                    cloud.Source.Planes[listed.Look.ClassPlane]));
            }
            if (IsProgressive)
                ListNumber++;
            new ListBlocksJob
            {
                Drawn = stream.Drawn.AsArray(),
                Clouds = m_listed.AsArray(),
                SizeNodeOfDrawn = m_sizes.NodeOfDrawn,
                Nodes = m_nodes,
                NodeOfInstance = m_nodeOfInstance,
                Draws = m_draws,
                InstanceOfBank = m_instanceOfBank,
                Seen = m_seen,
                Points = m_points,
                ListNumber = IsProgressive ? ListNumber : 0,
                PreviousFirstInstanceOfNode = m_previousFirstInstanceOfNode,
                ListedOfSlot = m_listedOfSlot,
            }.Run();
        }

        public void Dispose()
        {
            if (!IsCreated)
                return;
            m_listed.Dispose();
            m_clouds.Dispose();
            m_clipBoxes.Dispose();
            m_nodes.Dispose();
            m_nodeOfInstance.Dispose();
            m_draws.Dispose();
            m_instanceOfBank.Dispose();
            m_seen.Dispose();
            m_points.Dispose();
            m_previousFirstInstanceOfNode.Dispose();
            m_listedOfSlot.Dispose();
        }
    }
}
