namespace UnityEngine;

public enum RenderTextureFormat
{
    ARGB32 = 0,
    Depth = 1,
    ARGBHalf = 2,
    Default = 7,
    DefaultHDR = 9,
    ARGBFloat = 11,
    RGFloat = 12,
    RFloat = 14,
    ARGBInt = 17,
    RInt = 19,
}
