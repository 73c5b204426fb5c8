using System;
using System.Linq;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Mathematics;
using static FastPoints.Tests.E57.E57TestScans;

namespace FastPoints.Tests.E57
{
    public class E57ManyScansTests
    {
        [TestCase(false, false)]
        [TestCase(true, false)]
        [TestCase(true, true)]
        public void Open_PosesOfScans_AreTheScannersIfAllHaveOne(bool first, bool second)
        {
            E57TestScan Scan(int x, bool hasPose)
            {
                var scan = Floats(10);
                scan.Xml = hasPose ? E57TestScan.Pose(1, 0, 0, 0, x, 20, 30) : "";
                return scan;
            }
            double3 a = new double3(10, 20, 30), b = new double3(11, 20, 30);
            Assert.That(FileContents.OfE57(File(Scan(10, first), Scan(11, second))).Info.Scanners,
                Is.EqualTo(second ? new[] { a, b } : null));
            Assert.That(FileContents.OfE57(File(Scan(10, first))).Info.Scanners, Is.EqualTo(first ? new[] { a } : null));
        }

        [Test]
        public void Read_SeveralScansOnOneGrid_KeepsTheirDigits()
        {
            var moved = Grid(100, 0.001, 0.25, 8);
            moved.Xml = E57TestScan.Pose(1, 0, 0, 0, 1000, -2, 0.5);
            var first = Grid(50);
            var contents = FileContents.OfE57(File(first, moved));
            Assert.That(contents.HasFact("whole numbers, as stored"));
            int[] x = contents.Column<int>("X");
            for (int i = 0; i < 50; i++)
                Assert.That(x[i], Is.EqualTo(first.Fields[0].Integers[i]));
            for (int i = 0; i < 100; i++)
                Assert.That(x[50 + i], Is.EqualTo(moved.Fields[0].Integers[i] + 1000250));
            Assert.That(contents.Column<ushort>("PointSourceId"),
                Is.EqualTo(Enumerable.Repeat((ushort)1, 50).Concat(Enumerable.Repeat((ushort)2, 100))));
        }

        [Test]
        public void Read_ManyScansSomeEmpty_GivesEachItsPoints()
        {
            var scans = Enumerable.Range(0, 60).Select(i => Floats(i % 3 == 1 ? 0 : 5 + i, i * 1000)).ToArray();
            var contents = FileContents.OfE57(File(scans));
            Assert.That(contents.Blocks, Is.EqualTo(40));
            Assert.That(contents.Column<float>("X"),
                Is.EqualTo(scans.SelectMany(scan => scan.Fields[0].Reals).Select(v => (float)v)));
        }

        [Test]
        public void Read_ScansOfDifferentKinds_AreDoubles()
        {
            var contents = FileContents.OfE57(File(Grid(20, 0.001), Floats(10), Grid(20, 0.01)));
            Assert.That(contents.TypeOf("X"), Is.EqualTo(AttributeType.Float64));
            double[] x = contents.Column<double>("X");
            Assert.That(x[0], Is.EqualTo(Grid(20).Fields[0].Integers[0] * 0.001));
            Assert.That(x[21], Is.EqualTo(0.25));
        }

        [TestCase(0.001, 0.005, 0.001, 5), TestCase(0.01, 0.025, 0.005, 5), TestCase(0.001, -0.002, 0.001, -2)]
        [TestCase(1, 0.25, 0.25, 1), TestCase(1e-6, 1, 1e-6, 1000000)]
        public void Read_ScansOfDifferentScales_ShareOneExactGrid(double first, double second, double step, long factor)
        {
            var moved = Grid(40, second, 12, 2);
            moved.Xml = E57TestScan.Pose(1, 0, 0, 0, 1000, -2, 0.5);
            var scans = new[] { Grid(300, first, -3), moved };
            var contents = FileContents.OfE57(File(scans));
            Assert.That(contents.HasFact("on one grid that holds all exactly"));
            string[] names = { "X", "Y", "Z" };
            double[] pose = { 1000, -2, 0.5 };
            for (int axis = 0; axis < 3; axis++)
            {
                Assert.That(contents.Info.Transform.Scale[axis], Is.EqualTo(step).Within(1).Ulps);
                double offset = contents.Info.Transform.Offset[axis];
                long shiftOfFirst = (long)Math.Round((-3 - offset) / step),
                    shift = (long)Math.Round((12 + pose[axis] - offset) / step);
                long factorOfFirst = (long)Math.Round(first / step);
                Assert.That(Math.Abs(offset + shift * step - 12 - pose[axis]), Is.LessThan(1e-9));
                Assert.That(Integers(contents, names[axis]), Is.EqualTo(
                    scans[0].Fields[axis].Integers.Select(v => v * factorOfFirst + shiftOfFirst).Concat(
                    scans[1].Fields[axis].Integers.Select(v => v * factor + shift))));
            }
            var alone = FileContents.OfE57(File(scans), "Y");
            Assert.That(alone.Bytes("Y"), Is.EqualTo(contents.Bytes("Y")));
        }

        [TestCase(0.001, 0.0003, 0), TestCase(0.01, 0.02, 0.0033333333), TestCase(1, 1e-9, 0)]
        public void Read_ScansWithoutACommonStep_AreDoubles(double first, double second, double offset)
        {
            var scans = new[] { Grid(20, first), Grid(30, second, offset, 2) };
            var contents = FileContents.OfE57(File(scans));
            Assert.That(contents.TypeOf("X"), Is.EqualTo(AttributeType.Float64));
            Assert.That(contents.Column<double>("X"), Is.EqualTo(scans[0].Fields[0].Integers.Select(v => v * first).Concat(
                scans[1].Fields[0].Integers.Select(v => v * second + offset))));
        }

        [Test]
        public void Read_ScansWithDifferentFields_HaveZeroWhereOneIsMissing()
        {
            var with = Floats(3);
            with.Fields.Add(E57TestField.Integer("intensity", 10, 4000, 10, 20, 4000));
            var wider = Floats(2);
            wider.Fields.Add(E57TestField.Integer("intensity", -5, 70000, -5, 70000));
            var contents = FileContents.OfE57(File(with, Floats(2), wider));
            Assert.That(contents.Column<int>("Intensity"), Is.EqualTo(new[] { 10, 20, 4000, 0, 0, -5, 70000 }));
            Assert.That(contents.HasWarning("Intensity is there in 2 of 3 scans"));
        }
    }
}
