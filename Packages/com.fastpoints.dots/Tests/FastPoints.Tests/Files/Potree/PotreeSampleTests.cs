using System.IO;
using FastPoints.Tests;
using NUnit.Framework;

namespace FastPoints.Files.Tests
{
    /// <summary>Trees by PotreeConverter itself, beside the files that they were made from.</summary>
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
            using (var converted = PotreeTwins.Open(Sample(folder + "/metadata.json")))
            using (var source = PotreeTwins.Open(TestData.SampleOrIgnore("laz/" + laz)))
            {
                Assert.That(converted.Info.Warnings, Is.Empty);
                Assert.That(converted.PointCount, Is.EqualTo(points));
                Assert.That(converted.Tree.NodeCount, Is.EqualTo(nodes));
                var transform = converted.Info.Transform;
                var expected = PotreeTwins.Hashes(source, names.Split(','),
                    (geo, axis) => (int)((geo - transform.Offset[axis]) / transform.Scale[axis]));
                Assert.That(PotreeTwins.Hashes(converted, names.Split(','), null), Is.EqualTo(expected));
            }
        }
    }
}
