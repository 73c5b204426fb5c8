namespace Unity.IO.LowLevel.Unsafe;

public unsafe struct ReadHandle : IDisposable
{
    internal int m_Index;
    internal int m_Version;

    internal ReadHandle(ReadRequest request) => (m_Index, m_Version) = ReadRequest.All.Add(request);

    public JobHandle JobHandle => Find("JobHandle").JobHandle;
    public ReadStatus Status => Find("Status").Status;
    public long ReadCount => Find("ReadCount").Count;

    public bool IsValid() => ReadRequest.All.Find(m_Index, m_Version) != null;
    public void Cancel() => Find("Cancel").Cancel();

    /// <summary>Bytes of all commands.</summary>
    public long GetBytesRead()
    {
        ReadRequest request = Done("GetBytesRead");
        long bytes = 0;
        for (int i = 0; i < request.Count; i++)
            bytes += (long)request.BytesRead[i];
        return bytes;
    }

    public long GetBytesRead(uint readCommandIndex)
    {
        ReadRequest request = Done("GetBytesRead");
        if (readCommandIndex >= request.Count)
            throw new ArgumentOutOfRangeException(nameof(readCommandIndex), readCommandIndex,
                $"The read has {request.Count} commands.");
        return (long)request.BytesRead[readCommandIndex];
    }

    public ulong* GetBytesReadArray() => Done("GetBytesReadArray").BytesRead;

    public void Dispose()
    {
        ReadRequest request = Find("Dispose");
        if (!request.HasEnded)
            throw new InvalidOperationException("ReadHandle.Dispose cannot be called until the read operation completes.");
        ReadRequest.All.Remove(m_Index, m_Version);
        request.Free();
    }

    ReadRequest Done(string what)
    {
        ReadRequest request = Find(what);
        if (!request.HasEnded)
            throw new InvalidOperationException($"ReadHandle.{what} cannot be called until the read operation completes.");
        return request;
    }

    ReadRequest Find(string what) => ReadRequest.All.Find(m_Index, m_Version)
        ?? throw new InvalidOperationException($"ReadHandle.{what} cannot be used after the ReadHandle has been disposed.");
}
