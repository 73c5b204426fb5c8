namespace UnityEngine;

public sealed class QualitySettings : Object
{
    /// <summary>Pictures of the host are sRGB values, as they stand in files.</summary>
    public static ColorSpace activeColorSpace => ColorSpace.Gamma;
}
