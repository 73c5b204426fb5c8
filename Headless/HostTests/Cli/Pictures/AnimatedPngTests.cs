namespace FastPoints.HostTests.Cli.Pictures;

public class AnimatedPngTests
{
    string m_path;

    [SetUp]
    public void ChoosePath() => m_path = Path.Combine(Path.GetTempPath(), "fastpoints-" + Guid.NewGuid().ToString("N") + ".png");

    [TearDown]
    public void Delete() => File.Delete(m_path);

    string[] Beside() => Directory.GetFiles(Path.GetTempPath(), Path.GetFileName(m_path) + "*");

    static RgbaImage Image(uint color)
    {
        var image = new RgbaImage(5, 3);
        for (int y = 0; y < 3; y++)
            for (int x = 0; x < 5; x++)
                image[x, y] = color + (uint)(x + 16 * y);
        return image;
    }

    [Test]
    public void Add_ThreePictures_WritesFramesInOrderAndTheFirstAsPng()
    {
        using (var animation = new AnimatedPng(m_path, 5, 3, 3, 250))
        {
            for (uint i = 0; i < 3; i++)
            {
                Assert.That(File.Exists(m_path), Is.False);
                animation.Add(Image(0xFF000000u + 0x401000 * i));
            }
            Assert.That(() => animation.Add(Image(0)), Throws.ArgumentException);
        }
        Assert.That(Beside(), Is.EqualTo(new[] { m_path }));
        Assert.That(Png.Read(m_path).Rgba, Is.EqualTo(Image(0xFF000000u).Rgba));

        byte[] file = File.ReadAllBytes(m_path);
        var names = new List<string>();
        var sequence = new List<uint>();
        for (int at = 8; at < file.Length;)
        {
            uint length = Big(file, at);
            names.Add(Encoding.ASCII.GetString(file, at + 4, 4));
            if (names[names.Count - 1] == "fcTL" || names[names.Count - 1] == "fdAT")
                sequence.Add(Big(file, at + 8));
            if (names[names.Count - 1] == "acTL")
                Assert.That(Big(file, at + 8), Is.EqualTo(3));
            at += 12 + (int)length;
        }
        Assert.That(names, Is.EqualTo(new[]
            { "IHDR", "sRGB", "tEXt", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "fcTL", "fdAT", "IEND" }));
        Assert.That(sequence, Is.EqualTo(new uint[] { 0, 1, 2, 3, 4 }));
    }

    [Test]
    public void Dispose_BeforeTheLastPicture_LeavesNothing()
    {
        using (var animation = new AnimatedPng(m_path, 5, 3, 3, 250))
            animation.Add(Image(0xFF000000u));
        Assert.That(Beside(), Is.Empty);
    }

    static uint Big(byte[] from, int at) =>
        (uint)from[at] << 24 | (uint)from[at + 1] << 16 | (uint)from[at + 2] << 8 | from[at + 3];
}
