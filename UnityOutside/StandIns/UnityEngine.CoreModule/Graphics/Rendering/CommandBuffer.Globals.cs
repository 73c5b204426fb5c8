namespace UnityEngine.Rendering;

// SetGlobal: A is the name, Data the value.
public partial class CommandBuffer
{
    public void SetGlobalVector(int nameID, Vector4 value) => SetGlobal(nameID, PropertyValue.Of(value));

    public void SetGlobalVectorArray(int nameID, Vector4[] values) =>
        AddArray(null, nameID, MemoryMarshal.Cast<Vector4, float>(values));

    public void SetGlobalMatrixArray(int nameID, Matrix4x4[] values) =>
        AddArray(null, nameID, MemoryMarshal.Cast<Matrix4x4, float>(values));

    public void SetGlobalBuffer(int nameID, GraphicsBuffer value) => SetGlobal(nameID, PropertyValue.Of(value));

    public void SetGlobalTexture(int nameID, RenderTargetIdentifier value) =>
        SetGlobalTexture(nameID, value, RenderTextureSubElement.Default);

    public void SetGlobalTexture(int nameID, RenderTargetIdentifier value, RenderTextureSubElement element) =>
        Add(new RecordedCommand
        {
            Kind = CommandKind.SetGlobalTexture,
            A = nameID,
            B = element == RenderTextureSubElement.Depth ? 1 : 0,
            Data = AddTarget(value),
        });

    /// <summary>The projection as OpenGL has it; shaders get it as GL.GetGPUProjectionMatrix makes it.</summary>
    public void SetViewProjectionMatrices(Matrix4x4 view, Matrix4x4 proj)
    {
        int first = AddValue(PropertyValue.Of(view));
        AddValue(PropertyValue.Of(proj));
        Add(new RecordedCommand { Kind = CommandKind.SetViewProjection, Data = first });
    }

    public void EnableShaderKeyword(string keyword) =>
        Add(new RecordedCommand { Kind = CommandKind.SetKeyword, X = keyword, A = 1 });

    public void DisableShaderKeyword(string keyword) => Add(new RecordedCommand { Kind = CommandKind.SetKeyword, X = keyword });

    // A is the name, B how many bytes, Data where they are; X the compute shader whose constants they are, or null.
    unsafe void AddArray(ComputeShader shader, int nameID, System.ReadOnlySpan<float> values)
    {
        fixed (float* first = values)
            Add(new RecordedCommand
            {
                Kind = CommandKind.SetArray,
                X = shader,
                A = nameID,
                B = values.Length * 4,
                Data = AddBytes((byte*)first, values.Length * 4L),
            });
    }

    void SetGlobal(int nameID, in PropertyValue value) =>
        Add(new RecordedCommand { Kind = CommandKind.SetGlobal, A = nameID, Data = AddValue(value) });
}
