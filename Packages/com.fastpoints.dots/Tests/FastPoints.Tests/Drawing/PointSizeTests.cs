using FastPoints.Drawing;
using NUnit.Framework;

namespace FastPoints.Tests.Drawing
{
    public sealed class PointSizeTests
    {
        [Test]
        public void ToPx_EachMode_AppliesItsUnit()
        {
            Assert.That(PointSize.Pixels(3).ToPx(7, 11), Is.EqualTo(3));
            Assert.That(PointSize.World(0.5f).ToPx(7, 11), Is.EqualTo(5.5f));
            Assert.That(PointSize.Adaptive(2).ToPx(0.25f, 11), Is.EqualTo(5.5f));
        }

        [Test]
        public void ToPx_OutOfLimits_IsClamped()
        {
            var size = new PointSize { Mode = PointSizeMode.World, Value = 1, MinPx = 2, MaxPx = 10 };
            Assert.That(size.ToPx(0, 0.001f), Is.EqualTo(2));
            Assert.That(size.ToPx(0, 1e6f), Is.EqualTo(10));
            // Beside the eye.
            Assert.That(size.ToPx(0, float.PositiveInfinity), Is.EqualTo(10));
        }

        [Test]
        public void ToPx_NothingSet_IsOnePixel() => Assert.That(default(PointSize).ToPx(1, 1), Is.EqualTo(1));
    }
}
