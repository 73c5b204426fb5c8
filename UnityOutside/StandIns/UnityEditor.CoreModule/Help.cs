namespace UnityEditor;

public class Help
{
    /// <summary>Of the first HelpURL of its class; what is no URL of the web or of a file is a topic of Unity's own manual, which
    /// is not here.</summary>
    public static string GetHelpURLForObject(Object obj)
    {
        var urls = obj.GetType().GetCustomAttributes(typeof(HelpURLAttribute), true);
        string url = urls.Length > 0 ? ((HelpURLAttribute)urls[0]).URL : "";
        return Array.Exists(new[] { "http://", "https://", "file:///" }, s => url.StartsWith(s, StringComparison.Ordinal))
            ? url : "";
    }
}
