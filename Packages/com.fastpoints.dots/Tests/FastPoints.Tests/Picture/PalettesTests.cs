using System;
using FastPoints.Drawing;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Picture
{
    public class PalettesTests
    {
        [TestCase(0.0, 68, 1, 84), TestCase(0.25, 59, 82, 139), TestCase(0.5, 33, 145, 140)]
        [TestCase(0.75, 94, 201, 98), TestCase(1.0, 253, 231, 37)]
        public void Viridis_KnownEntries_AreWithinFiveSteps(double share, int red, int green, int blue)
        {
            uint color = Palettes.Viridis(share);
            Assert.That((int)(color & 255), Is.EqualTo(red).Within(5));
            Assert.That((int)(color >> 8 & 255), Is.EqualTo(green).Within(5));
            Assert.That((int)(color >> 16 & 255), Is.EqualTo(blue).Within(5));
            Assert.That(color >> 24, Is.EqualTo(255));
        }

        [TestCase(0.0, 48, 18, 59), TestCase(0.5, 164, 252, 60), TestCase(1.0, 122, 4, 3)]
        public void Turbo_KnownEntries_AreWithinAnEighth(double share, int red, int green, int blue)
        {
            uint color = Palettes.Turbo(share);
            Assert.That((int)(color & 255), Is.EqualTo(red).Within(32));
            Assert.That((int)(color >> 8 & 255), Is.EqualTo(green).Within(32));
            Assert.That((int)(color >> 16 & 255), Is.EqualTo(blue).Within(32));
        }

        [TestCase(ColorMode.ReturnNumber, 7), TestCase(ColorMode.PointSource, 100)]
        public void Create_Categories_HaveDistinctColours(ColorMode mode, int count)
        {
            using var palette = Palettes.Create(mode, Allocator.Persistent);
            for (int a = 1; a < count; a++)
                for (int b = a + 1; b <= count; b++)
                    Assert.That(palette[a], Is.Not.EqualTo(palette[b]), a + " and " + b);
        }

        [Test]
        public void Create_Gradient_ReplacesThatOfAmountsAndNotOfCategories()
        {
            using var turbo = Palettes.Create(ColorMode.Elevation, Allocator.Persistent, ColorRamp.Turbo);
            using var gray = Palettes.Create(ColorMode.Elevation, Allocator.Persistent, ColorRamp.Gray);
            using var intensity = Palettes.Create(ColorMode.Intensity, Allocator.Persistent);
            using var classes = Palettes.Create(ColorMode.Classification, Allocator.Persistent, ColorRamp.Turbo);
            Assert.That(turbo[255], Is.EqualTo(Palettes.Turbo(1)));
            Assert.That(gray.ToArray(), Is.EqualTo(intensity.ToArray()));
            Assert.That(classes[2], Is.EqualTo(Palettes.Pack(165, 125, 80)));
        }

        [TestCase(0.0, 0), TestCase(1.0, 255), TestCase(0.5, 188), TestCase(0.002, 7)]
        public void Gray_LinearLight_IsEncodedAsSrgb(double light, int value) =>
            Assert.That((int)(Palettes.Gray(light) & 255), Is.EqualTo(value));

        [Test]
        public void CreateAll_EachModeAndGradient_HasItsPalette([Values] ColorRamp ramp)
        {
            using var all = Palettes.CreateAll(Allocator.Persistent);
            foreach (ColorMode mode in Enum.GetValues(typeof(ColorMode)))
            {
                using var one = Palettes.Create(mode, Allocator.Persistent, ramp);
                Assert.That(all.GetSubArray(Palettes.IndexOf(mode, ramp) * Palettes.Length, Palettes.Length).ToArray(),
                    Is.EqualTo(one.ToArray()), mode.ToString());
            }
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
