namespace UnityEngine;

public sealed partial class Application
{
    /// <summary>The host is as an editor that does not play, unless a test has it play.</summary>
    public static bool isPlaying => SceneLoop.IsPlaying;

    public static bool isEditor => true;

    /// <summary>As a test says.</summary>
    public static bool isBatchMode { get; internal set; }

    internal static string AssetsPath;
    public static string dataPath => AssetsPath ?? AppContext.BaseDirectory + "Assets";
    internal static string PlayerFiles; // Of a test; there is none otherwise.

    public static string persistentDataPath => PlayerFiles;
    public static string temporaryCachePath => PlayerFiles;
    public static string streamingAssetsPath => AppContext.BaseDirectory + "StreamingAssets";
}
