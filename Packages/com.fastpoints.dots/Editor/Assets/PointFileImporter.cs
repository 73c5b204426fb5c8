using FastPoints.Files;
using UnityEditor.AssetImporters;

namespace FastPoints.Editor
{
    /// <summary>Imports LAS, LAZ and PLY files that lie in <c>Assets</c>, by their headers. Never chosen by Unity: two importers
    /// that claim one extension lock each other out, and others claim these (<see cref="PointFilePostprocessor"/> chooses
    /// it).</summary>
    [ScriptedImporter(Version, null, new[] { "las", "laz", "ply" }, AllowCaching = true)]
    public sealed class PointFileImporter : CloudImporter
    {
        protected override CloudHandle Describe(AssetImportContext context, string guid)
        {
            using (var reader = PointReaders.Open(context.assetPath))
            {
                var handle = new CloudHandle { CloudPath = ProjectPaths.OfAsset(guid) };
                handle.Sources.Add(context.assetPath);
                handle.IsOctree = reader.Tree != null;
                handle.Describe(reader.Info);
                foreach (var warning in reader.Info.Warnings)
                    context.LogImportWarning(warning.ToString());
                return handle;
            }
        }
    }
}
