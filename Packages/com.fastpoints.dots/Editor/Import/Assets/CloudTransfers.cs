using System;
using System.Collections.Generic;
using System.IO;
using System.Threading.Tasks;
using FastPoints.Core;
using FastPoints.Store;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Copies converted clouds out of the project and into it: on threads of the pool, each with a line in the Progress
    /// window.</summary>
    internal sealed class CloudTransfers : IDisposable
    {
        sealed class Transfer
        {
            public CloudCopy Copy;
            public string To;
            public int Progress;

            /// <summary>Unity itself ends what was cancelled in its window: nothing more is reported.</summary>
            public bool IsCancelled;
            public Action<string> Done;
        }

        readonly List<Transfer> m_transfers = new List<Transfer>();

        public bool IsCopying => m_transfers.Count > 0;

        /// <summary>Copies a finished cloud out to <c>NAME.fastpoints</c> in a folder, with a number if that is taken.</summary>
        /// <returns>The copy's folder, which exists when the copy is complete.</returns>
        public string Export(string cloud, string folder)
        {
            string to = FreeName(cloud, folder);
            Begin("Export ", cloud, to, null);
            return to;
        }

        /// <summary>Copies a finished cloud to the project's folder of clouds.</summary>
        /// <param name="done">Gets the copy's folder when it is complete.</param>
        public void Import(string cloud, ProjectPaths paths, Action<string> done)
        {
            Directory.CreateDirectory(paths.Clouds);
            Begin("Import ", cloud, FreeName(cloud, paths.Clouds), done);
        }

        /// <summary>Called once an update of the editor.</summary>
        public void Update()
        {
            for (int i = m_transfers.Count - 1; i >= 0; i--)
            {
                var transfer = m_transfers[i];
                if (!transfer.Copy.Work.IsCompleted)
                {
                    if (!transfer.IsCancelled)
                        Progress.Report(transfer.Progress, (float)transfer.Copy.Share, transfer.To);
                    continue;
                }
                m_transfers.RemoveAt(i);
                End(transfer);
            }
        }

        /// <summary>Cancels running copies; incomplete ones are deleted.</summary>
        public void Dispose()
        {
            foreach (var transfer in m_transfers)
            {
                transfer.Copy.Dispose();
                Finish(transfer, Progress.Status.Canceled);
            }
            m_transfers.Clear();
        }

        void Begin(string what, string cloud, string to, Action<string> done)
        {
            var transfer = new Transfer { Copy = new CloudCopy(cloud, to), To = to, Done = done };
            transfer.Progress = Progress.Start(what + Path.GetFileName(to), to, Progress.Options.Managed);
            Progress.RegisterCancelCallback(transfer.Progress, () =>
            {
                transfer.IsCancelled = true;
                transfer.Copy.Cancel();
                return true;
            });
            m_transfers.Add(transfer);
        }

        static void End(Transfer transfer)
        {
            if (transfer.Copy.Work.Status == TaskStatus.RanToCompletion)
            {
                Finish(transfer, Progress.Status.Succeeded);
                Debug.Log("FastPoints: copied to " + transfer.To);
                transfer.Done?.Invoke(transfer.To);
                return;
            }
            var failure = transfer.Copy.Work.Exception?.InnerException;
            if (failure == null || failure is OperationCanceledException)
                return;
            Finish(transfer, Progress.Status.Failed);
            if (failure is PointCloudException)
                Debug.LogError("FastPoints: " + failure.Message);
            else
                Debug.LogException(failure);
        }

        static void Finish(Transfer transfer, Progress.Status status)
        {
            if (!transfer.IsCancelled)
                Progress.Finish(transfer.Progress, status);
        }

        /// <summary>A free name, which no running copy uses either.</summary>
        string FreeName(string cloud, string folder)
        {
            var taken = m_transfers.ConvertAll(t => t.To);
            if (Directory.Exists(folder))
                taken.AddRange(Directory.GetFileSystemEntries(folder));
            return new FreeNames(folder, StoreFormat.FolderExtension, taken)
                .Next(Path.GetFileNameWithoutExtension(cloud.TrimEnd('/', '\\')));
        }
    }
}
