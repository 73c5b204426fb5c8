using FastPoints.Drawing;
using FastPoints.Picture;
using NUnit.Framework;

namespace FastPoints.Tests.Picture
{
    public class PictureOptionsTests
    {
        [TestCase(-1, ColorMode.Elevation, ColorDepth.None, true), TestCase(-1, ColorMode.Rgb, ColorDepth.Bits8, false)]
        [TestCase(-1, ColorMode.Classification, ColorDepth.None, true)]
        [TestCase(-1, ColorMode.Elevation, ColorDepth.Bits8, false)]
        [TestCase(-1, ColorMode.Intensity, ColorDepth.None, false)]
        [TestCase(0, ColorMode.Elevation, ColorDepth.None, false), TestCase(0.7f, ColorMode.Rgb, ColorDepth.Bits8, true)]
        public void LitFractionFor_Mode_IsOfCloudsWithoutColours(float fraction, ColorMode mode, ColorDepth color, bool isLit)
        {
            var options = new PictureOptions { LitFraction = fraction };
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
