namespace UnityEditor.AssetImporters;

/// <summary>What an importer said, for tests to look at.</summary>
public class AssetImportContext
{
    internal readonly List<string> Errors = new List<string>();
    internal readonly List<string> Warnings = new List<string>();
    readonly Dictionary<string, Object> m_objects = new Dictionary<string, Object>();

    internal AssetImportContext(string assetPath) => this.assetPath = assetPath;

    public string assetPath { get; }
    public Object mainObject { get; private set; }

    /// <summary>An identifier is one object's; names are the importer's.</summary>
    public void AddObjectToAsset(string identifier, Object obj) => m_objects.Add(identifier, obj);

    public void SetMainObject(Object obj) => mainObject = m_objects.ContainsValue(obj) ? obj
        : throw new System.InvalidOperationException("the main object was not added to the asset");

    public void LogImportError(string msg, Object obj = null) => Errors.Add(msg);
    public void LogImportWarning(string msg, Object obj = null) => Warnings.Add(msg);
}
