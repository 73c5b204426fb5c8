namespace UnityEngine;

public class Material : Object
{
    Shader m_shader;

    public Material(Shader shader)
    {
        if (shader == null)
            throw new ArgumentNullException(nameof(shader));
        m_shader = shader;
        name = shader.name;
    }

    public Material(Material source) : this(source.shader)
    {
        Sheet.CopyFrom(source.Sheet);
        Keywords.CopyFrom(source.Keywords);
    }

    public Shader shader
    {
        get => m_shader;
        set => m_shader = value;
    }

    public int passCount => m_shader.passCount;
    internal PropertySheet Sheet { get; } = new PropertySheet();
    internal KeywordSet Keywords { get; } = new KeywordSet();

    /// <summary>The pass of that name, or -1.</summary>
    public int FindPass(string passName) =>
        m_shader.Source.Passes.FindIndex(p => string.Equals(p.Name, passName, StringComparison.OrdinalIgnoreCase));

    public void EnableKeyword(string keyword) => Keywords.Set(keyword, true);
    public void DisableKeyword(string keyword) => Keywords.Set(keyword, false);
    public void SetFloat(int nameID, float value) => Sheet.Set(nameID, PropertyValue.Of(value));
    public void SetFloat(string name, float value) => SetFloat(Shader.PropertyToID(name), value);
    public void SetVector(int nameID, Vector4 value) => Sheet.Set(nameID, PropertyValue.Of(value));
    public void SetColor(int nameID, Color value) => Sheet.Set(nameID, PropertyValue.Of((Vector4)value));
    public void SetBuffer(int nameID, GraphicsBuffer value) => Sheet.Set(nameID, value);
    public void SetBuffer(string name, GraphicsBuffer value) => SetBuffer(Shader.PropertyToID(name), value);
    public void SetTexture(int nameID, Texture value) => Sheet.Set(nameID, value);

    public void SetTexture(int nameID, RenderTexture value, RenderTextureSubElement element) =>
        Sheet.Set(nameID, value, element == RenderTextureSubElement.Depth);

    public float GetFloat(int nameID) => m_shader.Source.Value(Sheet, nameID, out PropertyValue value) ? value.Vector.x : 0;
}
