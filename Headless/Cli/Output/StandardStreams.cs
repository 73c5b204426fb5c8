using System.Threading.Tasks;

namespace FastPoints.Cli.Output;

/// <summary>Standard input and output, by the name -. Both use temporary files: readers seek in a cloud, and the
/// head of a file that is written counts its points.</summary>
public sealed class StandardStreams : IDisposable
{
    const string Name = "-";
    const int PollMs = 50;

    string? m_folder;

    public static bool IsInput(string path) => path == Name;

    /// <summary>-, or with the ending of a format.</summary>
    public static bool IsOutput(string path) => path == Name || path.StartsWith(Name + ".", StringComparison.Ordinal);

    /// <summary>The file that a name is written to first: itself, except standard output, which is LAS unless it has another
    /// ending.</summary>
    public string FileOf(string output) =>
        !IsOutput(output) ? output : Temporary("stdout" + (output == Name ? ".las" : output[Name.Length..]));

    public void Send(string output)
    {
        if (!IsOutput(output))
            return;
        using var file = File.OpenRead(FileOf(output));
        using var to = Console.OpenStandardOutput();
        OutputFile.WithFileErrors("standard output", () => file.CopyTo(to));
    }

    /// <returns>A file of all that comes in.</returns>
    /// <exception cref="PointCloudException">It is empty, or too long to be kept.</exception>
    public string Receive(CliRun run)
    {
        string path = Temporary("stdin");
        if (File.Exists(path))
            throw new UsageException("- is standard input, which can be read once");
        // Others need space there too, perhaps the conversion itself.
        long limit = new DriveInfo(m_folder!).AvailableFreeSpace / 2;
        run.Progress.Begin("standard input");
        using var spool = new StreamSpool(Console.OpenStandardInput, path);
        while (!WaitFor(spool.Work, run))
        {
            run.Progress.Report(0, 0, spool.Bytes);
            if (spool.Bytes > limit)
                throw new PointCloudException(FailureCode.DiskFull, path, -1, "standard input has more than "
                    + NumberFormat.Bytes(limit) + ", half of what is free there: write it into a file, or set TMPDIR");
        }
        run.Progress.End();
        if (spool.Bytes == 0)
            throw new PointCloudException(FailureCode.Truncated, Name, -1, "standard input is empty, wanted a point cloud");
        run.Warn("standard input is kept in " + path + " until the end: " + NumberFormat.Bytes(spool.Bytes));
        return path;
    }

    static bool WaitFor(Task work, CliRun run)
    {
        try
        {
            return work.Wait(PollMs, run.Cancellation);
        }
        catch (AggregateException e) when (e.InnerException is PointCloudException)
        {
            throw e.InnerException;
        }
    }

    string Temporary(string name)
    {
        OutputFile.WithFileErrors(Path.GetTempPath(), () =>
            m_folder ??= Directory.CreateTempSubdirectory("fastpoints-").FullName);
        return Path.Combine(m_folder!, name);
    }

    public void Dispose()
    {
        if (m_folder == null)
            return;
        try
        {
            Directory.Delete(m_folder, true);
        }
        catch (IOException)
        {
            // Windows keeps open files: the system clears its folder.
        }
    }
}
