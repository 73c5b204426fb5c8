namespace UnityOutside.Graphics;

/// <summary>Shaders from their files, as Unity's importers make them of assets.</summary>
public static class HeadlessShaders
{
    /// <summary>A .shader file: its first SubShader. Passes are compiled when they are first drawn with.</summary>
    /// <exception cref="System.IO.InvalidDataException">Not ShaderLab as far as it is understood; names file and
    /// line.</exception>
    public static Shader Load(string path) => new Shader(ShaderLabReader.Read(path));

    /// <summary>A .compute file. Kernels are compiled when they are first run.</summary>
    /// <exception cref="System.IO.InvalidDataException">It has no kernel.</exception>
    public static ComputeShader LoadCompute(string path) => new ComputeShader(new ComputeSource(path));
}
