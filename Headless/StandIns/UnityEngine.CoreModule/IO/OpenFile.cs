using Unity.IO.LowLevel.Unsafe;
#if NET
using Microsoft.Win32.SafeHandles;
#endif

namespace StandIns.Io;

/// <summary>A file that reads share: opened by the I/O threads, closed when nobody reads it any more.</summary>
sealed unsafe class OpenFile
{
    // A cancelled read stops after as much.
    internal const int PartBytes = 16 << 20;

    readonly object m_lock = new object();
    readonly string m_path;
    readonly JobNode m_opened;
    int m_readers;
    bool m_closing;
#if NET
    SafeFileHandle m_handle;
#else
    FileStream m_handle;
#endif

    OpenFile(string path)
    {
        m_path = path;
        Status = FileStatus.Pending;
        m_opened = JobScheduler.BeginExternal();
        Opened = new JobHandle(m_opened);
    }

    internal FileStatus Status { get; private set; }
    internal JobHandle Opened { get; }

    internal static OpenFile Begin(string path)
    {
        var file = new OpenFile(path);
        IoThreads.Enqueue(() =>
        {
            file.Open();
            JobScheduler.FinishExternal(file.m_opened);
        });
        return file;
    }

    /// <summary>For one read that opens and closes the file itself, on an I/O thread.</summary>
    internal static OpenFile OpenHere(string path)
    {
        var file = new OpenFile(path);
        file.Open();
        JobScheduler.FinishExternal(file.m_opened);
        return file;
    }

    internal void AddReader()
    {
        lock (m_lock)
            m_readers++;
    }

    internal void RemoveReader()
    {
        lock (m_lock)
        {
            m_readers--;
            CloseIfUnused();
        }
    }

    /// <summary>Closes once the reads that were begun are done.</summary>
    internal void Close()
    {
        lock (m_lock)
        {
            m_closing = true;
            CloseIfUnused();
        }
    }

    /// <returns>Bytes read: fewer than asked for at the end of the file, -1 on failure.</returns>
    internal long Read(byte* to, long offset, long size, ref bool cancelled)
    {
        if (Status == FileStatus.Pending)
        {
            // Two threads serve the queue, so that a read may overtake the opening of its file.
            while (!JobScheduler.IsCompleted(Opened))
                System.Threading.Thread.Yield();
        }
        if (Status != FileStatus.Open || offset < 0)
            return -1;
        SimulatedLatency.Read();
        long done = 0;
        try
        {
            while (done < size && !System.Threading.Volatile.Read(ref cancelled))
            {
                int part = (int)Math.Min(size - done, PartBytes);
                int got = ReadAt(new Span<byte>(to + done, part), offset + done);
                if (got <= 0)
                    break;
                done += got;
            }
        }
        catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
        {
            return -1;
        }
        return done;
    }

#if NET
    int ReadAt(Span<byte> to, long offset) => RandomAccess.Read(m_handle, to, offset);
#else
    int ReadAt(Span<byte> to, long offset)
    {
        // A stream has one position.
        lock (m_handle)
        {
            m_handle.Position = offset;
            return m_handle.Read(to);
        }
    }
#endif

    void Open()
    {
        try
        {
#if NET
            m_handle = File.OpenHandle(m_path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
#else
            m_handle = new FileStream(m_path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, 1);
#endif
            Status = FileStatus.Open;
        }
        catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException
            || exception is ArgumentException || exception is NotSupportedException)
        {
            Status = FileStatus.OpenFailed;
        }
    }

    void CloseIfUnused()
    {
        if (!m_closing || m_readers > 0 || Status == FileStatus.Closed)
            return;
        Status = FileStatus.Closed;
        m_handle?.Dispose();
        m_handle = null;
    }
}
