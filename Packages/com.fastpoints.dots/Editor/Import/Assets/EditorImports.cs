using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Entities;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Connects the assets of a project to its queue of imports: it makes handles, requests conversions, shows their
    /// progress, and passes results on to assets and scenes.</summary>
    public sealed class EditorImports : IDisposable
    {
        static readonly TimeSpan s_reportAfter = TimeSpan.FromSeconds(0.25);

        readonly FastPointsSettings m_settings;
        readonly EditorTimeBudget m_timeBudget = new EditorTimeBudget();
        DateTime m_nextReport;
        readonly QueueProgress m_progress;
        readonly List<CloudDrop> m_drops = new List<CloudDrop>();
        readonly List<string> m_drawn = new List<string>();
        readonly List<Action> m_pendingWrites = new List<Action>(); // Assets whose files could not be written, to be tried again.
        bool m_isShowing;
        string m_problem;

        readonly Action[] m_parts;
        readonly HashSet<string> m_thrown = new HashSet<string>();
        double m_budgetMs;
        DateTime m_nowUtc;

        internal EditorImports(ProjectPaths paths, FastPointsSettings settings)
        {
            Paths = paths;
            m_settings = settings;
            // A reload of scripts, or quitting, ends deletions.
            if (PointCloudImports.IsMainEditor)
                FileChanges.BeginDeleteLeftovers(paths.Clouds, "*" + StoreFormat.FolderExtension + "*");
            Queue = new ImportQueue(paths, settings.ForConversion);
            Queue.ConversionEnded += End;
            m_progress = new QueueProgress(this);
            Thumbnails.Drawn += m_drawn.Add;
            Catalog = new CloudCatalog(paths);
            Assets = new CloudAssets(paths);
            UnusedClouds = new UnusedCloudPrompt(this);
            PointFilePrompt = new PointFilePrompt(settings);
            MissingData = new MissingDataPrompt(this);
            m_parts = new Action[]
            {
                UpdateQueue, () => Verification.Update(m_budgetMs), Transfers.Update, () => Exports.Update(m_budgetMs),
                UnusedClouds.Prompt, PointFilePrompt.Update, MissingData.Update, () => Thumbnails.Update(m_budgetMs),
                UpdateDrops, Report,
            };
        }

        internal ProjectPaths Paths { get; }
        internal ImportQueue Queue { get; }
        internal CloudCatalog Catalog { get; }
        internal CloudAssets Assets { get; }
        internal UnusedCloudPrompt UnusedClouds { get; }
        internal PointFilePrompt PointFilePrompt { get; }
        internal MissingDataPrompt MissingData { get; }
        internal EditorVerification Verification { get; } = new EditorVerification();
        internal CloudTransfers Transfers { get; } = new CloudTransfers();
        internal CloudExports Exports { get; } = new CloudExports();
        internal CloudThumbnails Thumbnails { get; } = new CloudThumbnails();

        /// <summary>The largest file in bytes that may be copied into the project.</summary>
        public long MaxCopiedBytes => (long)m_settings.MaxCopiedMiB << 20;

        /// <summary>Whether handles are still to be written because the system refused.</summary>
        internal bool HasPendingWrites => m_pendingWrites.Count > 0;

        /// <summary>Called once an update of the editor.</summary>
        public void Update(DateTime nowUtc)
        {
            m_nowUtc = nowUtc;
            m_budgetMs = m_timeBudget.Next(nowUtc, m_settings.UpdateMs, EditorApplication.isFocused);
            foreach (var part in m_parts)
            {
                try
                {
                    part();
                }
                catch (Exception e)
                {
                    // Rethrown, it would skip the other parts, and later subscribers of the update.
                    if (m_thrown.Add(e.ToString()))
                        Debug.LogException(e);
                }
            }
        }

        void UpdateQueue()
        {
            bool isPlaying = EditorApplication.isPlaying;
            Queue.IsPausedByPlayMode = isPlaying && m_settings.InPlayMode == InPlayMode.Pause;
            Queue.Session?.Adapt(isPlaying && m_settings.InPlayMode == InPlayMode.OneWorker ? 1 : m_settings.Workers,
                m_timeBudget.InFlightMs);
            Queue.Tick(m_budgetMs, m_nowUtc);
            if (m_progress.Session?.State == ConversionState.Suspended)
                m_progress.End(Progress.Status.Canceled);
        }

        void UpdateDrops()
        {
            if (m_drops.Count > 0 && m_drops[0].Update(m_budgetMs))
                m_drops.RemoveAt(0);
        }

        void Report()
        {
            // Each batch of imports costs Unity some ten milliseconds, whatever is in it.
            if (m_nowUtc >= m_nextReport || !Thumbnails.IsDrawing)
                ShowThumbnails();
            if (m_nowUtc < m_nextReport)
                return;
            m_nextReport = m_nowUtc + s_reportAfter;
            var refused = m_pendingWrites.ToArray();
            m_pendingWrites.Clear();
            foreach (var again in refused)
                again();
            if (Queue.Problem != m_problem && Queue.Problem != null)
                Debug.LogWarning("FastPoints: " + Queue.Problem);
            m_problem = Queue.Problem;
            if (Queue.Session != null)
                m_progress.Report();
        }

        /// <summary>Makes a handle for a file or folder that stays where it is.</summary>
        /// <param name="source">One cloud.</param>
        /// <param name="folder">The handle's folder, in <c>Assets</c>.</param>
        /// <returns>The asset; null if it could not be made, which is logged.</returns>
        public PointCloudAsset CreateAsset(string source, string folder)
        {
            try
            {
                var names = HandleFile.FreeHandlePaths(Paths.Absolute(folder));
                string path = HandleFile.Create(new[] { source }, Paths, names, NewTargets(), false, out var handle);
                string asset = Paths.Stored(path);
                AssetDatabase.ImportAsset(asset);
                AddThumbnail(handle);
                if (ShouldAutoConvert(handle))
                    Queue.Add(RequestFor(asset, handle));
                return AssetDatabase.LoadAssetAtPath<PointCloudAsset>(asset);
            }
            catch (PointCloudException e)
            {
                Debug.LogError("FastPoints: " + e.Message);
                return null;
            }
        }

        /// <summary>Does the same with several, as one cloud or as separate ones, which the user is asked once; in the next
        /// updates.</summary>
        /// <param name="target">Where they are shown; null for nowhere.</param>
        internal void CreateAsset(IReadOnlyList<string> sources, string folder, DropTarget target) =>
            m_drops.Add(new CloudDrop(this, sources, folder, target));

        internal bool IsCreating => m_drops.Count > 0;

        internal void CreatePointFileHandles(IReadOnlyList<string> assets)
        {
            // An asset is also reimported to show its picture: a cancelled conversion stays cancelled.
            if (m_isShowing || assets.Count == 0)
                return;
            var requests = new List<ImportRequest>();
            var known = new HashSet<string>();
            foreach (var request in Queue.Requests)
                if (request.State != ImportState.Failed)
                    known.Add(request.AssetGuid);
            foreach (string asset in assets)
                if (CreatePointFileHandle(asset) is { } request && !known.Contains(request.AssetGuid))
                    requests.Add(request);
            Queue.Add(requests);
        }

        /// <returns>A request to convert it, if it is to be converted at once.</returns>
        ImportRequest CreatePointFileHandle(string asset)
        {
            var handle = OfPointFile(asset);
            if (!CloudFolder.IsCloud(Paths.Absolute(handle.CloudPath)))
            {
                if (!File.Exists(CloudThumbnails.PathOf(Paths.Absolute(handle.CloudPath))))
                    AddThumbnail(handle);
                return ShouldAutoConvert(handle) && RequestFor(asset, handle) is { } request &&
                    !IsAutoConvertDisabled(request.Cloud)
                    ? request : null;
            }
            if (handle.Stamp?.Compare(handle.Sources.ConvertAll(Paths.Absolute)) == SourceChange.Changed)
                Debug.LogWarning("FastPoints: " + asset + " has changed since it was converted: its inspector converts it again");
            return null;
        }

        /// <summary>Copies an asset's converted cloud to a folder outside, under a free name.</summary>
        /// <returns>The copy's folder, which exists when the copy is complete; null if nothing can be copied, which is
        /// logged.</returns>
        public string ExportCopy(PointCloudAsset asset, string folder)
        {
            string cloud = Paths.Absolute(asset.ProjectPath);
            if (File.Exists(Path.Combine(cloud, StoreFormat.ManifestName)))
                return Transfers.ExportCopy(cloud, folder);
            Debug.LogError("FastPoints: " + asset.name + " is not converted: wanted a cloud in " + cloud);
            return null;
        }

        /// <summary>Copies a converted cloud into the project's folder of clouds, and makes a handle for the copy when it is
        /// complete.</summary>
        /// <param name="folder">The handle's folder, in <c>Assets</c>.</param>
        public void ImportCopy(string cloud, string folder)
        {
            TryCreateIgnoredFolder(Paths.Clouds);
            if (CloudSources.IsConverted(cloud))
                Transfers.ImportCopy(cloud, Paths, copy => Selection.activeObject = CreateAsset(copy, folder));
            else
                Debug.LogError("FastPoints: " + cloud + ": wanted a converted cloud, a folder with " + StoreFormat.ManifestName);
        }

        /// <summary>Converts an asset's cloud, for the first time or again.</summary>
        public void Convert(string asset) => Convert(new[] { asset });

        internal void Convert(IEnumerable<string> assets)
        {
            var requests = new List<ImportRequest>();
            foreach (string asset in assets)
                try
                {
                    var request = RequestFor(asset, HandleOf(asset));
                    FileChanges.TryDelete(AutoConvertMarkPath(request.Cloud), () => false);
                    requests.Add(request);
                }
                catch (PointCloudException e)
                {
                    Debug.LogError("FastPoints: " + e.Message);
                }
            Queue.Add(requests);
        }

        internal void Cancel(ImportRequest request)
        {
            Queue.Cancel(request);
            if (!request.OnlyNormalsLeft)
                DisableAutoConvert(request.Cloud);
        }

        /// <summary>However often Unity imports its asset, the cloud is no longer converted automatically, nor asked
        /// about.</summary>
        internal void DisableAutoConvert(string cloud)
        {
            TryCreateIgnoredFolder(Paths.Clouds);
            try
            {
                TextFile.Write(AutoConvertMarkPath(cloud), "", false);
            }
            catch (PointCloudException e)
            {
                Debug.LogWarning("FastPoints: " + e.Message);
            }
        }

        internal bool IsAutoConvertDisabled(string cloud) => File.Exists(AutoConvertMarkPath(cloud));

        string AutoConvertMarkPath(string cloud) => Path.ChangeExtension(Paths.Absolute(cloud), ".cancelled");

        /// <summary>The handle of an asset's cloud.</summary>
        /// <exception cref="PointCloudException">The handle cannot be read.</exception>
        internal CloudHandle HandleOf(string asset) => asset.EndsWith(CloudHandle.Extension, StringComparison.OrdinalIgnoreCase)
            ? HandleFile.Read(Paths.Absolute(asset))
            : OfPointFile(asset);

        /// <summary>The request in the queue for an asset's cloud, which a copy of the asset may have made; null if there is
        /// none.</summary>
        internal ImportRequest RequestOf(string asset) => Queue.RequestOfGuid(AssetDatabase.AssetPathToGUID(asset)) ??
            (Assets.All.TryGetValue(asset, out string cloud) ? Queue.RequestOfCloud(cloud) : null);

        /// <summary>Draws the picture of a handle's cloud: from the converted cloud if there is one, otherwise from its
        /// files.</summary>
        internal void AddThumbnail(CloudHandle handle)
        {
            TryCreateIgnoredFolder(Paths.Clouds);
            string cloud = Paths.Absolute(handle.CloudPath);
            if (handle.Sources.Count == 0 || CloudFolder.IsCloud(cloud))
                Thumbnails.Add(cloud);
            else
                Thumbnails.AddFiles(cloud, handle.Sources.ConvertAll(Paths.Absolute));
        }

        /// <summary>Called before scripts are reloaded or the editor quits.</summary>
        public void Suspend()
        {
            m_progress.End(Progress.Status.Canceled);
            foreach (var drop in m_drops)
                drop.Dispose();
            m_drops.Clear();
            Verification.Dispose();
            Transfers.Dispose();
            Exports.Dispose();
            MissingData.Dispose();
            Thumbnails.Dispose();
            Queue.Suspend();
        }

        public void Dispose() => Suspend();

        internal ImportRequest RequestFor(string asset, CloudHandle handle)
        {
            TryCreateIgnoredFolder(Paths.Clouds);
            return new ImportRequest
            {
                AssetGuid = AssetDatabase.AssetPathToGUID(asset),
                Cloud = handle.CloudPath,
                Sources = new List<string>(handle.Sources),
                Sampler = m_settings.Sampler,
                AddsNormals = m_settings.Normals,
            };
        }

        /// <summary>A new folder is ignored by Git: its content is large and can be converted again.</summary>
        internal void TryCreateIgnoredFolder(string folder)
        {
            if (Directory.Exists(folder) || !PointCloudImports.IsMainEditor)
                return;
            try
            {
                Directory.CreateDirectory(folder);
                if (m_settings.GitIgnore)
                    TextFile.Write(Path.Combine(folder, ".gitignore"),
                        "# FastPoints makes this again of its sources.\n*\n");
            }
            catch (Exception e) when (e is PointCloudException || FileFailures.IsFileFailure(e))
            {
                // The queue reports it and retries.
            }
        }

        internal bool ShouldAutoConvert(CloudHandle handle) => m_settings.ConvertAtOnce && ShouldConvert(handle);

        internal bool ShouldConvert(CloudHandle handle) =>
            handle.Sources.Count > 0 && (!handle.IsSourceOctree || m_settings.ConvertOctrees);

        /// <summary>Names for new clouds, none of which another asset or request is waiting for.</summary>
        internal FreePaths NewTargets()
        {
            var reserved = new List<string>(Assets.Clouds);
            reserved.AddRange(Queue.ReservedPaths);
            return Catalog.NewTargets(reserved);
        }

        CloudHandle OfPointFile(string asset)
        {
            string folder = ProjectPaths.StoredFolderOf(AssetDatabase.AssetPathToGUID(asset));
            var handle = new CloudHandle { CloudPath = Paths.Stored(folder) };
            handle.Sources.Add(asset);
            handle.IsSourceOctree = CloudSources.HasOctree(asset);
            try
            {
                handle.Stamp = StampFile.Read(Paths.Absolute(handle.CloudPath));
            }
            catch (PointCloudException e)
            {
                Debug.LogWarning("FastPoints: " + e.Message);
            }
            return handle;
        }

        void End(ImportRequest request, ConversionSession session)
        {
            string asset = AssetDatabase.GUIDToAssetPath(request.AssetGuid);
            m_progress.End(session.State == ConversionState.Done ? Progress.Status.Succeeded
                : session.State == ConversionState.Failed ? Progress.Status.Failed : Progress.Status.Canceled);
            if (session.Failure is PointCloudException known)
                Debug.LogError("FastPoints: " + known.FullMessage);
            else if (session.Failure != null)
                Debug.LogException(session.Failure);
            if (session.State != ConversionState.Done)
                return;
            if (session.Source is { } source)
            {
                foreach (var warning in source.Warnings)
                    Debug.LogWarning("FastPoints: " + warning);
                foreach (var loss in source.Losses)
                    Debug.LogWarning("FastPoints: " + loss);
            }
            string cloud = Paths.Absolute(request.Cloud);
            // A copy of an asset has the same cloud.
            foreach (string user in new List<string>(Assets.Of(cloud)))
            {
                if (session.Result != null)
                    Update(user, cloud, session, DateTime.UtcNow.AddMilliseconds(FileChanges.RetryTimeoutMs));
                Refresh(user);
            }
            Thumbnails.Add(cloud);
        }

        void Update(string asset, string cloud, ConversionSession session, DateTime untilUtc)
        {
            try
            {
                if (!asset.EndsWith(CloudHandle.Extension, StringComparison.OrdinalIgnoreCase))
                {
                    StampFile.Write(cloud, session.Stamp);
                    return;
                }
                var shown = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(asset);
                HandleFile.Update(Paths.Absolute(asset), session.Result.Manifest, session.Stamp, OriginShown(asset),
                    shown != null ? shown.Up : UpAxis.Z, session.Source);
                AssetDatabase.ImportAsset(asset);
            }
            catch (PointCloudException e)
            {
                if (e.InnerException != null && FileChanges.IsTransient(e.InnerException) && DateTime.UtcNow < untilUtc)
                    m_pendingWrites.Add(() => Update(asset, cloud, session, untilUtc));
                else
                    Debug.LogError("FastPoints: " + e.Message);
            }
        }

        /// <summary>Unity asks for an asset's picture when it imports the asset, and reimports an unchanged one only by
        /// force.</summary>
        internal void ShowThumbnails()
        {
            if (m_drawn.Count == 0)
                return;
            m_isShowing = true;
            AssetDatabase.StartAssetEditing();
            try
            {
                foreach (string cloud in m_drawn)
                    foreach (string asset in Assets.Of(cloud))
                        AssetDatabase.ImportAsset(asset, ImportAssetOptions.ForceUpdate);
                m_drawn.Clear();
            }
            finally
            {
                AssetDatabase.StopAssetEditing();
                m_isShowing = false;
            }
        }

        /// <summary>Makes the scenes' clouds of an asset open its folder again.</summary>
        /// <param name="asset">Its path.</param>
        public static void Refresh(string asset)
        {
            foreach (var cloud in CloudsOf(asset))
                cloud.Refresh();
            // Clouds of subscenes have no component.
            var shown = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(asset);
            if (shown != null)
                PointCloudSystemGroup.ObjectGroup?.Refresh(shown.Paths.FullPath);
            EditorApplication.QueuePlayerLoopUpdate();
        }

        /// <summary>The origin of the scenes' clouds of an asset; null if none is shown.</summary>
        static double3? OriginShown(string asset)
        {
            foreach (var cloud in CloudsOf(asset))
                if (cloud.Origin == null && cloud.TryGetSpace(out var space))
                    return space.OriginGeo;
            return null;
        }

        static IEnumerable<PointCloud> CloudsOf(string path)
        {
            var asset = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(path);
            if (asset == null)
                yield break;
            foreach (var cloud in Resources.FindObjectsOfTypeAll<PointCloud>())
                if (cloud.Cloud == asset)
                    yield return cloud;
        }
    }
}
