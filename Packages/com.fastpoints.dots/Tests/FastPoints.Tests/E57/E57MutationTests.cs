using System;
using System.Linq;
using FastPoints.Tests.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.E57
{
    public class E57MutationTests
    {
        const int Count = 900;

        static readonly string[] s_words =
        {
            "0", "-1", "1", "64", "255", "9223372036854775807", "-9223372036854775808", "18446744073709551615", "4294967296",
            "nan", "1e308", "Integer", "ScaledInteger", "Float", "String", "Structure", "single", "fileOffset", "recordCount",
            "minimum",
            "<", ">", "/>", "\"", "&", "]]>", "<a>", "cartesianX", "sphericalRange", "vectorChild", "",
        };

        static byte[] Seed(bool isSpherical)
        {
            double[] reals = Enumerable.Range(0, Count).Select(i => i * 0.25).ToArray();
            long[] longs = Enumerable.Range(0, Count).Select(i => (long)i % 100).ToArray();
            var first = new E57TestScan(
                E57TestField.Scaled("cartesianX", 0, 1000, 0.01, 5, longs),
                E57TestField.Scaled("cartesianY", -7, 100, 0.01, 0, longs),
                E57TestField.Scaled("cartesianZ", 0, 99, 0.01, 0, longs), E57TestField.Integer("colorRed", 0, 255, longs),
                E57TestField.Integer("cartesianInvalidState", 0, 2, longs.Select(v => v == 50 ? 2L : 0).ToArray()))
            {
                Packing = E57Packing.Ragged,
                RecordsPerPacket = 200,
                HasIgnored = true,
                Xml = E57TestScan.Pose(1, 0, 0, 0, 1, 2, 3),
            };
            string[] names = isSpherical ? new[] { "sphericalRange", "sphericalAzimuth", "sphericalElevation" }
                : new[] { "cartesianX", "cartesianY", "cartesianZ" };
            var second = new E57TestScan(E57TestField.Single(names[0], reals), E57TestField.Double(names[1], reals),
                E57TestField.Single(names[2], reals), E57TestField.Integer("returnIndex", 0, 99, longs))
            {
                RecordsPerPacket = 111,
                Xml = E57TestScan.Pose(0.5, 0.5, 0.5, 0.5, 100, 200, 300),
            };
            return new E57FileWriter(first, second).ToArray();
        }

        static byte[] Mutate(byte[] seed, int xmlStart, Random random)
        {
            bool isInXml = random.Next(3) == 0;
            byte[] mutated = Damage.Of(seed, random, count => isInXml && count > xmlStart ? random.Next(xmlStart, count)
                : random.Next(4) == 0 ? random.Next(Math.Min(count, 120)) : random.Next(count), s_words);
            if (random.Next(8) != 0)
                E57FileWriter.Seal(mutated);
            return mutated;
        }

        static int XmlStart(byte[] file) => (int)BitConverter.ToInt64(file, 24);

        static void Run(bool isSpherical, int files, int seedOfRandom)
        {
            byte[] seed = Seed(isSpherical);
            var random = new Random(seedOfRandom);
            int failures = 0, whole = 0, parts = 0;
            for (int i = 0; i < files; i++)
            {
                byte[] bytes = Mutate(seed, XmlStart(seed), random);
                try
                {
                    var contents = FileContents.OfE57(bytes);
                    Assert.That(contents.Points, Is.LessThanOrEqualTo(8L * bytes.Length + 65536));
                    Assert.That(contents.Info.Warnings.Count, Is.LessThan(20));
                    whole += contents.Points == Count * 2 - Count / 100 ? 1 : 0;
                    parts += contents.Points < Count * 2 - Count / 100 ? 1 : 0;
                }
                catch (PointCloudException e)
                {
                    Assert.That(e.IsBadInput, Is.True, e.Message);
                    Assert.That(e.Message.IndexOf('\n'), Is.EqualTo(-1));
                    failures++;
                }
            }
            Assert.That(failures, Is.GreaterThan(files / 10));
            Assert.That(whole, Is.GreaterThan(files / 30));
            Assert.That(parts, Is.GreaterThan(files / 30));
        }

        [Test]
        public void Read_DamagedFile_GivesPointsOrAFailureThatNamesIt([Values] bool isSpherical) =>
            Run(isSpherical, 500, isSpherical ? 1 : 2);

        [Test, Category("Long"), Explicit]
        public void Read_ManyDamagedFiles_GivesPointsOrAFailureThatNamesIt() => Run(true, 20000, 3);
    }
}
