namespace UnityEditor;

/// <summary>Lasts until the editor quits: reloads of scripts leave it alone.</summary>
public class SessionState
{
    static readonly Dictionary<string, string> s_strings = new Dictionary<string, string>();

    public static string GetString(string key, string defaultValue) =>
        s_strings.TryGetValue(key, out string value) ? value : defaultValue;

    public static void SetString(string key, string value) => s_strings[key] = value;
    public static void EraseString(string key) => s_strings.Remove(key);

    static readonly Dictionary<string, int> s_ints = new Dictionary<string, int>();

    public static int GetInt(string key, int defaultValue) => s_ints.TryGetValue(key, out int value) ? value : defaultValue;
    public static void SetInt(string key, int value) => s_ints[key] = value;
    public static void EraseInt(string key) => s_ints.Remove(key);
}
