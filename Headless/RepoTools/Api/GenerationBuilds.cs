namespace FastPoints.RepoTools.Api;

public sealed class GenerationBuilds : IDisposable
{
    private static readonly string[] s_assemblies =
    {
        "FastPoints", "FastPoints.Import", "FastPoints.Picture", "FastPoints.Surface", "FastPoints.Rendering",
        "FastPoints.Rendering.BuiltIn", "FastPoints.Rendering.Urp", "FastPoints.Rendering.Hdrp", "FastPoints.Entities",
        "FastPoints.Editor", "FastPoints.Scenes", "FastPoints.Benchmarks", "FastPoints.Evaluation", "FastPoints.Samples",
        "FastPoints.Samples.Editor", "FastPoints.Benchmarks.Unity", "FastPoints.Tests", "FastPoints.UnityTests",
        "FastPoints.UnityTests.Performance",
    };

    private readonly Resolver m_resolver = new Resolver();

    public GenerationBuilds(Repository repository, string generation)
    {
        Generation = generation;
        List<string> files = s_assemblies.Select(a => Path.Combine(repository.BuildOf(a, generation), a + ".dll")).ToList();
        string? absent = files.FirstOrDefault(f => !File.Exists(f));
        if (absent != null)
        {
            throw new ToolException($"{Path.GetRelativePath(repository.Root, absent)} is not there: run " +
                "dotnet build Headless/Generations.proj");
        }
        m_resolver.AddSearchDirectory(repository.BuildOf("FastPoints.Tests", generation));
        m_resolver.AddSearchDirectory(repository.BuildOf("FastPoints.Benchmarks.Unity", generation));
        m_resolver.AddSearchDirectory(repository.BuildOf("FastPoints.Editor", generation));
        m_resolver.AddSearchDirectory(repository.BuildOf("FastPoints.Samples.Editor", generation));
        m_resolver.AddSearchDirectory(repository.BuildOf("FastPoints.UnityTests.Performance", generation));
        m_resolver.AddSearchDirectory(repository.BuildOf("FastPoints.Rendering.Urp", generation));
        m_resolver.AddSearchDirectory(repository.BuildOf("FastPoints.Rendering.Hdrp", generation));
        foreach (string folder in NetStandardFolders())
            m_resolver.AddSearchDirectory(folder);
        Package = files.Select(Read).ToList();
        StandIns = Directory.GetDirectories(repository.StandIns).Select(Path.GetFileName)
            .Select(name => Path.Combine(repository.BuildOf(name!, generation), name + ".dll"))
            .Where(File.Exists).Select(Read).ToList();
    }

    public string Generation { get; }
    public IReadOnlyList<ModuleDefinition> Package { get; }
    public IReadOnlyList<ModuleDefinition> StandIns { get; }

    public void Dispose()
    {
        foreach (ModuleDefinition module in Package.Concat(StandIns))
            module.Dispose();
        m_resolver.Dispose();
    }

    private ModuleDefinition Read(string file)
    {
        ModuleDefinition module = ModuleDefinition.ReadModule(file, new ReaderParameters
        {
            AssemblyResolver = m_resolver,
            ReadSymbols = File.Exists(Path.ChangeExtension(file, ".pdb")),
        });
        m_resolver.Register(module.Assembly);
        return module;
    }

    /// <summary>Where the SDK keeps netstandard 2.1's reference assemblies; without them .NET's types are taken on
    /// trust.</summary>
    private static IEnumerable<string> NetStandardFolders()
    {
        string packages = Environment.GetEnvironmentVariable("NUGET_PACKAGES")
            ?? Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".nuget", "packages");
        string inPackages = Path.Combine(packages, "netstandard.library.ref", "2.1.0", "ref", "netstandard2.1");
        string? dotnet = Path.GetDirectoryName(Environment.ProcessPath);
        string inSdk = Path.Combine(dotnet ?? "", "packs", "NETStandard.Library.Ref", "2.1.0", "ref", "netstandard2.1");
        return new[] { inPackages, inSdk }.Where(Directory.Exists);
    }

    private sealed class Resolver : DefaultAssemblyResolver
    {
        internal void Register(AssemblyDefinition assembly) => RegisterAssembly(assembly);
    }
}
