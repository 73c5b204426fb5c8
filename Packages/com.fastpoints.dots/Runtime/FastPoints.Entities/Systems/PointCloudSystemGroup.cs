using System;
using System.Collections.Generic;
using FastPoints.Queries;
using FastPoints.Rendering;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Entities;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Entities
{
    /// <summary>
    /// All of streaming, once a frame: what the systems below it share, and its life. In the editor's world as in the player's.
    /// Their order:
    /// <list type="number">
    /// <item><see cref="CollectViewsSystem"/>: cameras that were drawn</item>
    /// <item><see cref="ApplyBudgetSystem"/>: limits that were set</item>
    /// <item><see cref="OpenCloudsSystem"/>, <see cref="PlaceCloudsSystem"/>: files become sources, transforms placements</item>
    /// <item><see cref="AddCloudsSystem"/>: entities that were added and removed</item>
    /// <item><see cref="ClipCloudsSystem"/>: boxes that all are clipped by</item>
    /// <item><see cref="ShowCloudsSystem"/>: how clouds are coloured</item>
    /// <item><see cref="ReceiveNodesSystem"/>: what arrived since the last frame</item>
    /// <item><see cref="ControlNodesSystem"/>: what users hide, pin and tint</item>
    /// <item><see cref="SelectNodesSystem"/>: what the cameras need</item>
    /// <item><see cref="UploadNodesSystem"/>: begins to copy</item>
    /// <item><see cref="RequestNodesSystem"/>: begins to read, evicts</item>
    /// <item><see cref="ListNodesSystem"/>: what to draw</item>
    /// <item><see cref="TrackNodesSystem"/>: entities of nodes follow</item>
    /// <item><see cref="ReportFailuresSystem"/>: reports what could not be read</item>
    /// </list>
    /// </summary>
    [WorldSystemFilter(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor)]
    [UpdateInGroup(typeof(PresentationSystemGroup))]
    public partial class PointCloudSystemGroup : ComponentSystemGroup
    {
        /// <summary>The group is idle after this many frames without reads and uploads: a dropped node is requested
        /// again within them.</summary>
        const int FramesToIdle = 40;

        /// <summary>A progressive picture has tried each point after as many frames as a block has points.</summary>
        const int FramesToComplete = PlaneShape.MaxPointsPerBlock;

        /// <summary>Bytes of graphics memory without a <see cref="PointCloudBudget"/>; changes apply from the next frame on. An
        /// editor sets it from the project's settings.</summary>
        public static long DefaultPoolBytes = 512 << 20;

        static readonly List<PointCloudSystemGroup> s_all = new List<PointCloudSystemGroup>();

        /// <summary>The world whose clouds are streamed and drawn, those of GameObjects too. Null for the first that has clouds;
        /// GameObjects prefer the default world, unless it draws nothing, as a server's. Other worlds' clouds wait until it ends.
        /// Set it before clouds are shown.</summary>
        public static World ObjectWorld { get; set; }

        NativeList<StreamView> m_views;
        NativeList<StreamView> m_lastViews;
        int m_idleFrames;
        readonly List<Entity> m_toDestroy = new List<Entity>();
        EntityQuery m_files;
        PointCloudQueries m_queries;
        bool m_cannotDraw;
        double m_lastSeconds;
        FrameStats m_stats;

        /// <summary>Null until <see cref="Begin"/>, or until there is a <see cref="PointCloudFile"/>: from then on, clouds are
        /// streamed to the graphics card and drawn.</summary>
        public StreamContext Stream { get; private set; }

        /// <summary>Asks the world's clouds for points, from the first call on: they then follow each frame. Null while nothing
        /// is streamed.</summary>
        public PointCloudQueries Queries => m_queries ??= Stream == null ? null : new PointCloudQueries(Stream);

        /// <summary>The same of the clouds of GameObjects.</summary>
        public static PointCloudQueries ObjectQueries => ObjectGroup?.Queries;

        /// <summary>The group of the world that GameObjects' clouds are in; null if no world has one.</summary>
        internal static PointCloudSystemGroup ObjectGroup
        {
            get
            {
                var chosen = ObjectWorld != null && ObjectWorld.IsCreated ? ObjectWorld : null;
                PointCloudSystemGroup found = null;
                foreach (var group in s_all)
                    if (chosen != null ? group.World == chosen : group.Scene != null)
                        return group;
                    else if (found == null || group.World == World.DefaultGameObjectInjectionWorld)
                        found = group;
                return found;
            }
        }

        internal double3 Shift; // By how much the world was moved (PointCloudOrigin.ShiftEntities).

        internal PointScene Scene { get; private set; } // What passes draw; null if Begin was called by hand.

        internal readonly EntityClouds Live = new EntityClouds();

        /// <summary>Whether files of clouds are being opened or polled, or have states to be taken.</summary>
        internal bool IsOpening { get; set; }

        /// <summary>Whether a cloud is unfinished on disk: its folder is polled once a second, if there are frames.</summary>
        internal bool IsFollowing { get; set; }

        /// <summary>What the frame has done so far; after the update, all that it did.</summary>
        public ref FrameStats Stats => ref m_stats;

        /// <summary>The cameras of the next frame: code that draws adds its own, and the frame takes them all.</summary>
        public NativeList<StreamView> Views => m_views;

        /// <summary>Whether another frame would change something: clouds are being opened, nodes are in flight, or a camera has
        /// moved. In edit mode and when paused, frames only come on request.</summary>
        public bool NeedsFrame
        {
            get
            {
                if (Stream == null)
                    return CanBegin;
                // Polling a folder needs frames until it ends.
                return m_idleFrames < FramesToIdle + (IsProgressive ? FramesToComplete : 0) || IsOpening ||
                    Scene != null && HasMoved(Scene.CollectNextViews());
            }
        }

        /// <summary>Begins to stream with a pool that the stream owns from now on.</summary>
        public void Begin(NodePool pool)
        {
            if (Stream != null)
                throw new InvalidOperationException("the world's clouds are streamed already");
            Stream = new StreamContext(pool);
        }

        /// <summary>The error of opening a <see cref="PointCloudFile"/>, in one line; null if there was none.</summary>
        public string ErrorOf(Entity cloud) => Live.Find(cloud)?.Error;

        /// <summary>Gives an entity with a <see cref="PointCloudPlacement"/> the source that it is streamed from; the
        /// stream takes it in the next frame. If there is one already, the new source is a newer state of the same
        /// cloud and replaces it when it is ready. Copies of the entity do not have it.</summary>
        /// <param name="source">It is disposed with the entity or the world.</param>
        /// <param name="look">What becomes the entity's <see cref="PointCloudLook"/> when the source is shown; null keeps the
        /// current one.</param>
        public void SetSource(Entity cloud, NodeSource source, PointCloudLook? look = null,
            CloudStage stage = CloudStage.Whole) => Live.GetOrAdd(cloud).SetSource(source, look, stage);

        protected override void OnCreate()
        {
            base.OnCreate();
            s_all.Add(this);
            m_views = new NativeList<StreamView>(Allocator.Persistent);
            m_lastViews = new NativeList<StreamView>(Allocator.Persistent);
            m_files = GetEntityQuery(ComponentType.ReadOnly<PointCloudFile>());
        }

        protected override void OnUpdate()
        {
            foreach (var entity in m_toDestroy)
                EntityManager.DestroyEntity(entity);
            m_toDestroy.Clear();
            if (Stream == null && !TryBegin())
            {
                // No system does it, as on a server.
                Live.RemoveDestroyed(EntityManager);
                return;
            }
            m_stats = default;
            CountSeconds();
            base.OnUpdate();
            m_queries?.Update();
            bool isBusy = m_queries != null && m_queries.IsCopying || m_stats.ReadsInFlight > 0 ||
                m_stats.RequestedNodes > 0 || m_stats.UploadedNodes > 0 ||
                m_stats.FadingNodes > 0 || Stream.Uploads.IsInFlight || Stream.IsRemovingAny || Stream.IsReadingHierarchy ||
                IsProgressive && HasMoved(m_views.AsArray());
            m_idleFrames = isBusy ? 0 : m_idleFrames + 1;
            m_lastViews.Clear();
            m_lastViews.AddRange(m_views.AsArray());
            m_views.Clear();
        }

        protected override void OnDestroy()
        {
            s_all.Remove(this);
            if (ObjectWorld == World)
                ObjectWorld = null;
            Live.Dispose();
            Scene?.Dispose();
            Scene = null;
            m_queries?.Dispose();
            m_queries = null;
            Stream?.Dispose();
            Stream = null;
            if (m_views.IsCreated)
            {
                m_views.Dispose();
                m_lastViews.Dispose();
            }
            base.OnDestroy();
        }

        /// <summary>Destroys an entity in the next frame, if it cannot be destroyed now.</summary>
        internal void DestroyLater(Entity entity)
        {
            m_toDestroy.Add(entity);
            Wake();
        }

        /// <summary>Requests frames after a change that they do not detect.</summary>
        internal void Wake() => m_idleFrames = 0;

        internal bool IsShown(string folder)
        {
            foreach (var (entity, live) in Live)
                if (IsShown(entity, live, folder))
                    return true;
            return false;
        }

        /// <summary>Has all clouds of this folder poll for newer data on disk in the next frame.</summary>
        internal void Refresh(string folder)
        {
            foreach (var (entity, live) in Live)
            {
                if (!IsShown(entity, live, folder))
                    continue;
                var file = EntityManager.GetComponentData<PointCloudFile>(entity);
                file.NeedsRefresh = true;
                EntityManager.SetComponentData(entity, file);
            }
        }

        bool IsShown(Entity entity, EntityCloud live, string folder) =>
            live.Opened?.Path == folder && EntityManager.HasComponent<PointCloudFile>(entity);

        internal void ReuseViews() => m_views.AddRange(m_lastViews.AsArray());

        bool IsProgressive => Scene != null && Scene.Style.IsProgressive && Application.isPlaying;

        unsafe bool HasMoved(NativeArray<StreamView> next) => next.Length > 0 && (next.Length != m_lastViews.Length ||
            UnsafeUtility.MemCmp(next.GetUnsafeReadOnlyPtr(), m_lastViews.GetUnsafePtr(),
                (long)next.Length * sizeof(StreamView)) != 0);

        /// <summary>By the clock: a game's time stands still in edit mode and when it is paused. Recorders say what a frame takes
        /// in the film.</summary>
        void CountSeconds()
        {
            double now = UnityEngine.Time.realtimeSinceStartupAsDouble;
            float recorded = UnityEngine.Time.captureDeltaTime;
            Stream.FrameSeconds = recorded > 0 ? recorded : (float)(now - m_lastSeconds);
            m_lastSeconds = now;
        }

        /// <summary>Two worlds of clients may have the same clouds: one of them shows them.</summary>
        bool CanBegin => !m_cannotDraw && !m_files.IsEmpty && PointScene.Current == null &&
            (ObjectWorld == null || !ObjectWorld.IsCreated || ObjectWorld == World);

        /// <summary>Begins with the first cloud: a world without clouds takes no memory.</summary>
        bool TryBegin()
        {
            if (!CanBegin)
                return false;
            // A server, or an editor without graphics.
            m_cannotDraw = SystemInfo.graphicsDeviceType == GraphicsDeviceType.Null;
            if (m_cannotDraw)
                return false;
            var resources = PointCloudResources.Load();
            string reason = resources == null ? "the package's " + PointCloudResources.Path + " is not there"
                : GraphicsNodePool.UnsupportedReason;
            if (reason != null)
            {
                m_cannotDraw = true;
                Debug.LogWarning("Point clouds are not drawn: " + reason);
                return false;
            }
            Begin(new GraphicsNodePool(resources.CopyPages, DefaultPoolBytes));
            Stream.Settings.FadeSeconds = StreamSettings.SceneFadeSeconds;
            Scene = new PointScene(resources.Points, resources.Compose, Stream, resources.Raster, resources.Progressive);
            PointScene.Current = Scene;
            return true;
        }
    }
}
