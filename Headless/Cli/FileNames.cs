using System.Runtime.InteropServices;

namespace FastPoints.Cli;

/// <summary>Names of files that are no UTF-8, as Linux allows: .NET has no text for them, and could not open them.</summary>
static partial class FileNames
{
    const int ReadOnly = 0, CloseOnExec = 0x80000;

    /// <summary>The arguments, with the names of such files replaced by ones of their open handles.</summary>
    public static string[] Readable(string[] args)
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
            return handle < 0 ? arg : "/proc/self/fd/" + handle.ToString(CultureInfo.InvariantCulture);
        }).ToArray();
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
