namespace FastPoints.Cli.Output;

/// <summary>An animation in the PNG format (APNG 1.0), without loss: viewers that know no animations show the first
/// picture.</summary>
sealed class AnimatedPng(string path, int widthPx, int heightPx, int pictures, int delayMs)
    : Animation(path, widthPx, heightPx, pictures)
{
    readonly ushort m_delayMs = checked((ushort)delayMs);
    uint m_sequence;

    protected override void Write(RgbaImage image, int number)
    {
        if (number == 0)
        {
            PngCodec.WriteHeader(Stream, WidthPx, HeightPx, true);
            // Frames, and how often to play them: 0 is for ever.
            var all = new byte[8];
            PngCodec.WriteBigEndian(all, 0, (uint)Pictures);
            PngCodec.WriteChunk(Stream, "acTL", all);
        }
        var control = new byte[26];
        PngCodec.WriteBigEndian(control, 0, m_sequence++);
        PngCodec.WriteBigEndian(control, 4, (uint)WidthPx);
        PngCodec.WriteBigEndian(control, 8, (uint)HeightPx);
        control[20] = (byte)(m_delayMs >> 8);
        control[21] = (byte)m_delayMs;
        control[22] = 1000 >> 8;
        control[23] = 1000 & 255;
        PngCodec.WriteChunk(Stream, "fcTL", control);
        byte[] pixels = PngCodec.Compress(image.Rgba, image.Width, image.Height, true);
        if (number == 0)
        {
            PngCodec.WriteChunk(Stream, "IDAT", pixels);
            return;
        }
        var data = new byte[pixels.Length + 4];
        PngCodec.WriteBigEndian(data, 0, m_sequence++);
        Array.Copy(pixels, 0, data, 4, pixels.Length);
        PngCodec.WriteChunk(Stream, "fdAT", data);
    }

    protected override void End() => PngCodec.WriteChunk(Stream, "IEND", []);
}
