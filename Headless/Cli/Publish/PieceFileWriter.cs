using Microsoft.Win32.SafeHandles;

namespace FastPoints.Cli.Publish;

/// <summary>A file of a cloud that is written piece by piece, its header last.</summary>
sealed unsafe class PieceFileWriter(CloudFolderWriter folder, string name) : IDisposable
{
    public const int BytesPerPiece = 4 << 20;

    NativeList<byte> m_bytes = new(1 << 16, Allocator.Persistent);
    long m_written = FileHeader.SizeBytes;

    public bool IsFull => m_bytes.Length >= BytesPerPiece;

    public ReadOnlySpan<byte> Append(SafeFileHandle source, string sourcePath, long offset, int count)
    {
        int start = m_bytes.Length;
        m_bytes.Resize(start + count, NativeArrayOptions.UninitializedMemory);
        var to = new Span<byte>(m_bytes.GetUnsafePtr() + start, count);
        Read(source, sourcePath, offset, to);
        return to;
    }

    public static void Read(SafeFileHandle file, string path, long offset, Span<byte> to)
    {
        try
        {
            for (int got; to.Length > 0; to = to[got..], offset += got)
                if ((got = RandomAccess.Read(file, to, offset)) == 0)
                    throw new PointCloudException(FailureCode.Truncated, path, offset, "the file became shorter");
        }
        catch (IOException e)
        {
            throw new PointCloudException(FailureCode.ReadFailed, path, offset, "cannot be read: " + e.Message, e);
        }
    }

    public IEnumerator<JobStep> Flush()
    {
        if (m_bytes.Length == 0)
            yield break;
        yield return JobStep.Of(CloudFolderWriter.Await(folder.WritePiece(name, m_bytes.AsArray(), m_written)));
        m_written += m_bytes.Length;
        m_bytes.Clear();
    }

    public IEnumerator<JobStep> Seal(FileHeader header)
    {
        yield return JobStep.Of(Flush());
        header.Version = StoreFormat.Version;
        header.HeaderHash = StoreFile.HashOf(header);
        yield return JobStep.Of(Seal(MemoryMarshal.AsBytes<FileHeader>(new[] { header }).ToArray()));
    }

    IEnumerator<JobStep> Seal(byte[] header)
    {
        using var bytes = new NativeArray<byte>(header, Allocator.Persistent);
        yield return JobStep.Of(CloudFolderWriter.Await(folder.Seal(name, bytes)));
    }

    public void Dispose() => m_bytes.Dispose();
}
