namespace StandIns.Io;

/// <summary>Files that were read by their name and stay open, as Unity keeps up to ten of them, but on Windows. Whoever reads
/// such a name again reads the file that lay there then.</summary>
static class NamedFiles
{
    const int MaxOpen = 10;

    static readonly bool s_keeps = !RuntimeInformation.IsOSPlatform(OSPlatform.Windows);

    // The one that was read last comes last.
    static readonly List<(string Path, OpenFile File)> s_open = new List<(string Path, OpenFile File)>();

    /// <summary>Opens a file if it is not open, on an I/O thread.</summary>
    internal static OpenFile Take(string path)
    {
        lock (s_open)
        {
            int at = s_open.FindIndex(o => o.Path == path);
            OpenFile file = at < 0 ? OpenFile.OpenHere(path) : s_open[at].File;
            file.AddReader();
            if (at >= 0)
                s_open.RemoveAt(at);
            if (!s_keeps || file.Status != FileStatus.Open)
            {
                file.Close();
                return file;
            }
            if (s_open.Count == MaxOpen)
            {
                s_open[0].File.Close();
                s_open.RemoveAt(0);
            }
            s_open.Add((path, file));
            return file;
        }
    }
}
