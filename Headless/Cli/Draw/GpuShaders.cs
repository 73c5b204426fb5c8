using UnityEngine;

namespace FastPoints.Cli.Draw;

/// <summary>The package's shaders on a graphics card.</summary>
public sealed class GpuShaders
{
    const string Folder = "Packages/com.fastpoints.dots/Shaders";

    /// <exception cref="UsageException">There is no card, or no compiler, or not the package's sources: which.</exception>
    public GpuShaders()
    {
        if (!HeadlessGraphics.IsAvailable)
            throw new UsageException("--gpu: " + HeadlessGraphics.WhyNot);
        string folder = FindFolder();
        Points = HeadlessShaders.Load(Path.Combine(folder, "Points.shader"));
        Compose = HeadlessShaders.Load(Path.Combine(folder, "Compose.shader"));
        Raster = HeadlessShaders.LoadCompute(Path.Combine(folder, "RasterPoints.compute"));
        CopyPages = HeadlessShaders.LoadCompute(Path.Combine(folder, "CopyPages.compute"));
    }

    public Shader Points { get; }
    public Shader Compose { get; }
    public ComputeShader CopyPages { get; }
    public ComputeShader Raster { get; }

    public NodePool CreatePool(long limitBytes, int bankBytes) => new GraphicsNodePool(CopyPages, limitBytes, bankBytes);

    /// <summary>The program is built within the repository.</summary>
    static string FindFolder()
    {
        for (string? at = AppContext.BaseDirectory; at != null; at = Path.GetDirectoryName(at))
            if (Directory.Exists(Path.Combine(at, Folder)))
                return Path.Combine(at, Folder);
        throw new UsageException("--gpu: " + Folder + " is in no folder above " + AppContext.BaseDirectory);
    }
}
