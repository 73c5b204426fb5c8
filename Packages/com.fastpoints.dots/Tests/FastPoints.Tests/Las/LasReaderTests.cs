using System;
using System.Collections.Generic;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Las
{
    [Category("Smoke")]
    public class LasReaderTests
    {
        static IEnumerable<int[]> VersionsAndFormats()
        {
            for (int minor = 0; minor <= 5; minor++)
                for (int format = 0; format <= (minor < 3 ? 3 : minor < 4 ? 5 : 10); format++)
                    yield return new[] { minor, format };
        }

        [TestCaseSource(nameof(VersionsAndFormats))]
        public void Open_EachVersionAndFormat_ReportsWhatTheHeaderSays(int[] versionAndFormat)
        {
            var built = new LasTestFile { Minor = versionAndFormat[0], Format = versionAndFormat[1] };
            using var file = built.RandomPoints(7).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.Format, Is.EqualTo("LAS"));
            Assert.That(reader.Info.Version, Is.EqualTo("1." + file.Minor));
            Assert.That(reader.Info.PointFormat, Is.EqualTo(file.Format));
            Assert.That(reader.Info.RecordBytes, Is.EqualTo(file.RecordBytes));
            Assert.That(reader.Info.PointsClaimed, Is.EqualTo(7));
            Assert.That(reader.Info.PointsReadable, Is.EqualTo(7));
            Assert.That(reader.PointCount, Is.EqualTo(7));
            Assert.That(reader.Info.BoundsClaimed.Max, Is.EqualTo(new double3(1000, 1000, 1000)));
            Assert.That(reader.Info.Transform.Scale, Is.EqualTo(new double3(0.01, 0.01, 0.01)));
            Assert.That(reader.Info.Warnings, Is.Empty);
            Assert.That(reader.Info.Facts, Has.Some.EqualTo(new KeyValuePair<string, string>("created", "day 36 of 2024")));
        }

        [Test]
        public void Read_AllColumns_AreTheRecordsBits([Range(0, 10)] int format)
        {
            using var file = new LasTestFile { Minor = 4, Format = format }.RandomPoints(3000, format + 1).Save();
            using var reader = PointReaders.Open(file.Path);
            long read = ReadPoints.EachBlock(reader, reader.Info.Schema, slot =>
            {
                for (int i = 0; i < slot.Points.Count; i++)
                    CheckPoint(slot.Points, i, file.Points, i * file.RecordBytes, format);
            });
            Assert.That(read, Is.EqualTo(3000));
        }

        [Test]
        public void Read_AnyRangeAndSelection_MatchesTheWhole()
        {
            using var file = new LasTestFile { Minor = 4, Format = 10, ExtraBytes = 3 }.RandomPoints(5000).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.HasCheapRanges);
            var whole = ReadPoints.Column<int>(reader, AttributeNames.Y);
            var red = ReadPoints.Column<ushort>(reader, AttributeNames.Red);
            var wanted = reader.Info.Schema.Select(AttributeNames.Y, AttributeNames.Red, "ExtraBytes[2]");
            Assert.That(wanted.Count, Is.EqualTo(3));
            using var slot = reader.CreateRead(wanted, 700, Allocator.Persistent);
            foreach (var (first, count) in new[] { (0, 700), (4999, 1), (1234, 513), (17, 0), (4300, 700), (1, 2) })
            {
                slot.Begin(new BlockRange(0, first, count));
                slot.Complete();
                Assert.That(slot.Points.Count, Is.EqualTo(count));
                Assert.That(slot.FirstPoint, Is.EqualTo(first));
                for (int i = 0; i < count; i++)
                {
                    Assert.That(slot.Points.Column<int>(0)[i], Is.EqualTo(whole[first + i]));
                    Assert.That(slot.Points.Column<ushort>(1)[i], Is.EqualTo(red[first + i]));
                    Assert.That(slot.Points.Column<byte>(2)[i], Is.EqualTo(file.Points[(first + i) * file.RecordBytes + 69]));
                }
            }
        }

        [TestCase(AttributeNames.X, AttributeNames.Y, AttributeNames.Z)]
        [TestCase(AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue)]
        [TestCase(AttributeNames.X, AttributeNames.Z, AttributeNames.Green, AttributeNames.Blue)]
        [TestCase(AttributeNames.Y, AttributeNames.Z, AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue)]
        public void Read_NeighboursInOnePassOrAlone_AreTheSame(params string[] names)
        {
            var positions = new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            var colors = new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue };
            using var file = new LasTestFile { Format = 2 }.RandomPoints(2000).Save();
            using var reader = PointReaders.Open(file.Path);
            ReadPoints.EachBlock(reader, reader.Info.Schema.Select(names), slot =>
            {
                for (int i = 0; i < 2000; i++)
                    foreach (string name in names)
                    {
                        int axis = Array.IndexOf(positions, name), color = Array.IndexOf(colors, name);
                        if (axis >= 0)
                            Check<int>(slot.Points, i, name, BitConverter.ToInt32(file.Points, i * 26 + 4 * axis));
                        else
                            Check<ushort>(slot.Points, i, name, BitConverter.ToUInt16(file.Points, i * 26 + 20 + 2 * color));
                    }
            });
        }

        [Test]
        public void Read_ManyBlocks_GivesEachPointOnce()
        {
            const int Count = 2 * 32768 + 123;
            using var file = new LasTestFile();
            file.Points = new byte[Count * file.RecordBytes];
            for (int i = 0; i < Count; i++)
                BitConverter.GetBytes(i).CopyTo(file.Points, i * file.RecordBytes);
            file.Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.BlockCount, Is.EqualTo(3));
            Assert.That(reader.PointsInBlock(2), Is.EqualTo(123));
            Assert.That(reader.FirstPointOfBlock(2), Is.EqualTo(2 * 32768));
            Assert.That(reader.MaxPointsPerBlock, Is.EqualTo(32768));
            var x = ReadPoints.Column<int>(reader, AttributeNames.X);
            for (int i = 0; i < Count; i++)
                if (x[i] != i)
                    Assert.That(x[i], Is.EqualTo(i));
        }

        [Test]
        public void Read_IntegerLimitsAndFineOrFarGrids_AreExact()
        {
            using var file = new LasTestFile
            {
                Scale = new[] { 1e-7, 1e-7, 1e-3 },
                Offset = new[] { 1e7, -1e7, 0.5 },
                Min = new[] { 1e7 - 215, -1e7 - 215, -2147484 },
                Max = new[] { 1e7 + 215, -1e7 + 215, 2147484 },
            };
            file.Positions(int.MinValue, int.MaxValue, 0, int.MaxValue, int.MinValue, 1, -1, 1, int.MinValue).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(ReadPoints.Column<int>(reader, AttributeNames.X), Is.EqualTo(new[] { int.MinValue, int.MaxValue, -1 }));
            Assert.That(ReadPoints.Column<int>(reader, AttributeNames.Y), Is.EqualTo(new[] { int.MaxValue, int.MinValue, 1 }));
            Assert.That(ReadPoints.Column<int>(reader, AttributeNames.Z), Is.EqualTo(new[] { 0, 1, int.MinValue }));
            var geo = reader.Info.Transform.ToGeo(new double3(-1, 1, 1));
            Assert.That(geo.x, Is.EqualTo(1e7 - 1e-7));
            Assert.That(geo.y, Is.EqualTo(-1e7 + 1e-7));
            Assert.That(geo.z, Is.EqualTo(0.501).Within(1e-15));
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Begin_RangeOutsideItsBlock_IsRefused()
        {
            using var file = new LasTestFile().RandomPoints(10).Save();
            using var reader = PointReaders.Open(file.Path);
            using var slot = reader.CreateRead(reader.Info.Schema, 8, Allocator.Persistent);
            Assert.That(() => slot.Begin(new BlockRange(0, 5, 6)), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => slot.Begin(new BlockRange(0, 0, 9)), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => slot.Begin(new BlockRange(0, -1, 2)), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => slot.Begin(new BlockRange(1, 0, 1)), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => reader.CreateRead(new PointSchema(new[] { new PointAttribute("None", AttributeType.UInt8) }), 8,
                Allocator.Persistent), Throws.ArgumentException);
        }

        [Test]
        public void Complete_FileBecameShorter_IsTruncatedAndNotFewerPoints()
        {
            using var file = new LasTestFile().RandomPoints(100).Save();
            using var reader = PointReaders.Open(file.Path);
            using var slot = reader.CreateRead(reader.Info.Schema, 100, Allocator.Persistent);
            using (var stream = System.IO.File.Open(file.Path, System.IO.FileMode.Open, System.IO.FileAccess.Write,
                System.IO.FileShare.ReadWrite))
                stream.SetLength(file.PointsOffset + 40 * 20 + 7);
            slot.Begin(new BlockRange(0, 0, 100));
            Failures.Of(() => slot.Complete(), FailureCode.Truncated, "wanted 100 points", "got 40");
            Assert.That(slot.Points.Count, Is.Zero);
        }

        [Test]
        public void Dispose_WithAReadInFlight_WaitsAndFreesTwice()
        {
            using var file = new LasTestFile().RandomPoints(30000).Save();
            using var reader = PointReaders.Open(file.Path);
            var slot = reader.CreateRead(reader.Info.Schema, 30000, Allocator.Persistent);
            slot.Begin(new BlockRange(0, 0, 30000));
            Assert.That(() => slot.Begin(new BlockRange(0, 0, 1)), Throws.InvalidOperationException);
            slot.Dispose();
            slot.Dispose();
            reader.Dispose();
        }

        [Test]
        public void Open_ZeroPoints_IsAnEmptyCloud()
        {
            using var file = new LasTestFile { Max = new double[] { 0, 0, 0 } }.Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.PointCount, Is.Zero);
            Assert.That(reader.BlockCount, Is.Zero);
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        static void CheckPoint(PointBatch points, int i, byte[] bytes, int at, int format)
        {
            byte returns = bytes[at + 14], flags = bytes[at + 15];
            Check<int>(points, i, AttributeNames.X, BitConverter.ToInt32(bytes, at));
            Check<int>(points, i, AttributeNames.Y, BitConverter.ToInt32(bytes, at + 4));
            Check<int>(points, i, AttributeNames.Z, BitConverter.ToInt32(bytes, at + 8));
            Check<ushort>(points, i, AttributeNames.Intensity, BitConverter.ToUInt16(bytes, at + 12));
            if (format < 6)
            {
                Check<byte>(points, i, AttributeNames.ReturnNumber, (byte)(returns & 7));
                Check<byte>(points, i, AttributeNames.NumberOfReturns, (byte)(returns >> 3 & 7));
                Check<byte>(points, i, AttributeNames.ScanDirectionFlag, (byte)(returns >> 6 & 1));
                Check<byte>(points, i, AttributeNames.EdgeOfFlightLine, (byte)(returns >> 7));
                Check<byte>(points, i, AttributeNames.Classification, (byte)(flags & 31));
                Check<byte>(points, i, AttributeNames.Synthetic, (byte)(flags >> 5 & 1));
                Check<byte>(points, i, AttributeNames.KeyPoint, (byte)(flags >> 6 & 1));
                Check<byte>(points, i, AttributeNames.Withheld, (byte)(flags >> 7));
                Check<sbyte>(points, i, AttributeNames.ScanAngle, (sbyte)bytes[at + 16]);
                Check<byte>(points, i, AttributeNames.UserData, bytes[at + 17]);
                Check<ushort>(points, i, AttributeNames.PointSourceId, BitConverter.ToUInt16(bytes, at + 18));
            }
            else
            {
                Check<byte>(points, i, AttributeNames.ReturnNumber, (byte)(returns & 15));
                Check<byte>(points, i, AttributeNames.NumberOfReturns, (byte)(returns >> 4));
                Check<byte>(points, i, AttributeNames.Synthetic, (byte)(flags & 1));
                Check<byte>(points, i, AttributeNames.KeyPoint, (byte)(flags >> 1 & 1));
                Check<byte>(points, i, AttributeNames.Withheld, (byte)(flags >> 2 & 1));
                Check<byte>(points, i, AttributeNames.Overlap, (byte)(flags >> 3 & 1));
                Check<byte>(points, i, AttributeNames.ScannerChannel, (byte)(flags >> 4 & 3));
                Check<byte>(points, i, AttributeNames.ScanDirectionFlag, (byte)(flags >> 6 & 1));
                Check<byte>(points, i, AttributeNames.EdgeOfFlightLine, (byte)(flags >> 7));
                Check<byte>(points, i, AttributeNames.Classification, bytes[at + 16]);
                Check<byte>(points, i, AttributeNames.UserData, bytes[at + 17]);
                Check<short>(points, i, AttributeNames.ScanAngle, BitConverter.ToInt16(bytes, at + 18));
                Check<ushort>(points, i, AttributeNames.PointSourceId, BitConverter.ToUInt16(bytes, at + 20));
            }
            int[] timeAt = { -1, 20, -1, 20, 20, 20, 22, 22, 22, 22, 22 };
            int[] colorAt = { -1, -1, 20, 28, -1, 28, -1, 30, 30, -1, 30 };
            int[] waveAt = { -1, -1, -1, -1, 28, 34, -1, -1, -1, 30, 38 };
            if (timeAt[format] >= 0)
                Check<long>(points, i, AttributeNames.GpsTime, BitConverter.ToInt64(bytes, at + timeAt[format]));
            if (colorAt[format] >= 0)
            {
                Check<ushort>(points, i, AttributeNames.Red, BitConverter.ToUInt16(bytes, at + colorAt[format]));
                Check<ushort>(points, i, AttributeNames.Green, BitConverter.ToUInt16(bytes, at + colorAt[format] + 2));
                Check<ushort>(points, i, AttributeNames.Blue, BitConverter.ToUInt16(bytes, at + colorAt[format] + 4));
            }
            if (format == 8 || format == 10)
                Check<ushort>(points, i, AttributeNames.NearInfrared, BitConverter.ToUInt16(bytes, at + 36));
            int wave = at + waveAt[format];
            if (waveAt[format] < 0)
                return;
            Check<byte>(points, i, AttributeNames.WavePacketDescriptorIndex, bytes[wave]);
            Check<ulong>(points, i, AttributeNames.ByteOffsetToWaveformData, BitConverter.ToUInt64(bytes, wave + 1));
            Check<uint>(points, i, AttributeNames.WaveformPacketSize, BitConverter.ToUInt32(bytes, wave + 9));
            Check<int>(points, i, AttributeNames.ReturnPointWaveformLocation, BitConverter.ToInt32(bytes, wave + 13));
            Check<int>(points, i, AttributeNames.ParametricDx, BitConverter.ToInt32(bytes, wave + 17));
            Check<int>(points, i, AttributeNames.ParametricDy, BitConverter.ToInt32(bytes, wave + 21));
            Check<int>(points, i, AttributeNames.ParametricDz, BitConverter.ToInt32(bytes, wave + 25));
        }

        // Floats are compared by their bits, so that NaN equals itself.
        static void Check<T>(PointBatch points, int i, string name, T wanted) where T : unmanaged, IEquatable<T>
        {
            T got = points.Column<T>(name)[i];
            if (!got.Equals(wanted))
                Assert.That(got, Is.EqualTo(wanted), name + " of point " + i);
        }
    }
}
