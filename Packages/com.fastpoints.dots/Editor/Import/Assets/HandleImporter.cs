using UnityEditor.AssetImporters;

namespace FastPoints.Editor
{
    /// <summary>Imports <c>.pointcloud</c> handles. Everything in the asset comes from the handle.</summary>
    [ScriptedImporter(Version, "pointcloud", AllowCaching = true)]
    internal sealed class HandleImporter : CloudImporter
    {
        protected override CloudHandle Describe(AssetImportContext context, string guid) => HandleFile.Read(context.assetPath);
    }
}
