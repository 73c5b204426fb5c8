using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using FastPoints.Build;
using FastPoints.Reading;
using FastPoints.Store;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    internal sealed class CloudTransfers : IDisposable
    {
        struct Transfer
        {
            public CloudCopy Copy;
            public int Progress;
            public Action<string> Done;
        }

        readonly List<Transfer> m_transfers = new List<Transfer>();

        public bool IsCopying => m_transfers.Count > 0;

        /// <summary>Copies a finished cloud out to <c>NAME.fastpoints</c> in a folder, with a number if that is taken.</summary>
        /// <returns>The copy's folder, which exists when the copy is complete.</returns>
        public string ExportCopy(string cloud, string folder)
        {
            string to = FreePath(cloud, folder);
            Begin("Export ", cloud, to, null);
            return to;
        }

        /// <summary>Copies a finished cloud to the project's folder of clouds.</summary>
        /// <param name="done">Gets the copy's folder when it is complete.</param>
        public void ImportCopy(string cloud, ProjectPaths paths, Action<string> done)
        {
            Directory.CreateDirectory(paths.Clouds);
            Begin("Import ", cloud, FreePath(cloud, paths.Clouds), done);
        }

        public void Update()
        {
            for (int i = m_transfers.Count - 1; i >= 0; i--)
            {
                var transfer = m_transfers[i];
                if (!transfer.Copy.Work.IsCompleted)
                {
                    if (!transfer.Copy.IsCancelledByUser)
                        Progress.Report(transfer.Progress, (float)transfer.Copy.Fraction, transfer.Copy.To);
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
            var copy = new CloudCopy(cloud, to);
            int progress = Progress.Start(what + Path.GetFileName(to), to, Progress.Options.Managed);
            Progress.RegisterCancelCallback(progress, () =>
            {
                copy.Cancel();
                return true;
            });
            m_transfers.Add(new Transfer { Copy = copy, Progress = progress, Done = done });
        }

        static void End(Transfer transfer)
        {
            if (transfer.Copy.Work.Status == TaskStatus.RanToCompletion)
            {
                Finish(transfer, Progress.Status.Succeeded);
                Debug.Log("FastPoints: copied to " + transfer.Copy.To);
                transfer.Done?.Invoke(transfer.Copy.To);
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
            // Unity itself ends what was cancelled in its window.
            if (!transfer.Copy.IsCancelledByUser)
                Progress.Finish(transfer.Progress, status);
        }

        /// <summary>A free name, which no running copy uses either.</summary>
        string FreePath(string cloud, string folder)
        {
            var taken = m_transfers.ConvertAll(t => t.Copy.To);
            if (Directory.Exists(folder))
                taken.AddRange(Directory.GetFileSystemEntries(folder));
            return new FreePaths(folder, StoreFormat.FolderExtension, taken)
                .Next(Path.GetFileNameWithoutExtension(cloud.TrimEnd('/', '\\')));
        }
    }

    /// <summary>Copies a converted cloud on a pool thread, for use in another project. The copy gets its name when it is
    /// complete; if cancelled or failed, it leaves nothing.</summary>
    internal sealed class CloudCopy : IDisposable
    {
        const string TemporarySuffix = ".copy";
        const int PieceBytes = 1 << 20;

        readonly CancellationTokenSource m_cancellation = new CancellationTokenSource();
        readonly string m_from;
        long m_bytes;
        long m_bytesDone;

        public CloudCopy(string from, string to)
        {
            m_from = from;
            To = to;
            Work = Task.Run(Run);
        }

        public Task Work { get; } // Ends when the copy has its name; throws a PointCloudException or is cancelled.

        public string To { get; } // A folder that does not exist until the copy is complete.

        /// <summary>From 0 to 1; any thread may ask.</summary>
        public double Fraction => Interlocked.Read(ref m_bytesDone) / (double)Math.Max(1, Interlocked.Read(ref m_bytes));

        public bool IsCancelledByUser { get; private set; }

        public void Cancel()
        {
            IsCancelledByUser = true;
            m_cancellation.Cancel();
        }

        /// <summary>Cancels, and waits for the megabyte being copied: a domain reload aborts threads and must not
        /// find anything half copied.</summary>
        public void Dispose()
        {
            m_cancellation.Cancel();
            try
            {
                Work.Wait();
            }
            catch (AggregateException)
            {
                // The result is no longer wanted.
            }
        }

        void Run()
        {
            string temporary = To + TemporarySuffix;
            try
            {
                if (!File.Exists(Path.Combine(m_from, StoreFormat.ManifestName)))
                    throw new PointCloudException(FailureCode.NotFound, m_from, -1, "wanted a finished cloud");
                if (Directory.Exists(To) || File.Exists(To))
                    throw new PointCloudException(FailureCode.WriteFailed, To, -1, "already exists");
                FileChanges.DeleteFolder(temporary);
                Directory.CreateDirectory(temporary);
                var files = Directory.GetFiles(m_from, "*", SearchOption.AllDirectories);
                CheckRoom(temporary, files);
                var buffer = new byte[PieceBytes];
                foreach (string file in files)
                    CopyFile(file, Path.Combine(temporary, Path.GetRelativePath(m_from, file)), buffer);
                FileChanges.Retry(() => FileChanges.MoveFolder(temporary, To), () => !m_cancellation.IsCancellationRequested);
            }
            catch (Exception e)
            {
                FileChanges.TryDelete(temporary, () => !m_cancellation.IsCancellationRequested);
                if (FileFailures.IsFileFailure(e))
                    throw FileFailures.WriteFailure(To, e);
                throw;
            }
        }

        void CheckRoom(string temporary, IEnumerable<string> files)
        {
            long bytes = 0;
            foreach (string file in files)
                bytes += new FileInfo(file).Length;
            Interlocked.Exchange(ref m_bytes, bytes);
            long free = CloudFolderWriter.FreeBytesOf(temporary);
            if (free >= 0 && free < bytes)
                throw PointCloudException.Wanted(FailureCode.DiskFull, To, -1, "free bytes on the disk", bytes, free);
        }

        void CopyFile(string from, string to, byte[] buffer)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(to));
            using var source = FileChanges.OpenToRead(from, 1);
            using var target = FileChanges.OpenToWrite(to, FileMode.CreateNew);
            for (int got = source.Read(buffer, 0, buffer.Length); got > 0; got = source.Read(buffer, 0, buffer.Length))
            {
                m_cancellation.Token.ThrowIfCancellationRequested();
                target.Write(buffer, 0, got);
                Interlocked.Add(ref m_bytesDone, got);
            }
        }
    }
}
