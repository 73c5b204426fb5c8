using System.Text;
using FastPoints.E57;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.E57
{
    public class Crc32CTests
    {
        [TestCase("", 0x00000000U), TestCase("a", 0xC1D04330U), TestCase("123456789", 0xE3069283U)]
        public void Of_KnownText_IsItsChecksum(string text, uint checksum)
        {
            using var crc = new Crc32C(Allocator.Temp);
            Assert.That(crc.Of(Encoding.ASCII.GetBytes(text + "x"), 0, text.Length), Is.EqualTo(checksum));
        }

        /// <summary>RFC 3720, B.4: 32 bytes of zeros, of ones, and counting up.</summary>
        [TestCase(0, 0, 0x8A9136AAU), TestCase(255, 0, 0x62A8AB43U), TestCase(0, 1, 0x46DD794EU)]
        public void Of_ThirtyTwoBytes_IsTheStandardsChecksum(int first, int step, uint checksum)
        {
            var bytes = new byte[32];
            for (int i = 0; i < 32; i++)
                bytes[i] = (byte)(first + i * step);
            using var crc = new Crc32C(Allocator.Temp);
            Assert.That(crc.Of(bytes, 0, 32), Is.EqualTo(checksum));
        }

        [Test]
        public void Of_AnyLength_MatchesBitByBit()
        {
            var bytes = new byte[1400];
            new System.Random(3).NextBytes(bytes);
            using var crc = new Crc32C(Allocator.Temp);
            for (int count = 0; count < 1000; count += 37)
                Assert.That(crc.Of(bytes, count / 3, count), Is.EqualTo(E57FileWriter.Crc32C(bytes, count / 3, count)));
        }
    }
}
