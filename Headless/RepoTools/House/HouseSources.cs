namespace FastPoints.RepoTools.House;

/// <summary>The files that the house looks into, each read and parsed once.</summary>
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
        SourceFile? glossary = Manual.FirstOrDefault(f => f.Path == Glossary.Path);
        HasGlossary = glossary != null;
        Glossary = Glossary.Parse(glossary?.Text ?? "");
        m_shapes = CSharp.AsParallel().Select(f => (f, CSharpShape.Of(f))).ToDictionary(p => p.f, p => p.Item2, ByReference);
    }

    public IReadOnlyList<SourceFile> Code { get; }
    public IReadOnlyList<SourceFile> CSharp { get; }
    public IReadOnlyList<SourceFile> Product { get; }
    public IReadOnlyList<SourceFile> Manual { get; }
    public Glossary Glossary { get; }
    public bool HasGlossary { get; }

    // A record would hash its whole text.
    private static IEqualityComparer<SourceFile> ByReference => ReferenceEqualityComparer.Instance;

    public CSharpShape ShapeOf(SourceFile file) => m_shapes[file];
}
