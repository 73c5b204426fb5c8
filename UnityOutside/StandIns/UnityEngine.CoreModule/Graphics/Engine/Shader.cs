namespace UnityEngine;

/// <summary>A .shader file; a host loads it by its path (HeadlessShaders.Load).</summary>
public sealed class Shader : Object
{
    internal Shader(ShaderLabSource source)
    {
        Source = source;
        name = source.Name;
    }

    internal ShaderLabSource Source { get; }

    public static int PropertyToID(string name) => PropertyNames.IdOf(name);
    public static void SetGlobalVector(int nameID, Vector4 value) => PropertySheet.Global.Set(nameID, PropertyValue.Of(value));
    public static void SetGlobalBuffer(int nameID, GraphicsBuffer value) => PropertySheet.Global.Set(nameID, value);
}
