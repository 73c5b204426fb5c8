using System;
using System.Threading.Tasks;
using FastPoints.Base;
using FastPoints.Store;

namespace FastPoints.Streaming
{
    /// <summary>
    /// A cloud's folder that may still be in the making, streamed as it grows: each new generation is added beside the one that
    /// is shown, and takes its place when nearly all that is selected of it is there. Main thread, but for opening folders.
    /// </summary>
    public sealed class FollowedFolder : IDisposable
    {
        /// <summary>Frames from one look at the folder to the next: a second.</summary>
        public const int FramesPerLook = 60;

        readonly CloudSuccession m_succession;
        readonly string m_path;
        readonly string[] m_planes;
        readonly CloudPlacement? m_placement;
        Task<CloudFolder> m_opening;
        long m_generation;
        bool m_isBuilding;
        int m_framesToLook;

        /// <param name="path">With or without the suffix of a folder in the making.</param>
        /// <param name="placement">Null for georeferenced space.</param>
        /// <param name="planes">As <see cref="FolderSource"/> has them.</param>
        /// <exception cref="PointCloudException">There is no cloud yet, or it is damaged.</exception>
        public FollowedFolder(StreamContext stream, string path, CloudPlacement? placement, params string[] planes)
            : this(new CloudSuccession(stream), path, placement, planes)
        {
        }

        /// <param name="succession">What is shown until the folder is there: a preview.</param>
        /// <param name="path">With or without the suffix of a folder in the making.</param>
        /// <param name="placement">Null for georeferenced space.</param>
        /// <param name="planes">As <see cref="FolderSource"/> has them.</param>
        /// <exception cref="PointCloudException">There is no cloud yet, or it is damaged.</exception>
        public FollowedFolder(CloudSuccession succession, string path, CloudPlacement? placement, params string[] planes)
        {
            m_succession = succession;
            m_path = path.EndsWith(StoreFormat.PartSuffix, StringComparison.Ordinal)
                ? path.Substring(0, path.Length - StoreFormat.PartSuffix.Length)
                : path;
            m_planes = planes;
            m_placement = placement;
            Add(CloudFolder.Open(m_path));
            m_framesToLook = FramesPerLook;
        }

        /// <summary>Number of the generation that is shown.</summary>
        public int Cloud => m_succession.Cloud;

        /// <summary>Of the newest generation that was found.</summary>
        public long Generation => m_generation;

        /// <summary>Whether newer generations are looked for.</summary>
        public bool IsBuilding => m_isBuilding;

        /// <summary>Whether the newest generation that was found is the one that is shown.</summary>
        public bool IsCurrent => m_succession.IsCurrent && m_opening == null;

        /// <summary>Once a frame, after it. Never waits.</summary>
        public void Update()
        {
            m_succession.Update();
            if (m_opening != null && m_opening.IsCompleted)
            {
                var opened = m_opening.Result;
                m_opening = null;
                if (opened != null)
                    Add(opened);
            }
            if (m_isBuilding && m_succession.IsCurrent && m_opening == null && --m_framesToLook <= 0)
            {
                m_framesToLook = FramesPerLook;
                long seen = m_generation;
                string path = m_path;
                m_opening = Task.Run(() => OpenNewer(path, seen));
            }
        }

        /// <summary>Waits for a folder that is being opened. What is streamed stays the stream's.</summary>
        public void Dispose()
        {
            m_opening?.Result?.Dispose();
            m_opening = null;
            m_isBuilding = false;
        }

        /// <returns>Null where there is none newer, or where it cannot be opened at this moment.</returns>
        static CloudFolder OpenNewer(string path, long seen)
        {
            CloudFolder folder = null;
            try
            {
                folder = CloudFolder.Open(path);
                if (folder.Manifest.Generation > seen || !folder.Manifest.IsBuilding)
                    return folder;
            }
            catch (PointCloudException)
            {
                // Between two generations, or gone: the next look tells.
            }
            folder?.Dispose();
            return null;
        }

        void Add(CloudFolder folder)
        {
            m_generation = folder.Manifest.Generation;
            m_isBuilding = folder.Manifest.IsBuilding;
            m_succession.Add(new FolderSource(folder, m_planes), m_placement);
        }
    }
}
