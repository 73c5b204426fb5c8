namespace UnityEngine.Rendering;

[Flags]
public enum RTClearFlags { None = 0, Color = 1, Depth = 2, ColorDepth = 3, Stencil = 4, All = 7 }
