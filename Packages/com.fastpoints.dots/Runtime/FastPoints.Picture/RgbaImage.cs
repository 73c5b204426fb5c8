using System;
using FastPoints.Drawing;

namespace FastPoints.Picture
{
    /// <summary>A finished picture: sRGB, 8 bits a channel, straight alpha, row by row from the top.</summary>
    public sealed class RgbaImage
    {
        public int Width { get; }
        public int Height { get; }

        /// <summary>Four bytes a pixel: red, green, blue, alpha.</summary>
        public byte[] Rgba { get; }

        public RgbaImage(int width, int height)
        {
            if (width < 1 || height < 1 || (long)width * height * 4 > int.MaxValue)
                throw new ArgumentOutOfRangeException(nameof(width), width + "x" + height, "wanted at least 1x1, at most 2 GiB");
            Width = width;
            Height = height;
            Rgba = new byte[width * height * 4];
        }

        /// <summary>A pixel in the format of <see cref="Palettes.Pack"/>.</summary>
        public uint this[int x, int y]
        {
            get
            {
                int at = (y * Width + x) * 4;
                return Palettes.Pack(Rgba[at], Rgba[at + 1], Rgba[at + 2], Rgba[at + 3]);
            }
            set
            {
                int at = (y * Width + x) * 4;
                Rgba[at] = (byte)value;
                Rgba[at + 1] = (byte)(value >> 8);
                Rgba[at + 2] = (byte)(value >> 16);
                Rgba[at + 3] = (byte)(value >> 24);
            }
        }

        /// <summary>The rows from the bottom up, as textures have them.</summary>
        public byte[] RgbaFromBottom()
        {
            var rows = new byte[Rgba.Length];
            for (int y = 0; y < Height; y++)
                Buffer.BlockCopy(Rgba, y * Width * 4, rows, (Height - 1 - y) * Width * 4, Width * 4);
            return rows;
        }
    }
}
