using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using FastPoints.Entities;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Files that were dropped together become assets: their headers are read and handles written on a thread of the
    /// pool, Unity imports all in one batch, and the rest is done in slices. However many there are, each asset is loaded
    /// once, and the queue is written once.</summary>
    internal sealed class CloudDrop : IDisposable
    {
        /// <summary>A handle on disk, or why there is none.</summary>
        struct Written
        {
            public string Path;
            public CloudHandle Handle;
            public PointCloudException Failure;
        }

        readonly EditorImports m_imports;
        readonly string[] m_sources;
        readonly string m_folder;
        readonly DropTarget m_target;
        readonly CancellationTokenSource m_cancellation = new CancellationTokenSource();
        PoolTask<List<Written>> m_writing;
        JobCoroutine m_rest;
        int m_progress = -1;
        int m_written;
        int m_clouds;

        /// <param name="sources">Absolute paths; their order has no effect.</param>
        /// <param name="folder">The handles' folder, in <c>Assets</c>.</param>
        /// <param name="target">Where they are shown, in the order of their paths; null for nowhere.</param>
        public CloudDrop(EditorImports imports, IReadOnlyList<string> sources, string folder, DropTarget target)
        {
            m_imports = imports;
            m_sources = new List<string>(sources).ToArray();
            Array.Sort(m_sources, StringComparer.Ordinal);
            m_folder = folder;
            m_target = target;
        }

        /// <summary>Called once an update of the editor; asks the user first, after the mouse was released.</summary>
        /// <returns>Whether it has ended.</returns>
        public bool Update(double budgetMs)
        {
            try
            {
                if (m_writing == null && m_rest == null && !TryBegin())
                    return true;
                if (m_writing != null && !m_writing.IsDone)
                {
                    Progress.Report(m_progress, (float)m_written / m_clouds, m_folder);
                    return false;
                }
                m_rest ??= new JobCoroutine(Import(m_writing.Take()));
                m_writing = null;
                if (!m_rest.Tick(budgetMs))
                    return false;
            }
            catch (Exception e)
            {
                Debug.LogError("FastPoints: " + PointCloudException.Of(m_folder, e).FullMessage);
                if (m_progress >= 0)
                    Progress.Finish(m_progress, Progress.Status.Failed);
                return true;
            }
            Progress.Finish(m_progress);
            return true;
        }

        /// <summary>Scripts are reloaded. Handles that are written by now are found by Unity's next refresh.</summary>
        public void Dispose()
        {
            m_cancellation.Cancel();
            m_writing?.TakeOrDefault();
            m_rest?.Cancel();
            if (m_progress < 0)
                return;
            Progress.Finish(m_progress, Progress.Status.Canceled);
            Debug.LogWarning("FastPoints: a reload of scripts broke off the import of " + m_clouds +
                " point clouds: drop those again that are not there");
        }

        bool TryBegin()
        {
            var choice = CanMerge ? Prompt() : SeveralFiles.Separate;
            if (choice == SeveralFiles.Ask)
                return false;
            var clouds = new List<string[]>();
            if (choice == SeveralFiles.OneCloud)
                clouds.Add(m_sources);
            else
                foreach (string source in m_sources)
                    clouds.Add(new[] { source });
            m_clouds = clouds.Count;
            m_progress = Progress.Start("Import " + m_sources.Length + " point cloud files", m_folder,
                Progress.Options.Unmanaged);
            string folder = m_imports.Paths.Absolute(m_folder);
            var (handles, targets) = (HandleFile.FreeHandlePaths(folder), m_imports.NewTargets());
            m_writing = PoolTask.Begin(folder, () => Write(clouds, handles, targets));
            return true;
        }

        /// <summary>Octrees and converted clouds are never combined.</summary>
        bool CanMerge => Array.TrueForAll(m_sources, s => File.Exists(s) && !CloudSources.HasOctree(s));

        /// <returns>Ask if the user does not want any.</returns>
        SeveralFiles Prompt()
        {
            var settings = FastPointsSettings.instance;
            if (settings.SeveralFiles != SeveralFiles.Ask)
                return settings.SeveralFiles;
            int answer = EditorUtility.DisplayDialogComplex("Several point cloud files", "Are these " + m_sources.Length +
                " files one point cloud, or separate ones on a shared origin? The answer is kept: Project Settings > " +
                "FastPoints changes it.", "One cloud", "Cancel", "Separate clouds");
            if (answer == 1)
                return SeveralFiles.Ask;
            settings.SeveralFiles = answer == 0 ? SeveralFiles.OneCloud : SeveralFiles.Separate;
            settings.Save();
            return settings.SeveralFiles;
        }

        /// <summary>On a pool thread.</summary>
        List<Written> Write(List<string[]> clouds, FreePaths handles, FreePaths targets)
        {
            var written = new List<Written>(clouds.Count);
            foreach (var sources in clouds)
            {
                if (m_cancellation.IsCancellationRequested)
                    break;
                var one = new Written();
                try
                {
                    one.Path = HandleFile.Create(sources, m_imports.Paths, handles, targets, true, out one.Handle);
                }
                catch (PointCloudException e)
                {
                    one.Failure = e;
                }
                written.Add(one);
                Interlocked.Increment(ref m_written);
            }
            return written;
        }

        IEnumerator<JobStep> Import(List<Written> written)
        {
            foreach (var failed in written.FindAll(w => w.Failure != null))
                Debug.LogError("FastPoints: " + failed.Failure.Message);
            written.RemoveAll(w => w.Failure != null);
            var paths = written.ConvertAll(w => m_imports.Paths.Stored(w.Path));
            AssetDatabase.StartAssetEditing();
            try
            {
                foreach (string path in paths)
                    AssetDatabase.ImportAsset(path);
            }
            finally
            {
                AssetDatabase.StopAssetEditing();
            }
            yield return default;
            var (requests, shown) = (new List<ImportRequest>(), new List<PointCloudAsset>());
            for (int i = 0; i < paths.Count; i++)
            {
                if (m_target != null)
                    shown.Add(AssetDatabase.LoadAssetAtPath<PointCloudAsset>(paths[i]));
                m_imports.AddThumbnail(written[i].Handle);
                if (m_imports.ShouldAutoConvert(written[i].Handle))
                    requests.Add(m_imports.RequestFor(paths[i], written[i].Handle));
                yield return default;
            }
            // All at once: what the user does between two of them stays a step of Undo of its own.
            m_target?.AddToScene(shown.FindAll(asset => asset != null));
            m_imports.Queue.Add(requests);
        }
    }

    internal enum SeveralFiles
    {
        Ask,
        OneCloud,
        Separate, // A cloud each, at a shared origin in scenes.
    }
}
