using System;
using System.IO;
using FastPoints.Las;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Mathematics;
using static FastPoints.Tests.Sources.EptTestClouds;

namespace FastPoints.Tests.Sources
{
    public class EptLazNodeTests
    {
        [TestCase(0, 3, 100), TestCase(1, 0, 100), TestCase(4, 7, 100), TestCase(2, 7, 3000)]
        public void LazNode_OnAnotherGrid_IsPlacedExactly(int workers, int format, int maxNodePoints)
        {
            var grids = new (long Factor, long Shift)[] { (1, 0), (1, -123456), (5, 7), (-1, 40), (1000, -1), (1, 1L << 20) };
            using (new WorkerCount(workers))
            using (var folder = Make(EptDataType.Laszip, 6000, 99, format, maxNodePoints))
            {
                for (int i = 1; i < folder.Nodes.Count; i++)
                    folder.MoveToGrid(folder.Nodes[i], grids[i % grids.Length].Factor, grids[i % grids.Length].Shift);
                using var reader = ReadPoints.Open(folder.Path);
                CheckNodes(reader, folder, 3, false);
                Assert.That(reader.Info.Warnings, Is.Empty);
                Assert.That(reader.Info.Transform.Scale, Is.EqualTo(new double3(0.01, 0.01, 0.01)));
            }
        }

        [TestCase(0.003, 0), TestCase(0.02, 0.015), TestCase(0.01, 1e9), TestCase(1e9, 0), TestCase(0, 0)]
        [TestCase(double.NaN, 0), TestCase(0.01, double.PositiveInfinity)]
        public void LazNode_OffTheGrid_IsAHole(double scale, double offset)
        {
            using var folder = Make(EptDataType.Laszip);
            var node = folder.Nodes[1];
            folder.WriteNode(node, node.Records, scale, offset);
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(Count(reader), Is.EqualTo(1500 - node.Records.Count));
            CheckWarned(reader, "do not lie on the root's grid");
        }

        [Test]
        public void LazNode_PositionBeyond32Bits_EndsBeforeIt()
        {
            using var folder = Make(EptDataType.Laszip);
            var node = folder.Nodes[1];
            foreach (var record in node.Records)
                Array.Clear(record, 0, 12);
            BitConverter.GetBytes(int.MinValue + 7).CopyTo(node.Records[19], 4);
            BitConverter.GetBytes(int.MinValue + 6).CopyTo(node.Records[20], 4);
            folder.WriteNode(node, node.Records, 0.01, -0.07);
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(Count(reader), Is.EqualTo(1500 - node.Records.Count + 20));
            CheckWarned(reader, "do not lie on the root's grid");
        }

        [TestCase(LasHeader.At.RecordBytes), TestCase(LasHeader.At.PointFormat), TestCase(0)]
        public void LazNode_OfAnotherKind_IsAHole(int at)
        {
            using var folder = Make(EptDataType.Laszip);
            string path = folder.DataPath(EptFolder.NameOf(folder.Nodes[1]));
            var bytes = File.ReadAllBytes(path);
            bytes[at] ^= 1;
            File.WriteAllBytes(path, bytes);
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(Count(reader), Is.EqualTo(1500 - folder.Nodes[1].Records.Count));
            CheckWarned(reader, "not what the other nodes' are");
        }

        [Test]
        public void LazNode_WithMorePointsThanClaimed_IsReported()
        {
            using var folder = Make(EptDataType.Laszip);
            string page = File.ReadAllText(folder.PagePath("0-0-0-0"));
            File.WriteAllText(folder.PagePath("0-0-0-0"), page.Replace("\"0-0-0-0\": 100", "\"0-0-0-0\": 90"));
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(Count(reader), Is.EqualTo(1490));
            CheckWarned(reader, "another number of points");
        }
    }
}
