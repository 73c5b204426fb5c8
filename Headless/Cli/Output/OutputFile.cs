namespace FastPoints.Cli.Output;

/// <summary>A file that is complete or absent: written under a temporary name beside its own, renamed by <see cref="Commit"/>,
/// deleted otherwise.</summary>
public sealed class OutputFile : IDisposable
{
    readonly string m_path;
    readonly string m_temporaryPath;
    bool m_isCommitted;

    public OutputFile(string path)
    {
        m_path = path;
        m_temporaryPath = IsDevice(path) ? path : path + "." + Environment.ProcessId + ".part";
        WithFileErrors(path, () =>
            Stream = new FileStream(m_temporaryPath, FileMode.Create, FileAccess.Write, FileShare.Read, 1 << 16));
    }

    public FileStream Stream { get; private set; } = null!;

    public void Commit()
    {
        WithFileErrors(m_path, () =>
        {
            Stream.Dispose();
            if (!IsDevice(m_path))
                File.Move(m_temporaryPath, m_path, overwrite: true);
        });
        m_isCommitted = true;
    }

    public void Dispose()
    {
        if (m_isCommitted)
            return;
        try
        {
            Stream.Dispose();
        }
        catch (IOException)
        {
            // Deleted even if flushing fails.
        }
        if (!IsDevice(m_path))
            File.Delete(m_temporaryPath);
    }

    public static bool IsDevice(string path) =>
        !OperatingSystem.IsWindows() && Path.GetFullPath(path) is var full && (full.StartsWith("/dev/", StringComparison.Ordinal)
            && !full.StartsWith("/dev/shm/", StringComparison.Ordinal) || full.StartsWith("/proc/", StringComparison.Ordinal));

    public static void Write(string path, byte[] bytes) => Write(path, [bytes]);

    /// <param name="parts">One after the other: a file may be larger than memory.</param>
    public static void Write(string path, IEnumerable<byte[]> parts)
    {
        using var file = new OutputFile(path);
        try
        {
            foreach (byte[] part in parts)
                file.Stream.Write(part);
        }
        catch (IOException e)
        {
            throw FileFailures.WriteFailure(path, e);
        }
        file.Commit();
    }

    public static void MakeFolder(string path) => WithFileErrors(path, () => Directory.CreateDirectory(path));

    public static void WithFileErrors(string path, Action write)
    {
        try
        {
            write();
        }
        catch (Exception e) when (FileFailures.IsFileFailure(e))
        {
            throw FileFailures.WriteFailure(path, e);
        }
    }
}
