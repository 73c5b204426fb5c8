namespace UnityEngine;

/// <summary>A .compute file; a host loads it by its path (HeadlessShaders.LoadCompute).</summary>
public sealed class ComputeShader : Object
{
    readonly ComputeSource m_source;
    readonly List<ComputeKernel> m_kernels = new List<ComputeKernel>();
    readonly CommandBuffer m_commands = new CommandBuffer();

    internal ComputeShader(ComputeSource source)
    {
        m_source = source;
        name = source.Name;
        foreach (string kernel in source.Kernels)
            m_kernels.Add(new ComputeKernel(source, kernel));
    }

    internal PropertySheet Constants { get; } = new PropertySheet();
    internal KeywordSet Keywords { get; } = new KeywordSet();

    /// <exception cref="ArgumentException">No such kernel.</exception>
    public int FindKernel(string name)
    {
        int kernel = m_kernels.FindIndex(k => k.Name == name);
        return kernel >= 0 ? kernel : throw new ArgumentException($"Kernel '{name}' not found in {this.name}");
    }

    public bool HasKernel(string name) => m_kernels.Exists(k => k.Name == name);

    /// <summary>The device here runs all that is compiled.</summary>
    public bool IsSupported(int kernelIndex) => Kernel(kernelIndex) != null;

    public void EnableKeyword(string keyword) => Keywords.Set(keyword, true);
    public void DisableKeyword(string keyword) => Keywords.Set(keyword, false);
    public void SetInt(int nameID, int val) => Constants.Set(nameID, PropertyValue.Of(val));
    public void SetInt(string name, int val) => SetInt(Shader.PropertyToID(name), val);
    public void SetFloat(int nameID, float val) => Constants.Set(nameID, PropertyValue.Of(val));
    public void SetFloat(string name, float val) => SetFloat(Shader.PropertyToID(name), val);
    public void SetVector(int nameID, Vector4 val) => Constants.Set(nameID, PropertyValue.Of(val));
    public void SetMatrix(int nameID, Matrix4x4 val) => Constants.Set(nameID, PropertyValue.Of(val));
    public void SetBuffer(int kernelIndex, int nameID, GraphicsBuffer buffer) => Kernel(kernelIndex).Sheet.Set(nameID, buffer);

    public void SetBuffer(int kernelIndex, string name, GraphicsBuffer buffer) =>
        SetBuffer(kernelIndex, Shader.PropertyToID(name), buffer);

    public void SetTexture(int kernelIndex, int nameID, Texture texture) => Kernel(kernelIndex).Sheet.Set(nameID, texture);

    public void Dispatch(int kernelIndex, int threadGroupsX, int threadGroupsY, int threadGroupsZ)
    {
        m_commands.Clear();
        m_commands.DispatchCompute(this, kernelIndex, threadGroupsX, threadGroupsY, threadGroupsZ);
        Graphics.ExecuteCommandBuffer(m_commands);
    }

    internal ComputeKernel Kernel(int index)
    {
        if ((uint)index >= (uint)m_kernels.Count)
            throw new IndexOutOfRangeException($"{name}: kernel {index} of {m_kernels.Count}");
        return m_kernels[index];
    }
}
