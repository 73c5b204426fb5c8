namespace FastPoints.HostTests.Cli.Pictures;

public class PngTests
{
    static RgbaImage Noise(int width, int height, bool opaque, uint seed)
    {
        var random = new Unity.Mathematics.Random(seed);
        var image = new RgbaImage(width, height);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
                image[x, y] = (x + y) % 3 == 0
                    ? random.NextUInt() | (opaque ? 0xFF000000u : 0)
                    : Palettes.Pack((byte)x, (byte)y, (byte)(x + y), (byte)(opaque ? 255 : x));
        return image;
    }

    [TestCase(1, 1, true), TestCase(7, 5, true), TestCase(7, 5, false), TestCase(300, 200, true)]
    [TestCase(300, 200, false)]
    public void Decode_OfEncoded_GivesThePictureBack(int width, int height, bool opaque)
    {
        var image = Noise(width, height, opaque, 5);
        var back = Png.Decode(Png.Encode(image), "memory");
        Assert.That(back.Width, Is.EqualTo(width));
        Assert.That(back.Height, Is.EqualTo(height));
        Assert.That(back.Rgba, Is.EqualTo(image.Rgba));
    }

    [Test]
    public void Encode_Picture_HasTheChunksOfAnSrgbPng()
    {
        byte[] file = Png.Encode(Noise(4, 3, true, 1));
        Assert.That(file[0], Is.EqualTo(0x89));
        // IHDR: 13 bytes, 4 by 3, 8 bits, RGB; its checksum; then sRGB, perceptual.
        Assert.That(BitConverter.ToString(file, 8, 25).Substring(0, 24), Is.EqualTo("00-00-00-0D-49-48-44-52-"));
        Assert.That(BitConverter.ToString(file, 16, 13), Is.EqualTo("00-00-00-04-00-00-00-03-08-02-00-00-00"));
        Assert.That(BitConverter.ToString(file, 33, 13), Is.EqualTo("00-00-00-01-73-52-47-42-00-AE-CE-1C-E9"));
        Assert.That(BitConverter.ToString(file, file.Length - 12), Is.EqualTo("00-00-00-00-49-45-4E-44-AE-42-60-82"));
    }

    /// <summary>A 2 by 1 grey picture made elsewhere byte by byte: stored deflate block of filter byte, 0x40, 0xC0.</summary>
    static byte[] Gray(byte colorType = 0, byte bits = 8, byte interlace = 0)
    {
        byte[] header = { 0, 0, 0, 2, 0, 0, 0, 1, bits, colorType, 0, 0, interlace };
        byte[] data = { 0x78, 0x01, 0x01, 0x03, 0x00, 0xFC, 0xFF, 0x00, 0x40, 0xC0, 0x01, 0x43, 0x01, 0x01 };
        using var file = new MemoryStream();
        file.Write(new byte[] { 0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A }, 0, 8);
        Chunk(file, "IHDR", header);
        Chunk(file, "IDAT", data);
        Chunk(file, "IEND", new byte[0]);
        return file.ToArray();
    }

    static void Chunk(Stream file, string name, byte[] content)
    {
        var bytes = new byte[content.Length + 4];
        for (int i = 0; i < 4; i++)
            bytes[i] = (byte)name[i];
        Array.Copy(content, 0, bytes, 4, content.Length);
        uint crc = uint.MaxValue;
        foreach (byte value in bytes)
        {
            crc ^= value;
            for (int bit = 0; bit < 8; bit++)
                crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
        }
        Big(file, (uint)content.Length);
        file.Write(bytes, 0, bytes.Length);
        Big(file, ~crc);
    }

    static void Big(Stream file, uint value)
    {
        for (int shift = 24; shift >= 0; shift -= 8)
            file.WriteByte((byte)(value >> shift));
    }

    [Test]
    public void Decode_GrayPicture_IsReadAsGray()
    {
        var image = Png.Decode(Gray(), "memory");
        Assert.That(image[0, 0], Is.EqualTo(0xFF404040u));
        Assert.That(image[1, 0], Is.EqualTo(0xFFC0C0C0u));
    }

    [TestCase(3, 8, 0, "colour type"), TestCase(0, 16, 0, "bits of a channel"), TestCase(0, 8, 1, "interlacing")]
    public void Decode_UnsupportedPng_IsRefusedWithTheReason(int colorType, int bits, int interlace, string reason) =>
        Assert.That(() => Png.Decode(Gray((byte)colorType, (byte)bits, (byte)interlace), "p.png"),
            Throws.TypeOf<PointCloudException>().With.Property("Code").EqualTo(FailureCode.Unsupported)
                .And.Message.Contains(reason).And.Message.StartsWith("p.png: at byte "));

    [Test]
    public void Decode_AnyByteChangedOrCut_NeverCrashes()
    {
        byte[] good = Png.Encode(Noise(20, 10, true, 2));
        var random = new Unity.Mathematics.Random(99);
        for (int round = 0; round < 500; round++)
        {
            byte[] bad = (byte[])good.Clone();
            if (round % 2 == 0)
                bad[random.NextInt(bad.Length)] ^= (byte)random.NextInt(1, 256);
            else
                Array.Resize(ref bad, random.NextInt(bad.Length));
            Assert.That(() => Png.Decode(bad, "memory"), Throws.TypeOf<PointCloudException>());
        }
    }

    [Test]
    public void Read_AFile_IsThePictureAndNoneIsAFailure()
    {
        using var folder = new ScratchFolder();
        var image = Noise(5, 4, false, 2);
        File.WriteAllBytes(folder["p.png"], Png.Encode(image));
        Assert.That(Png.Read(folder["p.png"]).Rgba, Is.EqualTo(image.Rgba));
        Assert.That(() => Png.Read(folder["none.png"]),
            Throws.TypeOf<PointCloudException>().With.Property("Code").EqualTo(FailureCode.NotFound));
    }
}
