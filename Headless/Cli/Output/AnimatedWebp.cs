namespace FastPoints.Cli.Output;

sealed unsafe class AnimatedWebp(string path, int widthPx, int heightPx, int pictures, int delayMs)
    : Animation(path, widthPx, heightPx, pictures)
{
    public const int MaxEdgePx = 16_383;

    const float Quality = 80;
    const int HeadBytes = 12;

    static readonly string[] s_names = OperatingSystem.IsWindows() ? ["libwebp.dll", "libwebp-7.dll"]
        : OperatingSystem.IsMacOS() ? ["libwebp.7.dylib", "/opt/homebrew/lib/libwebp.7.dylib"] : ["libwebp.so.7"];

    static readonly delegate* unmanaged<byte*, int, int, int, float, byte**, nuint> s_encode;
    static readonly delegate* unmanaged<byte*, void> s_free;

    static AnimatedWebp()
    {
        foreach (string name in s_names)
            if (s_encode == null && NativeLibrary.TryLoad(name, out var library))
            {
                s_free = (delegate* unmanaged<byte*, void>)NativeLibrary.GetExport(library, "WebPFree");
                s_encode = (delegate* unmanaged<byte*, int, int, int, float, byte**, nuint>)NativeLibrary.GetExport(library,
                    "WebPEncodeRGBA");
            }
    }

    public static bool CanWrite => s_encode != null;

    protected override void Write(RgbaImage image, int number)
    {
        if (number == 0)
        {
            // The file's length comes last.
            Stream.Write([.. "RIFF"u8, 0, 0, 0, 0, .. "WEBPVP8X"u8, 10, 0, 0, 0, 1 << 1, 0, 0, 0,
                .. LittleEndian(WidthPx - 1, 3), .. LittleEndian(HeightPx - 1, 3)]);
            // A background and how often to play: 0 is for ever. Then a chunk of ours, by which the file is known again.
            Stream.Write([.. "ANIM"u8, 6, 0, 0, 0, 0, 0, 0, 255, 0, 0, .. "MADE"u8, 10, 0, 0, 0, .. "FastPoints"u8]);
        }
        byte[] encoded = Encode(image);
        Stream.Write([.. "ANMF"u8, .. LittleEndian(16 + encoded.Length, 4), 0, 0, 0, 0, 0, 0, .. LittleEndian(WidthPx - 1, 3),
            .. LittleEndian(HeightPx - 1, 3), .. LittleEndian(delayMs, 3), 1 << 1]);
        Stream.Write(encoded);
    }

    protected override void End()
    {
        if (Stream.Length > uint.MaxValue)
            throw new IOException("a WebP file holds 4 GB at most");
        Stream.Position = 4;
        Stream.Write(LittleEndian(Stream.Length - 8, 4));
    }

    static byte[] Encode(RgbaImage image)
    {
        byte[] rgba = (byte[])image.Rgba.Clone();
        for (int i = 3; i < rgba.Length; i += 4)
            rgba[i] = byte.MaxValue;
        byte* file = null;
        fixed (byte* pixels = rgba)
        {
            nuint bytes = s_encode(pixels, image.Width, image.Height, 4 * image.Width, Quality, &file);
            if (bytes <= HeadBytes)
                throw new IOException("libwebp cannot pack a picture");
            byte[] encoded = new ReadOnlySpan<byte>(file + HeadBytes, (int)bytes - HeadBytes).ToArray();
            s_free(file);
            return encoded;
        }
    }

    static byte[] LittleEndian(long value, int bytes) => BitConverter.GetBytes(value)[..bytes];
}
