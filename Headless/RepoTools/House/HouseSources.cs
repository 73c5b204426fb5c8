namespace FastPoints.RepoTools.House;

public sealed class HouseSources
{
    private readonly Dictionary<SourceFile, CSharpShape> m_shapes;

    public HouseSources(IEnumerable<SourceFile> files)
    {
        List<SourceFile> all = files.OrderBy(f => f.Path, System.StringComparer.Ordinal).ToList();
        Code = all.Where(f => f.IsCode).ToList();
        CSharp = Code.Where(f => f.IsCSharp).ToList();
        Product = CSharp.Where(f => f.IsProduct).ToList();
        Manual = all.Where(f => f.IsManual).ToList();
        Readme = all.Where(f => f.IsReadme).ToList();
        SourceFile? glossary = Manual.FirstOrDefault(f => f.Path == Glossary.Path);
        HasGlossary = glossary != null;
        Glossary = Glossary.Parse(glossary?.Text ?? "");
        m_shapes = CSharp.AsParallel().Select(f => (f, CSharpShape.Of(f))).ToDictionary(p => p.f, p => p.Item2, ByReference);
    }

    public static HouseSources Of(Repository repository) => new HouseSources(repository.Files()
        .Where(SourceFile.IsWanted).AsParallel()
        .Select(f => new SourceFile(f, File.ReadAllText(Path.Combine(repository.Root, f)))));

    public IReadOnlyList<SourceFile> Code { get; }
    public IReadOnlyList<SourceFile> CSharp { get; }
    public IReadOnlyList<SourceFile> Product { get; }
    public IReadOnlyList<SourceFile> Manual { get; }
    public IReadOnlyList<SourceFile> Readme { get; }
    public Glossary Glossary { get; }
    public bool HasGlossary { get; }

    // A record would hash its whole text.
    private static IEqualityComparer<SourceFile> ByReference => ReferenceEqualityComparer.Instance;

    public ILookup<string, SourceFile> FilesOfTypes() =>
        Product.SelectMany(f => ShapeOf(f).Types, (f, t) => (t.Name, f)).ToLookup(p => p.Name, p => p.f);

    public CSharpShape ShapeOf(SourceFile file) => m_shapes[file];
}
