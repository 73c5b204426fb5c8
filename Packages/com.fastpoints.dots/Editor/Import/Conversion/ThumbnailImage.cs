using System;
using UnityEngine;

namespace FastPoints.Editor
{
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
