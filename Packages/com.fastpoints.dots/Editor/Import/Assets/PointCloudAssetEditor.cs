using System;
using System.IO;
using FastPoints.Entities;
using FastPoints.Reading;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace FastPoints.Editor
{
    [CustomEditor(typeof(PointCloudAsset))]
    internal sealed class PointCloudAssetEditor : UnityEditor.Editor
    {
        /// <summary>An import worker has no singletons of the main process, or old ones: it reads what was saved last.</summary>
        static ProjectPaths Paths => AssetDatabase.IsAssetImportWorkerProcess()
            ? FastPointsSettings.ReadPaths(Path.GetDirectoryName(Application.dataPath)) : PointCloudImports.ConfiguredPaths;

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

    internal static class ThumbnailImage
    {
        /// <summary>Bytes of an RGBA texture of another size: each pixel is the mean of what it covers.</summary>
        public static byte[] Resized(Texture2D image, int width, int height)
        {
            var pixels = image.GetPixels32();
            var bytes = new byte[width * height * 4];
            for (int y = 0; y < height; y++)
            {
                int low = (int)((long)y * image.height / height);
                int high = Math.Max(low + 1, (int)((y + 1L) * image.height / height));
                for (int x = 0; x < width; x++)
                {
                    int left = (int)((long)x * image.width / width);
                    int right = Math.Max(left + 1, (int)((x + 1L) * image.width / width));
                    int red = 0, green = 0, blue = 0, alpha = 0, count = (right - left) * (high - low);
                    for (int at = low * image.width; at < high * image.width; at += image.width)
                        for (int column = left; column < right; column++)
                        {
                            var pixel = pixels[at + column];
                            red += pixel.r;
                            green += pixel.g;
                            blue += pixel.b;
                            alpha += pixel.a;
                        }
                    int to = (y * width + x) * 4;
                    bytes[to] = (byte)((red + count / 2) / count);
                    bytes[to + 1] = (byte)((green + count / 2) / count);
                    bytes[to + 2] = (byte)((blue + count / 2) / count);
                    bytes[to + 3] = (byte)((alpha + count / 2) / count);
                }
            }
            return bytes;
        }
    }
}
