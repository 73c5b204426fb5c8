using NUnit.Framework;

namespace FastPoints.Tests.Core
{
    [Category("Smoke")]
    public class MortonTests
    {
        [TestCase(0u, 0u, 0u, 0UL)]
        [TestCase(1u, 0u, 0u, 1UL)]
        [TestCase(0u, 1u, 0u, 2UL)]
        [TestCase(0u, 0u, 1u, 4UL)]
        [TestCase(7u, 7u, 7u, 511UL)]
        [TestCase(Morton.MaxCoordinate, Morton.MaxCoordinate, Morton.MaxCoordinate, 0x7FFFFFFFFFFFFFFFUL)]
        [TestCase(1u << 20, 0u, 0u, 1UL << 60)]
        [TestCase(0u, 0u, 1u << 20, 1UL << 62)]
        public void Encode_KnownCoordinates_GivesTheirCode(uint x, uint y, uint z, ulong code) =>
            Assert.That(Morton.Encode(x, y, z), Is.EqualTo(code));

        [Test]
        public void Encode_EachBit_IsInterleaved()
        {
            for (int bit = 0; bit < Morton.BitsPerAxis; bit++)
            {
                Assert.That(Morton.Spread(1u << bit), Is.EqualTo(1UL << (3 * bit)));
                Assert.That(Morton.Gather(1UL << (3 * bit)), Is.EqualTo(1u << bit));
            }
        }

        [Test]
        public void EncodeFew_EachBit_MatchesEncode()
        {
            for (uint value = 0; value < 1 << Morton.ShortBits; value++)
            {
                uint y = value * 37 & (1 << Morton.ShortBits) - 1, z = value * 91 & (1 << Morton.ShortBits) - 1;
                Assert.That((ulong)Morton.EncodeShort(value, y, z), Is.EqualTo(Morton.Encode(value, y, z)));
            }
        }

        [Test]
        public void Decode_OfEncoded_GivesTheCoordinatesBack()
        {
            var random = new Unity.Mathematics.Random(7);
            for (int i = 0; i < 100_000; i++)
            {
                uint x = random.NextUInt() & Morton.MaxCoordinate;
                uint y = random.NextUInt() & Morton.MaxCoordinate;
                uint z = random.NextUInt() & Morton.MaxCoordinate;
                Morton.Decode(Morton.Encode(x, y, z), out uint dx, out uint dy, out uint dz);
                if (dx != x || dy != y || dz != z)
                    Assert.Fail(x + ", " + y + ", " + z + " came back as " + dx + ", " + dy + ", " + dz);
            }
        }

        /// <summary>What Burst makes vectors of has the codes of each position.</summary>
        [Test]
        public unsafe void Encode_Many_GivesTheCodesOfEach()
        {
            var random = new Unity.Mathematics.Random(3);
            uint* x = stackalloc uint[40], y = stackalloc uint[40], z = stackalloc uint[40], few = stackalloc uint[40];
            ulong* codes = stackalloc ulong[40];
            for (int count = 0; count <= 40; count++)
            {
                var corner = new Unity.Mathematics.uint3(random.NextUInt(), random.NextUInt(), random.NextUInt());
                int shift = count % 12;
                for (int i = 0; i < count; i++)
                {
                    x[i] = corner.x + (random.NextUInt() & (1 << 30) - 1);
                    y[i] = corner.y + (random.NextUInt() & (1 << 30) - 1);
                    z[i] = corner.z + (random.NextUInt() & (1 << 30) - 1);
                }
                Morton.Encode(x, y, z, count, new MortonCells(corner, shift), codes);
                Morton.EncodeShort(x, y, z, count, new MortonCells(corner, 30 - Morton.ShortBits), few);
                for (int i = 0; i < count; i++)
                {
                    uint dx = x[i] - corner.x, dy = y[i] - corner.y, dz = z[i] - corner.z;
                    Assert.That(codes[i], Is.EqualTo(Morton.Encode(dx >> shift, dy >> shift, dz >> shift)));
                    Assert.That(few[i], Is.EqualTo(Morton.EncodeShort(dx >> 30 - Morton.ShortBits, dy >> 30 - Morton.ShortBits,
                        dz >> 30 - Morton.ShortBits)));
                }
            }
        }

        [Test]
        public void Encode_TooManyBits_IgnoresThem() =>
            Assert.That(Morton.Encode(0xFFFFFFFFu, 0, 0), Is.EqualTo(Morton.Encode(Morton.MaxCoordinate, 0, 0)));
    }
}
