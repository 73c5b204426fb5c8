namespace FastPoints.HostTests.Cli.Pictures;

public sealed class PictureStyleTests
{
    [Test]
    public void SetStyle_EachKey_SetsItsOption()
    {
        var options = new PictureOptions();
        string[,] styles =
        {
            { "color", "classification" }, { "size", "2.5" }, { "points", "round" }, { "edl", "off" },
            { "light", "30,-5,0.25" },
            { "background", "#102030" }, { "up", "y" },
        };
        for (int i = 0; i < styles.GetLength(0); i++)
            Assert.That(options.SetStyle(styles[i, 0], styles[i, 1]), Is.Null);
        Assert.That(options.Color, Is.EqualTo(ColorMode.Classification));
        Assert.That(options.PointSizePx, Is.EqualTo(2.5f));
        Assert.That(options.RoundPoints, Is.True);
        Assert.That(options.EdlStrength, Is.EqualTo(0));
        Assert.That((options.LightAzimuth, options.LightElevation, options.LitFraction), Is.EqualTo((30.0, -5.0, 0.25f)));
        Assert.That(options.Background, Is.EqualTo(0xFF302010u));
        Assert.That(options.UpAxis, Is.EqualTo(UpAxis.Y));
    }

    [TestCase("z", UpAxis.Z), TestCase("-x", UpAxis.NegativeX), TestCase("-Y", UpAxis.NegativeY)]
    [TestCase("-z", UpAxis.NegativeZ), TestCase("w", null), TestCase("-", null), TestCase("-5", null)]
    public void SetStyle_Up_IsAnAxisOrItsNegative(string value, UpAxis? expected)
    {
        var options = new PictureOptions();
        string error = options.SetStyle("up", value);
        Assert.That(expected == null ? error.Contains("-z, got " + value) : error == null && options.UpAxis == expected, error);
    }

    [TestCase("2", PointSizeMode.Pixels, 2)]
    [TestCase("0.25u", PointSizeMode.World, 0.25f)]
    [TestCase("adaptive", PointSizeMode.Adaptive, PointSize.DefaultGaps)]
    [TestCase("adaptive:1.2", PointSizeMode.Adaptive, 1.2f)]
    public void SetStyle_Sizes_AreOfTheirKind(string value, PointSizeMode mode, float size)
    {
        var options = new PictureOptions();
        Assert.That(options.SetStyle("size", "adaptive") ?? options.SetStyle("size", value), Is.Null);
        Assert.That(options.SizeInWorld?.Mode ?? PointSizeMode.Pixels, Is.EqualTo(mode));
        Assert.That(options.SizeInWorld?.Value ?? options.PointSizePx, Is.EqualTo(size));
    }

    [TestCase("color", ""), TestCase("color", "3"), TestCase("size", "0"), TestCase("size", "-")]
    [TestCase("size", "u"), TestCase("size", "-1u"), TestCase("size", "adaptive:")]
    [TestCase("size", "adaptive:0"), TestCase("points", "flat"), TestCase("edl", "-1")]
    [TestCase("light", ""), TestCase("light", "30"), TestCase("light", "30,91"), TestCase("light", "30,45,1.1")]
    [TestCase("light", "30,45,1,1")]
    [TestCase("background", "12345"), TestCase("up", ""), TestCase("shine", "on")]
    public void SetStyle_BadValue_NamesTheWanted(string key, string value) =>
        Assert.That(new PictureOptions().SetStyle(key, value), Is.Not.Null.And.Not.Empty);

    [TestCase("auto", -1), TestCase("off", 0), TestCase("on", 0.7f)]
    public void SetStyle_Light_IsAShare(string value, float fraction)
    {
        var options = new PictureOptions { LitFraction = 2 };
        Assert.That(options.SetStyle("light", value), Is.Null);
        Assert.That(options.LitFraction, Is.EqualTo(fraction));
    }
}
