namespace UnityEngine.Rendering;

public enum RenderTextureSubElement { Color = 0, Depth = 1, Default = 3 }
