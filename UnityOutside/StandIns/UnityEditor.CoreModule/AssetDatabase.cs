namespace UnityEditor;

public class AssetImporter : Object
{
    internal string Path;

    public string assetPath => Path;

    public static AssetImporter GetAtPath(string path) =>
        AssetDatabase.Assets.ContainsKey(path) ? new AssetImporter { Path = path } : null;

    public void SaveAndReimport() => AssetDatabase.ImportAsset(Path);
}

public class AssetPostprocessor { }

public class AssetModificationProcessor { }

[Flags]
public enum AssetDeleteResult { DidNotDelete = 0 }

/// <summary>A file that no importer knows.</summary>
public class DefaultAsset : Object { }

/// <summary>Assets by path: as a test puts them there, or as importers make them of the files of a project.</summary>
public sealed class AssetDatabase
{
    internal static readonly Dictionary<string, Object> Assets = new Dictionary<string, Object>();
    internal static readonly Dictionary<string, Type> Overrides = new Dictionary<string, Type>();
    internal static readonly Dictionary<string, string[]> Dependencies = new Dictionary<string, string[]>();
    static readonly Dictionary<string, ulong> s_imported = new Dictionary<string, ulong>();
    static Type[] s_postprocessors;
    static Type[] s_modifications;
    static string s_importing;
    static readonly Dictionary<string, ImportAssetOptions> s_waiting = new Dictionary<string, ImportAssetOptions>();
    static int s_editing;
    static bool s_refreshes;
    internal static int s_loads, s_searches, s_batches;
    internal static Action<string> Importing;

    /// <summary>An asset's path is what is hashed: it keeps its number as long as it is not moved.</summary>
    /// <returns>Empty if there is none.</returns>
    public static string AssetPathToGUID(string path) => Assets.ContainsKey(path) || path == s_importing ? GuidOf(path) : "";

    public static string GUIDToAssetPath(string guid) => Assets.Keys.FirstOrDefault(p => GuidOf(p) == guid) ?? "";

    public static string[] GetAllAssetPaths() => Assets.Keys.ToArray();

    public static string GetAssetPath(Object assetObject) =>
        Assets.FirstOrDefault(a => ReferenceEquals(a.Value, assetObject)).Key ?? "";

    public static T LoadAssetAtPath<T>(string assetPath) where T : Object
    {
        s_loads++;
        return Assets.TryGetValue(assetPath, out var asset) ? asset as T : null;
    }

    public static Type GetMainAssetTypeAtPath(string assetPath) =>
        Assets.TryGetValue(assetPath, out var asset) ? asset.GetType() : null;

    /// <summary>Until as many ends nothing is imported: who then loads finds what was there before.</summary>
    public static void StartAssetEditing() => s_editing++;

    public static void StopAssetEditing()
    {
        if (s_editing == 0)
            throw new InvalidOperationException("StopAssetEditing without a StartAssetEditing");
        if (--s_editing > 0)
            return;
        var waiting = s_waiting.Where(w => CanImport(w.Key, w.Value)).Select(w => w.Key).ToArray();
        bool refreshes = s_refreshes;
        s_waiting.Clear();
        s_refreshes = false;
        foreach (string path in waiting)
            Import(path);
        if (waiting.Length > 0)
            Postprocess(waiting, new string[0]);
        if (refreshes)
            Refresh();
    }

    public static void ImportAsset(string path) => ImportAsset(path, ImportAssetOptions.Default);

    /// <summary>Nothing happens where nothing has changed, unless it is forced.</summary>
    public static void ImportAsset(string path, ImportAssetOptions options)
    {
        if (s_editing > 0)
        {
            s_waiting.TryGetValue(path, out var before);
            s_waiting[path] = before | options;
        }
        else if (CanImport(path, options))
        {
            Import(path);
            Postprocess(new[] { path }, new string[0]);
        }
    }

    static bool CanImport(string path, ImportAssetOptions options) =>
        File.Exists(Absolute(path)) && ((options & ImportAssetOptions.ForceUpdate) != 0 || HasChanged(path));

