using UnityEditor.AssetImporters;

namespace FastPoints.Editor
{
    /// <summary>Imports <c>.pointcloud</c> handles. All that is in the asset is in the handle.</summary>
    [ScriptedImporter(Version, "pointcloud", AllowCaching = true)]
    internal sealed class HandleImporter : CloudImporter
    {
        protected override CloudHandle Describe(AssetImportContext context, string guid) => HandleFile.Read(context.assetPath);
    }
}
