namespace UnityOutside.Api;

/// <summary>What the NUnit that the package is compiled against (3.6.0) has, and the one that Unity brings along
/// (com.unity.ext.nunit 2.0.5, a changed 3.5) has not. The two were compared by their public types and members.</summary>
public static class UnityNUnit
{
    private const string Assembly = "nunit.framework";

    /// <summary>Unity has changed much in these: no test needs them.</summary>
    private static readonly string[] s_namespaces =
    {
        "NUnit.Framework.Internal.Commands", "NUnit.Framework.Internal.Execution", "NUnit.Framework.Api",
    };

    private static readonly HashSet<string> s_types = new HashSet<string>(StringComparer.Ordinal)
    {
        "NUnit.Framework.MultipleAssertException", "NUnit.Framework.NonTestAssemblyAttribute", "NUnit.Framework.Warn",
        "NUnit.Framework.Internal.TestResult", "NUnit.Framework.Internal.TestCaseResult",
        "NUnit.Framework.Internal.TestSuiteResult",
        "NUnit.Framework.Internal.TestExecutionContext", "NUnit.Framework.Internal.StackFilter",
        "NUnit.Framework.Interfaces.AssertionResult", "NUnit.Framework.Interfaces.AssertionStatus",
        "NUnit.Framework.Constraints.Interval", "NUnit.Framework.Constraints.ItemsConstraintExpression",
        "NUnit.Framework.Constraints.DelayedConstraint.WithDimensionedDelayInterval",
        "NUnit.Framework.Constraints.DelayedConstraint.WithRawDelayInterval",
        "NUnit.Framework.Constraints.DelayedConstraint.WithRawPollingInterval",
    };

    private static readonly HashSet<string> s_members = new HashSet<string>(StringComparer.Ordinal)
    {
        "NUnit.Framework.Assert.Multiple", "NUnit.Framework.Assert.Warn",
        "NUnit.Framework.Interfaces.IApplyToContext.ApplyToContext",
        "NUnit.Framework.Interfaces.ITestResult.get_AssertionResults",
        "NUnit.Framework.Interfaces.ITestResult.get_WarningCount",
        "NUnit.Framework.Interfaces.ResultState.Matches", "NUnit.Framework.Interfaces.ResultState.Warning",
        "NUnit.Framework.TestContext.ResultAdapter.get_WarningCount",
        "NUnit.Framework.Constraints.DelayedConstraint.get_DelayInterval",
        "NUnit.Framework.Constraints.DelayedConstraint.set_DelayInterval",
        "NUnit.Framework.Constraints.DelayedConstraint.get_PollingInterval",
        "NUnit.Framework.Constraints.DelayedConstraint.set_PollingInterval",
        // Who derives from it has to override ApplyTo, which is not generic in Unity's.
        "NUnit.Framework.Constraints.Constraint..ctor",
    };

    public static string? FindAbsent(MemberReference used)
    {
        TypeReference? type = used as TypeReference ?? used.DeclaringType;
        if (type == null || Origins.AssemblyOf(type) != Assembly)
            return null;
        string name = DocId.DefinitionName(type);
        if (s_types.Contains(name) || s_namespaces.Any(n => name.StartsWith(n + ".", StringComparison.Ordinal)))
            return name;
        string member = name + "." + used.Name;
        bool isAbsent = s_members.Contains(member) || used.Name == "ApplyTo" ||
            // Its arguments for a method that makes the cases.
            (member == "NUnit.Framework.TestCaseSourceAttribute..ctor" && ((MethodReference)used).Parameters
                .Select(p => p.ParameterType.FullName).SequenceEqual(new[] { "System.String", "System.Object[]" }));
        return used is not TypeReference && isAbsent ? member : null;
    }
}
