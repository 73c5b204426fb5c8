using System;

namespace UnityEditor.AssetImporters
{
    [AttributeUsage(AttributeTargets.Class, Inherited = false)]
    public class ScriptedImporterAttribute : Attribute
    {
        public ScriptedImporterAttribute(int version, string ext)
            : this(version, new[] { ext }, null)
        {
        }

        public ScriptedImporterAttribute(int version, string[] exts, string[] overrideExts)
        {
            this.version = version;
            fileExtensions = exts;
            overrideFileExtensions = overrideExts;
        }

        public bool AllowCaching;

        public int version { get; }

        public string[] fileExtensions { get; }

        public string[] overrideFileExtensions { get; }
    }

    public abstract class ScriptedImporter : AssetImporter
    {
        public abstract void OnImportAsset(AssetImportContext ctx);
    }

    public abstract class AssetImporterEditor : Editor
    {
        public virtual bool showImportedObject => true;

        protected virtual bool needsApplyRevert => true;

        public virtual void OnEnable()
        {
        }

        public override void OnInspectorGUI()
        {
        }

        protected void ApplyRevertGUI()
        {
        }
    }

    public class ScriptedImporterEditor : AssetImporterEditor
    {
    }
}
