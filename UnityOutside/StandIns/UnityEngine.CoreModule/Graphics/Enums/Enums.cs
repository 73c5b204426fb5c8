namespace UnityEngine;

[Flags]
public enum CameraType { Game = 1, SceneView = 2, Preview = 4, VR = 8, Reflection = 16 }

public enum ColorSpace { Uninitialized = -1, Gamma = 0, Linear = 1 }

public enum CubemapFace
{
    Unknown = -1,
    PositiveX = 0,
    NegativeX = 1,
    PositiveY = 2,
    NegativeY = 3,
    PositiveZ = 4,
    NegativeZ = 5,
}

public enum FilterMode { Point = 0, Bilinear = 1, Trilinear = 2 }

[Flags]
public enum HideFlags
{
    None = 0,
    HideInHierarchy = 1,
    HideInInspector = 2,
    DontSaveInEditor = 4,
    NotEditable = 8,
    DontSaveInBuild = 16,
    DontUnloadUnusedAsset = 32,
    DontSave = 52,
    HideAndDontSave = 61,
}

public enum KeyCode { None = 0, Escape = 27 }

public enum MeshTopology { Triangles = 0, Quads = 2, Lines = 3, LineStrip = 4, Points = 5 }

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

public enum RenderTextureReadWrite { Default = 0, Linear = 1, sRGB = 2 }

public enum TextureWrapMode { Repeat = 0, Clamp = 1, Mirror = 2, MirrorOnce = 3 }
