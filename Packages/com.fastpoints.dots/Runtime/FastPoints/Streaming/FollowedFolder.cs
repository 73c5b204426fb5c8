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

        /// <summary>Of the newer generation's selected nodes, so many are drawn when the older one goes.</summary>
        const double ReadyShare = 0.95;
        const int None = -1;

        readonly StreamContext m_stream;
        readonly string m_path;
        readonly string[] m_planes;
        readonly CloudPlacement? m_placement;
        Task<CloudFolder> m_opening;
        long m_generation;
        bool m_isBuilding;
        int m_framesToLook;
        uint m_frameAdded;
        int m_next = None;

        /// <param name="path">With or without the suffix of a folder in the making.</param>
        /// <param name="placement">Null for georeferenced space.</param>
        /// <param name="planes">As <see cref="FolderSource"/> has them.</param>
        /// <exception cref="PointCloudException">There is no cloud yet, or it is damaged.</exception>
        public FollowedFolder(StreamContext stream, string path, CloudPlacement? placement, params string[] planes)
        {
            m_stream = stream;
            m_path = path.EndsWith(StoreFormat.PartSuffix, StringComparison.Ordinal)
                ? path.Substring(0, path.Length - StoreFormat.PartSuffix.Length)
                : path;
            m_planes = planes;
            m_placement = placement;
            Cloud = Add(CloudFolder.Open(m_path));
            m_framesToLook = FramesPerLook;
        }

        /// <summary>Number of the generation that is shown.</summary>
        public int Cloud { get; private set; }

        /// <summary>Of the newest generation that was found.</summary>
        public long Generation => m_generation;

        /// <summary>Whether newer generations are looked for.</summary>
        public bool IsBuilding => m_isBuilding;

        /// <summary>Whether the newest generation that was found is the one that is shown.</summary>
        public bool IsCurrent => m_next == None && m_opening == null;

        /// <summary>Once a frame, after it. Never waits.</summary>
        public void Update()
        {
            if (m_next != None && IsReady(m_next))
            {
                m_stream.Remove(Cloud);
                Cloud = m_next;
                m_next = None;
            }
            if (m_opening != null && m_opening.IsCompleted)
            {
                var opened = m_opening.Result;
                m_opening = null;
                if (opened != null)
                    m_next = Add(opened);
            }
            if (m_isBuilding && m_next == None && m_opening == null && --m_framesToLook <= 0)
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

        int Add(CloudFolder folder)
        {
            m_generation = folder.Manifest.Generation;
            m_isBuilding = folder.Manifest.IsBuilding;
            m_frameAdded = m_stream.Selector.Frame;
            var source = new FolderSource(folder, m_planes);
            return m_stream.Add(source, m_placement ?? CloudPlacement.Geo(source.Grid, source.Root));
        }

        bool IsReady(int cloud)
        {
            int selected = 0, drawn = 0;
            foreach (var node in m_stream.Selector.Selected)
                selected += node.Cloud == cloud ? 1 : 0;
            foreach (var node in m_stream.Drawn)
                drawn += node.Cloud == cloud ? 1 : 0;
            foreach (var missing in m_stream.Selector.Missing)
                if (missing.Cloud == cloud)
                    return false;
            // Out of view there is nothing to wait for, once a selection has had it.
            return drawn >= ReadyShare * selected && m_stream.Selector.Frame != m_frameAdded;
        }
    }
}
