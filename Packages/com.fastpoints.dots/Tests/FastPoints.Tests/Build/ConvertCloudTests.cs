using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Build;
using FastPoints.Drawing;
using FastPoints.Evaluation;
using FastPoints.Export;
using FastPoints.Nodes;
using FastPoints.Picture;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Tests.Nodes;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Build
{
    [Category("Smoke")]
    public class ConvertCloudTests : FolderTests
    {
        static readonly PositionTransform s_centimetres = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01) };

        string Target(string name = "cloud") => Folder.File(name + StoreFormat.FolderExtension);

        ConvertResult Convert(PointReader reader, string name = "cloud", ConvertSettings settings = null)
        {
            ConvertResult result = null;
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, Target(name), settings ?? new ConvertSettings(), r =>
                result = r, null));
            return result;
        }

        VerifyResult Verify(PointReader against, string name = "cloud")
        {
            var result = new VerifyResult();
            JobCoroutine.RunToEnd(VerifyCloud.Run(Target(name), against == null ? Array.Empty<PointReader>() : new[] { against },
                result, null));
            return result;
        }

        ConvertResult Prove(MemoryReader reader, ConvertSettings settings = null)
        {
            var converted = Convert(reader, "cloud", settings);
            var verified = Verify(reader);
            Assert.That(verified.Problems, Is.Empty);
            Assert.That(verified.Points, Is.EqualTo(converted.Manifest.Points));
            Assert.That(converted.Manifest.Points + converted.Manifest.PointsLeftOut, Is.EqualTo(reader.PointCount));
            return converted;
        }

        static int3[] Uniform(int count, int extent, uint seed = 7)
        {
            var random = new Unity.Mathematics.Random(seed);
            var positions = new int3[count];
            for (int i = 0; i < count; i++)
                positions[i] = random.NextInt3(extent);
            return positions;
        }

        [TestCase(1), TestCase(2), TestCase(127), TestCase(129)]
        public void Convert_FewPoints_AreOneLeaf(int count)
        {
            var made = Prove(MemoryReader.Of(Uniform(count, 1000), s_centimetres));
            Assert.That(made.Manifest.NodeCount, Is.EqualTo(1));
            Assert.That(made.Manifest.ChunkCount, Is.EqualTo(0));
        }

        [Test]
        public void Convert_NoPoints_IsAnEmptyCloud()
        {
            var made = Prove(MemoryReader.Of(new int3[0], s_centimetres));
            Assert.That(made.Manifest.NodeCount, Is.EqualTo(0));
        }

        [Test]
        public void Convert_UniformCube_KeepsEveryPointInSmallNodes([Values(Sampler.Random, Sampler.Poisson)] Sampler sampler)
        {
            var made = Prove(MemoryReader.Of(Uniform(440000, 100000), s_centimetres, 20000),
                new ConvertSettings { PointsPerChunk = 100000, Sampler = sampler });
            Assert.That(made.Manifest.ChunkCount, Is.GreaterThan(1));
            using var folder = CloudFolder.Open(Target());
            foreach (var table in folder.EachTable())
                foreach (var node in table.Nodes)
                    Assert.That(node.PointCount, Is.InRange(1, StoreFormat.MaxPointsPerNode));
        }

        [Test]
        public void Convert_Plane_KeepsEveryPoint()
        {
            var positions = Uniform(60000, 50000);
            for (int i = 0; i < positions.Length; i++)
                positions[i].z = -12345;
            Prove(MemoryReader.Of(positions, s_centimetres), new ConvertSettings { PointsPerChunk = 10000 });
        }

        [Test]
        public void Convert_Line_KeepsEveryPoint()
        {
            var positions = new int3[50000];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = new int3(i * 3, i * 3, i * 3);
            Prove(MemoryReader.Of(positions, s_centimetres), new ConvertSettings { PointsPerChunk = 10000 });
        }

        [Test]
        public void Convert_SixtyThousandEqualPoints_BecomeAChain([Values(Sampler.Random, Sampler.Poisson)] Sampler sampler)
        {
            var positions = Uniform(90000, 20000);
            for (int i = 0; i < 60000; i++)
                positions[i * 3 / 2] = new int3(777, 778, 779);
            var made = Prove(MemoryReader.Of(positions, s_centimetres),
                new ConvertSettings { PointsPerChunk = 20000, Sampler = sampler });
            Assert.That(made.LevelCount, Is.EqualTo(made.Manifest.Root.SideLog2 + 1));
        }

        [Test]
        public void Convert_AllEqual_CreatesAChainWithoutPositionBits()
        {
            var positions = new int3[120000];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = new int3(5, -6, 7);
            var made = Prove(MemoryReader.Of(positions, s_centimetres));
            Assert.That(made.Manifest.NodeCount, Is.EqualTo(3));
            Assert.That(made.Manifest.Root.SideLog2, Is.EqualTo(0));
            Assert.That(made.BytesOfPlane[0], Is.LessThan(120000 / 4));
        }

        [Test]
        public void Convert_IntegerLimits_AreKept()
        {
            var positions = Uniform(5000, 1000);
            positions[0] = new int3(int.MinValue, int.MinValue, int.MinValue);
            positions[1] = new int3(int.MaxValue, int.MaxValue, int.MaxValue);
            positions[2] = new int3(int.MaxValue, int.MinValue, 0);
            var made = Prove(MemoryReader.Of(positions, s_centimetres));
            Assert.That(made.Manifest.BoundsMax, Is.EqualTo(new Grid3(int.MaxValue, int.MaxValue, int.MaxValue)));
            Assert.That(made.Manifest.Root.SideLog2, Is.EqualTo(32));
        }

        [Test]
        public void Convert_UtmOffsetsWithFineScale_KeepsExactPositions()
        {
            var transform = new PositionTransform { Scale = new double3(1e-4, 1e-4, 1e-4), Offset = new double3(1e7, 5e6, -100) };
            var made = Prove(MemoryReader.Of(Uniform(30000, 30000000), transform));
            Assert.That(made.Manifest.Grid.Step.x, Is.EqualTo(1e-4));
            Assert.That(made.Manifest.Grid.Origin.x, Is.EqualTo(1e7));
        }

        [Test]
        public void Convert_FilesOfDifferentScaleAndOffset_ShareOneGrid()
        {
            var positions = Uniform(20000, 100000);
            var coarse = MemoryReader.Of(positions, s_centimetres, 1000, 5);
            var fine = MemoryReader.Of(Uniform(20000, 100000, 3),
                new PositionTransform { Scale = new double3(0.001, 0.01, 0.025), Offset = new double3(500, -0.005, 3) });
            ConvertResult made = null;
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { coarse, fine }, Target(), new ConvertSettings(), r => made = r, null));
            var result = new VerifyResult();
            JobCoroutine.RunToEnd(VerifyCloud.Run(Target(), new[] { fine, coarse }, result, null));
            Assert.That(result.Problems, Is.Empty);
            Assert.That(coarse.Info.Warnings, Is.Empty);
            Assert.That(fine.Info.Warnings, Is.Empty);
            Assert.That(made.Manifest.Grid.Step.z, Is.EqualTo(0.005).Within(1e-15));
        }

        [Test]
        public void Convert_OutlierFarAway_GrowsTheRootAndKeepsTheRest([Values] Sampler sampler)
        {
            // The outlier is not in the sample, and half the points are in a corner that it fools.
            var positions = Uniform(60000, 2000);
            for (int i = 30000; i < 60000; i++)
                positions[i] += new int3(100000, 50000, 0);
            positions[45001] = new int3(-2000000000, 2000000000, 5);
            var made = Prove(MemoryReader.Of(positions, s_centimetres),
                new ConvertSettings { PointsPerChunk = 5000, Sampler = sampler });
            Assert.That(made.Manifest.Root.SideLog2, Is.InRange(31, 32));
        }

        [Test]
        public void Convert_FloatsWithNaN_SkipsThem()
        {
            var random = new Unity.Mathematics.Random(3);
            float[] x = new float[5000], y = new float[5000], z = new float[5000];
            for (int i = 0; i < x.Length; i++)
            {
                x[i] = random.NextInt(4096) / 64f;
                y[i] = random.NextInt(4096) / -64f;
                z[i] = random.NextInt(4096) / 16f;
            }
            x[17] = float.NaN;
            y[1234] = float.PositiveInfinity;
            z[4999] = float.NegativeInfinity;
            var reader = new MemoryReader(new PointSchema(PositionColumns.Attributes(AttributeType.Float32)),
                PositionTransform.Identity, 700, x, y, z);
            var made = Prove(reader);
            Assert.That(made.Manifest.PointsLeftOut, Is.EqualTo(3));
            Assert.That(made.Manifest.Grid.Step.z, Is.EqualTo(1 / 16.0));
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(1));
        }

        [Test]
        public void Convert_OneTwoSevenWorkers_WriteTheSameBytes([Values] Sampler sampler)
        {
            var positions = Uniform(240000, 3000);
            for (int i = 0; i < positions.Length; i++)
                positions[i].z /= 1000;
            var before = new Dictionary<string, byte[]>();
            foreach (int workers in new[] { 1, 2, 7 })
            {
                using var threads = new WorkerCount(workers);
                string name = "w" + workers;
                Convert(MemoryReader.Of(positions, s_centimetres, 3001), name, new ConvertSettings
                {
                    PointsPerChunk = 60000,
                    Workers = workers,
                    Sampler = sampler,
                });
                foreach (string file in Directory.GetFiles(Target(name), "*", SearchOption.AllDirectories))
                {
                    string relative = file.Substring(Target(name).Length);
                    byte[] bytes = File.ReadAllBytes(file);
                    if (workers == 1)
                        before.Add(relative, bytes);
                    else
                        Assert.That(bytes, Is.EqualTo(before[relative]), relative);
                }
            }
            Assert.That(before.Count, Is.GreaterThan(4));
        }

        [Test]
        public void Convert_SomeOutliers_StoresDisplayRangesWithoutThem()
        {
            var positions = Uniform(20000, 1000);
            for (int i = 0; i < 20; i++)
                positions[i * 1000].z = 100000;
            var manifest = Convert(MemoryReader.Of(positions, s_centimetres)).Manifest;
            var shown = manifest.DisplayRanges.Value;
            Assert.That(manifest.BoundsGeo.Max.z, Is.EqualTo(1000).Within(1e-9));
            Assert.That(shown.Elevation.Min, Is.EqualTo(0.05).Within(0.04), "a two-hundredth lies below");
            Assert.That(shown.Elevation.Max, Is.EqualTo(9.95).Within(0.05));
            Assert.That(shown.BoundsGeo.Max.z, Is.LessThan(12));
            Assert.That(shown.Intensity.Min, Is.EqualTo(655).Within(300), "a hundredth lies below");
            Assert.That(shown.HasColor, Is.True);

            var read = CloudManifest.FromJson(File.ReadAllText(Path.Combine(Target(), StoreFormat.ManifestName)), "cloud.json");
            var ranges = DisplayRanges.Of(read);
            Assert.That((ranges.ElevationLow, ranges.ElevationHigh), Is.EqualTo((shown.Elevation.Min, shown.Elevation.Max)));
            Assert.That((ranges.IntensityLow, ranges.IntensityHigh), Is.EqualTo((shown.Intensity.Min, shown.Intensity.Max)));
            Assert.That((ranges.Robust.Max.z, ranges.Full.Max.z), Is.EqualTo((shown.BoundsGeo.Max.z, manifest.BoundsGeo.Max.z)));
            Assert.That(ranges.Resolve(ColorMode.Auto), Is.EqualTo(ColorMode.Rgb));
            read.DisplayRanges = null;
            Assert.That(DisplayRanges.Of(read).ElevationHigh, Is.EqualTo(1000).Within(1e-9), "converted before it was told");
        }

        [TestCase(1), TestCase(3)]
        public void Convert_SomeWorkers_ReadsAsManyBlocksAtOnce(int workers)
        {
            using var threads = new WorkerCount(3);
            var reader = MemoryReader.Of(Uniform(20000, 3000), s_centimetres, 1000);
            Convert(reader, "cloud", new ConvertSettings { Workers = workers, SecondsToFirstGeneration = 1e9 });
            // Once for the sample and once for reading: all others depend on another block's jobs.
            Assert.That(reader.BlocksWithoutDependency, Is.EqualTo(2 * workers));
        }

        [Test]
        public void Convert_TextByOneWorker_WritesTheSameBytes()
        {
            string path = Folder.File("text.xyz");
            using (var writer = new StreamWriter(path))
                foreach (var position in Uniform(30000, 1000))
                    writer.Write(position.x + " " + position.y + " " + position.z + "\n");
            foreach (int workers in new[] { 0, 1 })
                using (var reader = PointReaders.Open(path))
                    Convert(reader, "w" + workers, new ConvertSettings { Workers = workers });
            foreach (string file in Directory.GetFiles(Target("w0"), "*", SearchOption.AllDirectories))
                Assert.That(File.ReadAllBytes(Target("w1") + file.Substring(Target("w0").Length)),
                    Is.EqualTo(File.ReadAllBytes(file)));
        }

        [Test]
        public void Convert_OtherOrderOfTheSamePoints_GivesTheSameNodes([Values(Sampler.Random, Sampler.Poisson)] Sampler sampler)
        {
            var positions = Uniform(40000, 500);
            var turned = (int3[])positions.Clone();
            Array.Reverse(turned);
            var settings = new ConvertSettings { Attributes = new string[0], Sampler = sampler };
            var first = Convert(MemoryReader.Of(positions, s_centimetres), "a", settings);
            var second = Convert(MemoryReader.Of(turned, s_centimetres), "b", settings);
            Assert.That(second.Manifest.Checksum, Is.EqualTo(first.Manifest.Checksum));
            byte[] Upper(string cloud) => File.ReadAllBytes(
                Directory.GetFiles(Path.Combine(Target(cloud), StoreFormat.UpperFolderName)).Single());
            // Their heads differ: clouds of other sources.
            Assert.That(Upper("b").Skip(FileHeader.SizeBytes), Is.EqualTo(Upper("a").Skip(FileHeader.SizeBytes)));
        }

        internal static List<LevelSpacing> Spacings(string cloud)
        {
            var spacings = new List<LevelSpacing>();
            JobCoroutine.RunToEnd(MeasureSpacing.Run(cloud, spacings));
            return spacings;
        }

        [Test]
        public void Convert_Poisson_KeepsTheSpacingInsideOfChunks()
        {
            // A slanted plane: a chunk's face along a plane would leave both sides without each other's samples.
            var positions = Uniform(300000, 100000);
            for (int i = 0; i < positions.Length; i++)
                positions[i].z = positions[i].x / 3 + positions[i].y / 5;
            Prove(MemoryReader.Of(positions, s_centimetres),
                new ConvertSettings { PointsPerChunk = 60000, Sampler = Sampler.Poisson });
            var verified = Verify(null);
            int sampledLevels = 0;
            foreach (var (level, near) in verified.Levels.Zip(Spacings(Target("cloud")), (level, near) => (level, near)))
            {
                TestContext.WriteLine(level.Nodes + " nodes, " + level.SampledPoints + " of " +
                    level.Points + " points sampled, " +
                    near.MinDistance / level.Spacing + " spacings, " + near.NearAcrossChunks + " nearer across chunks");
                if (level.SampledPoints == 0)
                    continue;
                sampledLevels++;
                Assert.That(near.MinDistance, Is.GreaterThanOrEqualTo(0.99 * level.Spacing));
                Assert.That(near.NearAcrossChunks, Is.LessThanOrEqualTo(0.003 * level.SampledPoints));
            }
            Assert.That(sampledLevels, Is.GreaterThan(1));
        }

        [Test]
        public void Convert_Average_KeepsTheValuesAndAddsTheirMeans()
        {
            var positions = Uniform(200000, 100000);
            for (int i = 0; i < positions.Length; i++)
                positions[i].z = 0;
            var reader = MemoryReader.Of(positions, s_centimetres);
            Prove(reader, new ConvertSettings { PointsPerChunk = 60000, Sampler = Sampler.Average });
            using var folder = CloudFolder.Open(Target());
            using var selection = new NodeSelection(folder);
            Assert.That(folder.Layout.Planes[folder.Layout.Planes.Count - 1].Name, Does.EndWith(StoreLayout.AverageSuffix));
            // Noise of the whole range of 16 bits: the values' deviation is that of one, the means' that of many.
            const double one = 65536 / 3.4641016;
            Assert.That(Deviation(folder, selection, null, 10), Is.LessThan(0.6 * one));
            Assert.That(Deviation(folder, selection, null, 1000000), Is.EqualTo(one).Within(300));
            // A corner of the cloud, to its leaves: nothing that is seen stands for anything else, and most of the rest is
            // not chosen.
            var corner = Camera.Orthographic(new double3(60, 60, 100), new double3(60, 60, 0), new double3(0, 1, 0), 100);
            Assert.That(Deviation(folder, selection, corner, 1000000), Is.EqualTo(one).Within(600));
            Assert.That(selection.Points, Is.LessThan(100000));
        }

        [Test]
        public unsafe void LoadNodes_InManyReads_FillsTheSameBatch()
        {
            Prove(MemoryReader.Of(Uniform(200000, 100000), s_centimetres), new ConvertSettings { PointsPerChunk = 60000 });
            using var folder = CloudFolder.Open(Target());
            using var selection = new NodeSelection(folder);
            selection.Choose(null, 100000);
            var schema = LoadNodes.SchemaFor(folder, AttributeNames.Intensity);
            using var whole = new PointBatch(schema, (int)selection.Points, Allocator.Persistent);
            using var parts = new PointBatch(schema, (int)selection.Points, Allocator.Persistent);
            JobCoroutine.RunToEnd(LoadNodes.Run(folder, selection, whole, null));
            // A node at a time, and a few.
            foreach (long max in new[] { 1, 100000 })
            {
                JobCoroutine.RunToEnd(LoadNodes.Run(folder, selection, parts, null, max));
                Assert.That(parts.Count, Is.EqualTo(whole.Count));
                for (int c = 0; c < schema.Count; c++)
                    Assert.That(UnsafeUtility.MemCmp(ColumnOf(parts, c), ColumnOf(whole, c),
                        (long)whole.Count * schema[c].Type.SizeOf()), Is.Zero, schema[c].Name);
            }
        }

        static unsafe byte* ColumnOf(PointBatch batch, int column) =>
            (byte*)batch.Bytes.GetUnsafeReadOnlyPtr() + batch.Column(column).OffsetBytes;

        static unsafe double Deviation(CloudFolder folder, NodeSelection selection, Camera? camera, long budget)
        {
            selection.Choose(camera?.ToStreamView(4000, 4000), budget);
            var schema = LoadNodes.SchemaFor(folder, AttributeNames.Intensity);
            using var batch = new PointBatch(schema, (int)selection.Points, Allocator.Persistent);
            JobCoroutine.RunToEnd(LoadNodes.Run(folder, selection, batch, null));
            var values = (ushort*)((byte*)batch.Bytes.GetUnsafeReadOnlyPtr() +
                batch.Column(schema.IndexOf(AttributeNames.Intensity)).OffsetBytes);
            double sum = 0, squares = 0;
            for (int i = 0; i < batch.Count; i++)
            {
                sum += values[i];
                squares += (double)values[i] * values[i];
            }
            double mean = sum / batch.Count;
            Assert.That(mean, Is.EqualTo(32768).Within(400));
            return math.sqrt(squares / batch.Count - mean * mean);
        }

        [Test]
        public void Convert_Cancelled_LeavesNothing()
        {
            var work =
                new CoroutineStack(ConvertCloud.Run(new[] { MemoryReader.Of(Uniform(30000, 1000), s_centimetres) }, Target(),
                new ConvertSettings { PointsPerChunk = 3000 }, r => { }, null));
            for (int i = 0; i < 60 && work.MoveNext(); i++)
                work.Current.Complete();
            work.Dispose();
            FileChanges.AwaitDeletes();
            Assert.That(Directory.GetFileSystemEntries(Folder.Path), Is.Empty);
        }

        [Test]
        public void Convert_TargetWithOtherThings_IsRefused()
        {
            Directory.CreateDirectory(Target());
            File.WriteAllText(Path.Combine(Target(), "letter.txt"), "mine");
            Assert.That(() => Convert(MemoryReader.Of(Uniform(10, 10), s_centimetres)), Throws.TypeOf<PointCloudException>());
            Assert.That(File.Exists(Path.Combine(Target(), "letter.txt")), Is.True);
        }

        [Test]
        public void Verify_OtherSource_ReportsIt()
        {
            var positions = Uniform(2000, 1000);
            Convert(MemoryReader.Of(positions, s_centimetres));
            positions[1000].x ^= 1;
            Assert.That(Verify(MemoryReader.Of(positions, s_centimetres)).Ok, Is.False);
            positions[1000].x ^= 1;
            Assert.That(Verify(MemoryReader.Of(positions, s_centimetres)).Ok, Is.True);
            Assert.That(Verify(MemoryReader.Of(positions, s_centimetres, 1000, 2)).Ok, Is.False);
        }

        [Test]
        public void Verify_AnyByteChanged_FindsIt()
        {
            Convert(MemoryReader.Of(Uniform(40000, 2000), s_centimetres), "cloud",
                new ConvertSettings { PointsPerChunk = 25000 });
            Assert.That(Verify(null).Ok, Is.True);
            var random = new System.Random(11);
            foreach (string file in Directory.GetFiles(Target(), "*.bin", SearchOption.AllDirectories))
            {
                byte[] good = File.ReadAllBytes(file);
                for (int i = 0; i < 8; i++)
                {
                    var bad = (byte[])good.Clone();
                    // Headers, tables and planes alike.
                    int at = i == 0 ? 20 : i == 1 ? bad.Length - 1 - random.Next(100) : random.Next(bad.Length);
                    bad[at] ^= (byte)(1 << random.Next(8));
                    File.WriteAllBytes(file, bad);
                    Assert.That(Verify(null).Ok, Is.False, file + " at " + at);
                }
                File.WriteAllBytes(file, new ArraySegment<byte>(good, 0, good.Length - 16).ToArray());
                Assert.That(Verify(null).Ok, Is.False, file + " cut short");
                File.Delete(file);
                Assert.That(Verify(null).Ok, Is.False, file + " missing");
                File.WriteAllBytes(file, good);
            }
            Assert.That(Verify(null).Ok, Is.True);
        }
    }
}
