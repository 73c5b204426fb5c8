using System;
using System.IO;
using FastPoints.Entities;
using FastPoints.Reading;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

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
            var stored = new Texture2D(1, 1, TextureFormat.RGBA32, false);
            try
            {
                if (!stored.LoadImage(File.ReadAllBytes(picture)))
                    return null;
                var texture = new Texture2D(width, height, TextureFormat.RGBA32, false);
                texture.SetPixelData(ThumbnailImage.Resized(stored, width, height), 0);
                texture.Apply();
                return texture;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                return null;
            }
            finally
            {
                DestroyImmediate(stored);
            }
        }
    }
}
