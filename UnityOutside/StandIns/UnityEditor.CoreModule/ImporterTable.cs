namespace UnityEditor;

static class ImporterTable
{
    static readonly List<(Type Importer, string[] Extensions, string[] Overrides)> s_importers =
        new List<(Type, string[], string[])>();

    /// <param name="extensions">Files of these are imported by it without further ado; may be null.</param>
    /// <param name="overrides">For files of these it can be chosen; may be null.</param>
    public static void Add(Type importer, string[] extensions, string[] overrides)
    {
        s_importers.Add((importer, extensions ?? new string[0], overrides ?? new string[0]));
        foreach (string extension in s_importers[s_importers.Count - 1].Extensions)
            if (Claiming(extension).Length > 1)
                Debug.LogError("Multiple scripted importers are targeting the extension '" + extension +
                    "' and have all been rejected: " + string.Join(", ", Claiming(extension).Select(t => t.FullName)));
    }

    public static void Clear() => s_importers.Clear();

    /// <summary>Null if nobody claims the extension, or more than one does.</summary>
    public static Type Default(string path)
    {
        var claiming = Claiming(ExtensionOf(path));
        return claiming.Length == 1 ? claiming[0] : null;
    }

    public static bool CanBeOverride(string path, Type importer) =>
        s_importers.Exists(i => i.Importer == importer && Has(i.Overrides, ExtensionOf(path)));

    static Type[] Claiming(string extension) =>
        s_importers.Where(i => Has(i.Extensions, extension)).Select(i => i.Importer).ToArray();

    static bool Has(string[] extensions, string extension) => extensions.Contains(extension, StringComparer.OrdinalIgnoreCase);
    static string ExtensionOf(string path) => Path.GetExtension(path).TrimStart('.');
}
