using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Build;
using FastPoints.Reading;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>The clouds to convert, one after the other, and the one being converted. Every change is on disk before the work
    /// continues: after a reload of scripts, a crash or a loss of power, the same clouds are converted from where they
    /// were.</summary>
    /// <remarks>Main thread. Its file and its lock only exist while there is something to do.</remarks>
    internal sealed class ImportQueue : IDisposable
    {
        public const string FileName = "imports.json";
        public const string LockName = "imports.lock";
        public const int MaxAttempts = 3; // An import that has ended the editor this often is not restarted automatically.

        const int Version = 1;
        static readonly TimeSpan s_refreshInterval = TimeSpan.FromSeconds(2);

        readonly ProjectPaths m_paths;
        readonly Func<ImportRequest, ConvertSettings> m_settings;
        readonly List<ImportRequest> m_requests = new List<ImportRequest>();
        FolderLock m_lock;
        DateTime m_nextRefresh;
        bool m_isUnsaved;

        /// <param name="paths">The queue is kept beside the converted clouds.</param>
        /// <param name="settings">Makes new settings for each request.</param>
        public ImportQueue(ProjectPaths paths, Func<ImportRequest, ConvertSettings> settings)
        {
            m_paths = paths;
            m_settings = settings;
        }

        public IReadOnlyList<ImportRequest> Requests => m_requests;

        public ConversionSession Session { get; private set; }

        public bool IsPausedByPlayMode { get; set; }

        public bool HasWork => m_requests.Exists(r => r.State == ImportState.Waiting || r.State == ImportState.Running);

        public ImportRequest CurrentRequest { get; private set; }

        /// <summary>Why nothing is converted or saved, in one line: another editor, or a folder that cannot be written. Null if
        /// all is well.</summary>
        public string Problem { get; private set; }

        /// <summary>Raised again when the cloud has got normals; the session says which it was, and with what success.</summary>
        public event Action<ImportRequest, ConversionSession> ConversionEnded;

        string FilePath => Path.Combine(m_paths.Clouds, FileName);

        internal int SaveCount { get; private set; } // How often the file was written or deleted.

        /// <summary>Adds a request at the end and removes a waiting one of the same folder. A folder that is being made stays
        /// with its request.</summary>
        public void Add(ImportRequest request) => Add(new[] { request });

        public void Add(IReadOnlyList<ImportRequest> requests)
        {
            if (requests.Count == 0)
                return;
            m_nextRefresh = default;
            Append(requests);
            Save();
        }

        /// <summary>Unsaved requests: until the lock is acquired, or the folder can be written; null for
        /// none.</summary>
        internal IReadOnlyList<ImportRequest> Unsaved =>
            (m_lock == null || m_isUnsaved) && m_requests.Count > 0 ? m_requests : null;

        public IEnumerable<string> ReservedPaths
        {
            get
            {
                foreach (var request in m_requests)
                    yield return m_paths.Absolute(request.Cloud);
            }
        }

        public ImportRequest RequestOfGuid(string guid) => m_requests.Find(r => r.AssetGuid == guid);

        public ImportRequest RequestOfCloud(string cloud) => m_requests.Find(r => IsSame(FolderOf(r), cloud));

        /// <summary>Continues the running conversion or begins the next one; called once an update.</summary>
        /// <param name="budgetMs">Main-thread time to use, not counting jobs.</param>
        public void Tick(double budgetMs, DateTime nowUtc)
        {
            if (!TryHoldLock(nowUtc))
                return;
            if (m_isUnsaved && nowUtc >= m_nextRefresh)
            {
                m_nextRefresh = nowUtc + s_refreshInterval;
                Save();
            }
            if (IsPausedByPlayMode)
                return;
            if (CurrentRequest?.State == ImportState.Paused && m_requests.Exists(r => r.State == ImportState.Waiting))
                SuspendSession();
            if (Session == null)
                Begin();
            else if (Session.Tick(budgetMs))
                End();
            if (m_requests.Count == 0 && !m_isUnsaved)
                ReleaseLock();
        }

        /// <summary>Lets others run first. A running conversion keeps its memory until another begins. One that reads its header
        /// is not paused.</summary>
        public void Pause(ImportRequest request)
        {
            if (request == CurrentRequest)
                Session.Pause();
            if (request == CurrentRequest ? Session.State == ConversionState.Paused : request.State == ImportState.Waiting)
                request.State = ImportState.Paused;
            Save();
        }

        public void Resume(ImportRequest request)
        {
            if (request == CurrentRequest)
                Session.Resume();
            else
                request.Attempts = 0;
            request.State = request == CurrentRequest ? ImportState.Running : ImportState.Waiting;
            request.Failure = null;
            Save();
        }

        public void MoveFirst(ImportRequest request)
        {
            if (request == CurrentRequest || !m_requests.Remove(request))
                return;
            m_requests.Insert(CurrentRequest == null ? 0 : m_requests.IndexOf(CurrentRequest) + 1, request);
            Save();
        }

        /// <summary>Removes a request and deletes what was made of it so far.</summary>
        public void Cancel(ImportRequest request)
        {
            if (!m_requests.Remove(request))
                return;
            if (request == CurrentRequest)
            {
                Session.Cancel();
                End();
            }
            else
            {
                CloudFolderWriter.DeleteUnfinished(m_paths.Absolute(request.Cloud));
                Save();
            }
            if (m_requests.Count == 0 && !m_isUnsaved)
                ReleaseLock();
        }

        /// <summary>Ends the running conversion before scripts are reloaded or the editor quits; the next queue of this folder
        /// continues it. What is <see cref="Unsaved"/> stays.</summary>
        public void Suspend()
        {
            if (CurrentRequest != null)
            {
                if (CurrentRequest.State == ImportState.Running)
                    CurrentRequest.State = ImportState.Waiting;
                SuspendSession();
                Save();
            }
            if (Unsaved == null)
                m_requests.Clear();
            ReleaseLock();
        }

        public void Dispose() => Suspend();

        bool TryHoldLock(DateTime nowUtc)
        {
            if (m_lock != null)
            {
                if (m_lock.Renew(nowUtc))
                    return true;
                m_lock = null;
                Problem = "another editor has taken over the imports of " + m_paths.Clouds;
                Session?.Suspend();
                Session = null;
                CurrentRequest = null;
                m_requests.Clear();
            }
            if (nowUtc < m_nextRefresh)
                return false;
            m_nextRefresh = nowUtc + s_refreshInterval;
            if (m_requests.Count == 0 && !File.Exists(FilePath))
            {
                Problem = null;
                return false;
            }
            try
            {
                string owner = FolderLock.TakeOrGetOwner(Path.Combine(m_paths.Clouds, LockName), out m_lock);
                Problem = owner == null ? null : owner + " imports into " + m_paths.Clouds;
                if (m_lock != null)
                    Load();
            }
            catch (PointCloudException e)
            {
                ReleaseLock();
                Problem = e.Message;
            }
            return m_lock != null;
        }

        void Begin()
        {
            CurrentRequest = m_requests.Find(r => r.State == ImportState.Waiting);
            if (CurrentRequest == null)
                return;
            CurrentRequest.State = ImportState.Running;
            CurrentRequest.Attempts++;
            Save();
            var sources = CurrentRequest.OnlyNormalsLeft ? null : CurrentRequest.Sources.ConvertAll(m_paths.Absolute);
            Session = new ConversionSession(sources, m_paths.Absolute(CurrentRequest.Cloud), m_settings(CurrentRequest));
        }

        /// <summary>The next session of this target continues from what is on disk.</summary>
        void SuspendSession()
        {
            Session.Suspend();
            CurrentRequest.Attempts = 0;
            (CurrentRequest, Session) = (null, null);
        }

        void End()
        {
            var request = CurrentRequest;
            var session = Session;
            CurrentRequest = null;
            Session = null;
            request.Attempts = 0;
            if (session.State == ConversionState.Failed)
            {
                request.State = ImportState.Failed;
                request.Failure = session.Failure.Message;
            }
            else if (session.State == ConversionState.Done && request.AddsNormals && !request.OnlyNormalsLeft)
            {
                (request.OnlyNormalsLeft, request.State) = (true, ImportState.Waiting);
            }
            else
            {
                m_requests.Remove(request);
            }
            Save();
            ConversionEnded?.Invoke(request, session);
        }

        /// <summary>Loaded requests come before those already here.</summary>
        void Load()
        {
            var kept = File.Exists(FilePath) ? Read() : new List<ImportRequest>();
            var added = new List<ImportRequest>(m_requests);
            m_requests.Clear();
            m_requests.AddRange(kept);
            foreach (var request in m_requests)
            {
                if (request.State != ImportState.Running)
                    continue;
                bool hasFailed = request.Attempts >= MaxAttempts;
                request.State = hasFailed ? ImportState.Failed : ImportState.Waiting;
                request.Failure = hasFailed ? "the editor ended " + request.Attempts + " times while this was imported" : null;
            }
            Append(added);
            Save();
        }

        void Append(IReadOnlyList<ImportRequest> requests)
        {
            var folders = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
            string running = CurrentRequest == null ? null : FolderOf(CurrentRequest);
            foreach (var request in requests)
                folders.Add(FolderOf(request));
            m_requests.RemoveAll(r => r != CurrentRequest && folders.Contains(FolderOf(r)));
            // The later of two requests for a folder counts.
            for (int i = requests.Count - 1, at = m_requests.Count; i >= 0; i--)
                if (folders.Remove(FolderOf(requests[i])) && !IsSame(FolderOf(requests[i]), running))
                    m_requests.Insert(at, requests[i]);
        }

        /// <summary>Reads the file. A damaged one is renamed: its clouds are imported again on request. One of a later version
        /// is left alone.</summary>
        List<ImportRequest> Read()
        {
            try
            {
                return FromJson(StoreFile.ReadText(FilePath), FilePath);
            }
            catch (PointCloudException e) when (e.Code == FailureCode.BadInput)
            {
                Problem = e.Message;
                string aside = FilePath + ".bad";
                FileChanges.Replace(FilePath, aside);
                return new List<ImportRequest>();
            }
        }

        /// <summary>Saves the requests; without the lock they stay in memory until it is acquired.</summary>
        void Save()
        {
            if (m_lock == null)
                return;
            SaveCount++;
            try
            {
                if (m_requests.Count == 0)
                    FileChanges.Delete(FilePath);
                else
                    TextFile.Write(FilePath, ToJson(m_requests));
                if (m_isUnsaved)
                    Problem = null;
                m_isUnsaved = false;
            }
            catch (Exception e) when (e is PointCloudException || FileFailures.IsFileFailure(e))
            {
                m_isUnsaved = true;
                Problem = e.Message;
            }
        }

        internal static string ToJson(IReadOnlyList<ImportRequest> requests)
        {
            var json = new JsonWriter().BeginObject().Add("version", Version).BeginArray("requests");
            foreach (var request in requests)
                request.Write(json);
            return json.EndArray().EndObject().ToString();
        }

        internal static List<ImportRequest> FromJson(string text, string path)
        {
            var json = JsonMembers.Parse(text, path);
            json.RequireVersion(Version);
            return json.Objects("requests").ConvertAll(ImportRequest.Read);
        }

        void ReleaseLock()
        {
            m_lock?.Dispose();
            m_lock = null;
        }

        string FolderOf(ImportRequest request) => m_paths.Absolute(request.Cloud);

        static bool IsSame(string a, string b) => string.Equals(a, b, StringComparison.OrdinalIgnoreCase);
    }
}
