namespace FastPoints.Cli.Parts;

/// <summary>The start of a part's file. Behind it come what is known of the part, pieces of bytes, and at the end the
/// entries, which say where the pieces are and have their hashes.</summary>
[StructLayout(LayoutKind.Explicit, Size = SizeBytes)]
unsafe struct PartHeader
{
    public const int SizeBytes = 64;
    public const int CurrentVersion = 1;
    public const ulong TopsMagic = 0x53504F5450545046; // "FPTPTOPS"
    public const ulong NodesMagic = 0x5345444F4E545046; // "FPTNODES"

    const int MaxFactBytes = 1 << 20;

    [FieldOffset(0)] public ulong HeaderHash; // Of all behind it up to the pieces. It tells one part.nodes from all others.
    [FieldOffset(8)] public ulong Magic;
    [FieldOffset(16)] public int Version;
    [FieldOffset(20)] public int FactBytes;
    [FieldOffset(24)] public ulong CloudId;

    [FieldOffset(32)] public ulong NodesHash; // The hash of the part.nodes that belongs to part.tops.
    [FieldOffset(40)] public long EntriesOffset;
    [FieldOffset(48)] public long EntryBytes;
    [FieldOffset(56)] public ulong EntriesHash;

    /// <summary>Reads and checks the start of a file.</summary>
    /// <param name="facts">Receives what is known of the part.</param>
    public static PartHeader Read(string path, ulong magic, ulong cloudId, out byte[] facts)
    {
        long size = StoreFile.SizeOf(path);
        PartHeader header;
        using (var start = StoreFile.Read(path, 0, SizeBytes, Allocator.Persistent))
            header = *(PartHeader*)start.GetUnsafeReadOnlyPtr();
        Check(path, 8, "magic", magic, header.Magic);
        Check(path, 16, "version", CurrentVersion, (ulong)header.Version);
        if (header.FactBytes < 0 || header.FactBytes > MaxFactBytes)
            throw PointCloudException.Wanted(FailureCode.BadInput, path, 20, "size", "at most " + MaxFactBytes + " bytes",
                header.FactBytes);
        using (var start = StoreFile.Read(path, 0, SizeBytes + header.FactBytes, Allocator.Persistent))
        {
            StoreFile.CheckHash(path, 0, start.GetSubArray(sizeof(ulong), start.Length - sizeof(ulong)), header.HeaderHash);
            facts = start.GetSubArray(SizeBytes, header.FactBytes).ToArray();
        }
        Check(path, 24, "cloud", cloudId, header.CloudId);
        if (header.EntriesOffset + header.EntryBytes != size)
            throw PointCloudException.Wanted(FailureCode.Truncated, path, size, "bytes",
                header.EntriesOffset + header.EntryBytes, size);
        return header;
    }

    public readonly byte[] ReadEntries(string path)
    {
        using var bytes = StoreFile.Read(path, EntriesOffset, EntryBytes, Allocator.Persistent);
        StoreFile.CheckHash(path, EntriesOffset, bytes, EntriesHash);
        return bytes.ToArray();
    }

    public static void Check(string path, long offset, string what, ulong wanted, ulong got)
    {
        if (wanted != got)
            throw PointCloudException.Wanted(FailureCode.BadInput, path, offset, what, wanted.ToString("x"),
                got.ToString("x"));
    }
}

/// <summary>Writes such a file: pieces as they come, then the entries, the header last.</summary>
sealed unsafe class PartFileWriter : IDisposable
{
    const int BytesAtOnce = 4 << 20;

    readonly CloudFolderWriter m_folder;
    readonly string m_name;
    NativeList<byte> m_bytes = new NativeList<byte>(1 << 16, Allocator.Persistent);
    PartHeader m_header;
    readonly byte[] m_start;
    long m_written;

    public PartFileWriter(CloudFolderWriter folder, string name, PartHeader header, byte[] facts)
    {
        m_folder = folder;
        m_name = name;
        m_header = header;
        m_header.Version = PartHeader.CurrentVersion;
        m_header.FactBytes = facts.Length;
        m_start = new byte[PartHeader.SizeBytes + facts.Length];
        facts.CopyTo(m_start, PartHeader.SizeBytes);
        Append(m_start);
    }

    public long Offset => m_written + m_bytes.Length; // Where the next piece comes.

    public ulong HeaderHash => m_header.HeaderHash;

    public IEnumerator<JobStep> Add(NativeArray<byte> piece)
    {
        m_bytes.AddRange(piece);
        if (m_bytes.Length >= BytesAtOnce)
            yield return JobStep.Of(Flush());
    }

    public IEnumerator<JobStep> Finish(byte[] entries)
    {
        m_header.EntriesOffset = Offset;
        m_header.EntryBytes = entries.Length;
        m_header.EntriesHash = ContentHash.Of(entries);
        Append(entries);
        yield return JobStep.Of(Flush());
        StoreHeader();
        m_header.HeaderHash = ContentHash.Of(new ReadOnlySpan<byte>(m_start, sizeof(ulong), m_start.Length - sizeof(ulong)));
        StoreHeader();
        using var start = new NativeArray<byte>(m_start, Allocator.Persistent);
        yield return JobStep.Of(CloudFolderWriter.Await(m_folder.Seal(m_name, start)));
    }

    public void Dispose()
    {
        if (m_bytes.IsCreated)
            m_bytes.Dispose();
    }

    void StoreHeader()
    {
        fixed (byte* first = m_start)
            *(PartHeader*)first = m_header;
    }

    void Append(byte[] bytes)
    {
        fixed (byte* first = bytes)
            m_bytes.AddRange(first, bytes.Length);
    }

    IEnumerator<JobStep> Flush()
    {
        yield return JobStep.Of(CloudFolderWriter.Await(m_folder.WritePiece(m_name, m_bytes.AsArray(), m_written)));
        m_written += m_bytes.Length;
        m_bytes.Clear();
    }
}
