namespace UnityEditor.IMGUI.Controls;

/// <summary>Nobody drags it: it stays as it is set.</summary>
public abstract class PrimitiveBoundsHandle
{
    public Vector3 center { get; set; }

    public void DrawHandle() { }
}

public class BoxBoundsHandle : PrimitiveBoundsHandle
{
    public Vector3 size { get; set; }
}
