namespace FastPoints.RepoTools.Package;

/// <summary>What Unity's Test Runner makes of the package's tests. It runs all that is not explicit, and with a filter explicit
/// tests, too, where they match: one that only leaves categories out matches all others. In a test that loads scripts anew it
/// runs [SetUp] again.</summary>
public static class TestRules
{
    private const string Smoke = "Smoke";

    private static readonly string[] s_long = { "Long", "Large" };

    private static readonly string[] s_tests =
        { "TestAttribute", "TestCaseAttribute", "TestCaseSourceAttribute", "UnityTestAttribute" };

    public static IEnumerable<string> Check(ModuleDefinition module)
    {
        foreach ((TypeDefinition type, MethodDefinition test) in Tests(module))
        {
            string name = type.FullName + "." + test.Name;
            List<CustomAttribute> attributes = Attributes(type, test).ToList();
            List<string> categories = Categories(attributes);
            bool isLong = categories.Intersect(s_long).Any();
            bool isExplicit = attributes.Any(a => a.AttributeType.Name == "ExplicitAttribute");
            if (isLong && !isExplicit)
                yield return $"{name}: Long or Large and not Explicit: Run All would run it";
            if (isExplicit && !isLong)
                yield return $"{name}: Explicit and neither Long nor Large: a filter that leaves these out would run it";
            if (isExplicit && categories.Contains(Smoke))
                yield return $"{name}: Explicit and of the category {Smoke}, which would run it";
            if (test.CustomAttributes.Any(a => a.AttributeType.Name == "UnityTestAttribute") && SetUpOf(type) is { } setUp)
                yield return $"{name}: {setUp} runs again where scripts are loaded anew: wanted [UnitySetUp]";
            if (attributes.Any(a => a.Properties.Any(p => p.Name is "Category" or "Explicit" or "Categories")))
                yield return $"{name}: wanted its categories as attributes of the method";
        }
    }

    public static IEnumerable<string> WithoutSmoke(ModuleDefinition module) => Tests(module)
        .GroupBy(t => string.Join('.', t.Type.Namespace.Split('.').Take(3)),
            t => Categories(Attributes(t.Type, t.Test)).Contains(Smoke))
        .Where(g => !g.Any(isSmoke => isSmoke)).Select(g => g.Key);

    private static IEnumerable<(TypeDefinition Type, MethodDefinition Test)> Tests(ModuleDefinition module) =>
        module.GetTypes().SelectMany(t => t.Methods, (type, method) => (type, method))
            .Where(t => t.method.CustomAttributes.Any(a => s_tests.Contains(a.AttributeType.Name)));

    private static List<string> Categories(IEnumerable<CustomAttribute> attributes) => attributes
        .Where(a => a.AttributeType.Name == "CategoryAttribute")
        .Select(a => (string)a.ConstructorArguments[0].Value).ToList();

    private static IEnumerable<CustomAttribute> Attributes(TypeDefinition type, MethodDefinition test) =>
        test.CustomAttributes.Concat(Chain(type).SelectMany(t => t.CustomAttributes));

    private static string? SetUpOf(TypeDefinition type) => Chain(type).SelectMany(t => t.Methods)
        .FirstOrDefault(m => m.CustomAttributes.Any(a => a.AttributeType.Name == "SetUpAttribute"))?.Name;

    private static IEnumerable<TypeDefinition> Chain(TypeDefinition type)
    {
        for (TypeDefinition? at = type; at != null; at = at.BaseType is { } from ? Resolution.Of(from) : null)
            yield return at;
    }
}
