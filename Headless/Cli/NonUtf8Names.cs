namespace FastPoints.Cli;

/// <summary>Names of files that are not UTF-8, which Linux allows but .NET cannot open.</summary>
static partial class NonUtf8Names
{
    const int ReadOnly = 0, CloseOnExec = 0x80000;

    static string? s_links;

    /// <summary>The arguments, with such files replaced by links of similar names to open handles.</summary>
    public static string[] WithLinks(string[] args)
    {
        if (!OperatingSystem.IsLinux() || !args.Any(a => a.Contains('\uFFFD')))
            return args;
        // The host's own words come first.
        var words = new List<byte[]>();
        foreach (var word in File.ReadAllBytes("/proc/self/cmdline").AsSpan().TrimEnd((byte)0).ToArray().Split((byte)0))
            words.Add(word);
        return args.Select((arg, i) =>
        {
            byte[] name = words[words.Count - args.Length + i];
            if (!arg.Contains('\uFFFD') || Encoding.UTF8.GetBytes(arg).AsSpan().SequenceEqual(name))
                return arg;
            int handle = Open([.. name, 0], ReadOnly | CloseOnExec);
            if (handle < 0)
                throw new UsageException(Printable(name) + ": no such file can be read, and none is written under a name that is "
                    + "no UTF-8");
            s_links ??= Directory.CreateTempSubdirectory("fastpoints-").FullName;
            string folder = Directory.CreateDirectory(Path.Combine(s_links, i.ToString(CultureInfo.InvariantCulture))).FullName;
            string link = Path.Combine(folder, Printable(name.AsSpan().TrimEnd((byte)'/')).Split('/')[^1]);
            File.CreateSymbolicLink(link, "/proc/self/fd/" + handle.ToString(CultureInfo.InvariantCulture));
            return link;
        }).ToArray();
    }

    public static bool IsTemporaryLink(string path) => s_links != null && path.StartsWith(s_links, StringComparison.Ordinal);

    public static void DeleteLinks()
    {
        if (s_links != null)
            Directory.Delete(s_links, true);
    }

    static string Printable(ReadOnlySpan<byte> name)
    {
        var text = new StringBuilder();
        for (int bytes; !name.IsEmpty; name = name[bytes..])
            if (Rune.DecodeFromUtf8(name, out var rune, out bytes) == OperationStatus.Done)
                text.Append(rune.ToString());
            else
                text.Append('%').Append(System.Convert.ToHexString(name[..bytes]));
        return text.ToString();
    }

    static IEnumerable<byte[]> Split(this byte[] bytes, byte by)
    {
        int first = 0;
        for (int end = 0; end <= bytes.Length; end++)
            if (end == bytes.Length || bytes[end] == by)
            {
                yield return bytes[first..end];
                first = end + 1;
            }
    }

    [LibraryImport("libc", EntryPoint = "open")]
    private static partial int Open(byte[] path, int flags);
}
