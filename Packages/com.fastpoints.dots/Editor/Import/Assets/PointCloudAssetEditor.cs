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

    /// <summary>Resizes a picture to the layout of a texture.</summary>
    internal static class ThumbnailImage
    {
        /// <summary>Bytes of an RGBA texture from the bottom row up: each pixel is the mean of what it covers.</summary>
        public static byte[] Resized(RgbaImage image, int width, int height)
        {
            var bytes = new byte[width * height * 4];
            for (int y = 0; y < height; y++)
                for (int x = 0; x < width; x++)
                {
                    var rows = Covered(y, height, image.Height);
                    var columns = Covered(x, width, image.Width);
                    for (int channel = 0; channel < 4; channel++)
                        bytes[((height - 1 - y) * width + x) * 4 + channel] = Mean(image, columns, rows, channel);
                }
            return bytes;
        }

        static (int From, int To) Covered(int at, int count, int size)
        {
            int from = (int)((long)at * size / count);
            return (from, System.Math.Max(from + 1, (int)((at + 1L) * size / count)));
        }

        static byte Mean(RgbaImage image, (int From, int To) columns, (int From, int To) rows, int channel)
        {
            int count = (columns.To - columns.From) * (rows.To - rows.From), sum = 0;
            for (int y = rows.From; y < rows.To; y++)
                for (int x = columns.From; x < columns.To; x++)
                    sum += image.Rgba[(y * image.Width + x) * 4 + channel];
            return (byte)((sum + count / 2) / count);
        }
    }
}
