namespace UnityEngine;

/// <summary>Values for one draw, before the material's.</summary>
public sealed class MaterialPropertyBlock
{
    internal PropertySheet Sheet { get; } = new PropertySheet();

    public void Clear() => Sheet.Clear();
    public void SetFloat(int nameID, float value) => Sheet.Set(nameID, PropertyValue.Of(value));
    public void SetInteger(int nameID, int value) => Sheet.Set(nameID, PropertyValue.Of(value));
    public void SetVector(int nameID, Vector4 value) => Sheet.Set(nameID, PropertyValue.Of(value));
    public void SetMatrix(int nameID, Matrix4x4 value) => Sheet.Set(nameID, PropertyValue.Of(value));
    public void SetBuffer(int nameID, GraphicsBuffer value) => Sheet.Set(nameID, value);
}
