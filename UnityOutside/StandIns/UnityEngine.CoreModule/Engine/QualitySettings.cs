namespace UnityEngine;

public sealed class QualitySettings : Object
{
    /// <summary>Pictures of the host are sRGB values, as they stand in files, unless a host says otherwise.</summary>
    public static ColorSpace activeColorSpace { get; internal set; } = ColorSpace.Gamma;
}
