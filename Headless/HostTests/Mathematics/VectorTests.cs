using System;
using System.Globalization;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.HostTests.Mathematics
{
    public sealed class VectorTests
    {
        [Test]
        public void Operators_OnVectors_WorkByComponent()
        {
            var a = new int4(7, -8, 9, 10);
            var b = new int4(2, 3, -4, 5);

            Assert.That(a + b, Is.EqualTo(new int4(9, -5, 5, 15)));
            Assert.That(a - b, Is.EqualTo(new int4(5, -11, 13, 5)));
            Assert.That(a * 2, Is.EqualTo(new int4(14, -16, 18, 20)));
            Assert.That(a / b, Is.EqualTo(new int4(3, -2, -2, 2)));
            Assert.That(a % b, Is.EqualTo(new int4(1, -2, 1, 0)));
            Assert.That(a << 1, Is.EqualTo(new int4(14, -16, 18, 20)));
            Assert.That(-a, Is.EqualTo(new int4(-7, 8, -9, -10)));
            Assert.That(~new uint2(0, uint.MaxValue), Is.EqualTo(new uint2(uint.MaxValue, 0)));
            Assert.That(a > b, Is.EqualTo(new bool4(true, false, true, true)));
            Assert.That(a == 9, Is.EqualTo(new bool4(false, false, true, false)));
        }

        [Test]
        public void HashCode_OfEachType_IsUnitys()
        {
            var codes = new (object Of, uint Code)[]
            {
                (new bool2(true, false), 0x57C8E9B2), (new bool3(true, false, true), 0xD865353F),
                (new bool4(true, false, false, true), 0x9CD39CEE), (new int2(7, -8), 0x29DDB7F8),
                (new int3(1, 2, 3), 0xAF2D05FF), (new int4(1, -2, 3, int.MinValue), 0xC7389875), (new uint2(7, 8), 0xA48B429E),
                (new uint3(1, 2, uint.MaxValue), 0xBE8B99A1), (new uint4(1, 2, 3, 4), 0xCBAEE859),
                (new float2(1, -2), 0x9A5D5341), (new float3(0, 0, 1.5f), 0x7E9513F9), (new float3(0, -0.0f, 1.5f), 0xFE9513F9),
                (new float4(1, 2, 3, 4), 0x4CC36EE1), (new double2(0.1, -1), 0xB5ECB90C),
                (new double3(0.1, -1, 1e300), 0x89721BA6), (new double4(1, 2, 3, 4), 0xC951BFC3),
                (new double3x3(1, 0, 0, 0, 1, 0, 0, 0, 1), 0xAEC0D005),
                (new double4x4(new double4(1, 0, 0, 0), new double4(0, 1, 0, 0), new double4(0, 0, 1, 0), new double4(0, 0, 0, 1)),
                    0xF352ADE1),
                (new float4x4(new float4(1, 0, 0, 0), new float4(0, 1, 0, 0), new float4(0, 0, 1, 0), new float4(0, 0, 0, 1)),
                    0x52F7230F),
            };
            foreach ((object of, uint code) in codes)
                Assert.That((uint)of.GetHashCode(), Is.EqualTo(code), of.ToString());
        }

        [Test]
        public void Conversions_BetweenTypes_TruncateAndWiden()
        {
            float3 widened = new int3(1, 2, 3);
            var truncated = (int3)new float3(1.9f, -1.9f, 2.5f);
            double2 doubled = new float2(0.5f, 0.25f);

            Assert.That(widened, Is.EqualTo(new float3(1, 2, 3)));
            Assert.That(truncated, Is.EqualTo(new int3(1, -1, 2)));
            Assert.That(doubled, Is.EqualTo(new double2(0.5, 0.25)));
            Assert.That(new int2(true), Is.EqualTo(new int2(1, 1)));
            Assert.That(new float4(new float2(1, 2), 3, 4), Is.EqualTo(new float4(1, 2, 3, 4)));
        }

        [Test]
        public void Swizzles_ReadAndWritten_KeepTheirOrder()
        {
            var v = new float4(1, 2, 3, 4);
            v.wx = new float2(8, 9);

            Assert.That(v, Is.EqualTo(new float4(9, 2, 3, 8)));
            Assert.That(v.zyx, Is.EqualTo(new float3(3, 2, 9)));
            Assert.That(v.yyy, Is.EqualTo(new float3(2, 2, 2)));
            Assert.That(v.zzzz, Is.EqualTo(new float4(3, 3, 3, 3)));
        }

        [Test]
        public void Indexer_EachComponent_ReadsAndWritesIt()
        {
            var v = new double3(1, 2, 3);
            v[1] = 5;

            Assert.That(v, Is.EqualTo(new double3(1, 5, 3)));
            Assert.That(v[2], Is.EqualTo(3));
        }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
        [Test]
        public void Indexer_OutOfRange_Throws() =>
            Assert.That(() => new float3(1, 2, 3)[3], Throws.ArgumentException);
#endif

        [Test]
        public void ToString_OfVectors_IsUnitys()
        {
            Assert.That(new float2(1.5f, 2).ToString("R", CultureInfo.InvariantCulture), Is.EqualTo("float2(1.5f, 2f)"));
            Assert.That(new int3(1, 2, 3).ToString(), Is.EqualTo("int3(1, 2, 3)"));
        }

        [Test]
        public unsafe void Layout_OfVectors_HasNoGaps()
        {
            Assert.That(sizeof(float3), Is.EqualTo(12));
            Assert.That(sizeof(double3), Is.EqualTo(24));
            Assert.That(sizeof(bool3), Is.EqualTo(3));
            Assert.That(sizeof(float4x4), Is.EqualTo(64));
        }

        [Test]
        public void GetHashCode_EqualVectors_IsEqual() =>
            Assert.That(new int3(1, 2, 3).GetHashCode(), Is.EqualTo(new int3(1, 2, 3).GetHashCode()));
    }
}
