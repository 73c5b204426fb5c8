namespace FastPoints.RepoTools.Reference;

public sealed class Summaries
{
    private static readonly CSharpParseOptions s_options =
        new CSharpParseOptions(LanguageVersion.Latest, DocumentationMode.Parse)
            .WithPreprocessorSymbols("FASTPOINTS_PHYSICS", "FASTPOINTS_AI", "FASTPOINTS_DOTS_PHYSICS");

    private readonly Dictionary<string, string> m_ofType = new Dictionary<string, string>(StringComparer.Ordinal);

    public static Summaries Load(string packageRoot)
    {
        var summaries = new Summaries();
        foreach (string file in new[] { "Runtime", "Editor" }.Select(f => Path.Combine(packageRoot, f))
            .SelectMany(f => Directory.EnumerateFiles(f, "*.cs", SearchOption.AllDirectories)).Order(StringComparer.Ordinal))
            summaries.Add(File.ReadAllText(file));
        return summaries;
    }

    public void Add(string code)
    {
        SyntaxNode root = CSharpSyntaxTree.ParseText(code, s_options).GetRoot();
        foreach (MemberDeclarationSyntax type in root.DescendantNodes(n => n is not BaseTypeDeclarationSyntax)
            .OfType<MemberDeclarationSyntax>().Where(m => m is BaseTypeDeclarationSyntax or DelegateDeclarationSyntax))
        {
            XmlElementSyntax? summary = type.GetLeadingTrivia().Select(t => t.GetStructure())
                .OfType<DocumentationCommentTriviaSyntax>().SelectMany(c => c.Content).OfType<XmlElementSyntax>()
                .FirstOrDefault(e => e.StartTag.Name.ToString() == "summary");
            if (summary != null)
                m_ofType.TryAdd(FullName(type), FirstSentence(Text(summary.Content)));
        }
    }

    public string? Of(TypeDefinition type) => m_ofType.GetValueOrDefault(type.FullName);

    private static string FullName(MemberDeclarationSyntax type)
    {
        (string name, int arity) = type switch
        {
            TypeDeclarationSyntax t => (t.Identifier.ValueText, t.Arity),
            DelegateDeclarationSyntax d => (d.Identifier.ValueText, d.Arity),
            _ => (((BaseTypeDeclarationSyntax)type).Identifier.ValueText, 0),
        };
        string space = string.Join(".", type.Ancestors().OfType<BaseNamespaceDeclarationSyntax>().Reverse().Select(n => n.Name));
        return (space.Length == 0 ? "" : space + ".") + name + (arity == 0 ? "" : "`" + arity);
    }

    private static string Text(IEnumerable<XmlNodeSyntax> nodes)
    {
        var text = new StringBuilder();
        foreach (XmlNodeSyntax node in nodes)
        {
            if (node is XmlTextSyntax plain)
                text.Append(string.Concat(plain.TextTokens.Select(t => t.ValueText)));
            else if (node is XmlElementSyntax element)
                text.Append(element.StartTag.Name.ToString() == "c" ? $"`{Text(element.Content)}`" : Text(element.Content));
            else if (node is XmlEmptyElementSyntax reference)
                text.Append($"`{Referred(reference)}`");
        }
        return Regex.Replace(text.ToString(), @"\s+", " ").Trim();
    }

    private static string Referred(XmlEmptyElementSyntax reference) => reference.Attributes.Select(a => a switch
    {
        XmlCrefAttributeSyntax cref => Regex.Replace(cref.Cref.ToString(), @"\(.*|^(\w+\.)*(?=[A-Z]\w*\.[A-Z])", ""),
        XmlNameAttributeSyntax name => name.Identifier.ToString(),
        _ => "",
    }).FirstOrDefault() ?? "";

    private static string FirstSentence(string text)
    {
        Match end = Regex.Match(text, @"\.(?= [A-Z`])");
        return (end.Success ? text[..end.Index] : text).TrimEnd('.').Replace("|", "\\|");
    }
}
