namespace UnityOutside.Graphics;

public static class HeadlessShaders
{
    public static Shader Load(string path) => new Shader(ShaderLabReader.Read(path));

    public static ComputeShader LoadCompute(string path) => new ComputeShader(new ComputeSource(path));
}
