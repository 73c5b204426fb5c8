using System;
using FastPoints.Picture;

namespace FastPoints.Editor
{
    /// <summary>Resizes a picture to the layout of a texture.</summary>
    internal static class ThumbnailImage
    {
        /// <summary>Bytes of an RGBA texture from the bottom row up: each pixel is the mean of what it covers.</summary>
        public static byte[] Resized(RgbaImage image, int width, int height)
        {
            var bytes = new byte[width * height * 4];
            for (int y = 0; y < height; y++)
            {
                int top = (int)((long)y * image.Height / height);
                int bottom = Math.Max(top + 1, (int)((y + 1L) * image.Height / height));
                for (int x = 0; x < width; x++)
                {
                    int left = (int)((long)x * image.Width / width);
                    int right = Math.Max(left + 1, (int)((x + 1L) * image.Width / width));
                    Average(image, left, right, top, bottom, bytes, ((height - 1 - y) * width + x) * 4);
                }
            }
            return bytes;
        }

        static void Average(RgbaImage image, int left, int right, int top, int bottom, byte[] to, int at)
        {
            int count = (right - left) * (bottom - top);
            for (int channel = 0; channel < 4; channel++)
            {
                int sum = 0;
                for (int y = top; y < bottom; y++)
                    for (int x = left; x < right; x++)
                        sum += image.Rgba[(y * image.Width + x) * 4 + channel];
                to[at + channel] = (byte)((sum + count / 2) / count);
            }
        }
    }
}
