using FastPoints.Drawing;
using NUnit.Framework;

namespace FastPoints.Tests.Drawing
{
    public sealed class ClassMaskTests
    {
        [Test]
        public void Has_EachClass_IsWhetherItWasAdded()
        {
            var mask = ClassMask.Of(0, 31, 32, 127, 128, 200, 255, -1, 256);
            for (int c = 0; c < 256; c++)
            {
                bool isIn = c == 0 || c == 31 || c == 32 || c == 127 || c == 128 || c == 200 || c == 255;
                Assert.That(mask.Has(c), Is.EqualTo(isIn), c.ToString());
                Assert.That(mask.Inverse.Has(c), Is.EqualTo(!isIn), c.ToString());
            }
            Assert.That(mask.IsEmpty, Is.False);
            Assert.That(ClassMask.Of().IsEmpty, Is.True);
        }
    }
}
