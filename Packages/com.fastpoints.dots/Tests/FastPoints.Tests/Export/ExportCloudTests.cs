using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Export;
using FastPoints.Las;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Streaming;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Export
{
    public class ExportCloudTests
    {
        TemporaryFolder m_folder;

        [SetUp]
        public void MakeFolder() => m_folder = new TemporaryFolder();

        [TearDown]
        public void RemoveFolder() => m_folder.Dispose();

        static ExportResult Run(PointReader reader, string path, ExportSettings settings = null)
        {
            ExportResult result = null;
            JobCoroutine.RunToEnd(ExportCloud.Run(reader, path, settings ?? new ExportSettings(), r => result = r, null));
            return result;
        }

        static IEnumerable<string> MatrixFiles() => TestData.TryPath("data/laszip-matrix", out string folder)
            ? Directory.GetFiles(folder, "*.laz").Select(Path.GetFileName).OrderBy(name => name, StringComparer.Ordinal)
            : new[] { "none" };

        [Test]
        public void Run_EachPointFormat_WritesEveryRecordInOrder([Range(0, 10)] int format, [Values(0, 3)] int extra)
        {
            var writer = new LazFileWriter
            {
                PointFormat = format,
                ItemVersion = format < 6 ? 2 : 3,
                ExtraBytes = extra,
                ChunkPoints = new[] { 2500 },
            };
            var records = LazRecords.Make(format, extra, 9000, 7 + format);
            string source = m_folder.Write("source.laz", writer.Write(records)), laz = m_folder.File("out.laz");
            using (var reader = PointReaders.Open(source))
            {
                Assert.That(Run(reader, laz).Points, Is.EqualTo(records.Count));
                Run(reader, m_folder.File("out.las"));
            }
            var truth = records.SelectMany(record => record).ToArray();
            foreach (string path in new[] { laz, m_folder.File("out.las") })
            {
                using var reader = LazFileReading.Open(path);
                Assert.That(reader.Info.Warnings.Where(w => !w.Text.StartsWith("the bounds")), Is.Empty);
                Assert.That(LazFileReading.Difference(LazFileReading.Records(reader, LazFileReading.LayoutOf(path)), truth,
                    writer.RecordBytes), Is.Null, path);
            }
            // LazModelTests has what these bytes must be.
            var chunk = LazEncoder.Chunk(writer.Items(), records);
            var bytes = File.ReadAllBytes(laz);
            int at = (int)BitConverter.ToUInt32(bytes, 96) + 8;
            Assert.That(bytes.Skip(at).Take(chunk.Length).SequenceEqual(chunk), Is.True, "the chunk's bytes");
            Assert.That(BitConverter.ToInt64(bytes, at - 8), Is.EqualTo(at + chunk.Length), "where the table is");
        }

        [TestCase(1), TestCase(2), TestCase(4095), TestCase(4096), TestCase(4097), TestCase(50000), TestCase(50001)]
        public void Run_ChunksOfEachLength_AreRead(int points)
        {
            foreach (int format in new[] { 3, 7 })
            {
                var records = LazRecords.Make(format, 0, points, points);
                var writer = new LazFileWriter { PointFormat = format, ItemVersion = format < 6 ? 2 : 3 };
                string path = m_folder.File("out.laz");
                using (var source = PointReaders.Open(m_folder.Write("source.laz", writer.Write(records))))
                    Run(source, path);
                using var reader = LazFileReading.Open(path);
                Assert.That(LazFileReading.Difference(LazFileReading.Records(reader, LazFileReading.LayoutOf(path)),
                    records.SelectMany(record => record).ToArray(), writer.RecordBytes), Is.Null);
            }
        }

        [TestCaseSource(nameof(MatrixFiles))]
        public void Run_FilesOfLASzip_GivesEveryRecordInOrder(string name)
        {
            string source = TestData.PathOrIgnore("data/laszip-matrix/" + name), path = m_folder.File("out.laz");
            using var from = LazFileReading.Open(source);
            Run(from, path);
            using var to = LazFileReading.Open(path);
            var layout = LazFileReading.LayoutOf(source);
            Assert.That(LazFileReading.Difference(LazFileReading.Records(to, LazFileReading.LayoutOf(path)),
                LazFileReading.Records(from, layout), layout.RecordBytes), Is.Null);
            Assert.That(to.Info.Crs.Summary, Is.EqualTo(from.Info.Crs.Summary));
            Assert.That(to.Info.Transform, Is.EqualTo(from.Info.Transform));
        }

        [Test]
        public void Run_Doubles_StatesTheError()
        {
            var random = new System.Random(5);
            var points = Enumerable.Range(0, 20000).Select(_ => 1000 + 90 * new double3(random.NextDouble(),
                random.NextDouble(), random.NextDouble())).ToArray();
            using var source = new MemoryPointReader(TestBatches.OfPositions(points), 3000);
            var result = Run(source, m_folder.File("out.las"));
            double worst = 0;
            int i = 0;
            using var reader = PointReaders.Open(m_folder.File("out.las"));
            ReadPoints.EachBlock(reader, reader.Info.Schema, read =>
            {
                for (int p = 0; p < read.Points.Count; p++, i++)
                {
                    var stored = new double3(read.Points.Column<int>(0)[p], read.Points.Column<int>(1)[p],
                        read.Points.Column<int>(2)[p]);
                    worst = Math.Max(worst, math.cmax(math.abs(reader.Info.Transform.ToGeo(stored) - points[i])));
                }
            });
            Assert.That(i, Is.EqualTo(points.Length));
            Assert.That(worst, Is.GreaterThan(0).And.LessThanOrEqualTo(1e-5));
            Assert.That(result.PositionError, Is.EqualTo(worst).Within(1e-12));
        }

        [Test]
        public void Run_NonFinitePositions_AreSkippedInLasAndKeptInPly()
        {
            using var source = new MemoryPointReader(TestBatches.OfPositions(new double3(1, 2, 3),
                new double3(double.NaN, 2, 3), new double3(4, double.NegativeInfinity, 6), new double3(7, 8, 9)), 2);
            var las = Run(source, m_folder.File("out.las"));
            Assert.That((las.Points, las.PointsLeftOut), Is.EqualTo((2L, 2L)));
            var ply = Run(source, m_folder.File("out.ply"));
            Assert.That((ply.Points, ply.PointsLeftOut, ply.PositionError), Is.EqualTo((4L, 0L, 0.0)));
            using var reader = PointReaders.Open(m_folder.File("out.ply"));
            Assert.That(reader.PointCount, Is.EqualTo(4));
        }

        [Test]
        public void Run_CoordinatesOfAnySize_AreWrittenOrCounted([Values(1e-300, 1e-9, 1, 1e9, 1e300)] double size,
            [Values(0, 1e6)] double offset, [Values(".las", ".laz", ".ply")] string ending)
        {
            var corner = new double3(offset, offset, offset);
            var points = Enumerable.Range(0, 100).Select(i => corner + size * new double3(i, -i, i % 7)).ToArray();
            using var source = new MemoryPointReader(TestBatches.OfPositions(points), 30);
            var result = Run(source, m_folder.File("out" + ending));
            Assert.That(result.Points + result.PointsLeftOut, Is.EqualTo(100));
            Assert.That(result.PointsLeftOut, Is.Zero);
            using var reader = PointReaders.Open(m_folder.File("out" + ending));
            Assert.That(reader.PointCount, Is.EqualTo(100));
        }

        /// <summary>64-bit numbers get another offset if their differences fit, and a coarser step if not.</summary>
        [TestCase(5_000_000_000L, 1L, ExpectedResult = 0.0)]
        [TestCase(long.MaxValue / 16, 40_000_000L, ExpectedResult = 0.0)]
        [TestCase(-7L, 100_000_003L, ExpectedResult = 5.0)]
        public double Run_WholeNumbers_MovedOrRounded(long first, long step)
        {
            var batch = TestBatches.New(100, AttributeType.Int64);
            for (int i = 0; i < 100; i++)
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Put(batch, axis, i, first + i * step);
            batch.Count = 100;
            using var source = new MemoryPointReader(batch, 30);
            var result = Run(source, m_folder.File("out.las"));
            Assert.That(result.PointsLeftOut, Is.Zero);
            using var reader = PointReaders.Open(m_folder.File("out.las"));
            int at = 0;
            ReadPoints.EachBlock(reader, reader.Info.Schema, read =>
            {
                for (int p = 0; p < read.Points.Count; p++, at++)
                    Assert.That(reader.Info.Transform.ToGeo(new double3(read.Points.Column<int>(0)[p], 0, 0)).x,
                        Is.EqualTo((double)(first + at * step)).Within(result.PositionError + Math.Abs((double)first) * 1e-15));
            });
            return result.PositionError > 0 ? 5 : 0;
        }

        [Test]
        [Category("Smoke")]
        public void Run_BoxesClassesAndFractions_WritesOnlyTheirPoints()
        {
            using var source = Grid();
            var box = new ClipBox(new double3(2, 2, 2), new double3(4, 4, 4));
            var cut = new ClipBox(box.CenterWorld - 1, box.CenterWorld + 1, true);
            long Count(ExportSettings settings) => Run(source, m_folder.File("out.las"), settings).Points;
            Assert.That(Count(new ExportSettings { Clips = new[] { box } }), Is.EqualTo(27));
            Assert.That(Count(new ExportSettings { Clips = new[] { cut } }), Is.EqualTo(1000 - 27));
            Assert.That(Count(new ExportSettings { Clips = new[] { box, cut } }), Is.Zero);
            Assert.That(Count(new ExportSettings { Classes = new[] { 0, 2 } }), Is.EqualTo(334 + 333));
            Assert.That(Count(new ExportSettings { Budget = 77 }), Is.EqualTo(77));
            Assert.That(Count(new ExportSettings { Budget = 5000 }), Is.EqualTo(1000));
            Assert.That(Count(new ExportSettings { Classes = new int[0] }), Is.Zero);
            Failures.Of(() => Count(new ExportSettings { Level = 1 }), FailureCode.Unsupported, "no octree");
        }

        [Test]
        public void Run_SomeAttributes_OthersAreZeroOrAbsent()
        {
            using var source = Grid();
            Run(source, m_folder.File("out.ply"), new ExportSettings { Attributes = new string[0] });
            using (var ply = PointReaders.Open(m_folder.File("out.ply")))
                Assert.That(ply.Info.Schema.Count, Is.EqualTo(3));
            Run(source, m_folder.File("out.las"), new ExportSettings { Attributes = new[] { "Weight" } });
            using var las = PointReaders.Open(m_folder.File("out.las"));
            Assert.That(las.Info.Schema.Has("Weight"), Is.True);
            ReadPoints.EachBlock(las, las.Info.Schema.Select(AttributeNames.Classification), read =>
                Assert.That(read.Points.Column<byte>(0).Take(read.Points.Count), Is.All.Zero));
        }

        /// <summary>What LAS's own field cannot hold is kept whole beside it, and said.</summary>
        [Test]
        public void Run_FieldTooSmall_WritesExtraBytesWithAWarning()
        {
            var batch = TestBatches.New(20, AttributeType.Float64,
                new PointAttribute(AttributeNames.Intensity, AttributeType.Float32));
            for (int i = 0; i < 20; i++)
                TestBatches.Set(batch, 3, i, i * 0.25);
            batch.Count = 20;
            using var source = new MemoryPointReader(batch, 20);
            var result = Run(source, m_folder.File("out.las"));
            Assert.That(result.Losses.Select(l => l.ToString()),
                Has.Some.Contains("the field for Intensity: lost, since it is Float32"));
            using var reader = PointReaders.Open(m_folder.File("out.las"));
            var extra = reader.Info.Schema.Single(a => a.Type == AttributeType.Float32);
            ReadPoints.EachBlock(reader, reader.Info.Schema.Select(extra.Name), read =>
                Assert.That(read.Points.Column<float>(0).Take(20), Is.EqualTo(Enumerable.Range(0, 20).Select(i => i * 0.25f))));
        }

        [Test]
        public void Run_CancelledAnywhere_LeavesNothing([Values(".las", ".laz", ".ply")] string ending)
        {
            for (int steps = 0; steps < 60; steps += 7)
            {
                using var source = Grid();
                var work =
                    new CoroutineStack(ExportCloud.Run(source, m_folder.File("out" + ending), new ExportSettings(), _ => { },
                    null));
                bool isRunning = true;
                for (int i = 0; i < steps && (isRunning = work.MoveNext()); i++)
                    work.Current.Complete();
                if (!isRunning)
                    break;
                work.Dispose();
                Assert.That(Directory.GetFileSystemEntries(m_folder.Path), Is.Empty, steps + " steps");
            }
        }

        [Test]
        public void Run_Failed_KeepsTheOldFile()
        {
            string path = m_folder.Write("out.las", new byte[] { 1, 2, 3 });
            using var source = new MemoryPointReader(TestBatches.OfPositions(new double3(1, 2, 3)), 2);
            Failures.Of(() => Run(source, path, new ExportSettings { Classes = new[] { 2 } }), FailureCode.BadInput, "classes");
            Failures.Of(() => Run(source, m_folder.File("gone/out.las")), FailureCode.NotFound);
            Assert.That(File.ReadAllBytes(path), Is.EqualTo(new byte[] { 1, 2, 3 }));
            Assert.That(Directory.GetFileSystemEntries(m_folder.Path), Is.EqualTo(new[] { path }));
            Run(source, path);
            using var made = PointReaders.Open(path);
            Failures.Of(() => Run(made, path), FailureCode.WriteFailed, "is the source");
        }

        [Test]
        public void Run_NoPoints_WritesAnEmptyFile([Values(".las", ".laz", ".ply")] string ending)
        {
            using var source = new MemoryPointReader(TestBatches.OfPositions(), 2);
            Assert.That(Run(source, m_folder.File("out" + ending)).Points, Is.Zero);
            using var reader = PointReaders.Open(m_folder.File("out" + ending));
            Assert.That(reader.PointCount, Is.Zero);
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        /// <summary>More points than 32 bits count go into LAS 1.4 alone, whose old counts are then 0.</summary>
        [Test]
        public void SetPoints_BeyondThirtyTwoBits_OnlyInTheLargeCount()
        {
            var byReturn = new ulong[16];
            byReturn[1] = 5_000_000_000;
            var header = new LasHeader { VersionMinor = 4, PointFormat = 1, Count64 = 5_000_000_000 };
            header.SetCountsAndBounds("x", byReturn, default, default);
            Assert.That((header.LegacyCount, header.LegacyByReturn[0], header.ByReturn[0]),
                Is.EqualTo((0u, 0u, 5_000_000_000ul)));
            header.VersionMinor = 2;
            Failures.Of(() => header.SetCountsAndBounds("x", byReturn, default, default), FailureCode.Unsupported, "1.2");
        }

        static MemoryPointReader Grid()
        {
            var batch = TestBatches.New(1000, AttributeType.Float64,
                new PointAttribute(AttributeNames.Classification, AttributeType.UInt8),
                new PointAttribute("Weight", AttributeType.Float32));
            for (int i = 0; i < 1000; i++)
            {
                TestBatches.Set(batch, 0, i, i % 10);
                TestBatches.Set(batch, 1, i, i / 10 % 10);
                TestBatches.Set(batch, 2, i, i / 100);
                TestBatches.Set(batch, 3, i, i % 3);
                TestBatches.Set(batch, 4, i, i * 0.5);
            }
            batch.Count = 1000;
            return new MemoryPointReader(batch, 130);
        }
    }
}
