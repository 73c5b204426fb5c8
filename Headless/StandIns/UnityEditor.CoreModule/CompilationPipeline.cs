namespace UnityEditor.Compilation;

public enum AssembliesType { Editor = 0, Player = 1, PlayerWithoutTestAssemblies = 2 }

public class Assembly
{
    internal Assembly(string name, params string[] sourceFiles) => (this.name, this.sourceFiles) = (name, sourceFiles);

    public string name { get; }
    public string[] sourceFiles { get; }
}

/// <summary>The project's assemblies, as a test puts them there.</summary>
public static class CompilationPipeline
{
    internal static readonly List<Assembly> Assemblies = new List<Assembly>();

    public static Assembly[] GetAssemblies(AssembliesType assembliesType) => Assemblies.ToArray();
}
