namespace UnityEditor;

[Flags]
public enum EnterPlayModeOptions { None = 0, DisableDomainReload = 1, DisableSceneReload = 2 }

public sealed class EditorSettings : UnityEngine.Object
{
    public static bool enterPlayModeOptionsEnabled { get; set; }
    public static EnterPlayModeOptions enterPlayModeOptions { get; set; }
}
