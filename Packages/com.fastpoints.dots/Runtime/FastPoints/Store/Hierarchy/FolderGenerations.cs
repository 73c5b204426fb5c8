using System;
using System.Diagnostics;
using FastPoints.Core;

namespace FastPoints.Store
{
    /// <summary>Follows the generations of a cloud's folder that may still be in the making: looks for a newer one once a second,
    /// on a thread of the pool, and keeps it until it is taken. Main thread; only <see cref="Dispose"/> waits.</summary>
    internal sealed class FolderGenerations : IDisposable
    {
        /// <summary>Between two looks at the folder, however many frames come: in edit mode some come at rest, or none.</summary>
        public static readonly TimeSpan PollInterval = TimeSpan.FromSeconds(1);

        /// <summary>For a moment after a build, neither it nor its result may exist.</summary>
        const int MissesUntilDeleted = 2;

        readonly string m_path;
        PoolTask<Poll> m_polling;
        CloudFolder m_newest;
        ulong m_cloudId;
        long m_lastPoll = Stopwatch.GetTimestamp();
        int m_misses;
        bool m_isRequested;

        /// <summary>The result of one look.</summary>
        struct Poll
        {
            public bool Exists;

            /// <summary>Null if there is no newer one, or if it cannot be opened at this moment.</summary>
            public CloudFolder Newer;
        }

        /// <param name="first">This object owns it; it is the first to be taken.</param>
        public FolderGenerations(CloudFolder first) : this(first.FolderPath)
        {
            Keep(first);
        }

        /// <summary>Follows a folder that may not exist yet.</summary>
        /// <param name="path">With or without the suffix of a folder in the making.</param>
        public FolderGenerations(string path)
        {
            m_path = StoreFormat.FinishedPath(path);
            IsBuilding = true;
        }

        /// <summary>Number of the newest generation; 0 before the first.</summary>
        public long Generation { get; private set; }

        /// <summary>Whether any generation was found.</summary>
        public bool IsFound { get; private set; }

        /// <summary>Whether it looks for newer ones.</summary>
        public bool IsBuilding { get; private set; }

        /// <summary>Whether the folder no longer exists: the build was broken off, or the folder was deleted.</summary>
        public bool IsDeleted => m_misses >= MissesUntilDeleted;

        /// <summary>Whether no look is asked for or in progress, and no generation waits to be taken.</summary>
        public bool IsIdle => m_polling == null && m_newest == null && !m_isRequested;

        /// <summary>The newest generation that was not taken; null for none.</summary>
        public CloudFolder Newest => m_newest;

        /// <summary>Hands over <see cref="Newest"/>.</summary>
        public CloudFolder Take()
        {
            var taken = m_newest;
            m_newest = null;
            return taken;
        }

        /// <summary>Looks again with the next update, even at a finished cloud, which may have been rebuilt.</summary>
        public void Refresh() => m_isRequested = true;

        /// <summary>Called once a frame. It does not look while a generation waits to be taken, and never waits itself.</summary>
        /// <exception cref="PointCloudException">A look failed unexpectedly.</exception>
        public void Update()
        {
            if (m_polling != null && m_polling.IsDone)
            {
                var looked = m_polling;
                m_polling = null;
                var seen = looked.Take();
                m_misses = seen.Exists ? 0 : IsBuilding ? m_misses + 1 : MissesUntilDeleted;
                if (seen.Newer != null)
                    Keep(seen.Newer);
            }
            if (m_polling != null || m_newest != null || !m_isRequested && !(IsBuilding && IsPollDue))
                return;
            m_lastPoll = Stopwatch.GetTimestamp();
            m_isRequested = false;
            BeginPoll();
        }

        bool IsPollDue => (Stopwatch.GetTimestamp() - m_lastPoll) / (double)Stopwatch.Frequency >= PollInterval.TotalSeconds;

        /// <summary>This is a method of its own because a lambda's closure is allocated where its method begins.</summary>
        void BeginPoll()
        {
            string path = m_path;
            ulong cloudId = m_cloudId;
            long generation = Generation;
            bool wasBuilding = IsBuilding;
            m_polling = PoolTask.Begin(path, () => PollFolder(path, cloudId, generation, wasBuilding));
        }

        /// <summary>Waits if a folder is being opened.</summary>
        public void Dispose()
        {
            m_polling?.TakeOrDefault().Newer?.Dispose();
            m_polling = null;
            m_newest?.Dispose();
            m_newest = null;
            IsBuilding = false;
        }

        static Poll PollFolder(string path, ulong cloudId, long generation, bool wasBuilding)
        {
            var look = new Poll { Exists = CloudFolder.IsCloud(path) };
            if (!look.Exists)
                return look;
            CloudFolder folder = null;
            try
            {
                folder = CloudFolder.Open(path);
                var manifest = folder.Manifest;
                // A result without its final name cannot be read for long.
                bool isNewer = manifest.IsBuilding ? manifest.Generation > generation || manifest.CloudId != cloudId
                    : !folder.IsUnfinished && (wasBuilding || manifest.CloudId != cloudId);
                if (isNewer)
                {
                    look.Newer = folder;
                    return look;
                }
            }
            catch (PointCloudException)
            {
                // The folder is between two generations, or gone: the next look decides.
            }
            folder?.Dispose();
            return look;
        }

        void Keep(CloudFolder folder)
        {
            m_newest = folder;
            IsFound = true;
            m_cloudId = folder.Manifest.CloudId;
            Generation = folder.Manifest.Generation;
            IsBuilding = folder.IsUnfinished;
        }
    }
}
