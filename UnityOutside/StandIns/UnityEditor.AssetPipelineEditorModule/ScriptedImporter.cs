using UnityEngine;

namespace UnityEditor.AssetImporters;

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public class ScriptedImporterAttribute : Attribute
{
    public ScriptedImporterAttribute(int version, string ext) : this(version, new[] { ext }, null) { }

    public ScriptedImporterAttribute(int version, string[] exts, string[] overrideExts) =>
        (fileExtensions, overrideFileExtensions) = (exts, overrideExts);

    public bool AllowCaching;

    public string[] fileExtensions { get; }
    public string[] overrideFileExtensions { get; }
}

public abstract class ScriptedImporter : AssetImporter
{
    public abstract void OnImportAsset(AssetImportContext ctx);
}

/// <summary>Says what an inspector has left out, as Unity does.</summary>
public abstract class AssetImporterEditor : Editor
{
    bool m_isEnabled;
    bool m_hasDrawn;
    bool m_hasApplied;

    public virtual bool showImportedObject => true;
    protected virtual bool needsApplyRevert => true;

    public virtual void OnEnable() => m_isEnabled = true;

    public virtual void OnDisable()
    {
        if (!m_isEnabled)
            Debug.LogError(GetType().Name + ".OnEnable must call base.OnEnable to avoid unexpected behaviour.");
        else if (needsApplyRevert && m_hasDrawn && !m_hasApplied)
            Debug.LogError(GetType().Name + ".OnInspectorGUI must call ApplyRevertGUI to avoid unexpected behaviour.");
    }

    public override void OnInspectorGUI() => ApplyRevertGUI();

    internal void DrawInspector()
    {
        m_hasDrawn = true;
        Draw();
    }

    protected void ApplyRevertGUI() => m_hasApplied = true;
}

public class ScriptedImporterEditor : AssetImporterEditor { }
