using UnityEngine;

namespace FastPoints.Cli.Draw;

public sealed class GpuShaders
{
    const string Folder = "Packages/com.fastpoints.dots/Shaders";

    public GpuShaders()
    {
        if (!HeadlessGraphics.IsAvailable)
            throw new UsageException("--gpu: " + HeadlessGraphics.UnsupportedReason);
        string folder = FindFolder();
        Points = HeadlessShaders.Load(Path.Combine(folder, "Points.shader"));
        Compose = HeadlessShaders.Load(Path.Combine(folder, "Compose.shader"));
        Raster = HeadlessShaders.LoadCompute(Path.Combine(folder, "RasterPoints.compute"));
        Progressive = HeadlessShaders.LoadCompute(Path.Combine(folder, "ProgressiveRaster.compute"));
        Gather = HeadlessShaders.LoadCompute(Path.Combine(folder, "GatherPoints.compute"));
        CopyPages = HeadlessShaders.LoadCompute(Path.Combine(folder, "CopyPages.compute"));
    }

    public Shader Points { get; }
    public Shader Compose { get; }
    public ComputeShader CopyPages { get; }
    public ComputeShader Raster { get; }
    public ComputeShader Progressive { get; }
    public ComputeShader Gather { get; }

    public NodePool CreatePool(long limitBytes, int bankBytes) => new GraphicsNodePool(CopyPages, limitBytes, bankBytes);

    static string FindFolder()
    {
        for (string? at = AppContext.BaseDirectory; at != null; at = Path.GetDirectoryName(at))
            if (Directory.Exists(Path.Combine(at, Folder)))
                return Path.Combine(at, Folder);
        throw new UsageException("--gpu: " + Folder + " is in no folder above " + AppContext.BaseDirectory);
    }
}
