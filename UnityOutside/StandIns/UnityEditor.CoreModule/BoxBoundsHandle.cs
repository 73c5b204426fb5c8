namespace UnityEditor.IMGUI.Controls;

/// <summary>A drag moves its side along x as Slider1D does: by the whole way since it was taken, in the space of then.</summary>
public abstract class PrimitiveBoundsHandle
{
    internal static float? Way; // The way in the world since the side was taken; null while nobody drags.

    static Matrix4x4 s_space;
    static Vector3 s_start;

    public Vector3 center { get; set; }

    private protected abstract Vector3 Size { get; set; }

    public void DrawHandle()
    {
        if (Way is not { } way)
        {
            GUIUtility.hotControl = 0;
        }
        else if (GUIUtility.hotControl == 0)
        {
            GUIUtility.hotControl = GetHashCode() | 1;
            (s_space, s_start) = (Handles.matrix, center + new Vector3(Size.x / 2, 0, 0));
        }
        else if (GUIUtility.hotControl == (GetHashCode() | 1))
        {
            var axis = (Vector3)s_space.GetColumn(0);
            var place = s_space.inverse.MultiplyPoint3x4(s_space.MultiplyPoint3x4(s_start) + axis.normalized * way);
            float min = center.x - Size.x / 2;
            center = new Vector3((place.x + min) / 2, center.y, center.z);
            Size = new Vector3(place.x - min, Size.y, Size.z);
            GUI.changed = true;
        }
    }
}

public class BoxBoundsHandle : PrimitiveBoundsHandle
{
    public Vector3 size { get; set; }

    private protected override Vector3 Size { get => size; set => size = value; }
}
