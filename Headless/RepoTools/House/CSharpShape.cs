namespace FastPoints.RepoTools.House;

public sealed record CSharpShape(IReadOnlyList<Counted> Parameters, IReadOnlyList<Counted> Methods,
    IReadOnlyList<DeclaredType> Types, IReadOnlyList<Written> Names)
{
    // As the newest generation of Unity's editor compiles the package.
    private static readonly CSharpParseOptions s_options = new CSharpParseOptions(LanguageVersion.Latest,
        DocumentationMode.None, SourceCodeKind.Regular,
        new[] { "ENABLE_UNITY_COLLECTIONS_CHECKS", "UNITY_EDITOR", "UNITY_INCLUDE_TESTS", "UNITY_6000_3_OR_NEWER",
            "FASTPOINTS_PHYSICS", "FASTPOINTS_AI", "FASTPOINTS_DOTS_PHYSICS" });

    public static CSharpShape Of(SourceFile file)
    {
        SyntaxNode root = CSharpSyntaxTree.ParseText(file.Text, s_options).GetRoot();
        // Members lie in namespaces and types alone, so the walk need not go into them.
        List<SyntaxNode> nodes = root
            .DescendantNodes(n => n is CompilationUnitSyntax or BaseNamespaceDeclarationSyntax or TypeDeclarationSyntax)
            .ToList();
        return new CSharpShape(
            nodes.Concat(root.DescendantNodes().OfType<LocalFunctionStatementSyntax>()).SelectMany(ParametersOf).ToList(),
            nodes.Where(n => n is BaseMethodDeclarationSyntax or BasePropertyDeclarationSyntax).Select(Method).ToList(),
            nodes.Where(n => n is BaseTypeDeclarationSyntax or DelegateDeclarationSyntax).Cast<MemberDeclarationSyntax>()
                .Where(t => t.Parent is not TypeDeclarationSyntax)
                .Select(t => new DeclaredType(FullName(t), t.Modifiers.Any(SyntaxKind.PublicKeyword))).ToList(),
            file.IsProduct ? DeclaredNames(root) : Array.Empty<Written>());
    }

    private static bool IsRecordOrReadonlyStruct(SyntaxNode type) => type is RecordDeclarationSyntax ||
        type is StructDeclarationSyntax structure && structure.Modifiers.Any(SyntaxKind.ReadOnlyKeyword);

    private static IEnumerable<Counted> ParametersOf(SyntaxNode node)
    {
        (SyntaxToken name, ParameterListSyntax? parameters) = node switch
        {
            MethodDeclarationSyntax m => (m.Identifier, m.ParameterList),
            LocalFunctionStatementSyntax f => (f.Identifier, f.ParameterList),
            ConstructorDeclarationSyntax c when !IsRecordOrReadonlyStruct(c.Parent!) => (c.Identifier, c.ParameterList),
            TypeDeclarationSyntax t when !IsRecordOrReadonlyStruct(t) => (t.Identifier, t.ParameterList),
            _ => default,
        };
        if (parameters != null)
            yield return new Counted(name.ValueText, LineOf(name), parameters.Parameters.Count);
    }

    private static Counted Method(SyntaxNode node)
    {
        SyntaxToken name = node switch
        {
            MethodDeclarationSyntax m => m.Identifier,
            ConstructorDeclarationSyntax c => c.Identifier,
            DestructorDeclarationSyntax d => d.Identifier,
            OperatorDeclarationSyntax o => o.OperatorToken,
            ConversionOperatorDeclarationSyntax o => o.OperatorKeyword,
            PropertyDeclarationSyntax p => p.Identifier,
            IndexerDeclarationSyntax i => i.ThisKeyword,
            EventDeclarationSyntax e => e.Identifier,
            _ => node.GetFirstToken(),
        };
        int first = LineOf(name);
        return new Counted(name.ValueText, first, LineOf(node.GetLastToken()) - first + 1);
    }

    private static string FullName(MemberDeclarationSyntax type)
    {
        (SyntaxToken name, int arity) = type switch
        {
            TypeDeclarationSyntax t => (t.Identifier, t.Arity),
            DelegateDeclarationSyntax d => (d.Identifier, d.Arity),
            _ => (((BaseTypeDeclarationSyntax)type).Identifier, 0),
        };
        IEnumerable<string> spaces = type.Ancestors().OfType<BaseNamespaceDeclarationSyntax>().Reverse()
            .Select(n => n.Name.ToString());
        return string.Join(".", spaces.Append(arity == 0 ? name.ValueText : $"{name.ValueText}`{arity}"));
    }

    // An identifier under a name is a use of it; under anything else a declaration.
    private static List<Written> DeclaredNames(SyntaxNode root) => root.DescendantTokens()
        .Where(t => t.IsKind(SyntaxKind.IdentifierToken) && t.Parent is not SimpleNameSyntax)
        .Select(t => new Written(t.ValueText, LineOf(t))).ToList();

    private static int LineOf(SyntaxToken token) => token.GetLocation().GetLineSpan().EndLinePosition.Line + 1;
}

public sealed record Counted(string Name, int Line, int Amount);

public sealed record DeclaredType(string Name, bool IsPublic);

public sealed record Written(string Text, int Line);
