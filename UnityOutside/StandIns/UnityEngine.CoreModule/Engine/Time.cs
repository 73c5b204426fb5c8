namespace UnityEngine;

/// <summary>A host sets what a frame takes.</summary>
public partial class Time
{
    internal static float s_frame = 1 / 60f;

    public static float deltaTime => s_frame;
}
