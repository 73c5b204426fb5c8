using System.IO;
using FastPoints.Core;
using FastPoints.Entities;
using FastPoints.Picture;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Shows the picture of a cloud's asset in the Project window, as <see cref="CloudThumbnails"/> has drawn
    /// it.</summary>
    [CustomEditor(typeof(PointCloudAsset))]
    internal sealed class PointCloudAssetEditor : UnityEditor.Editor
    {
        /// <summary>An import worker has no singletons of the main process, or old ones: it reads what was saved last.</summary>
        static ProjectPaths Paths => AssetDatabase.IsAssetImportWorkerProcess()
            ? FastPointsSettings.ReadPaths(Path.GetDirectoryName(Application.dataPath)) : PointCloudImports.Paths;

        /// <returns>Null if there is no picture yet: Unity then shows the type's icon.</returns>
        public override Texture2D RenderStaticPreview(string assetPath, Object[] subAssets, int width, int height)
        {
            string path = ((PointCloudAsset)target).ProjectPath;
            if (string.IsNullOrEmpty(path))
                return null;
            string picture = CloudThumbnails.PathOf(Paths.Absolute(path));
            if (!File.Exists(picture))
                return null;
            try
            {
                var texture = new Texture2D(width, height, TextureFormat.RGBA32, false);
                texture.SetPixelData(ThumbnailImage.Resized(Png.Read(picture), width, height), 0);
                texture.Apply();
                return texture;
            }
            catch (PointCloudException)
            {
                return null;
            }
        }
    }
}
