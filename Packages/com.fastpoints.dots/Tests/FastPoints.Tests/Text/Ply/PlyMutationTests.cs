using System;
using FastPoints.Tests.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Text
{
    public class PlyMutationTests
    {
        static readonly string[] s_words =
        {
            "0", "-1", "4", "99999999999999999999", "18446744073709551615", "4294967296", "nan", "list", "vertex", "face",
            "float",
            "uint64", "char", "ascii", "binary_big_endian", "end_header", "property", "element", "\r", "\n", " ", "",
        };

        static byte[] Seed(string format, bool hasLists)
        {
            var file = PlyTestFile.WithHeader(format, "comment seed", "element face 2", "property list uchar int i",
                "element vertex 6",
                "property float x", "property double y", "property short z", "property uchar red",
                hasLists ? "property list ushort char l" : "property int l", "element edge 1", "property int a");
            bool isBig = format == "binary_big_endian";
            if (format == "ascii")
            {
                file.Text("2 5 6\n0\n");
                for (int i = 0; i < 6; i++)
                    file.Text(i + ".5 " + i + "e-3 " + -i + " 200 " + (hasLists ? "2 1 1\n" : "7\n"));
                return file.Text("5\n").ToArray();
            }
            file.Values(isBig, (byte)2, 5, 6, (byte)0);
            for (int i = 0; i < 6; i++)
            {
                file.Values(isBig, i + 0.5f, i * 1e-3, (short)-i, (byte)200);
                if (hasLists)
                    file.Values(isBig, (ushort)2, (sbyte)1, (sbyte)1);
                else
                    file.Values(isBig, 7);
            }
            return file.Values(isBig, 5).ToArray();
        }

        [Test]
        public void Read_DamagedFile_GivesPointsOrAFailureThatNamesIt(
            [Values("ascii", "binary_little_endian", "binary_big_endian")] string format, [Values] bool hasLists)
        {
            byte[] seed = Seed(format, hasLists);
            var random = new Random(format.Length * 2 + (hasLists ? 1 : 0));
            int failures = 0, whole = 0;
            using (var file = new PlyTestFile())
                for (int i = 0; i < 600; i++)
                {
                    byte[] bytes = Damage.Of(seed, random, random.Next, s_words);
                    System.IO.File.WriteAllBytes(file.Path, bytes);
                    try
                    {
                        var contents = FileContents.OfPly(file.Path);
                        Assert.That(contents.Points, Is.LessThanOrEqualTo(bytes.Length));
                        Assert.That(contents.Info.Warnings.Count, Is.LessThan(10));
                        whole += contents.Points == 6 ? 1 : 0;
                    }
                    catch (PointCloudException e)
                    {
                        Assert.That(e.IsBadInput, Is.True, e.Message);
                        Assert.That(e.Message, Does.StartWith(file.Path));
                        Assert.That(e.Message.IndexOf('\n'), Is.EqualTo(-1));
                        failures++;
                    }
                }
            Assert.That(failures, Is.GreaterThan(50));
            Assert.That(whole, Is.GreaterThan(20));
        }
    }
}
