using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;

namespace FastPoints.Reading
{
    /// <summary>Writes a stream (of a web response, an archive, an asset's bytes) into a file, on a pool thread: readers
    /// jump about in a cloud and read many of its pieces together, which only files allow. The file gets its name when it is
    /// complete; if cancelled or failed, it leaves nothing.</summary>
    public sealed class StreamSpool : IDisposable
    {
        const string TemporarySuffix = ".part";
        const int PieceBytes = 1 << 20;

        readonly CancellationTokenSource m_cancellation = new CancellationTokenSource();
        readonly Func<Stream> m_open;
        readonly string m_path;
        readonly long m_lengthBytes;
        long m_bytes;

        /// <param name="open">Called once, on that thread; the stream is disposed there.</param>
        /// <param name="path">Path of the file, whose extension names its format; an existing file is replaced.</param>
        /// <param name="lengthBytes">The length that the stream must have; negative if unknown.</param>
        public StreamSpool(Func<Stream> open, string path, long lengthBytes = -1)
        {
            m_open = open;
            m_path = path;
            m_lengthBytes = lengthBytes;
            Work = Task.Run(Run);
        }

        /// <summary>Ends when the file has its name; fails with a <see cref="PointCloudException"/> or the stream's
        /// exception, or is cancelled.</summary>
        public Task Work { get; }

        /// <summary>Bytes written so far; any thread.</summary>
        public long Bytes => Interlocked.Read(ref m_bytes);

        /// <summary>Progress from 0 to 1; 0 until the end if the length is unknown.</summary>
        public double Fraction =>
            Work.Status == TaskStatus.RanToCompletion ? 1 : m_lengthBytes > 0 ? (double)Bytes / m_lengthBytes : 0;

        /// <summary>Cancels the work without waiting for its end.</summary>
        public void Dispose() => m_cancellation.Cancel();

        void Run()
        {
            string temporary = m_path + TemporarySuffix;
            try
            {
                using (var from = m_open())
                using (var to = Create(temporary))
                    Copy(from, to);
                if (m_lengthBytes >= 0 && m_bytes != m_lengthBytes)
                    throw PointCloudException.Wanted(FailureCode.Truncated, m_path, m_bytes, "bytes of the stream", m_lengthBytes,
                        m_bytes);
                Replace(temporary);
            }
            catch
            {
                FileChanges.TryDelete(temporary, () => false);
                throw;
            }
        }

        void Copy(Stream from, Stream to)
        {
            var buffer = new byte[PieceBytes];
            for (int got = from.Read(buffer, 0, PieceBytes); got > 0; got = from.Read(buffer, 0, PieceBytes))
            {
                m_cancellation.Token.ThrowIfCancellationRequested();
                try
                {
                    to.Write(buffer, 0, got);
                }
                catch (Exception e) when (FileFailures.IsFileFailure(e))
                {
                    throw FileFailures.WriteFailure(m_path, e);
                }
                Interlocked.Add(ref m_bytes, got);
            }
            m_cancellation.Token.ThrowIfCancellationRequested();
        }

        Stream Create(string temporary)
        {
            try
            {
                return FileChanges.OpenToWrite(temporary, FileMode.Create);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.WriteFailure(m_path, e);
            }
        }

        void Replace(string temporary)
        {
            try
            {
                FileChanges.Retry(() => FileChanges.Replace(temporary, m_path),
                    () => !m_cancellation.IsCancellationRequested);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.WriteFailure(m_path, e);
            }
        }
    }
}
