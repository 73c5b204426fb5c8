using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Las
{
    public class LasMutationTests
    {
        const int CasesPerFile = 300;

        static readonly string[] s_samples =
        {
            "las/1.0_0.las", "las/extrabytes.las", "las/1_4_w_evlr.las", "las/pdrf9-1.5.las", "las/simple1_3.las",
            "las/5points_14.las", "las/interesting.las", "broken/bad-geotiff-keys.las",
        };

        static IEnumerable<TestCaseData> OwnFiles()
        {
            var minorOfFormat = new[] { 0, 1, 2, 2, 3, 3, 4, 4, 4, 5, 5 };
            for (int format = 0; format < minorOfFormat.Length; format++)
                yield return new TestCaseData(minorOfFormat[format], format)
                    .SetName("Mutation_OwnPointFormat" + format + "_EndsInALineOrAResult");
        }

        static IEnumerable<TestCaseData> Samples()
        {
            foreach (string sample in s_samples)
                yield return new TestCaseData(sample).SetName("Mutation_Sample_" + sample + "_EndsInALineOrAResult");
        }

        [TestCaseSource(nameof(OwnFiles))]
        public void MutateOwn(int minor, int format)
        {
            using var file = new LasTestFile { Minor = minor, Format = format, ExtraBytes = 7, Padding = 2 };
            file.RandomPoints(40, format);
            byte[] keys = LasTestFile.Shorts(1, 1, 0, 3, 3072, 0, 1, 32633, 3073, 34737, 4, 0, 3077, 34736, 1, 0);
            file.Vlr("LASF_Projection", 34735, keys)
                .Vlr("LASF_Projection", 34736, BitConverter.GetBytes(0.3))
                .Vlr("LASF_Projection", 34737, Encoding.ASCII.GetBytes("abc|"));
            var extra = new byte[2 * 192];
            extra[2] = 3;
            extra[3] = 8;
            extra[4] = (byte)'a';
            extra[112] = 1;
            extra[192 + 2] = 15;
            extra[192 + 4] = (byte)'b';
            file.Vlr("LASF_Spec", 4, extra);
            if (minor >= 4)
                file.Evlr("u", 1, new byte[9])
                    .Evlr("LASF_Projection", 2112, Encoding.ASCII.GetBytes("PROJCS[\"x\",UNIT[\"m\",1],ID[\"EPSG\",1]]"));
            Mutate(file.ToBytes(), file.PointsOffset, 1000 + 16 * minor + format);
        }

        [TestCaseSource(nameof(Samples))]
        public void MutateSample(string sample)
        {
            var bytes = File.ReadAllBytes(TestData.SampleOrIgnore(sample));
            Mutate(bytes, Math.Min(bytes.Length, BitConverter.ToInt32(bytes, 96)), bytes.Length);
        }

        static void Mutate(byte[] sound, int pointsOffset, int seed)
        {
            var random = new Random(seed);
            int opened = 0;
            using (var file = new LasTestFile())
                for (int i = 0; i < CasesPerFile; i++)
                {
                    file.Save(Damaged(sound, pointsOffset, random));
                    if (Survives(file.Path, "seed " + seed + ", case " + i))
                        opened++;
                }
            Assert.That(opened, Is.GreaterThan(0));
        }

        static bool Survives(string path, string which)
        {
            try
            {
                using var reader = PointReaders.Open(path);
                long bytes = new FileInfo(path).Length;
                Assert.That((double)reader.PointCount * reader.Info.RecordBytes, Is.LessThanOrEqualTo(bytes), which);
                Assert.That((long)reader.MaxPointsPerBlock * reader.Info.RecordBytes, Is.LessThanOrEqualTo(bytes), which);
                Assert.That(reader.Info.Facts.Count, Is.LessThan(100 + bytes / 32), which);
                Assert.That(reader.Info.Warnings.Count, Is.LessThan(100 + bytes / 4), which);
                Assert.That(reader.Info.Transform.Scale.x, Is.Not.NaN.And.Not.EqualTo(0), which);
                ReadPoints.EachBlock(reader, reader.Info.Schema, read => { });
                return true;
            }
            catch (PointCloudException failure)
            {
                Assert.That(failure.Message, Does.Not.Contain("\n"), which);
                return false;
            }
        }

        static byte[] Damaged(byte[] sound, int pointsOffset, Random random) => Damage.Of(sound, random, count =>
        {
            int head = Math.Max(1, Math.Min(count, pointsOffset));
            int range = random.Next(4) == 0 ? count : random.Next(2) == 0 ? Math.Min(head, 393) : head;
            return random.Next(Math.Min(range, count));
        });
    }
}
