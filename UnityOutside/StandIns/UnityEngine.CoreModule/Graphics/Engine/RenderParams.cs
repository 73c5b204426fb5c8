namespace UnityEngine;

public struct RenderParams(Material mat)
{
    internal readonly Material Material = mat;

    /// <summary>What is outside of a camera's view is not drawn; an empty box, as at first, is in none.</summary>
    public Bounds worldBounds { get; set; } = default;

    public MaterialPropertyBlock matProps { get; set; } = null;
}
