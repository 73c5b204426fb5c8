using FastPoints.Drawing;
using FastPoints.Picture;
using NUnit.Framework;

namespace FastPoints.Tests.Picture
{
    public class PictureOptionsTests
    {
        [Test]
        public void TrySetStyle_EachKey_SetsItsOption()
        {
            var options = new PictureOptions();
            string[,] styles =
            {
                { "color", "classification" }, { "size", "2.5" }, { "points", "round" }, { "edl", "off" },
                { "light", "30,-5,0.25" },
                { "background", "#102030" }, { "up", "y" },
            };
            for (int i = 0; i < styles.GetLength(0); i++)
                Assert.That(options.TrySetStyle(styles[i, 0], styles[i, 1], out string error), Is.True, error);
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
        public void TrySetStyle_Up_IsAnAxisOrItsNegative(string value, UpAxis? expected)
        {
            var options = new PictureOptions();
            Assert.That(options.TrySetStyle("up", value, out string error), Is.EqualTo(expected != null), error);
            Assert.That(expected == null ? error.Contains("-z, got " + value) : options.UpAxis == expected, Is.True);
        }

        [TestCase("2", PointSizeMode.Pixels, 2)]
        [TestCase("0.25u", PointSizeMode.World, 0.25f)]
        [TestCase("adaptive", PointSizeMode.Adaptive, PointSize.DefaultGaps)]
        [TestCase("adaptive:1.2", PointSizeMode.Adaptive, 1.2f)]
        public void TrySetStyle_Sizes_AreOfTheirKind(string value, PointSizeMode mode, float size)
        {
            var options = new PictureOptions();
            Assert.That(options.TrySetStyle("size", "adaptive", out string error), Is.True, error);
            Assert.That(options.TrySetStyle("size", value, out error), Is.True, error);
            Assert.That(options.SizeInWorld?.Mode ?? PointSizeMode.Pixels, Is.EqualTo(mode));
            Assert.That(options.SizeInWorld?.Value ?? options.PointSizePx, Is.EqualTo(size));
        }

        [TestCase("color", ""), TestCase("color", "3"), TestCase("size", "0"), TestCase("size", "-")]
        [TestCase("size", "u"), TestCase("size", "-1u"), TestCase("size", "adaptive:")]
        [TestCase("size", "adaptive:0"), TestCase("points", "flat"), TestCase("edl", "-1")]
        [TestCase("light", ""), TestCase("light", "30"), TestCase("light", "30,91"), TestCase("light", "30,45,1.1")]
        [TestCase("light", "30,45,1,1")]
        [TestCase("background", "12345"), TestCase("up", ""), TestCase("shine", "on")]
        public void TrySetStyle_BadValue_NamesTheWanted(string key, string value)
        {
            Assert.That(new PictureOptions().TrySetStyle(key, value, out string error), Is.False);
            Assert.That(error, Is.Not.Null.And.Not.Empty);
        }

        [TestCase("auto", ColorMode.Elevation, ColorDepth.None, true), TestCase("auto", ColorMode.Rgb, ColorDepth.Bits8, false)]
        [TestCase("auto", ColorMode.Classification, ColorDepth.None, true)]
        [TestCase("auto", ColorMode.Elevation, ColorDepth.Bits8, false)]
        [TestCase("auto", ColorMode.Intensity, ColorDepth.None, false)]
        [TestCase("off", ColorMode.Elevation, ColorDepth.None, false), TestCase("on", ColorMode.Rgb, ColorDepth.Bits8, true)]
        public void LitFractionFor_Mode_IsOfCloudsWithoutColours(string light, ColorMode mode, ColorDepth color, bool isLit)
        {
            var options = new PictureOptions();
            Assert.That(options.TrySetStyle("light", light, out string error), Is.True, error);
            Assert.That(options.LitFractionFor(mode, color), Is.EqualTo(isLit ? 0.7f : 0));
        }

        [Test]
        public void EdlFor_Auto_IsOffForColourAndOnForTheOthers()
        {
            var options = new PictureOptions();
            Assert.That(options.EdlFor(ColorMode.Rgb), Is.EqualTo(0));
            Assert.That(options.EdlFor(ColorMode.Elevation), Is.GreaterThan(0));
            options.EdlStrength = 0.7f;
            Assert.That(options.EdlFor(ColorMode.Rgb), Is.EqualTo(0.7f));
        }
    }
}
