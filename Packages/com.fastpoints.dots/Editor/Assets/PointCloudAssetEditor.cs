using System.IO;
using FastPoints.Base;
using FastPoints.Entities;
using FastPoints.Picture;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The picture of a cloud's asset in the Project window: what <see cref="CloudThumbnails"/> has drawn.</summary>
    [CustomEditor(typeof(PointCloudAsset))]
    internal sealed class PointCloudAssetEditor : UnityEditor.Editor
    {
        /// <returns>Null, and Unity shows the type's icon, where there is no picture yet.</returns>
        public override Texture2D RenderStaticPreview(string assetPath, Object[] subAssets, int width, int height)
        {
            string path = ((PointCloudAsset)target).ProjectPath;
            if (string.IsNullOrEmpty(path))
                return null;
            string picture = CloudThumbnails.PathOf(PointCloudImports.Paths.Absolute(path));
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
