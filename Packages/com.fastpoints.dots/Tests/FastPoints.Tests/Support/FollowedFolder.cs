using System;
using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Tests
{
    /// <summary>A cloud's folder that may be unfinished, streamed as it grows: each new generation is added beside the
    /// one that is shown, and replaces it when nearly all its selected nodes are resident. Main thread, but for opening
    /// folders.</summary>
    public sealed class FollowedFolder : IDisposable
    {
        readonly CloudVersions m_versions;
        readonly GenerationPoller m_generations;
        readonly string[] m_planes;
        readonly CloudPlacement? m_placement;

        /// <param name="placement">Null for georeferenced space.</param>
        public FollowedFolder(StreamContext stream, string path, CloudPlacement? placement, params string[] planes)
            : this(new CloudVersions(stream), path, placement, planes) { }

        /// <param name="placement">Null for georeferenced space.</param>
        internal FollowedFolder(CloudVersions versions, string path, CloudPlacement? placement, params string[] planes)
        {
            m_versions = versions;
            m_planes = planes;
            m_placement = placement;
            m_generations = new GenerationPoller(CloudFolder.Open(StoreFormat.FinishedPath(path)));
            Add(m_generations.Take());
        }

        public int Cloud => m_versions.ShownNumber;
        public long Generation => m_generations.Generation;
        public bool IsBuilding => m_generations.IsBuilding;
        public bool IsCurrent => m_versions.IsCurrent && m_generations.Newest == null;

        /// <summary>Once a frame, after it. Never waits. A generation that is not shown yet may never be: its files get other
        /// names with the next one.</summary>
        public void Update()
        {
            m_versions.Update();
            // A build of a test's size has ended before a second is over.
            if (IsBuilding)
                m_generations.Refresh();
            m_generations.Update();
            if (m_generations.Newest != null)
                Add(m_generations.Take());
        }

        public void Dispose() => m_generations.Dispose();

        void Add(CloudFolder folder) => m_versions.Add(new FolderSource(folder, m_planes),
            m_placement ?? CloudPlacement.Geo(folder.Manifest.Grid, folder.Manifest.Root),
            folder.IsUnfinished ? CloudStage.Building : CloudStage.Whole);
    }
}
