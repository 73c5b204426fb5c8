using System;
using FastPoints.Core;
using FastPoints.Store;
using FastPoints.Streaming;

namespace FastPoints.Tests.Support
{
    /// <summary>A cloud's folder that may still be in the making, streamed as it grows: each new generation is added beside the
    /// one that is shown, and takes its place when nearly all that is selected of it is there. Main thread, but for opening
    /// folders.</summary>
    public sealed class FollowedFolder : IDisposable
    {
        readonly CloudVersions m_versions;
        readonly FolderGenerations m_generations;
        readonly string[] m_planes;
        readonly CloudPlacement? m_placement;

        /// <param name="path">With or without the suffix of a folder in the making.</param>
        /// <param name="placement">Null for georeferenced space.</param>
        /// <param name="planes">As <see cref="FolderSource"/> has them.</param>
        /// <exception cref="PointCloudException">There is no cloud yet, or it is damaged.</exception>
        public FollowedFolder(StreamContext stream, string path, CloudPlacement? placement, params string[] planes)
            : this(new CloudVersions(stream), path, placement, planes) { }

        /// <param name="versions">What is shown until the folder is there: a preview.</param>
        /// <param name="path">With or without the suffix of a folder in the making.</param>
        /// <param name="placement">Null for georeferenced space.</param>
        /// <param name="planes">As <see cref="FolderSource"/> has them.</param>
        /// <exception cref="PointCloudException">There is no cloud yet, or it is damaged.</exception>
        public FollowedFolder(CloudVersions versions, string path, CloudPlacement? placement, params string[] planes)
        {
            m_versions = versions;
            m_planes = planes;
            m_placement = placement;
            m_generations = new FolderGenerations(CloudFolder.Open(StoreFormat.FinishedPath(path)));
            Add(m_generations.Take());
        }

        /// <summary>Number of the generation that is shown.</summary>
        public int Cloud => m_versions.Cloud;

        /// <summary>Of the newest generation that was found.</summary>
        public long Generation => m_generations.Generation;

        /// <summary>Whether newer generations are looked for.</summary>
        public bool IsBuilding => m_generations.IsBuilding;

        /// <summary>Whether the newest generation that was found is the one that is shown.</summary>
        public bool IsCurrent => m_versions.IsCurrent && m_generations.Newest == null;

        /// <summary>Once a frame, after it. Never waits. A generation that is not shown yet may never be: its files get other
        /// names with the next one.</summary>
        /// <exception cref="PointCloudException">As of <see cref="FolderGenerations.Update"/>.</exception>
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

        /// <summary>Waits for a folder that is being opened. What is streamed stays the stream's.</summary>
        public void Dispose() => m_generations.Dispose();

        void Add(CloudFolder folder) => m_versions.Add(new FolderSource(folder, m_planes),
            m_placement ?? CloudPlacement.Geo(folder.Manifest.Grid, folder.Manifest.Root),
            folder.IsUnfinished ? CloudStage.Building : CloudStage.Whole);
    }
}