    /// <summary>Looks at all files in <c>Assets</c>, but for those that Unity hides.</summary>
    public static void Refresh()
    {
        if (s_importing != null)
            throw new InvalidOperationException("AssetDatabase.Refresh is not allowed while an asset is imported");
        s_refreshes = s_editing > 0;
        if (s_refreshes)
            return;
        var found = Directory.GetFiles(Application.dataPath, "*", SearchOption.AllDirectories)
            .Select(f => "Assets/" + Path.GetRelativePath(Application.dataPath, f).Replace('\\', '/'))
            .Where(f => !f.Split('/').Any(IsHidden)).OrderBy(f => f, StringComparer.Ordinal).ToArray();
        var deleted = s_imported.Keys.Except(found).ToArray();
        foreach (string path in deleted)
            Forget(path);
        var changed = found.Where(HasChanged).ToArray();
        foreach (string path in changed)
            Import(path);
        if (changed.Length + deleted.Length > 0)
            Postprocess(changed, deleted);
    }

    /// <summary>Of a filter by type, as <c>t:Name</c>, or an empty one, and of no other.</summary>
    public static string[] FindAssets(string filter)
    {
        s_searches++;
        return Find(filter);
    }

    static string[] Find(string filter) =>
        Assets.Where(a => filter == "" || "t:" + KindOf(a.Value) == filter).Select(a => GuidOf(a.Key)).ToArray();

    static string KindOf(Object asset) => asset is GameObject ? "Prefab" : asset.GetType().Name;

    public static string[] FindAssets(string filter, string[] searchInFolders) => Find(filter)
        .Where(guid => searchInFolders.Any(f => GUIDToAssetPath(guid).StartsWith(f + "/", StringComparison.Ordinal))).ToArray();

    public static void CreateAsset(Object asset, string path) => throw EditorOnly.NotHere(nameof(CreateAsset));
    public static void SaveAssets() => throw EditorOnly.NotHere(nameof(SaveAssets));

    /// <returns>Its number.</returns>
    public static string CreateFolder(string parentFolder, string newFolderName)
    {
        string path = parentFolder + "/" + newFolderName;
        System.IO.Directory.CreateDirectory(path);
        return GuidOf(path);
    }

    /// <summary>A file or a folder, with what is imported of it.</summary>
    public static bool DeleteAsset(string path)
    {
        bool isFolder = System.IO.Directory.Exists(path);
        if (!isFolder && !System.IO.File.Exists(path))
            return false;
        WillDelete(path);
        if (isFolder)
            System.IO.Directory.Delete(path, true);
        else
            System.IO.File.Delete(path);
        var gone = Assets.Keys.Where(a => a == path || a.StartsWith(path + "/", StringComparison.Ordinal)).ToArray();
        foreach (string asset in gone)
            Forget(asset);
        if (gone.Length > 0)
            Postprocess(new string[0], gone);
        return true;
    }

    /// <summary>Of a folder it is told alone, not of what is in it. A method of other parameters is not called.</summary>
    static void WillDelete(string path)
    {
        s_modifications ??= Derived(typeof(AssetModificationProcessor));
        foreach (var type in s_modifications)
            if (type.GetMethod("OnWillDeleteAsset", Any) is { } method)
                method.Invoke(null, new object[] { path, RemoveAssetOptions.MoveAssetToTrash });
    }

    const BindingFlags Any = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;

    static Type[] Derived(Type from) => TypeCache.Referring(from.Assembly).SelectMany(a => a.GetTypes())
        .Where(t => t.IsSubclassOf(from)).ToArray();

    public static bool IsValidFolder(string path) => Directory.Exists(path);

    public static string[] GetDependencies(string[] pathNames, bool recursive) =>
        pathNames.SelectMany(p => Dependencies.TryGetValue(p, out var of) ? of : new string[0]).Concat(pathNames).Distinct()
            .ToArray();

    public static Type GetImporterOverride(string path) => Overrides.TryGetValue(path, out var type) ? type : null;
    public static Type GetDefaultImporter(string path) => ImporterTable.Default(path) ?? typeof(AssetImporter);
    public static Type GetImporterType(string assetPath) => GetImporterOverride(assetPath) ?? GetDefaultImporter(assetPath);

