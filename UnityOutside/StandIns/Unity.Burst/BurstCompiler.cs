namespace Unity.Burst;

/// <summary>There is nothing that compiles here.</summary>
public static class BurstCompiler
{
    public static readonly BurstCompilerOptions Options = new BurstCompilerOptions();
}

public sealed class BurstCompilerOptions
{
    internal BurstCompilerOptions() { }

    public bool EnableBurstCompileSynchronously { get; set; }
}
