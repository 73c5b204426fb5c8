namespace UnityEngine.Rendering;

// SetGlobal: A is the name, Data the value.
public partial class CommandBuffer
{
    public void SetGlobalVector(int nameID, Vector4 value) => SetGlobal(nameID, PropertyValue.Of(value));

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

    void SetGlobal(int nameID, in PropertyValue value) =>
        Add(new RecordedCommand { Kind = CommandKind.SetGlobal, A = nameID, Data = AddValue(value) });
}
