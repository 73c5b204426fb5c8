namespace UnityEditor;

public sealed class PlayerSettings : UnityEngine.Object
{
    public static UnityEngine.ColorSpace colorSpace { get; set; }
}
