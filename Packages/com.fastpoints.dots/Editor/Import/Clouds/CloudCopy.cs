using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using FastPoints.Core;
using FastPoints.Reading;
using FastPoints.Store;
using FastPoints.Build;

namespace FastPoints.Editor
{
    /// <summary>Copies a converted cloud on a thread of the pool, for use in another project. The copy gets its name when it is
    /// complete; if cancelled or failed, it leaves nothing.</summary>
    internal sealed class CloudCopy : IDisposable
    {
        const string TemporarySuffix = ".copy";
        const int PieceBytes = 1 << 20;

        readonly CancellationTokenSource m_cancellation = new CancellationTokenSource();
        readonly string m_from;
        readonly string m_to;
        long m_bytes;
        long m_bytesDone;

        /// <param name="from">A finished cloud's folder.</param>
        /// <param name="to">A folder that does not exist yet.</param>
        public CloudCopy(string from, string to)
        {
            m_from = from;
            m_to = to;
            Work = Task.Run(Run);
        }

        /// <summary>Ends when the copy has its name; throws a <see cref="PointCloudException"/> or is cancelled.</summary>
        public Task Work { get; }

        /// <summary>Progress from 0 to 1; any thread may ask.</summary>
        public double Share
        {
            get
            {
                long bytes = Interlocked.Read(ref m_bytes);
                return bytes == 0 ? 0 : Interlocked.Read(ref m_bytesDone) / (double)bytes;
            }
        }

        public void Cancel() => m_cancellation.Cancel();

        /// <summary>Cancels, and waits for the megabyte being copied: a domain reload ends threads without notice and must not
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
            string temporary = m_to + TemporarySuffix;
            try
            {
                if (!File.Exists(Path.Combine(m_from, StoreFormat.ManifestName)))
                    throw new PointCloudException(FailureCode.NotFound, m_from, -1, "wanted a finished cloud");
                if (Directory.Exists(m_to) || File.Exists(m_to))
                    throw new PointCloudException(FailureCode.WriteFailed, m_to, -1, "already exists");
                FileChanges.DeleteFolder(temporary);
                Directory.CreateDirectory(temporary);
                var files = Directory.GetFiles(m_from, "*", SearchOption.AllDirectories);
                CheckRoom(temporary, files);
                var buffer = new byte[PieceBytes];
                foreach (string file in files)
                    CopyFile(file, Path.Combine(temporary, Path.GetRelativePath(m_from, file)), buffer);
                FileChanges.Retry(() => FileChanges.MoveFolder(temporary, m_to), () => !m_cancellation.IsCancellationRequested);
            }
            catch (Exception e)
            {
                FileChanges.TryDelete(temporary, () => !m_cancellation.IsCancellationRequested);
                if (FileFailures.IsFileFailure(e))
                    throw FileFailures.Writing(m_to, e);
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
                throw PointCloudException.Wanted(FailureCode.DiskFull, m_to, -1, "free bytes on the disk", bytes, free);
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
