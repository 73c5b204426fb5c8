using FastPoints.Picture;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Picture
{
    public class PalettesTests
    {
        /// <summary>Published values of viridis at five places.</summary>
        [TestCase(0.0, 68, 1, 84)]
        [TestCase(0.25, 59, 82, 139)]
        [TestCase(0.5, 33, 145, 140)]
        [TestCase(0.75, 94, 201, 98)]
        [TestCase(1.0, 253, 231, 37)]
        public void Viridis_KnownPlaces_AreWithinFiveSteps(double share, int red, int green, int blue)
        {
            uint color = Palettes.Viridis(share);
            Assert.That((int)(color & 255), Is.EqualTo(red).Within(5));
            Assert.That((int)(color >> 8 & 255), Is.EqualTo(green).Within(5));
            Assert.That((int)(color >> 16 & 255), Is.EqualTo(blue).Within(5));
            Assert.That(color >> 24, Is.EqualTo(255));
        }

        [TestCase(0.0, 0)]
        [TestCase(1.0, 255)]
        [TestCase(0.5, 188)]
        [TestCase(0.002, 7)]
        public void Gray_ShareOfLight_IsEncodedAsSrgb(double light, int value)
        {
            Assert.That((int)(Palettes.Gray(light) & 255), Is.EqualTo(value));
        }

        [Test]
        public void Create_Classification_HasItsOwnColourForEachUsualClass()
        {
            using var palette = Palettes.Create(ColorMode.Classification, Allocator.Persistent);
            for (int a = 0; a < 23; a++)
                for (int b = a + 1; b < 24; b++)
                    Assert.That(palette[a], Is.Not.EqualTo(palette[b]), a + " and " + b);
            Assert.That(palette[255], Is.EqualTo(palette[23]));
        }
    }
}
