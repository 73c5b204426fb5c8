namespace UnityEngine;

public sealed partial class Resources
{
    /// <summary>What a host puts where assets would be.</summary>
    internal static readonly Dictionary<string, Object> Assets = new Dictionary<string, Object>();

    /// <summary>Of scenes: what is inactive or disabled, too.</summary>
    public static T[] FindObjectsOfTypeAll<T>() where T : Object => StandIns.Scene.SceneLoop.Find<T>();

    public static T Load<T>(string path) where T : Object => Assets.TryGetValue(path, out var asset) ? asset as T : null;
}
