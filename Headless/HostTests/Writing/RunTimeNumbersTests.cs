namespace FastPoints.HostTests.Writing;

/// <summary>Fractions become text, and text fractions, by NumberText alone: what the run time has for that differs between
/// Mono and .NET. For people it may round ("N0", "0.##").</summary>
public sealed class RunTimeNumbersTests
{
    private static readonly string[] s_forPeopleAlone =
        { "FastPoints.Tests", "FastPoints.UnityTests", "FastPoints.UnityTests.Performance" };

    [Test]
    public void Package_FractionsAsText_NeverUseTheRuntimesParser()
    {
        using GenerationBuilds builds = Checkout.Builds(RepoTools.Repository.Generations[0]);

        Assert.That(builds.Package.Where(m => !s_forPeopleAlone.Contains(m.Assembly.Name.Name)).SelectMany(Statistics), Is.Empty);
    }

    [TestCase(nameof(Planted.Digits), 1)]
    [TestCase(nameof(Planted.Beside), 1)]
    [TestCase(nameof(Planted.Formatted), 1)]
    [TestCase(nameof(Planted.Built), 1)]
    [TestCase(nameof(Planted.Read), 2)]
    [TestCase(nameof(Planted.ForPeople), 0)]
    public void FindMethod_Planted_IsFound(string method, int statistics)
    {
        using ModuleDefinition module = ModuleDefinition.ReadModule(typeof(RunTimeNumbersTests).Assembly.Location);
        TypeDefinition planted = module.GetType(typeof(RunTimeNumbersTests).FullName)
            .NestedTypes.Single(t => t.Name == nameof(Planted));

        Assert.That(Statistics(planted.Methods.Single(m => m.Name == method)).Count(), Is.EqualTo(statistics));
    }

    private static class Planted
    {
        internal static string Digits(double value) => value.ToString("R", CultureInfo.InvariantCulture);
        internal static string Beside(float value) => "at " + value;
        internal static string Formatted(double value) => string.Format(CultureInfo.InvariantCulture, "{0:R}", value);
        internal static string Built(double value) => new StringBuilder().Append(value).ToString();

        internal static bool Read(string text) =>
            double.Parse(text, CultureInfo.InvariantCulture) > 1 || float.TryParse(text, out float _);

        internal static string ForPeople(double value) =>
            value.ToString("N0", CultureInfo.InvariantCulture) + string.Format(CultureInfo.InvariantCulture, "{0:0.00}", value);
    }

    private static IEnumerable<string> Statistics(ModuleDefinition module) =>
        module.GetTypes().SelectMany(t => t.Methods).SelectMany(Statistics);

    private static IEnumerable<string> Statistics(MethodDefinition method)
    {
        if (!method.HasBody)
            yield break;
        foreach (Instruction at in method.Body.Instructions)
        {
            if (at.Operand is string text && Regex.IsMatch(text, @"\{\d+(,-?\d+)?:[RGrg]\d*\}"))
                yield return $"{method.FullName}: \"{text}\"";
            if (at.Operand is not MethodReference called)
                continue;
            bool isFraction = IsFraction(at.Previous?.OpCode == OpCodes.Constrained ? (TypeReference)at.Previous.Operand
                : called.DeclaringType);
            bool isByRunTime = called.Name switch
            {
                "ToString" => isFraction && !IsRounded(at),
                "Parse" or "TryParse" => isFraction,
                "Append" => called.DeclaringType.FullName == "System.Text.StringBuilder" &&
                    IsFraction(called.Parameters[0].ParameterType),
                _ => false,
            };
            if (isByRunTime)
                yield return $"{method.FullName}: {called.FullName}";
        }
    }

    private static bool IsFraction(TypeReference type) => type.FullName is "System.Double" or "System.Single";

    private static bool IsRounded(Instruction at)
    {
        for (int back = 0; back < 8 && at.Previous != null; back++)
        {
            at = at.Previous;
            if (at.Operand is string format)
                return Regex.IsMatch(format, "^([FNP]\\d*|G\\d|[0#,.%]+)$");
        }
        return false;
    }
}
