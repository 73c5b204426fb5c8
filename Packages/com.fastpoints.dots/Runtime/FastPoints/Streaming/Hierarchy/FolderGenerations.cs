using System;
using FastPoints.Base;
using FastPoints.Store;

namespace FastPoints.Streaming
{
    /// <summary>
    /// The generations of a cloud's folder that may still be in the making: looks for a newer one once a second, on a thread of
    /// the pool, and keeps it until somebody takes it. Main thread; only <see cref="Dispose"/> waits.
    /// </summary>
    internal sealed class FolderGenerations : IDisposable
    {
        /// <summary>Frames from one look at the folder to the next: a second.</summary>
        public const int FramesPerLook = 60;

        /// <summary>Between a build and its result there may be neither for a moment.</summary>
        const int LooksUntilGone = 2;

        readonly string m_path;
        PoolWork<Look> m_looking;
        CloudFolder m_newest;
        ulong m_cloudId;
        int m_framesToLook = FramesPerLook;
        int m_looksInVain;
        bool m_isAsked;

        /// <summary>What was found.</summary>
        struct Look
        {
            public bool IsThere;

            /// <summary>Null where there is no newer one, or where it cannot be opened at this moment.</summary>
            public CloudFolder Newer;
        }

        /// <param name="first">Becomes this object's, the first to be taken.</param>
        public FolderGenerations(CloudFolder first) : this(first.FolderPath)
        {
            Keep(first);
        }

        /// <summary>Of a folder that may come.</summary>
        /// <param name="path">With or without the suffix of a folder in the making.</param>
        public FolderGenerations(string path)
        {
            m_path = StoreFormat.FinishedPath(path);
            IsBuilding = true;
        }

        /// <summary>Of the newest one; 0 before the first.</summary>
        public long Generation { get; private set; }

        /// <summary>Whether there was one.</summary>
        public bool IsFound { get; private set; }

        /// <summary>Whether newer ones are looked for.</summary>
        public bool IsBuilding { get; private set; }

        /// <summary>Whether what was looked for is not there any more: the build was broken off, or somebody deleted
        /// it.</summary>
        public bool IsGone => m_looksInVain >= LooksUntilGone;

        /// <summary>Whether nothing is being looked for at this moment.</summary>
        public bool IsIdle => m_looking == null;

        /// <summary>The newest one that nobody has taken; null for none.</summary>
        public CloudFolder Newest => m_newest;

        /// <summary>Hands <see cref="Newest"/> over.</summary>
        public CloudFolder Take()
        {
            var taken = m_newest;
            m_newest = null;
            return taken;
        }

        /// <summary>Looks with the next update, at a finished cloud too: it may have been made anew.</summary>
        public void Refresh() => m_isAsked = true;

        /// <summary>Once a frame. Looks for nothing while there is one to take. Never waits.</summary>
        /// <exception cref="PointCloudException">A look came to what nobody foresaw.</exception>
        public void Update()
        {
            if (m_looking != null && m_looking.IsDone)
            {
                var looked = m_looking;
                m_looking = null;
                var seen = looked.Take();
                m_looksInVain = seen.IsThere ? 0 : IsBuilding ? m_looksInVain + 1 : LooksUntilGone;
                if (seen.Newer != null)
                    Keep(seen.Newer);
            }
            if (m_looking != null || m_newest != null || !m_isAsked && !(IsBuilding && --m_framesToLook <= 0))
                return;
            m_framesToLook = FramesPerLook;
            m_isAsked = false;
            BeginLook();
        }

        /// <summary>A method of its own: what a lambda takes along is allocated where its method begins.</summary>
        void BeginLook()
        {
            string path = m_path;
            ulong cloudId = m_cloudId;
            long generation = Generation;
            bool wasBuilding = IsBuilding;
            m_looking = PoolWork.Begin(path, () => LookAt(path, cloudId, generation, wasBuilding));
        }

        /// <summary>Waits for a folder that is being opened.</summary>
        public void Dispose()
        {
            m_looking?.TakeIfSound().Newer?.Dispose();
            m_looking = null;
            m_newest?.Dispose();
            m_newest = null;
            IsBuilding = false;
        }

        static Look LookAt(string path, ulong cloudId, long generation, bool wasBuilding)
        {
            var look = new Look { IsThere = CloudFolder.IsCloud(path) };
            if (!look.IsThere)
                return look;
            CloudFolder folder = null;
            try
            {
                folder = CloudFolder.Open(path);
                var manifest = folder.Manifest;
                // A result that has not got its name yet cannot be read for long.
                bool isNewer = manifest.IsBuilding ? manifest.Generation > generation || manifest.CloudId != cloudId
                    : !folder.IsInTheMaking && (wasBuilding || manifest.CloudId != cloudId);
                if (isNewer)
                {
                    look.Newer = folder;
                    return look;
                }
            }
            catch (PointCloudException)
            {
                // Between two generations, or gone: the next look tells.
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
            IsBuilding = folder.IsInTheMaking;
        }
    }
}
