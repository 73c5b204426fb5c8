using System.ComponentModel;

namespace FastPoints.RepoTools.Package;

/// <summary>What <c>npm pack</c> would put into the package that registries for Unity hand out.</summary>
public sealed class NpmPack
{
    private readonly HashSet<string> m_files;

    private NpmPack(IEnumerable<string> files, long packedBytes, long installedBytes)
    {
        m_files = new HashSet<string>(files, StringComparer.Ordinal);
        PackedBytes = packedBytes;
        InstalledBytes = installedBytes;
    }

    public long PackedBytes { get; }
    public long InstalledBytes { get; }

    /// <summary>Null where npm is not installed.</summary>
    public static NpmPack? OfFolder(string folder)
    {
        var start = new ProcessStartInfo(OperatingSystem.IsWindows() ? "npm.cmd" : "npm")
        {
            WorkingDirectory = folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        foreach (string argument in new[] { "pack", "--dry-run", "--json", "--offline", "--ignore-scripts" })
            start.ArgumentList.Add(argument);
        try
        {
            using Process npm = Process.Start(start)!;
            // What goes to the error stream is for people, and a full pipe would stop it.
            npm.ErrorDataReceived += (_, _) => { };
            npm.BeginErrorReadLine();
            string said = npm.StandardOutput.ReadToEnd();
            npm.WaitForExit();
            if (npm.ExitCode != 0)
                throw new ToolException($"npm pack ended with {npm.ExitCode} in {folder}");
            return Parse(said);
        }
        catch (Win32Exception)
        {
            return null;
        }
    }

    /// <param name="json">What <c>npm pack --json</c> writes: a list of one package, by its name since npm 11.</param>
    public static NpmPack Parse(string json)
    {
        using JsonDocument document = JsonDocument.Parse(json);
        JsonElement root = document.RootElement;
        JsonElement package = root.ValueKind == JsonValueKind.Array ? root.EnumerateArray().Single()
            : root.TryGetProperty("files", out _) ? root : root.EnumerateObject().Single().Value;
        return new NpmPack(package.GetProperty("files").EnumerateArray().Select(f => f.GetProperty("path").GetString()!),
            package.GetProperty("size").GetInt64(), package.GetProperty("unpackedSize").GetInt64());
    }

    /// <summary>It packs exactly the existing files: Unity wants every .meta, the manual and the samples.</summary>
    public IEnumerable<string> Check(IReadOnlyCollection<string> files)
    {
        foreach (string missing in files.Where(f => !m_files.Contains(f)))
            yield return $"{missing}: npm pack leaves it out";
        foreach (string extra in m_files.Except(files))
            yield return $"{extra}: npm pack adds it";
    }
}
