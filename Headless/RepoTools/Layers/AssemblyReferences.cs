using System.Xml.Linq;

namespace FastPoints.RepoTools.Layers;

public static class AssemblyReferences
{
    private static readonly string[] s_dots = { "Unity.Burst", "Unity.Collections", "Unity.Mathematics" };
    private static readonly string[] s_view = s_dots.Append("FastPoints").ToArray();
    private static readonly string[] s_shared = s_view.Append("FastPoints.Import").ToArray();
    private static readonly string[] s_drawing = { "FastPoints", "FastPoints.Rendering" };
    private static readonly string[] s_entities = { "Unity.Entities", "Unity.Entities.Hybrid", "Unity.Transforms" };
    private static readonly string[] s_testRunner = { "UnityEngine.TestRunner", "UnityEditor.TestRunner" };

    private static readonly Dictionary<string, string[]> s_mayReference = new Dictionary<string, string[]>
    {
        ["FastPoints"] = s_dots,
        ["FastPoints.Import"] = s_view,
        ["FastPoints.Picture"] = s_shared,
        ["FastPoints.Surface"] = s_view
            .Concat(new[] { "FastPoints.Entities", "Unity.Entities", "Unity.Physics", "Unity.Transforms" }).ToArray(),
        ["FastPoints.Rendering"] = s_view,
        ["FastPoints.Rendering.BuiltIn"] = s_drawing,
        ["FastPoints.Rendering.Urp"] = s_drawing
            .Concat(new[] { "Unity.RenderPipelines.Core.Runtime", "Unity.RenderPipelines.Universal.Runtime" }).ToArray(),
        ["FastPoints.Rendering.Hdrp"] = s_drawing
            .Concat(new[] { "Unity.RenderPipelines.Core.Runtime", "Unity.RenderPipelines.HighDefinition.Runtime" }).ToArray(),
        ["FastPoints.Entities"] = s_view.Append("FastPoints.Rendering").Concat(s_entities).ToArray(),
        ["FastPoints.Editor"] = s_shared
            .Concat(new[] { "FastPoints.Picture", "FastPoints.Rendering", "FastPoints.Entities",
                "Unity.Entities", "Unity.Entities.Hybrid" })
            .ToArray(),
        ["FastPoints.Tests"] = s_shared.Concat(s_entities)
            .Concat(new[] { "FastPoints.Picture", "FastPoints.Rendering", "FastPoints.Entities" })
            .Concat(new[] { "FastPoints.Benchmarks", "FastPoints.Evaluation", "FastPoints.Scenes", "FastPoints.Surface" })
            .Concat(s_testRunner).ToArray(),
        ["FastPoints.Scenes"] = s_shared,
        ["FastPoints.Samples"] = s_shared.Concat(s_entities)
            .Concat(new[] { "FastPoints.Rendering", "FastPoints.Entities", "FastPoints.Surface" }).ToArray(),
        ["FastPoints.Samples.Editor"] = new[]
        {
            "FastPoints", "FastPoints.Editor", "FastPoints.Entities", "FastPoints.Rendering", "FastPoints.Surface",
            "FastPoints.Samples", "Unity.Collections", "Unity.Entities", "Unity.Mathematics",
        },
        ["FastPoints.UnityTests"] = s_shared.Concat(s_testRunner)
            .Concat(new[] { "FastPoints.Picture", "FastPoints.Rendering", "FastPoints.Entities", "FastPoints.Editor" })
            .Concat(new[] { "FastPoints.Benchmarks", "Unity.Entities", "Unity.Scenes" })
            .ToArray(),
        ["FastPoints.UnityTests.Performance"] = s_testRunner
            .Concat(new[] { "FastPoints.Editor", "FastPoints.Entities", "FastPoints.UnityTests", "Unity.PerformanceTesting" })
            .ToArray(),
        ["FastPoints.Evaluation"] = s_shared.Append("FastPoints.Picture").ToArray(),
        ["FastPoints.Benchmarks"] = s_shared.Concat(s_entities)
            .Concat(new[] { "FastPoints.Entities", "FastPoints.Evaluation", "FastPoints.Picture", "FastPoints.Scenes" })
            .Append("FastPoints.Surface").ToArray(),
        ["FastPoints.Benchmarks.Unity"] = new[] { "FastPoints.Benchmarks", "Unity.Burst", "Unity.PerformanceTesting" }
            .Concat(s_testRunner).ToArray(),
    };

    public static IEnumerable<string> CheckTable(Asmdef asmdef)
    {
        if (!s_mayReference.TryGetValue(asmdef.Name, out string[]? allowed))
        {
            yield return $"{asmdef.Name} is not in the table of assemblies";
            yield break;
        }
        foreach (string reference in asmdef.References)
        {
            if (reference.StartsWith("GUID:", System.StringComparison.Ordinal))
                yield return $"{asmdef.Name} references {reference}: by name, please";
            else if (!allowed.Contains(reference))
                yield return $"{asmdef.Name} must not reference {reference}";
        }
    }

    /// <summary>What the asmdef and the csproj of an assembly reference differently. Modules of the engine and the editor need no
    /// line in an asmdef, and Unity's test runner is NUnit here.</summary>
    public static IEnumerable<string> CheckProject(Asmdef asmdef, string project)
    {
        List<string> inProject = XDocument.Load(project).Descendants("ProjectReference")
            .Select(r => Path.GetFileNameWithoutExtension(r.Attribute("Include")!.Value)).Except(s_testRunner).ToList();
        List<string> wanted = asmdef.References.Except(s_testRunner).ToList();
        foreach (string missing in wanted.Except(inProject))
            yield return $"{asmdef.Name}.csproj does not reference {missing}, the asmdef does";
        foreach (string extra in inProject.Except(wanted).Where(r => !IsEngineModule(r)))
            yield return $"{asmdef.Name}.csproj references {extra}, the asmdef does not";
    }

    private static bool IsEngineModule(string assembly) => assembly.EndsWith("Module", System.StringComparison.Ordinal) &&
        (assembly.StartsWith("UnityEngine.", System.StringComparison.Ordinal) ||
            assembly.StartsWith("UnityEditor.", System.StringComparison.Ordinal));
}
