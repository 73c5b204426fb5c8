namespace FastPoints.RepoTools.Api;

/// <summary>What the stand-ins show and neither the package nor the host nor any test names, over the builds for .NET and for
/// every generation.</summary>
public static class UnusedStandIns
{
    private const string NotYet = "Unity.Collections";

    private static readonly string[] s_tests =
    {
        "HostTests/debug/HostTests.dll", "UnityOutside.Tests/debug/UnityOutside.Tests.dll",
        "FastPoints.Tests/debug_net10.0/FastPoints.Tests.dll",
    };

    public static IEnumerable<string> Check(Repository repository)
    {
        string bin = Path.Combine(repository.Headless, "artifacts", "bin");
        string[] tests = s_tests.Select(t => Path.Combine(bin, t)).ToArray();
        foreach (string absent in tests.Where(f => !File.Exists(f)))
            throw new ToolException($"{absent} is not there: run dotnet build Headless/Tests.proj");
        IEnumerable<string> generations = Directory.GetDirectories(bin)
            .SelectMany(project => Repository.Generations
                .Select(g => Path.Combine(project, "unity-" + g, Path.GetFileName(project) + ".dll")))
            .Where(File.Exists);
        string host = Path.GetDirectoryName(tests[0])!;
        IEnumerable<string> standIns = Directory.GetDirectories(repository.StandIns).Select(f => Path.GetFileName(f)!);
        return StandInUse.Check(Directory.GetFiles(host, "*.dll").Where(IsOurs).Concat(tests).Concat(generations).ToList(),
            standIns.Where(name => name != NotYet).ToArray(), host);
    }

    private static bool IsOurs(string file)
    {
        string name = Path.GetFileName(file);
        return name is "RepoTools.dll" || name.StartsWith("FastPoints", StringComparison.Ordinal)
            || name.StartsWith("Unity", StringComparison.Ordinal);
    }
}
