namespace StandIns.Io;

/// <summary>One read of several segments of a file, from the call to the last byte. Used again after Dispose, so that a
/// read makes no garbage on the main thread, as in Unity.</summary>
sealed unsafe class ReadRequest
{
    /// <summary>The status of a read whose file is being opened, or whose commands wait for a job. Unity's enum has no name for
    /// it.</summary>
    internal const ReadStatus WaitingOnJob = (ReadStatus)3;

    internal static readonly HandleTable<ReadRequest> All = new HandleTable<ReadRequest>();
    static readonly Stack<ReadRequest> s_free = new Stack<ReadRequest>();

    readonly Action m_read;
    JobNode m_node;
    string m_path;
    OpenFile m_file;
    ReadCommand* m_commands;
    ulong* m_bytesRead;
    int m_status = (int)WaitingOnJob;
    bool m_cancelled;

    /// <param name="path">A file to read by its name, or null if <paramref name="file"/> is given.</param>
    internal static ReadRequest Take(string path, OpenFile file, ReadCommand* commands, int count)
    {
        ReadRequest request = null;
        lock (s_free)
            if (s_free.Count > 0)
                request = s_free.Pop();
        request ??= new ReadRequest();
        request.m_node = JobScheduler.BeginExternal();
        request.m_path = path;
        request.m_file = file;
        request.m_status = (int)WaitingOnJob;
        request.m_cancelled = false;
        request.Info = null;
        // From now on the file stays open for this read, even if it has to wait for a job first.
        file?.AddReader();
        request.SetCommands(commands, count);
        request.JobHandle = new JobHandle(request.m_node);
        return request;
    }

    ReadRequest() => m_read = Read;

    internal static void Prepare(int count)
    {
        lock (s_free)
            while (s_free.Count < count)
                s_free.Push(new ReadRequest());
    }

    internal JobHandle JobHandle { get; private set; }
    internal int Count { get; private set; }
    internal ReadStatus Status => (ReadStatus)Volatile.Read(ref m_status);
    internal ulong* BytesRead => m_bytesRead;

    /// <summary>Of a request for a file's length.</summary>
    internal FileInfoResult* Info { get; set; }

    internal void Cancel() => Volatile.Write(ref m_cancelled, true);

    void SetCommands(ReadCommand* commands, int count)
    {
        m_commands = commands;
        Count = count;
        if (count == 0)
            return;
        m_bytesRead = (ulong*)Memory.NativeHeap.Allocate((long)count * sizeof(ulong), sizeof(ulong));
        for (int i = 0; i < count; i++)
            m_bytesRead[i] = 0;
    }

    internal bool HasEnded => Status != ReadStatus.InProgress && Status != WaitingOnJob;

    internal void Enqueue()
    {
        if (m_file == null || m_file.Status != FileStatus.Pending)
            Begin();
        IoThreads.Enqueue(m_read);
    }

    /// <summary>The job is done that the commands waited for. Who did not wait for the file too, as the page on FileHandle asks,
    /// gets nothing.</summary>
    internal void EnqueueDeferred(ReadCommandArray* commands)
    {
        bool isOpen = m_file.Status != FileStatus.Pending;
        SetCommands(commands->ReadCommands, commands->CommandCount);
        if (isOpen)
        {
            Enqueue();
            return;
        }
        m_file.RemoveReader();
        Finish(ReadStatus.Failed);
    }

    void Begin() => Volatile.Write(ref m_status, (int)ReadStatus.InProgress);

    internal void Free()
    {
        if (m_bytesRead != null)
            Memory.NativeHeap.Free(m_bytesRead);
        m_bytesRead = null;
        m_file = null;
        lock (s_free)
            s_free.Push(this);
    }

    void Read()
    {
        if (Info != null)
        {
            var found = new FileInfo(OpenFile.OnDisk(m_path));
            *Info = found.Exists ? new FileInfoResult { FileSize = found.Length, FileState = FileState.Exists } : default;
            Finish(ReadStatus.Complete);
            return;
        }
        OpenFile file = m_file;
        if (file == null && !m_cancelled)
            file = NamedFiles.Take(m_path);
        file?.AwaitOpen();
        Begin();
        ReadStatus status = ReadStatus.Complete;
        for (int i = 0; i < Count && status != ReadStatus.Failed; i++)
        {
            if (Volatile.Read(ref m_cancelled))
                break;
            long read = file.Read((byte*)m_commands[i].Buffer, m_commands[i].Offset, m_commands[i].Size, ref m_cancelled);
            m_bytesRead[i] = (ulong)Math.Max(read, 0);
            if (read < 0)
                status = ReadStatus.Failed;
            else if (read < m_commands[i].Size)
                status = ReadStatus.Truncated;
        }
        if (Count == 0 && file != null && file.Status == FileStatus.OpenFailed)
            status = ReadStatus.Failed;
        file?.RemoveReader();
        Finish(Volatile.Read(ref m_cancelled) ? ReadStatus.Canceled : status);
    }

    void Finish(ReadStatus status)
    {
        // Whoever sees the status may dispose the read, and the next one may take this object.
        JobNode node = m_node;
        Volatile.Write(ref m_status, (int)status);
        JobScheduler.FinishExternal(node);
    }
}
