using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary><em>Assets > Import point cloud...</em></summary>
    static class PointCloudMenu
    {
        [MenuItem("Assets/Import point cloud...", false, 20)]
        static void ImportFile() => Take(EditorUtility.OpenFilePanelWithFilters("Import point cloud", "",
            new[] { "Point clouds", "las,laz,ply,e57,txt,xyz,csv,pts", "All files", "*" }));

        [MenuItem("Assets/Import point cloud folder...", false, 20)]
        static void ImportFolder() =>
            Take(EditorUtility.OpenFolderPanel("Import Potree, EPT, converted cloud, or a folder of tiles", "", ""));

        static void Take(string source)
        {
            if (!string.IsNullOrEmpty(source))
                Selection.activeObject = PointCloudImports.Current.Take(source, "Assets");
        }
    }
}
