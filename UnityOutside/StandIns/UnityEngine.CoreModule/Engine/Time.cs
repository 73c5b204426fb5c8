namespace UnityEngine;

/// <summary>A host sets what a frame takes.</summary>
public partial class Time
{
    internal static float s_frame = 1 / 60f;
    static readonly Stopwatch s_clock = Stopwatch.StartNew();

    public static float deltaTime => s_frame;
    public static float captureDeltaTime { get; set; }
    public static double realtimeSinceStartupAsDouble => s_clock.Elapsed.TotalSeconds;
}
