using System.IO;
using System.Linq;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Sources
{
    public class EptSampleTests
    {
        [TestCase("1.2-with-color", 1065, 1, 1, 1)]
        [TestCase("bcbf", 5, 5, 5, 1)]
        [TestCase("ellipsoid-zstandard", 100000, 1, 1, 1)]
        [TestCase("lone-star-laszip", 518862, 13, 4, 6)]
        [TestCase("lion_takanawa_ept_bin", 341989, 16, 3, 1)]
        public void Sample_Tree_IsAsKnown(string name, int points, int nodes, int levels, int pages)
        {
            using var reader = ReadPoints.Open(Folder(name));
            Assert.That((reader.PointCount, reader.Tree.NodeCount, reader.Tree.LevelCount, reader.Tree.PageCount),
                Is.EqualTo(((long)points, nodes, levels, pages)));
            Assert.That(reader.Info.Warnings.Any(warning => warning.Text.Contains("ept.json claims 10 points")),
                Is.EqualTo(name == "bcbf"));
        }

        [TestCase("1.2-with-color", "las/1.2-with-color.las", 1065)]
        [TestCase("lone-star-laszip", "copc/lone-star.copc.laz", 518862)]
        [TestCase("lion_takanawa_ept_bin", "potree/lion_takanawa_laz/cloud.js", 341989)]
        public void Sample_Twin_HasTheSamePoints(string name, string twin, int points)
        {
            using var reader = ReadPoints.Open(Folder(name));
            using var other = PointReaders.Open(TestData.SampleOrIgnore(twin));
            var names = PointMultiset.CommonNames(reader, other);
            Assert.That(names, Has.Length.GreaterThan(8));
            PointMultiset.CheckTwins(reader, other, names, math.abs(other.Info.Transform.Scale), points);
        }

        static string Folder(string name) => Path.GetDirectoryName(TestData.SampleOrIgnore("ept/" + name + "/ept.json"));
    }
}
