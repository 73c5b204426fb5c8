namespace UnityEngine;

/// <summary>Lines that the editor draws over a scene: nothing here.</summary>
public sealed class Gizmos
{
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;

    public static void DrawWireCube(Vector3 center, Vector3 size) { }
}
