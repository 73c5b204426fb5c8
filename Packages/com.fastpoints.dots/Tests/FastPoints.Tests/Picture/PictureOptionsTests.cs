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
                { "background", "#102030" }, { "up", "y" },
            };
            for (int i = 0; i < styles.GetLength(0); i++)
                Assert.That(options.TrySetStyle(styles[i, 0], styles[i, 1], out string error), Is.True, error);
            Assert.That(options.Color, Is.EqualTo(ColorMode.Classification));
            Assert.That(options.PointSizePx, Is.EqualTo(2.5f));
            Assert.That(options.RoundPoints, Is.True);
            Assert.That(options.EdlStrength, Is.EqualTo(0));
            Assert.That(options.Background, Is.EqualTo(0xFF302010u));
            Assert.That(options.UpAxis, Is.EqualTo(UpAxis.Y));
        }

        [TestCase("color", "pink")]
        [TestCase("color", "3")]
        [TestCase("size", "0")]
        [TestCase("size", "-")]
        [TestCase("points", "flat")]
        [TestCase("edl", "-1")]
        [TestCase("background", "12345")]
        [TestCase("up", "")]
        [TestCase("shine", "on")]
        public void TrySetStyle_BadValue_SaysWhatWasWanted(string key, string value)
        {
            Assert.That(new PictureOptions().TrySetStyle(key, value, out string error), Is.False);
            Assert.That(error, Is.Not.Null.And.Not.Empty);
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
