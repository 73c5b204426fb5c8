using System;
using System.Linq;
using FastPoints.Las;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Las
{
    public class LasClaimsTests
    {
        const int CountAt = 107, Count64At = 247;

        [Test]
        public void Open_TruncatedFile_GivesCompleteRecordsAndWarns()
        {
            using var file = new LasTestFile().RandomPoints(10);
            var bytes = file.ToBytes();
            file.Save(bytes.Take(bytes.Length - 27).ToArray());
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.PointCount, Is.EqualTo(8));
            Assert.That(reader.Info.PointsClaimed, Is.EqualTo(10));
            Assert.That(ReadPoints.Column<int>(reader, AttributeNames.X).Length, Is.EqualTo(8));
            CheckWarning(reader, CountAt, "claims 10 points, the file holds 8 and 13 of the 20 bytes of the next");
        }

        [TestCase(0xFFFFFFFFul, 2), TestCase(11949411299132633685ul, 4), TestCase(ulong.MaxValue, 5)]
        public void Open_AbsurdCount_AllocatesByTheFilesSize(ulong claimed, int minor)
        {
            using var file = new LasTestFile { Minor = minor }.RandomPoints(10);
            file.SaveWith(minor < 4 ? CountAt : Count64At, minor < 4 ? BitConverter.GetBytes((uint)claimed)
                : BitConverter.GetBytes(claimed));
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.PointsClaimed, Is.EqualTo(claimed));
            Assert.That(reader.PointCount, Is.EqualTo(10));
            Assert.That(reader.MaxPointsPerBlock, Is.EqualTo(10));
            CheckWarning(reader, minor < 4 ? CountAt : Count64At, "the file holds 10");
        }

        [Test]
        public void Open_FileEndsBeforeTheFirstPoint_IsTruncated()
        {
            using var file = new LasTestFile().RandomPoints(10);
            file.Save(file.ToBytes().Take(227 + 19).ToArray());
            var failure = CheckFailure(file, FailureCode.Truncated, 227);
            Assert.That(failure.Message, Does.Contain("claims 10 points, the file holds 0 and 19 of the 20 bytes"));
        }

        [Test]
        public void Open_MorePointsThanClaimed_GivesTheClaimedAndReportsIt()
        {
            using var file = new LasTestFile().RandomPoints(10).SaveWith(CountAt, BitConverter.GetBytes(4));
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.PointCount, Is.EqualTo(4));
            CheckWarning(reader, CountAt, "room for 6 more");
        }

        [Test]
        public void Open_CountsThatDiffer_BelievesThe64BitOne()
        {
            using var file = new LasTestFile { Minor = 4 }.RandomPoints(10).SaveWith(CountAt, BitConverter.GetBytes(3));
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.PointCount, Is.EqualTo(10));
            CheckWarning(reader, CountAt, "the 32-bit point count is 3, the 64-bit one 10: 10 is used");
        }

        [Test]
        public void Open_64BitCountMissing_UsesThe32BitOne()
        {
            using var file = new LasTestFile { Minor = 4 }.RandomPoints(10).SaveWith(Count64At, BitConverter.GetBytes(0L));
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.PointCount, Is.EqualTo(10));
            CheckWarning(reader, CountAt, "10 is used");
        }

        [Test]
        public void Open_EvlrsAfterThePoints_AreNotReadAsPoints()
        {
            using var file = new LasTestFile { Minor = 4, Format = 6 }.RandomPoints(10).Evlr("user", 7, new byte[100]);
            file.SaveWith(Count64At, BitConverter.GetBytes(1000L));
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.PointCount, Is.EqualTo(10));
            Assert.That(((LasReader)reader).Vlrs.Records[0].DataBytes, Is.EqualTo(100));
        }

        [Test]
        public void Open_WaveformsAfterThePoints_AreNotReadAsPoints()
        {
            using var file = new LasTestFile { Minor = 3, Format = 4 }.RandomPoints(10);
            var bytes = file.ToBytes();
            BitConverter.GetBytes((long)bytes.Length).CopyTo(bytes, 227);
            BitConverter.GetBytes(1000).CopyTo(bytes, CountAt);
            file.Save(bytes.Concat(new byte[500]).ToArray());
            using (var reader = PointReaders.Open(file.Path))
                Assert.That(reader.PointCount, Is.EqualTo(10));
            BitConverter.GetBytes(10).CopyTo(bytes, CountAt);
            file.Save(bytes.Concat(new byte[500]).ToArray());
            using (var reader = PointReaders.Open(file.Path))
                Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Open_WaveformsAmongThePoints_BelievesTheCount()
        {
            using var file = new LasTestFile { Minor = 3 }.RandomPoints(10).SaveWith(227, BitConverter.GetBytes(300L));
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.PointCount, Is.EqualTo(10));
            CheckWarning(reader, 227, "among the points");
        }

        [TestCase(24, new byte[] { 2, 0 }, FailureCode.Unsupported, "LAS version: wanted 1.0 to 1.5, got 2.0")]
        [TestCase(25, new byte[] { 6 }, FailureCode.Unsupported, "got 1.6")]
        [TestCase(104, new byte[] { 11 }, FailureCode.Unsupported, "point format: wanted 0 to 10, got 11")]
        [TestCase(104, new byte[] { 0x80 }, FailureCode.BadInput, "no LASzip VLR")]
        [TestCase(105, new byte[] { 19, 0 }, FailureCode.BadInput, "record length of point format 0: wanted at least 20, got 19")]
        [TestCase(96, new byte[] { 226, 0, 0, 0 }, FailureCode.BadInput, "offset to point data: wanted at least 227, got 226")]
        [TestCase(96, new byte[] { 0, 0, 0, 255 }, FailureCode.Truncated, "claims 3 points, the file holds 0")]
        public void Open_UnreadableHeader_IsOneLineThatNamesTheField(int at, byte[] field, FailureCode code, string detail)
        {
            using var file = new LasTestFile().RandomPoints(3).SaveWith(at, field);
            var failure = Failures.Of(() => PointReaders.Open(file.Path).Dispose(), code);
            Assert.That(failure.ByteOffset, Is.GreaterThanOrEqualTo(0));
            Assert.That(failure.Message, Does.StartWith(file.Path).And.Contain(detail));
        }

        [Test]
        public void Open_HeaderTruncatedAnywhere_IsTruncated([Values(4, 24, 100, 226)] int bytes)
        {
            using var file = new LasTestFile().RandomPoints(3);
            file.Save(file.ToBytes().Take(bytes).ToArray());
            CheckFailure(file, FailureCode.Truncated, 0);
        }

        [TestCase(0.0), TestCase(double.NaN), TestCase(double.PositiveInfinity), TestCase(1e300)]
        public void Open_ScaleThatLosesPoints_IsTakenFromAnotherAxis(double scale)
        {
            using var file = new LasTestFile { Scale = new[] { 0.001, scale, 0.02 } }.Positions(1, 2, 3).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.Transform.Scale, Is.EqualTo(new double3(0.001, 0.001, 0.02)));
            CheckWarning(reader, 139, "scale of y");
        }

        [Test]
        public void Open_AllScalesZeroAndOffsetNaN_AssumesValuesWithAWarning()
        {
            using var file = new LasTestFile { Scale = new double[3], Offset = new[] { double.NaN, 5, double.NegativeInfinity } };
            file.Positions(1, 2, 3).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.Transform.Scale, Is.EqualTo(new double3(0.01, 0.01, 0.01)));
            Assert.That(reader.Info.Transform.Offset, Is.EqualTo(new double3(0, 5, 0)));
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(5));
        }

        [Test]
        public void Open_NegativeScale_IsKept()
        {
            using var file = new LasTestFile { Scale = new[] { 0.01, -0.01, 0.01 }, Min = new[] { 0, -1000.0, 0 } };
            file.Positions(100, 200, 300).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.Transform.ToGeo(new double3(0, 200, 0)).y, Is.EqualTo(-2));
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Open_BoundsInRawIntegers_AreScaledWithAWarning()
        {
            using var file = new LasTestFile
            {
                Scale = new[] { 0.001, 0.001, 0.001 },
                Offset = new[] { 0, 5e6, 0 },
                Min = new double[] { -235434519, 800843145, 265094 },
                Max = new double[] { -234935841, 800946249, 273811 },
            };
            file.Positions(-234935841, 800843145, 265094, -235434519, 800946249, 273811).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.HasBoundsClaimed);
            Assert.That(reader.Info.BoundsClaimed.Min, Is.EqualTo(reader.Info.Transform.ToGeo(
                new double3(-235434519, 800843145, 265094))));
            CheckWarning(reader, 179, "raw integers");
        }

        [Test]
        public void Open_BoundsSmallerThanThePoints_AreKeptWithAWarning()
        {
            using var file = new LasTestFile { Max = new double[] { 5, 5, 5 } }.Positions(1, 2, 3, 1000, 1000, 1000).Save();
            using var reader = PointReaders.Open(file.Path);
            CheckWarning(reader, 179, "leave out points");
        }

        [TestCase(0.0, 0.0, "all zero")]
        [TestCase(double.NaN, 1.0, "wanted a box")]
        [TestCase(5.0, 1.0, "wanted a box")]
        [TestCase(0.0, double.PositiveInfinity, "wanted a box")]
        public void Open_InvalidBounds_AreIgnoredWithAWarning(double min, double max, string detail)
        {
            using var file = new LasTestFile { Min = new[] { min, min, min }, Max = new[] { max, max, max } }.Positions(1, 2, 3)
                .Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.HasBoundsClaimed, Is.False);
            CheckWarning(reader, 179, detail);
            Assert.That(ReadPoints.Column<int>(reader, AttributeNames.Z), Is.EqualTo(new[] { 3 }));
        }

        [Test]
        public void Open_HeaderSizeBelowItsVersions_TakesLaterFieldsAsAbsent()
        {
            using var file = new LasTestFile { Minor = 4 }.RandomPoints(10).SaveWith(94, BitConverter.GetBytes((ushort)227));
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.PointCount, Is.EqualTo(10));
            CheckWarning(reader, 94, "header size: wanted 375 for LAS 1.4, got 227");
        }

        [Test]
        public void Open_PointsInsideTheHeader_Warns()
        {
            using var file = new LasTestFile { Minor = 4 }.RandomPoints(10).SaveWith(96, BitConverter.GetBytes(300));
            using var reader = PointReaders.Open(file.Path);
            CheckWarning(reader, 96, "inside the header");
        }

        static PointCloudException CheckFailure(LasTestFile file, FailureCode code, long at)
        {
            var failure = Failures.Of(() => PointReaders.Open(file.Path).Dispose(), code);
            Assert.That(failure.ByteOffset, Is.EqualTo(at));
            Assert.That(failure.Path, Is.EqualTo(file.Path));
            return failure;
        }

        static void CheckWarning(PointReader reader, long at, string detail)
        {
            Assert.That(reader.Info.Warnings.Count, Is.GreaterThan(0));
            Assert.That(reader.Info.Warnings.Any(warning => warning.ByteOffset == at && warning.Text.Contains(detail)),
                string.Join("\n", reader.Info.Warnings));
        }
    }
}
