using System;
using System.Diagnostics;

namespace FastPoints.Store
{
    // Follows a cloud's folder that may be unfinished: polls for a newer generation once a second, on a thread of the
    // pool, and keeps it until it is taken. Main thread; only Dispose waits.
    internal sealed class GenerationPoller : IDisposable
    {
        // By time, not by frames: an idle editor may draw none.
        public static readonly TimeSpan PollInterval = TimeSpan.FromSeconds(1);
        const int MissesUntilDeleted = 2; // For a moment after a build, neither it nor its result may exist.

        readonly string m_path, m_journal;
        CloudManifest m_known; // Of the generation that was kept last.
        ulong m_knownEdits; // Their hash; 0 for none.
        int m_writes = EditJournal.Writes; // Before they were read.
        EditOperation m_draft; // Likewise.
        PoolTask<Poll> m_polling;
        long m_lastPoll = Stopwatch.GetTimestamp();
        int m_misses;
        bool m_isRequested;
        bool m_isStale;

        struct Poll
        {
            public bool Exists;
            public bool HasFailed; // It exists, but could not be opened.

            // Null if there is no newer one, or if it cannot be opened at this moment.
            public CloudFolder Newer;
            public Edited Edits;
        }

        // What is to be applied to a cloud, or why nothing is.
        struct Edited
        {
            public EditPlan Plan;
            public ulong Hash;
            public PointCloudException Refused;
        }

        // Takes ownership of the folder, which is also the first that Take returns.
        public GenerationPoller(CloudFolder first) : this(first.FolderPath)
        {
            m_draft = EditJournal.DraftAt(m_journal);
            Keep(first, EditsOf(first, m_draft));
        }

        // The folder may not exist yet. The path may have the suffix of an unfinished folder.
        public GenerationPoller(string path)
        {
            m_path = StoreFormat.FinishedPath(path);
            m_journal = EditJournal.PathOf(path);
            IsBuilding = true;
        }

        // 0 before the first.
        public long Generation { get; private set; }
        public bool IsFound { get; private set; }
        public bool IsBuilding { get; private set; }

        public bool IsDeleted => m_misses >= MissesUntilDeleted; // The build was aborted, or the folder was deleted.

        // No poll is requested or in flight, and no generation waits to be taken.
        public bool IsIdle => m_polling == null && Newest == null && !IsRequested;

        bool IsRequested => m_isRequested || m_writes != EditJournal.Writes || m_draft != EditJournal.DraftAt(m_journal);

        public bool IsFollowing => IsBuilding || m_isStale; // Looks again once a second.

        public CloudFolder Newest { get; private set; }

        public EditPlan Edits { get; private set; } // Of the generation that was kept last, as it was opened; null for none.

        public PointCloudException Refused { get; private set; } // Why its edits are not applied, or null.

        public CloudFolder Take()
        {
            var taken = Newest;
            Newest = null;
            return taken;
        }

        // Looks again with the next update, even at a finished cloud, which may have been rebuilt.
        public void Refresh() => m_isRequested = true;

        // What a web server gave was not what the cloud said: looks, until it opens, whether there is another now.
        public void MarkStale() => m_isStale = SourcePath.IsRemote(m_path);

        // Called once a frame; it never waits. Throws where a look failed unexpectedly.
        public void Update()
        {
            if (m_polling != null && m_polling.IsDone)
            {
                var looked = m_polling;
                m_polling = null;
                var seen = looked.Take();
                m_misses = seen.Exists ? 0 : IsBuilding ? m_misses + 1 : MissesUntilDeleted;
                m_isStale |= seen.HasFailed && SourcePath.IsRemote(m_path);
                if (seen.Newer != null)
                    Keep(seen.Newer, seen.Edits);
            }
            if (m_polling != null || Newest != null || !IsRequested && !(IsFollowing && IsPollDue))
                return;
            m_lastPoll = Stopwatch.GetTimestamp();
            m_isRequested = m_isStale = false;
            m_writes = EditJournal.Writes;
            m_draft = EditJournal.DraftAt(m_journal);
            BeginPoll();
        }

        bool IsPollDue => (Stopwatch.GetTimestamp() - m_lastPoll) / (double)Stopwatch.Frequency >= PollInterval.TotalSeconds;

        // A method of its own because a lambda's closure is allocated where its method begins.
        void BeginPoll()
        {
            string path = m_path;
            var known = m_known;
            ulong edits = m_knownEdits;
            var draft = m_draft;
            bool wasBuilding = IsBuilding;
            m_polling = PoolTask.Begin(path, () => PollFolder(path, known, edits, draft, wasBuilding));
        }

        public void Dispose()
        {
            m_polling?.TakeOrDefault().Newer?.Dispose();
            m_polling = null;
            Newest?.Dispose();
            Newest = null;
            IsBuilding = m_isStale = false;
        }

        static Poll PollFolder(string path, CloudManifest known, ulong edits, EditOperation draft, bool wasBuilding)
        {
            var look = new Poll { Exists = CloudFolder.IsCloud(path) };
            if (!look.Exists)
                return look;
            CloudFolder folder = null;
            CloudFolder.MarkStale(path);
            try
            {
                folder = CloudFolder.Open(path);
                var manifest = folder.Manifest;
                bool isOther = known == null || manifest.CloudId != known.CloudId;
                look.Edits = EditsOf(folder, draft);
                // A finished cloud under its temporary name is about to be renamed: wait for that.
                bool isNewer = manifest.IsBuilding ? isOther || manifest.Generation > known.Generation
                    : !folder.IsUnfinished && (wasBuilding || isOther || manifest.RootHash != known.RootHash ||
                        look.Edits.Hash != edits);
                if (isNewer)
                {
                    look.Newer = folder;
                    return look;
                }
            }
            catch (PointCloudException)
            {
                // The folder is between two generations, or gone: the next look decides.
                look.HasFailed = true;
            }
            folder?.Dispose();
            return look;
        }

        static Edited EditsOf(CloudFolder folder, EditOperation draft)
        {
            var plan = EditPlan.Of(folder, out var refused, draft);
            return new Edited { Plan = plan, Hash = plan?.Hash ?? 0, Refused = refused };
        }

        void Keep(CloudFolder folder, Edited edits)
        {
            (Edits, m_knownEdits, Refused) = (edits.Plan, edits.Hash, edits.Refused);
            Newest = folder;
            IsFound = true;
            m_known = folder.Manifest;
            Generation = folder.Manifest.Generation;
            IsBuilding = folder.IsUnfinished;
        }
    }
}
