using System.Linq;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Sources
{
    public class CopcSampleTests
    {
        [TestCase("1.2-with-color", 1065, 65, 4, 1)]
        [TestCase("simple_with_page", 1065, 65, 4, 2)]
        [TestCase("ellipsoid", 100000, 5, 2, 1)]
        [TestCase("example", 30, 1, 1, 1)]
        [TestCase("lone-star", 518862, 15, 3, 1)]
        public void Sample_Tree_IsAsKnown(string name, int points, int nodes, int levels, int pages)
        {
            using var reader = ReadPoints.Open(TestData.SampleOrIgnore("copc/" + name + ".copc.laz"));
            Assert.That(reader.Info.Format, Is.EqualTo("COPC"));
            Assert.That(reader.Info.Version, Is.EqualTo("1.4"));
            Assert.That((reader.PointCount, reader.Tree.NodeCount, reader.Tree.LevelCount, reader.Tree.PageCount),
                Is.EqualTo(((long)points, nodes, levels, pages)));
            CheckPositions(reader);
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [TestCase("1.2-with-color", "las/1.2-with-color.las", 1065)]
        [TestCase("simple_with_page", "las/1.2-with-color.las", 1065)]
        [TestCase("ellipsoid", "laz/ellipsoid-1.4.laz", 100000)]
        [TestCase("example", "las/example.las", 30)]
        public void Sample_Twin_HasTheSamePoints(string name, string twin, int points)
        {
            string path = TestData.SampleOrIgnore("copc/" + name + ".copc.laz");
            using var reader = ReadPoints.Open(path);
            using var other = PointReaders.Open(TestData.SampleOrIgnore(twin));
            var names = PointMultiset.CommonNames(reader, other);
            // The twin's colours and intensities fill 16 bits, these 8.
            if (name == "ellipsoid")
                names = names.Except(new[]
                {
                    AttributeNames.Intensity, AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue,
                }).ToArray();
            Assert.That(names, Is.SupersetOf(new[] { AttributeNames.GpsTime, AttributeNames.PointSourceId }));
            PointMultiset.CheckTwins(reader, other, names, math.abs(reader.Info.Transform.Scale), points);
        }

        static void CheckPositions(PointReader reader)
        {
            var wanted = reader.Info.Schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z);
            var nodeOfBlock = Enumerable.Range(0, reader.Tree.NodeCount).Where(i => reader.Tree[i].Block >= 0)
                .ToDictionary(i => reader.Tree[i].Block, i => reader.Tree[i]);
            var step = 2 * math.abs(reader.Info.Transform.Scale);
            ReadPoints.EachBlock(reader, wanted, read =>
            {
                var node = nodeOfBlock[read.Range.Block];
                double edge = reader.Tree.EdgeOfLevel(node.Level);
                var min = reader.Tree.Cube.Min + edge * new double3(node.Cell.x, node.Cell.y, node.Cell.z);
                var box = new BoundsGeo(min - step, min + edge + step);
                var all = new BoundsGeo(reader.Info.BoundsClaimed.Min - step, reader.Info.BoundsClaimed.Max + step);
                var x = read.Points.Column<int>(0);
                var y = read.Points.Column<int>(1);
                var z = read.Points.Column<int>(2);
                bool isInside = true;
                for (int i = 0; i < read.Points.Count; i++)
                {
                    var geo = reader.Info.Transform.ToGeo(new double3(x[i], y[i], z[i]));
                    isInside &= box.Contains(geo) && all.Contains(geo);
                }
                Assert.That(isInside, "node " + node.Level + " " + node.Cell);
            });
        }
    }
}
