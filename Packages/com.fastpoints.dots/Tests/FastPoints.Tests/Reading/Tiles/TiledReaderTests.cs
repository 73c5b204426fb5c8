using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using FastPoints.Build;
using FastPoints.Evaluation;
using FastPoints.Export;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Scenes;
using FastPoints.Sources;
using FastPoints.Store;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Reading
{
    public class TiledReaderTests : FolderTests
    {
        string PathOf(string name) => Folder.File(name);

        /// <summary>A LAS file of these stored positions; the i-th point's intensity is i + 1.</summary>
        string WriteLas(string name, int3[] stored, double3 scale, double3 offset, int pointFormat = 3, string wkt = null)
        {
            var settings = new LasWriterSettings { PointFormat = pointFormat, Scale = scale, Offset = offset, Wkt = wkt };
            using (var writer = LasWriter.Create(PathOf(name), settings))
            using (var batch = new PointBatch(writer.Schema, Math.Max(1, stored.Length), Allocator.Persistent))
            {
                var bytes = batch.Bytes;
                for (int i = 0; i < bytes.Length; i++)
                    bytes[i] = 0;
                var x = batch.Column<int>("X");
                var y = batch.Column<int>("Y");
                var z = batch.Column<int>("Z");
                var intensity = batch.Column<ushort>("Intensity");
                for (int i = 0; i < stored.Length; i++)
                {
                    x[i] = stored[i].x;
                    y[i] = stored[i].y;
                    z[i] = stored[i].z;
                    intensity[i] = (ushort)(i + 1);
                }
                batch.Count = stored.Length;
                writer.Append(batch);
                writer.Complete();
            }
            return PathOf(name);
        }

        string WriteText(string name, string text)
        {
            File.WriteAllBytes(PathOf(name), Encoding.ASCII.GetBytes(text));
            return PathOf(name);
        }

        static int3[] Positions(int count, uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var positions = new int3[count];
            for (int i = 0; i < count; i++)
                positions[i] = random.NextInt3(-1000000000, 1000000000);
            return positions;
        }

        static void Coroutine(IEnumerator<JobStep> work) => JobCoroutine.RunToEnd(work);

        [Test]
        public void Open_TilesOfOneGrid_KeepsTheirNumbers()
        {
            var scale = new double3(0.01, 0.01, 0.01);
            var offset = new double3(500000, 4000000, 0);
            var positions = new[] { Positions(40000, 1), Positions(0, 2), Positions(70001, 3) };
            var paths = new List<string>();
            for (int i = 0; i < positions.Length; i++)
                paths.Add(WriteLas(i + ".las", positions[i], scale, offset));
            using var reader = PointReaders.Open(paths);
            Assert.That(reader.PointCount, Is.EqualTo(110001));
            Assert.That(reader.Info.Schema[0].Type, Is.EqualTo(AttributeType.Int32));
            Assert.That(reader.Info.Transform.Offset, Is.EqualTo(offset));
            Assert.That(ReadPoints.Column<int>(reader, "X"), Is.EqualTo(positions.SelectMany(p => p).Select(p => p.x)));
            Assert.That(ReadPoints.Column<ushort>(reader, "Intensity").Skip(40000).Take(3), Is.EqualTo(new[] { 1, 2, 3 }));
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        // Scales that meet below the finest, negative ones, offsets apart by whole and by broken steps, degrees, far out.
        [TestCase(0.01, 0.0, 0.025, 0.0)]
        [TestCase(0.001, 500000.0, -0.01, 501000.0)]
        [TestCase(0.001, 637012.24, 0.001, 637012.2437)]
        [TestCase(1e-7, -120.0, 1e-7, 179.5)]
        [TestCase(1e-9, 0.0, 0.001, 1e7)]
        [TestCase(0.01, -1e7, 0.01, 1e7)]
        public void Open_TilesOfDifferentGrids_HoldsEachExactly(double scaleA, double offsetA, double scaleB, double offsetB)
        {
            var positions = new[] { Positions(1000, 4), Positions(1000, 5) };
            positions[1][0] = new int3(int.MinValue, int.MaxValue, 0);
            var transforms = new[] { (scaleA, offsetA), (scaleB, offsetB) };
            var paths = new List<string>();
            for (int i = 0; i < 2; i++)
                paths.Add(WriteLas(i + ".las", positions[i], new double3(transforms[i].Item1, 0.01, 0.01),
                    new double3(transforms[i].Item2, 0, 0)));
            using var reader = PointReaders.Open(paths);
            Assert.That(reader.Info.Warnings, Is.Empty);
            var x = ReadPoints.Column<long>(reader, "X");
            decimal step = Decimal(reader.Info.Transform.Scale.x), origin = Decimal(reader.Info.Transform.Offset.x);
            for (int i = 0; i < x.Length; i++)
            {
                var (scale, offset) = transforms[i / 1000];
                Assert.That(x[i] * step + origin,
                    Is.EqualTo(positions[i / 1000][i % 1000].x * Decimal(scale) + Decimal(offset)));
            }
            Assert.That(ReadPoints.Column<int>(reader, "Y")[1000], Is.EqualTo(int.MaxValue));
        }

        static decimal Decimal(double value) =>
            decimal.Parse(value.ToString("G12", System.Globalization.CultureInfo.InvariantCulture),
                System.Globalization.NumberStyles.Float, System.Globalization.CultureInfo.InvariantCulture);

        [Test]
        public void Open_OffsetsWithoutACommonStep_NamesTheLoss()
        {
            var scale = new double3(0.01, 0.01, 0.01);
            string a = WriteLas("a.las", Positions(10, 1), scale, default);
            string b = WriteLas("b.las", Positions(10, 2), scale, new double3(1.0 / 3, 0, 0));
            using var reader = PointReaders.Open(new[] { a, b });
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("no common step"));
            var x = ReadPoints.Column<long>(reader, "X");
            Assert.That((x[10] - Positions(10, 2)[0].x) * 0.01, Is.EqualTo(1.0 / 3).Within(0.005));
        }

        [Test]
        public void Open_DifferentAttributes_UnitesThem()
        {
            var scale = new double3(0.01, 0.01, 0.01);
            string las = WriteLas("a.las", Positions(5, 1), scale, default, 1);
            string old = WriteLas("b.las", Positions(5, 2), scale, default, 2);
            string ply = WriteText("c.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n" +
                "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty float Intensity\n" +
                "end_header\n1.5 2.5 3.5 255 128 0 0.5\n4 5 6 1 2 3 70000\n");
            using var reader = PointReaders.Open(new[] { las, old, ply });
            ReadPoints.IndexBlocks(reader);
            var schema = reader.Info.Schema;
            Assert.That(schema[schema.IndexOf("X")].Type, Is.EqualTo(AttributeType.Float64));
            Assert.That(schema[schema.IndexOf("Red")].Type, Is.EqualTo(AttributeType.UInt16));
            Assert.That(schema[schema.IndexOf("Intensity")].Type, Is.EqualTo(AttributeType.Float32));
            var x = ReadPoints.Column<double>(reader, "X");
            Assert.That(x[0], Is.EqualTo(Positions(5, 1)[0].x * 0.01));
            Assert.That(x[10], Is.EqualTo(1.5));
            Assert.That(ReadPoints.Column<ushort>(reader, "Red").Skip(10), Is.EqualTo(new ushort[] { 65535, 257 }));
            Assert.That(ReadPoints.Column<ushort>(reader, "Red").Take(10), Is.All.EqualTo(0));
            Assert.That(ReadPoints.Column<float>(reader, "Intensity"),
                Is.EqualTo(new[] { 1f, 2, 3, 4, 5, 1, 2, 3, 4, 5, 0.5f, 70000 }));
            Assert.That(ReadPoints.Column<double>(reader, "GpsTime"), Is.All.EqualTo(0));
            var warnings = reader.Info.Warnings.Select(w => w.Text).ToList();
            Assert.That(warnings, Has.Some.Contains("GpsTime in 2 (b.las, ...)"));
            Assert.That(warnings, Has.Some.Contains("8 bits times 257"));
            Assert.That(warnings, Has.Some.Contains("others floats"));
        }

        [Test]
        public void Open_ScanAnglesOfTwoKinds_AreDegrees()
        {
            var scale = new double3(0.01, 0.01, 0.01);
            string a = WriteLas("a.las", Positions(1, 1), scale, default, 1), b = WriteLas("b.las", Positions(1, 2), scale,
                default, 6);
            PatchByte(a, 16, unchecked((byte)-15));
            PatchByte(b, 18, 0xF6);
            PatchByte(b, 19, 0xFF);
            using var reader = PointReaders.Open(new[] { a, b });
            Assert.That(ReadPoints.Column<float>(reader, "ScanAngle"), Is.EqualTo(new[] { -15f, -0.06f }).Within(1e-6));
        }

        static void PatchByte(string path, int atInRecord, byte value)
        {
            var bytes = File.ReadAllBytes(path);
            bytes[BitConverter.ToInt32(bytes, 96) + atInRecord] = value;
            File.WriteAllBytes(path, bytes);
        }

        [Test]
        public void OpenFolder_MixedFiles_TakesCloudsByNameAndListsTheOthers()
        {
            var scale = new double3(0.01, 0.01, 0.01);
            WriteLas("b.las", Positions(2, 2), scale, default);
            WriteLas("a10.las", Positions(1, 1), scale, default);
            WriteLas("Z.las", Positions(3, 3), scale, default);
            WriteText("notes.md", "what this is");
            WriteText("broken.ply", "ply\nnonsense");
            WriteText("empty.laz", "");
            Directory.CreateDirectory(PathOf("sub"));
            using var reader = PointReaders.Open(Folder.Path);
            Assert.That(ReadPoints.Column<int>(reader, "X"),
                Is.EqualTo(new[] { 3, 1, 2 }.SelectMany(n => Positions(n, (uint)n)).Select(p => p.x)));
            var warnings = reader.Info.Warnings.Select(w => w.ToString()).ToList();
            Assert.That(warnings, Has.Some.Contains("notes.md"));
            Assert.That(warnings, Has.Some.Contains("broken.ply: left out"));
            Assert.That(warnings, Has.Some.Contains("empty.laz: left out"));
            Assert.That(warnings, Has.Some.Contains("folders in it are not looked into: sub"));
            Assert.That(reader.Info.Format, Is.EqualTo("LAS"));
        }

        [Test]
        public void OpenFolder_WithoutClouds_Fails()
        {
            WriteText("notes.md", "what this is");
            Failures.Of(() => PointReaders.Open(Folder.Path), FailureCode.Unsupported, "no point cloud");
        }

        [Test]
        public void Open_OneOfSeveralIsBroken_Fails()
        {
            string a = WriteLas("a.las", Positions(2, 2), new double3(1, 1, 1), default), b = WriteText("b.las", "LASF");
            Assert.That(() => PointReaders.Open(new[] { a, b }), Throws.InstanceOf<PointCloudException>());
            Assert.That(() => PointReaders.Open(new[] { a, PathOf("c") }), Throws.InstanceOf<PointCloudException>());
        }

        [Test]
        public void Open_DifferentCoordinateSystems_Warns()
        {
            var one = new double3(1, 1, 1);
            string a = WriteLas("a.las", Positions(1, 1), one, default, 7, "PROJCS[\"A\",AUTHORITY[\"EPSG\",\"25832\"]]");
            string b = WriteLas("b.las", Positions(1, 1), one, default, 7, "PROJCS[\"B\",AUTHORITY[\"EPSG\",\"25833\"]]");
            string c = WriteLas("c.las", Positions(1, 1), one, default, 7);
            using var reader = PointReaders.Open(new[] { a, b, c });
            Assert.That(reader.Info.Crs.Epsg, Is.EqualTo(25832));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("coordinate systems differ"));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("1 file names no coordinate system"));
        }

        /// <summary>Ranges in any order, from files whose blocks must be found and others, more of them than stay open.</summary>
        [Test]
        public void Read_MoreTilesThanStayOpen_InAnyOrder()
        {
            const int tiles = 3 * TiledReader.MaxOpen;
            var expected = new List<float>();
            var paths = new List<string>();
            for (int i = 0; i < tiles; i++)
            {
                var text = new StringBuilder();
                for (int p = 0; p <= i % 3; p++)
                {
                    text.Append(100 * i + p).Append(" 0 0\n");
                    expected.Add(100 * i + p);
                }
                string kind = i % 2 == 0 ? "ascii" : "binary_little_endian";
                string head = "ply\nformat " + kind + " 1.0\nelement vertex " + (i % 3 + 1) +
                    "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
                if (i % 2 == 0)
                {
                    paths.Add(WriteText(i + ".ply", head + text));
                    continue;
                }
                var bytes = Encoding.ASCII.GetBytes(head).ToList();
                for (int p = 0; p <= i % 3; p++)
                    foreach (float value in new[] { 100f * i + p, 0, 0 })
                        bytes.AddRange(BitConverter.GetBytes(value));
                File.WriteAllBytes(PathOf(i + ".ply"), bytes.ToArray());
                paths.Add(PathOf(i + ".ply"));
            }
            using var reader = (TiledReader)PointReaders.Open(paths);
            Assert.That(reader.BlocksAreKnown, Is.False);
            ReadPoints.IndexBlocks(reader);
            Assert.That(ReadPoints.Column<float>(reader, "X"), Is.EqualTo(expected));
            using var read = reader.CreateRead(reader.Info.Schema.Select("X", "Z"), 2, Allocator.Persistent);
            for (int i = 0; i < reader.BlockCount; i++)
            {
                int block = i * 37 % reader.BlockCount, last = reader.PointsInBlock(block) - 1;
                read.Begin(new BlockRange(block, last, 1));
                read.Complete();
                Assert.That(read.Points.Column<float>("X")[0], Is.EqualTo(expected[(int)read.FirstPoint]));
                Assert.That(read.FirstPoint, Is.EqualTo(reader.FirstPointOfBlock(block) + last));
                Assert.That(reader.OpenCount, Is.LessThanOrEqualTo(TiledReader.MaxOpen));
            }
        }

        [Test]
        public void Read_FileChangedSince_Fails()
        {
            string a = WriteLas("a.las", Positions(2, 2), new double3(1, 1, 1), default);
            string b = WriteLas("b.las", Positions(2, 3), new double3(1, 1, 1), default);
            using var reader = PointReaders.Open(new[] { a, b });
            WriteLas("b.las", Positions(7, 3), new double3(1, 1, 1), default);
            Failures.Of(() => ReadPoints.Column<int>(reader, "X"), FailureCode.ReadFailed, "b.las", "has changed");
        }

        [Test]
        public void Convert_TilesOfDifferentGrids_IsTheSameCloud()
        {
            var random = new Unity.Mathematics.Random(9);
            var positions = new int3[20000];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = random.NextInt3(100000);
            var paths = new[]
            {
                WriteLas("a.las", positions, new double3(0.01, 0.01, 0.01), new double3(500000, 4000000, 0)),
                WriteLas("b.las", positions, new double3(0.001, 0.001, 0.001), new double3(501000, 4000000, 0)),
                WriteLas("c.las", positions, new double3(-0.025, 0.025, 0.01), new double3(500100, 4000100, 0), 7),
            };
            string target = PathOf("all.fastpoints");
            using var reader = PointReaders.Open(paths);
            ConvertResult result = null;
            Coroutine(ConvertCloud.Run(new[] { reader }, target, new ConvertSettings(), r => result = r, null));
            Assert.That(result.Manifest.Points, Is.EqualTo(60000));
            Assert.That(result.Manifest.PointsLeftOut, Is.Zero);
            Assert.That(result.Manifest.Grid.Step.x, Is.EqualTo(0.001));
            Assert.That(StoredSources.Read(target).Select(s => s.Name + " " + s.Points),
                Is.EqualTo(new[] { "a.las 20000", "b.las 20000", "c.las 20000" }));
            var verified = new VerifyResult();
            Coroutine(VerifyCloud.Run(target, new[] { reader }, verified, null));
            Assert.That(verified.Problems, Is.Empty);
        }

        [Test]
        public void Summarise_TilesOfDifferentGrids_HasTheBoundsOfAll()
        {
            string a = WriteLas("a.las", new[] { new int3(0, 0, 0) }, new double3(0.01, 0.01, 0.01), new double3(500000, 0, 0));
            string b = WriteLas("b.las", new[] { new int3(1500, 1, 2) }, new double3(0.001, 1, 1), new double3(500001, 0, 0));
            using var reader = PointReaders.Open(new[] { a, b });
            var summarise = new SummariseCloud(reader);
            Coroutine(summarise.Run(null));
            Assert.That(summarise.Summary.Points, Is.EqualTo(2));
            Assert.That(summarise.Summary.Bounds.Min.x, Is.EqualTo(500000));
            Assert.That(summarise.Summary.Bounds.Max.x, Is.EqualTo(500002.5));
        }

        [Test]
        public void Sample_MoreTilesThanRanges_GivesEachTileItsPoints()
        {
            const int tileSteps = 100_000;
            var paths = new List<string>();
            for (int t = 0; t < 20; t++)
            {
                var positions = Positions(t == 7 ? 5000 : 100, (uint)t + 1);
                for (int i = 0; i < positions.Length; i++)
                    positions[i] = math.abs(positions[i]) % tileSteps + new int3(t * tileSteps, 0, 0);
                paths.Add(WriteLas(t.ToString("D2") + ".las", positions, 0.01, 0));
            }
            using var reader = PointReaders.Open(paths);
            SourceSample sample = null;
            Coroutine(SourceSample.Read(reader, () => 0, 0, 1 << 20, (_, loaded) => loaded, s => sample = s));
            using (sample)
            {
                var points = new double[20];
                foreach (var range in sample.Ranges)
                    for (int i = 0; i < range.Count; i++)
                        points[(int)(sample.Stored[range.First + i].x / tileSteps)] += range.Weight;
                for (int t = 0; t < 20; t++)
                    Assert.That(points[t], Is.EqualTo(t == 7 ? 5000 : 100).Within(1e-6), "tile " + t);
            }
        }

        [Test]
        public void Open_FilesWithAWarningEach_WarnsOfAThousand()
        {
            var bytes = File.ReadAllBytes(WriteLas("0000.las", Positions(3, 1), new double3(0.01, 0.01, 0.01), default));
            for (int i = 1; i <= 1003; i++)
            {
                BitConverter.GetBytes(3 + i).CopyTo(bytes, 107);
                File.WriteAllBytes(PathOf(i.ToString("D4") + ".las"), bytes);
            }
            using var reader = PointReaders.Open(Folder.Path);
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(1001));
            Assert.That(reader.Info.Warnings[1000].Text, Is.EqualTo("more files have other warnings"));
            Assert.That(reader.PointCount, Is.EqualTo(3 * 1004));
        }

        [TestCase(200)]
        public void Convert_ManyFiles_OpensWithoutTheirNames(int files)
        {
            var bytes = File.ReadAllBytes(WriteLas("00000.las", Positions(3, 1), new double3(0.01, 0.01, 0.01), default));
            for (int i = 1; i < files; i++)
                File.WriteAllBytes(PathOf(i.ToString("D5") + ".las"), bytes);
            string path = PathOf("cloud" + StoreFormat.FolderExtension);
            using (var reader = PointReaders.Open(Folder.Path))
                Coroutine(ConvertCloud.Run(new[] { reader }, path, new ConvertSettings(), _ => { }, null));
            Assert.That(StoredSources.Read(path).Count, Is.EqualTo(files));
            Assert.That(new FileInfo(Path.Combine(path, StoreFormat.ManifestName)).Length, Is.LessThanOrEqualTo(16 << 10));
            File.WriteAllText(Path.Combine(path, StoreFormat.SourcesName), "damaged");
            using var folder = CloudFolder.Open(path);
            Assert.That(folder.Manifest.Points, Is.EqualTo(3 * files));
        }

        /// <summary>Ten thousand files: seconds, and a handful of handles.</summary>
        [Test, Category("Long"), Explicit]
        public void Open_TenThousandFiles_IsQuick()
        {
            var bytes = File.ReadAllBytes(WriteLas("00000.las", Positions(3, 1), new double3(0.01, 0.01, 0.01), default));
            for (int i = 1; i < 10000; i++)
                File.WriteAllBytes(PathOf(i.ToString("D5") + ".las"), bytes);
            var watch = Stopwatch.StartNew();
            using var reader = (TiledReader)PointReaders.Open(Folder.Path);
            TestContext.WriteLine("opened in " + watch.Elapsed.TotalSeconds + " s");
            Assert.That(watch.Elapsed.TotalSeconds, Is.LessThan(20));
            Assert.That(reader.PointCount, Is.EqualTo(30000));
            Assert.That(reader.OpenCount, Is.LessThanOrEqualTo(TiledReader.MaxOpen));
            watch.Restart();
            Assert.That(ReadPoints.Column<int>(reader, "X").Sum(x => (long)x),
                Is.EqualTo(10000 * Positions(3, 1).Sum(p => (long)p.x)));
            TestContext.WriteLine("read in " + watch.Elapsed.TotalSeconds + " s");
        }
    }
}
