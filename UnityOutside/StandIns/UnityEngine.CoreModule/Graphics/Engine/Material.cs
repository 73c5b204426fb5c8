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

    internal PropertySheet Sheet { get; } = new PropertySheet();
    internal KeywordSet Keywords { get; } = new KeywordSet();

    public void EnableKeyword(string keyword) => Keywords.Set(keyword, true);
    public void DisableKeyword(string keyword) => Keywords.Set(keyword, false);
    public void SetFloat(int nameID, float value) => Sheet.Set(nameID, PropertyValue.Of(value));
    public void SetVector(int nameID, Vector4 value) => Sheet.Set(nameID, PropertyValue.Of(value));
    public void SetColor(int nameID, Color value) => Sheet.Set(nameID, PropertyValue.Of((Vector4)value));
    public void SetBuffer(int nameID, GraphicsBuffer value) => Sheet.Set(nameID, value);
    public void SetTexture(int nameID, Texture value) => Sheet.Set(nameID, value);
}
