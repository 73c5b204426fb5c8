using System;
using System.Linq;
using FastPoints.Las;
using FastPoints.Sources;
using NUnit.Framework;

namespace FastPoints.Tests.Las
{
    public class LasVlrTableTests
    {
        const int VlrCountAt = 100, EvlrOffsetAt = 235, EvlrCountAt = 243;

        [Test]
        public void Records_BeforeAndAfterThePoints_AreListedWithTheirBytes()
        {
            using var file = new LasTestFile { Minor = 4, Format = 6, Padding = 2 }.RandomPoints(4)
                .Vlr("first", 1, new byte[] { 1, 2, 3 }).Vlr("second", 65535, new byte[0])
                .Evlr("third", 3, new byte[] { 9 }).Evlr("fourth", 4, new byte[70000]);
            file.Save();
            using var reader = (LasReader)PointReaders.Open(file.Path);
            Assert.That(reader.Vlrs.Records.Select(record => record.UserId + record.RecordId + record.IsExtended),
                Is.EqualTo(new[] { "first1False", "second65535False", "third3True", "fourth4True" }));
            Assert.That(reader.Vlrs.Records.Select(record => record.DataBytes), Is.EqualTo(new[] { 3L, 0, 1, 70000 }));
            Assert.That(reader.Vlrs.Payload(reader.Vlrs.Find("third", 3)).Bytes, Is.EqualTo(new byte[] { 9 }));
            Assert.That(reader.Vlrs.Find("third", 4), Is.Null);
            Assert.That(reader.Info.Warnings, Is.Empty);
            Assert.That(reader.Info.Facts.Where(fact => fact.Key == "EVLR").Select(fact => fact.Value),
                Is.EqualTo(new[] { "third/3, 1 bytes, a description", "fourth/4, 70000 bytes, a description" }));
        }

        [TestCase(3u), TestCase(uint.MaxValue)]
        public void Records_CountTooLarge_StopAtThePoints(uint count)
        {
            using var file = new LasTestFile().RandomPoints(40).Vlr("first", 1, new byte[10]);
            file.SaveWith(VlrCountAt, BitConverter.GetBytes(count));
            CheckOneRecordAndOneWarning(file, VlrCountAt, 40);
        }

        [Test]
        public void Records_LengthBeyondThePoints_IsSkipped()
        {
            using var file = new LasTestFile().RandomPoints(40).Vlr("first", 1, new byte[10]).Vlr("second", 2, new byte[10]);
            int second = 227 + 64;
            file.SaveWith(second + 20, BitConverter.GetBytes((ushort)11));
            CheckOneRecordAndOneWarning(file, second, 40);
        }

        [TestCase(0ul), TestCase(100ul), TestCase(1000000ul), TestCase(ulong.MaxValue)]
        public void Records_ExtendedStartAnywhere_PointsLoad(ulong start)
        {
            using var file = new LasTestFile { Minor = 4, Format = 6 }.RandomPoints(40).Vlr("first", 1, new byte[10])
                .Evlr("second", 2, new byte[10]);
            file.SaveWith(EvlrOffsetAt, BitConverter.GetBytes(start));
            using var reader = (LasReader)PointReaders.Open(file.Path);
            Assert.That(reader.Vlrs.Records.Count, Is.EqualTo(1));
            Assert.That(reader.PointCount, Is.EqualTo(40));
            Assert.That(reader.Info.Warnings.Any(warning => warning.ByteOffset == EvlrOffsetAt));
        }

        [Test]
        public void Records_ExtendedOfZeroBytesCountedWithoutEnd_EndWithTheFile()
        {
            using var file = new LasTestFile { Minor = 4, Format = 6 }.RandomPoints(40);
            for (int i = 0; i < 20; i++)
                file.Evlr("again", 1, new byte[0]);
            file.SaveWith(EvlrCountAt, BitConverter.GetBytes(uint.MaxValue));
            using var reader = (LasReader)PointReaders.Open(file.Path);
            Assert.That(reader.Vlrs.Records.Count, Is.EqualTo(20));
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(1));
        }

        [TestCase(11ul), TestCase(ulong.MaxValue), TestCase(0x7FFFFFFFFFFFFFFFul)]
        public void Records_ExtendedLengthBeyondTheFile_IsSkipped(ulong length)
        {
            using var file = new LasTestFile { Minor = 4, Format = 6 }.RandomPoints(40).Vlr("first", 1, new byte[10])
                .Evlr("second", 2, new byte[10]);
            int start = file.PointsOffset + file.Points.Length;
            file.SaveWith(start + 20, BitConverter.GetBytes(length));
            CheckOneRecordAndOneWarning(file, start, 40);
        }

        static void CheckOneRecordAndOneWarning(LasTestFile file, long at, int points)
        {
            using var reader = (LasReader)PointReaders.Open(file.Path);
            Assert.That(reader.Vlrs.Records.Count, Is.EqualTo(1));
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(1), string.Join("\n", reader.Info.Warnings));
            Assert.That(reader.Info.Warnings[0].ByteOffset, Is.EqualTo(at));
            Assert.That(reader.PointCount, Is.EqualTo(points));
        }
    }
}
