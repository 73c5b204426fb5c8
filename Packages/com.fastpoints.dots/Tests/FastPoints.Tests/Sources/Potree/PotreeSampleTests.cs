using System;
using System.IO;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Sources
{
    public class PotreeSampleTests
    {
        static string Sample(string index) => Path.GetDirectoryName(TestData.SampleOrIgnore("potree/" + index));

        /// <summary>PotreeConverter truncates (x - offset) / scale, whose last bits may lie below the whole number: so positions
        /// are the source's, or up to one step lower. Reading adds nothing to that, in either encoding.</summary>
        [TestCase("v2-autzen-brotli", "autzen_trim.laz", 93, 110000,
            "GpsTime,ReturnNumber,NumberOfReturns,Intensity,Classification,ScanAngle,UserData,PointSourceId,Red,Green,Blue")]
        [TestCase("v2-mixedconifer-default", "MixedConifer.laz", 157, 37657,
            "GpsTime,ReturnNumber,NumberOfReturns,Intensity,Classification,ScanAngle,UserData,PointSourceId,treeID")]
        public void Potree2_BesideItsSource_HasItsPoints(string folder, string laz, int nodes, int points, string names)
        {
            using var converted = ReadPoints.Open(Sample(folder + "/metadata.json"));
            using var source = ReadPoints.Open(TestData.SampleOrIgnore("laz/" + laz));
            Assert.That(converted.Info.Warnings, Is.Empty);
            Assert.That(converted.PointCount, Is.EqualTo(points));
            Assert.That(converted.Tree.NodeCount, Is.EqualTo(nodes));
            var transform = converted.Info.Transform;
            var expected = PotreeTwins.Hashes(source, names.Split(','),
                (geo, axis) => (int)((geo - transform.Offset[axis]) / transform.Scale[axis]));
            Assert.That(PotreeTwins.Hashes(converted, names.Split(','), null), Is.EqualTo(expected));
        }

        /// <summary>Potree 1.7 BIN beside a plain reading of its files: positions in double, within a step above Potree's own,
        /// and in their node's cell.</summary>
        [Test]
        public void Potree1_Bin_HasThePointsOfItsFiles()
        {
            string folder = Sample("lion_takanawa/cloud.js");
            using var reader = ReadPoints.Open(folder);
            Assert.That(reader.Info.Warnings, Is.Empty);
            Assert.That(reader.PointCount, Is.EqualTo(272768));
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(167));
            var scale = reader.Info.Transform.Scale.x;
            int node = 0;
            ReadPoints.EachBlock(reader, reader.Info.Schema, read =>
            {
                while (reader.Tree[node].Block != read.Range.Block)
                    node++;
                var cell = reader.Tree[node];
                string name = PotreeNames.NameOf(cell.Level, cell.Cell);
                var bytes = File.ReadAllBytes(Path.Combine(folder, "data", "r", name + ".bin"));
                Assert.That(bytes.Length, Is.EqualTo(18 * read.Points.Count), name);
                double edge = reader.Tree.EdgeOfLevel(cell.Level);
                for (int axis = 0; axis < 3; axis++)
                {
                    double corner = reader.Tree.Cube.Min[axis] + cell.Cell[axis] * edge;
                    var stored = read.Points.Column<int>(axis);
                    double min = double.MaxValue, max = double.MinValue;
                    for (int i = 0; i < read.Points.Count; i++)
                    {
                        double own = BitConverter.ToInt32(bytes, 18 * i + 4 * axis) * scale + corner;
                        double above = stored[i] * scale + reader.Info.Transform.Offset[axis] - own;
                        min = Math.Min(min, above);
                        max = Math.Max(max, above);
                    }
                    Assert.That(min, Is.GreaterThan(-1e-4 * scale), name);
                    Assert.That(max, Is.LessThan(scale), name);
                }
                var red = read.Points.Column<byte>("Red");
                var up = read.Points.Column<float>("NormalZ");
                for (int i = 0; i < read.Points.Count; i++)
                    if (red[i] != bytes[18 * i + 12]
                        || up[i] != PotreeNormals.FromSphereMap(bytes[18 * i + 16], bytes[18 * i + 17]).z)
                        Assert.Fail(name + ", point " + i);
            });
        }

        /// <summary>Potree 1.4 with LAZ nodes beside these files, opened one by one.</summary>
        [Test]
        public void Potree1_Laz_HasThePointsOfItsFiles()
        {
            string folder = Sample("lion_takanawa_laz/cloud.js");
            var names = new[] { "X", "Y", "Z", "Red", "Green", "Blue", "Intensity" };
            var sums = new ulong[names.Length];
            long points = 0;
            foreach (string path in Directory.GetFiles(Path.Combine(folder, "data"), "*.laz"))
                using (var node = PointReaders.Open(path))
                {
                    points += node.PointCount;
                    for (int i = 0; i < names.Length; i++)
                        foreach (ulong bits in PotreeTwins.Bits(node, names[i]))
                            sums[i] += bits;
                }
            using var reader = ReadPoints.Open(folder);
            Assert.That(points, Is.EqualTo(341989));
            Assert.That(reader.PointCount, Is.EqualTo(points));
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(200));
            for (int i = 0; i < names.Length; i++)
            {
                ulong sum = 0;
                foreach (ulong bits in PotreeTwins.Bits(reader, names[i]))
                    sum += bits;
                Assert.That(sum, Is.EqualTo(sums[i]), names[i]);
            }
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Potree2_PumpWithoutItsPoints_HasItsHierarchy()
        {
            using var reader = ReadPoints.Open(Sample("v2-pump-hierarchy/metadata.json"));
            Assert.That(reader.PointCount, Is.EqualTo(1213990));
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(490));
            Assert.That(reader.Tree.LevelCount, Is.EqualTo(7));
        }
    }
}
