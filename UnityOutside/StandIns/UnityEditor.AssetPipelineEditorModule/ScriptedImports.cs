using StandIns.Scene;

namespace UnityEditor.AssetImporters;

/// <summary>Runs the scripted importers of an assembly as an import worker would: each import by a new one, twice, for what
/// comes of it depends on nothing but the file.</summary>
static class ScriptedImports
{
    /// <summary>What somebody has set in an importer's inspector; null for nothing.</summary>
    public static Action<ScriptedImporter> Configure { get; set; }

    public static AssetImportContext Last { get; private set; } // What the last import said.

    /// <summary>From now on they import.</summary>
    public static void Register(Assembly assembly)
    {
        foreach (var type in assembly.GetTypes())
            if (type.GetCustomAttribute<ScriptedImporterAttribute>() is { } attribute)
                ImporterTable.Add(type, attribute.fileExtensions, attribute.overrideFileExtensions);
        AssetDatabase.Importing = Import;
    }

    /// <summary>There is no project any more.</summary>
    public static void Clear()
    {
        ImporterTable.Clear();
        AssetDatabase.Importing = null;
        Configure = null;
    }

    static void Import(string path)
    {
        var importer = AssetDatabase.GetImporterType(path);
        AssetDatabase.Assets.TryGetValue(path, out var before);
        if (!typeof(ScriptedImporter).IsAssignableFrom(importer))
        {
            AssetDatabase.Assets[path] = new DefaultAsset();
            return;
        }
        Last = Run(importer, path);
        var made = Last.mainObject;
        string difference = SerializedFields.FindDifference(made, Run(importer, path).mainObject);
        if (difference != null)
            throw new InvalidOperationException(importer.Name + " makes another " + difference + " of " + path + " each time");
        // Moving an asset does not import it again, and caches know none of the folders that it lies in elsewhere.
        if (SerializedFields.Of(made.GetType()).FirstOrDefault(f => Names(f.GetValue(made), path)) is { } field)
            throw new InvalidOperationException(importer.Name + " keeps the asset's path in " + field.Name);
        if (before == null || before.GetType() != made.GetType())
            AssetDatabase.Assets[path] = made;
        else
            SerializedFields.Copy(made, before);
    }

    static bool Names(object value, string path) => value is string text ? text == path
        : value is string[] texts && texts.Contains(path);

    static AssetImportContext Run(Type importer, string path)
    {
        var made = (ScriptedImporter)Activator.CreateInstance(importer);
        made.Path = path;
        Configure?.Invoke(made);
        var context = new AssetImportContext(path);
        made.OnImportAsset(context);
        return context;
    }
}
