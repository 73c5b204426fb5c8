using System;
using System.Text;
using FastPoints.Store;
using NUnit.Framework;

namespace FastPoints.Tests.Store
{
    public unsafe class ContentHashTests
    {
        // Published results of XXH64 with seed 0.
        [TestCase("", 0xEF46DB3751D8E999UL)]
        [TestCase("a", 0xD24EC4F1A98C6E5BUL)]
        [TestCase("abc", 0x44BC2CF5AD770999UL)]
        [TestCase("Nobody inspects the spammish repetition", 0xFBCEA83C8A378BF1UL)]
        public void Of_KnownText_GivesThePublishedHash(string text, ulong wanted)
        {
            byte[] bytes = Encoding.ASCII.GetBytes(text + "?");
            fixed (byte* b = bytes)
                Assert.That(ContentHash.Of(b, text.Length), Is.EqualTo(wanted));
        }

        [Test]
        public void Copy_AnyLength_CopiesAndGivesTheHash()
        {
            var random = new Random(5);
            var from = new byte[400];
            random.NextBytes(from);
            for (int length = 0; length < 300; length++)
            {
                var to = new byte[400];
                var wanted = new byte[400];
                Array.Copy(from, 3, wanted, 5, length);
                fixed (byte* f = from, t = to)
                    Assert.That(ContentHash.Copy(t + 5, f + 3, length), Is.EqualTo(ContentHash.Of(f + 3, length)));
                Assert.That(to, Is.EqualTo(wanted));
            }
        }
    }
}
