using FastPoints.Entities;
using UnityEditor;

namespace FastPoints.Editor
{
    static class PointCloudMenu
    {
        [MenuItem("Assets/Import point cloud...", false, 20)]
        static void ImportFile() => Import(EditorUtility.OpenFilePanelWithFilters("Import point cloud", "",
            new[] { "Point clouds", "las,laz,ply,e57,pcd,ptx,txt,xyz,csv,pts", "All files", "*" }));

        [MenuItem("Assets/Import point cloud folder...", false, 20)]
        static void ImportFolder() =>
            Import(EditorUtility.OpenFolderPanel("Import Potree, EPT, converted cloud, or a folder of tiles", "", ""));

        [MenuItem("Assets/Import copy of converted point cloud...", false, 20)]
        static void ImportCopy()
        {
            string cloud = EditorUtility.OpenFolderPanel("Import a copy of a converted cloud", "", "");
            if (!string.IsNullOrEmpty(cloud))
                PointCloudImports.Current.ImportCopy(cloud, "Assets");
        }

        [MenuItem("Assets/Export point cloud...", false, 20)]
        static void Export()
        {
            string folder = EditorUtility.OpenFolderPanel("Export point cloud into a folder", "", "");
            if (!string.IsNullOrEmpty(folder))
                PointCloudImports.Current.ExportCopy((PointCloudAsset)Selection.activeObject, folder);
        }

        [MenuItem("Assets/Export point cloud...", true, 20)]
        static bool CanExport() => Selection.activeObject is PointCloudAsset;

        static void Import(string source)
        {
            if (!string.IsNullOrEmpty(source))
                Selection.activeObject = PointCloudImports.Current.CreateAsset(source, "Assets");
        }
    }
}
