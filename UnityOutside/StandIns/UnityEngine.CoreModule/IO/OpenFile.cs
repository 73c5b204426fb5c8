#if NET
using Microsoft.Win32.SafeHandles;
#endif

namespace StandIns.Io;

/// <summary>A file that reads share: opened by the I/O threads, closed when nobody reads it any more. Used again then, so that
/// it makes no garbage on the main thread, as in Unity.</summary>
sealed unsafe class OpenFile
{
    internal const int PartBytes = 16 << 20; // A cancelled read stops after as much.

    static readonly Stack<OpenFile> s_free = new Stack<OpenFile>();

    readonly object m_lock = new object();
    readonly Action m_open;
    string m_path;
    JobNode m_opened;
    int m_readers;
    bool m_closing;
#if NET
    SafeFileHandle m_handle;
#else
    FileStream m_handle;
#endif

    internal static void Prepare(int count)
    {
        lock (s_free)
            while (s_free.Count < count)
                s_free.Push(new OpenFile());
    }

    OpenFile() => (m_open, Close) = (Open, CloseAfterReads);

    internal FileStatus Status { get; private set; }
    internal JobHandle Opened { get; private set; }
    internal Action Close { get; }

    internal static OpenFile Begin(string path)
    {
        var file = Take(path);
        IoThreads.Enqueue(file.m_open);
        return file;
    }

    /// <summary>For reads by name, on an I/O thread.</summary>
    internal static OpenFile OpenHere(string path)
    {
        var file = Take(path);
        file.Open();
        return file;
    }

    /// <summary>What is in an Android package has an address; here a folder by the package's name has it.</summary>
    internal static string OnDisk(string path) =>
        path.StartsWith("jar:file://", StringComparison.Ordinal) ? path.Substring("jar:file://".Length) : path;

    static OpenFile Take(string path)
    {
        OpenFile file = null;
        lock (s_free)
            if (s_free.Count > 0)
                file = s_free.Pop();
        file ??= new OpenFile();
        file.m_path = OnDisk(path);
        file.m_closing = false;
        file.Status = FileStatus.Pending;
        file.m_opened = JobScheduler.BeginExternal();
        file.Opened = new JobHandle(file.m_opened);
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

    void CloseAfterReads()
    {
        lock (m_lock)
        {
            m_closing = true;
            CloseIfUnused();
        }
    }

    /// <summary>Two threads serve the queue, so that a read may overtake the opening of its file.</summary>
    internal void AwaitOpen()
    {
        while (Status == FileStatus.Pending && !JobScheduler.IsCompleted(Opened))
            System.Threading.Thread.Yield();
    }

    /// <returns>Bytes read: fewer than asked for at the end of the file, -1 on failure.</returns>
    internal long Read(byte* to, long offset, long size, ref bool cancelled)
    {
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
            WindowsFiles.CheckRead(m_path, true);
            m_handle = File.OpenHandle(m_path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
            WindowsFiles.Opened(m_handle);
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
        JobScheduler.FinishExternal(m_opened);
    }

    void CloseIfUnused()
    {
        if (!m_closing || m_readers > 0 || Status == FileStatus.Closed)
            return;
        Status = FileStatus.Closed;
#if NET
        if (m_handle != null)
            WindowsFiles.Closing(m_handle);
#endif
        m_handle?.Dispose();
        m_handle = null;
        lock (s_free)
            s_free.Push(this);
    }
}