    /// <summary>Imports the asset with it at once.</summary>
    public static void SetImporterOverride<T>(string path) where T : AssetImporter
    {
        if (!Assets.ContainsKey(path))
        {
            Debug.LogError("Cannot set Importer override at \"" + path + "\". No Asset found at that path.");
        }
        else if (!ImporterTable.CanBeOverride(path, typeof(T)))
        {
            Debug.LogError("Cannot set Importer override at " + path + " because " + typeof(T).Name +
                " is not a valid Importer for this asset.");
        }
        else
        {
            CheckWritable(Absolute(path) + ".meta");
            Overrides[path] = typeof(T);
            ImportAsset(path);
        }
    }

    /// <summary>Version control, as a test has it: whether a file may be checked out. Null for none, which refuses
    /// nothing.</summary>
    internal static Func<string, bool> s_checksOut;

    /// <summary>Has whoever locks files unlock one; says the same of files outside of the project, as of those that nobody
    /// locks.</summary>
    public static bool MakeEditable(string path)
    {
        if (path == null)
            throw new ArgumentNullException(nameof(path));
        if (Path.IsPathRooted(path) || path.StartsWith("../", StringComparison.Ordinal) || s_checksOut == null)
            return true;
        if (!s_checksOut(path))
            return false;
        File.SetAttributes(Absolute(path), File.GetAttributes(Absolute(path)) & ~FileAttributes.ReadOnly);
        return true;
    }

    /// <summary>A locked file is read-only. Who writes one all the same, as the system's owner may here, is refused.</summary>
    internal static void CheckWritable(string path)
    {
        if (File.Exists(path) && (File.GetAttributes(path) & FileAttributes.ReadOnly) != 0)
            throw new UnauthorizedAccessException("Access to the path '" + path + "' is denied.");
    }

    /// <summary>Importers and previews are made in processes of their own, several at once: while one runs here, this is such
    /// a one.</summary>
    public static bool IsAssetImportWorkerProcess() => s_importing != null || s_previewing;

    internal static bool s_previewing;

    internal static void Clear()
    {
        if (s_editing != 0)
            throw new InvalidOperationException("a batch of imports was begun and never ended: Unity would import nothing more");
        (s_loads, s_searches, s_batches) = (0, 0, 0);
        Assets.Clear();
        Overrides.Clear();
        Dependencies.Clear();
        s_checksOut = null;
        s_imported.Clear();
    }

    static void Import(string path)
    {
        s_importing = path;
        try
        {
            Importing(path);
        }
        finally
        {
            s_importing = null;
        }
        s_imported[path] = StampOf(path);
    }

    static void Forget(string path)
    {
        Assets.Remove(path);
        Overrides.Remove(path);
        s_imported.Remove(path);
    }

    static bool HasChanged(string path) =>
        !Assets.ContainsKey(path) || !s_imported.TryGetValue(path, out ulong known) || known != StampOf(path);

    static void Postprocess(string[] imported, string[] deleted)
    {
        s_batches++;
        s_postprocessors ??= Derived(typeof(AssetPostprocessor));
        foreach (var type in s_postprocessors)
            type.GetMethod("OnPostprocessAllAssets", Any)?.Invoke(null,
                new object[] { imported, deleted, new string[0], new string[0] });
    }

    /// <summary>Names that Unity takes no notice of, of files and of folders.</summary>
    static bool IsHidden(string name) => name[0] == '.' || name[name.Length - 1] == '~' || name == "cvs" ||
        name.EndsWith(".tmp", StringComparison.OrdinalIgnoreCase) || name.EndsWith(".meta", StringComparison.Ordinal);

    static string Absolute(string path) => Path.Combine(Path.GetDirectoryName(Application.dataPath), path);

    static ulong StampOf(string path) =>
        Hash(GetImporterType(path).FullName, Hash(File.ReadAllBytes(Absolute(path)), 14695981039346656037));

    static string GuidOf(string path)
    {
        ulong hash = Hash(path, 14695981039346656037);
        return hash.ToString("x16") + (~hash).ToString("x16");
    }

    static ulong Hash(string text, ulong hash) => Hash(Encoding.UTF8.GetBytes(text), hash);

    static ulong Hash(byte[] bytes, ulong hash)
    {
        foreach (byte b in bytes)
            hash = (hash ^ b) * 1099511628211;
        return hash;
    }
}
