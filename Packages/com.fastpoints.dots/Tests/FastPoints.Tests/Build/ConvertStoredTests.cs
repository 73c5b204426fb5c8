using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Build;
using FastPoints.Export;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Store;
using FastPoints.Tests.Nodes;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Build
{
    public class ConvertStoredTests : FolderTests
    {
        const int Points = 200000;

        static readonly PositionTransform s_centimetres = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01) };

        static MemoryReader Uneven(int count = Points, int blockPoints = 2000)
        {
            var random = new Unity.Mathematics.Random(5);
            var positions = new int3[count];
            for (int i = 0; i < count; i++)
            {
                positions[i] = i % 4 == 0 ? new int3(70000, 60000, 50000) + random.NextInt3(300)
                    : random.NextInt3(new int3(100000, 100000, 1000));
            }
            positions[count * 2 / 3] = new int3(-300000000, 7, 7);
            return MemoryReader.Of(positions, s_centimetres, blockPoints);
        }

        static MemoryReader Equal(int count)
        {
            var positions = new int3[count];
            for (int i = 0; i < count; i++)
                positions[i] = new int3(-5, 600, 7);
            return MemoryReader.Of(positions, s_centimetres, 5000);
        }

        static ConvertSettings InFiles(long pointsPerChunk = 10000) => new ConvertSettings
        {
            PointsPerChunk = pointsPerChunk,
            MemoryBytes = 3 << 20,
            PointsPerCheckpoint = 50000,
        };

        [Test]
        public void Convert_StarvedWorkers_KeepsBlocksInFlightWithinTheMemory([Values(1, 8)] int memoryMegabytes)
        {
            var reader = Uneven(300000, 500);
            var settings = InFiles();
            settings.MemoryBytes = memoryMegabytes << 20;
            settings.InFlightMs = 1e9;
            settings.SecondsToFirstGeneration = 1e9;
            Convert(reader, "cloud", settings);
            Assert.That(reader.MaxSlotBytes, Is.LessThanOrEqualTo(settings.MemoryBytes / 4));
            Assert.That(reader.MaxSlotBytes, Is.GreaterThan(settings.MemoryBytes / 16), "reads are ahead");
            Assert.That(reader.SlotBytes, Is.Zero);
        }

        static ConvertSettings InMemory(long pointsPerChunk = 10000) => new ConvertSettings { PointsPerChunk = pointsPerChunk };

        string Target(string name) => Folder.File(name + StoreFormat.FolderExtension);

        ConvertResult Convert(PointReader reader, string name, ConvertSettings settings)
        {
            ConvertResult result = null;
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, Target(name), settings, r => result = r, null));
            return result;
        }

        void Prove(PointReader reader, string name)
        {
            Assert.That(Verified(name, reader).Points, Is.EqualTo(reader.PointCount));
        }

        Dictionary<string, byte[]> Files(string name)
        {
            var files = new Dictionary<string, byte[]>();
            foreach (string file in Directory.GetFiles(Target(name), "*", SearchOption.AllDirectories))
                files.Add(file.Substring(Target(name).Length), File.ReadAllBytes(file));
            return files;
        }

        static void AssertSame(Dictionary<string, byte[]> got, Dictionary<string, byte[]> wanted)
        {
            Assert.That(got.Keys, Is.EquivalentTo(wanted.Keys));
            foreach (var file in wanted)
                Assert.That(got[file.Key], Is.EqualTo(file.Value), file.Key);
        }

        [Test]
        public void Convert_MorePointsThanMemory_WritesTheSameBytesWithAnyWorkers()
        {
            Convert(Uneven(), "memory", InMemory());
            var wanted = Files("memory");
            foreach (int workers in new[] { 1, 2, 7 })
            {
                using var threads = new WorkerCount(workers);
                var made = Convert(Uneven(), "w" + workers, InFiles());
                Assert.That(made.TemporaryBytesPeak, Is.GreaterThan(0));
                Assert.That(made.SliceMs, Is.Ordered.And.All.GreaterThan(0));
                AssertSame(Files("w" + workers), wanted);
            }
            Prove(Uneven(), "memory");
        }

        [Test]
        public void Convert_PointsAtOnePosition_AreSplitByCountIntoOneChain()
        {
            const int count = 330000;
            var reader = Equal(count);
            var made = Convert(reader, "memory", InMemory(70000));
            Assert.That(made.Manifest.ChunkCount, Is.GreaterThan(0));
            Assert.That(made.Manifest.Root.SideLog2, Is.EqualTo(0));
            Prove(reader, "memory");
            Convert(Equal(count), "files", InFiles(70000));
            AssertSame(Files("files"), Files("memory"));
        }

        [Test]
        public void Convert_ManySmallChunks_MergesTopsByRegion()
        {
            // Tops of a filled volume are as large as nodes may be: 8 * 50,000 points are one region's.
            var random = new Unity.Mathematics.Random(9);
            var positions = new int3[1000000];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = random.NextInt3(4000);
            var reader = MemoryReader.Of(positions, s_centimetres, 20000);
            var made = Convert(reader, "cloud", InMemory(20000));
            Assert.That(made.Manifest.NodeCount, Is.GreaterThan(10));
            Prove(reader, "cloud");
        }

        [Test]
        public void Convert_PoissonInRegions_KeepsTheSpacingWithinRegions()
        {
            // Chunks are their tops whole: so many points that two regions and the root sample them.
            var random = new Unity.Mathematics.Random(9);
            var positions = new int3[850000];
            for (int i = 0; i < positions.Length; i++)
                positions[i] = new int3(random.NextInt(40000), random.NextInt(40000), 0);
            Convert(MemoryReader.Of(positions, s_centimetres, 20000), "cloud",
                new ConvertSettings { PointsPerChunk = 20000, Sampler = Sampler.Poisson });
            Assert.That(Directory.GetFiles(Path.Combine(Target("cloud"), StoreFormat.UpperFolderName)),
                Has.Length.GreaterThan(1));
            var result = Verified("cloud");
            int levels = 0;
            double ofAll = double.PositiveInfinity;
            var spacings = ConvertCloudTests.Spacings(Target("cloud"));
            foreach (var (level, near) in result.Levels.Zip(spacings, (level, near) => (level, near)))
            {
                TestContext.WriteLine(level.SampledPoints + " of " + level.Points + " points sampled, " +
                    near.MinDistance / level.Spacing + " spacings, " +
                    near.MinDistanceAcrossChunks / level.Spacing + " of all");
                if (level.SampledPoints == 0)
                    continue;
                levels++;
                Assert.That(near.MinDistance, Is.GreaterThanOrEqualTo(0.99 * level.Spacing));
                ofAll = Math.Min(ofAll, near.MinDistanceAcrossChunks / level.Spacing);
            }
            Assert.That(levels, Is.GreaterThan(1));
            Assert.That(ofAll, Is.LessThan(0.99), "what was sampled apart has such distances too");
        }

        /// <summary>What would fit into memory, too, once it takes long.</summary>
        [Test, Category("Long"), Explicit]
        public void Convert_AbortedAnywhereInMemory_ResumesToTheSameBytes() =>
            Convert_AbortedAnywhere_ResumesToTheSameBytes(true);

        [TestCase(false)]
        public void Convert_AbortedAnywhere_ResumesToTheSameBytes(bool fits)
        {
            ConvertSettings Settings()
            {
                var settings = fits ? InMemory() : InFiles();
                (settings.PointsPerCheckpoint, settings.SecondsInMemory) = (50000, 0);
                return settings;
            }
            Convert(Uneven(), "whole", InMemory());
            var wanted = Files("whole");
            var progress = new StageProgress();
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { Uneven() }, Target("count"), Settings(), r => { }, progress));
            int stages = progress.Finished.Count;
            var random = new System.Random(4);
            int continued = 0;
            for (int attempt = 0; attempt < 6; attempt++)
            {
                string name = "broken" + attempt, part = Target(name) + StoreFormat.UnfinishedSuffix, kept = part + "-kept";
                progress = new StageProgress();
                var work = new CoroutineStack(ConvertCloud.Run(new[] { Uneven() }, Target(name), Settings(), r => { }, progress));
                // Steps depend on how fast reads and writes are.
                double stop = (attempt + random.NextDouble()) / 6 * stages;
                while (progress.Finished.Count + progress.Fraction < stop && work.MoveNext())
                    work.Current.Complete();
                // What a kill would leave: the folder as it is now, and a file that nobody closed.
                bool isWhole = Directory.Exists(Target(name));
                if (!isWhole)
                {
                    CopyWhileWritten(part, kept);
                    foreach (string file in Directory.GetFiles(Path.Combine(kept, BuildFiles.RecordFolderName)))
                        using (var stream = File.Open(file, FileMode.Append))
                            stream.Write(new byte[77], 0, 77);
                }
                work.Dispose();
                if (isWhole)
                    continue;
                Assert.That(Directory.Exists(part), Is.False, "cancelled");
                Directory.Move(kept, part);
                var made = Convert(Uneven(), name, Settings());
                continued += made.Note != null && made.Note.StartsWith("continued") ? 1 : 0;
                AssertSame(Files(name), wanted);
            }
            Assert.That(continued, Is.GreaterThan(2));
        }

        [Test]
        public void Convert_SlowReading_CanResumeAfterFewerPoints([Values(0, 1e9)] double secondsPerCheckpoint)
        {
            var settings = InFiles();
            (settings.PointsPerCheckpoint, settings.SecondsPerCheckpoint) = (100_000, secondsPerCheckpoint);
            string journal = Path.Combine(Target("cloud") + StoreFormat.UnfinishedSuffix, BuildFiles.JournalName);
            var blocks = new HashSet<int>();
            using (var work = new CoroutineStack(ConvertCloud.Run(new[] { Uneven(200_000, 500) }, Target("cloud"), settings, r =>
                { },
                null)))
            {
                while (work.MoveNext())
                {
                    work.Current.Complete();
                    var read = File.Exists(journal) ? BuildJournal.FromJson(File.ReadAllText(journal)) : null;
                    if (read != null && read.CurrentStage == BuildJournal.Stage.Read)
                        blocks.Add(read.Block);
                }
            }
            Assert.That(blocks, Has.Count.InRange(secondsPerCheckpoint == 0 ? 4 : 0, secondsPerCheckpoint == 0 ? 400 : 3));
        }

        [Test]
        public void Convert_AbortedWithOtherSettings_BeginsAgain()
        {
            string part = Target("cloud") + StoreFormat.UnfinishedSuffix;
            var work = new CoroutineStack(ConvertCloud.Run(new[] { Uneven() }, Target("cloud"), InFiles(), r => { }, null));
            while (!File.Exists(Path.Combine(part, BuildFiles.JournalName)) && work.MoveNext())
                work.Current.Complete();
            Copy(part, part + "-kept");
            work.Dispose();
            Directory.Move(part + "-kept", part);
            var made = Convert(Uneven(), "cloud", InFiles(20000));
            Assert.That(made.Note, Does.Contain("began again"));
            Prove(Uneven(), "cloud");
        }

        [Test]
        public void Convert_DamagedTemporaryFiles_FailsOrBeginsAgain()
        {
            string part = Target("cloud") + StoreFormat.UnfinishedSuffix;
            var work = new CoroutineStack(ConvertCloud.Run(new[] { Uneven() }, Target("cloud"), InFiles(), r => { }, null));
            int tops = 0;
            while (tops < 3 && work.MoveNext())
            {
                work.Current.Complete();
                tops = Directory.GetFiles(Path.Combine(part, BuildFiles.TopFolderName), "*.bin").Length;
            }
            CopyWhileWritten(part, part + "-kept");
            work.Dispose();
            var random = new System.Random(8);
            for (int attempt = 0; attempt < 8; attempt++)
            {
                Copy(part + "-kept", part);
                string[] files = Directory.GetFiles(part, "*", SearchOption.AllDirectories);
                Array.Sort(files, string.CompareOrdinal);
                string file = files[random.Next(files.Length)];
                byte[] bytes = File.ReadAllBytes(file);
                if (bytes.Length == 0 || attempt % 3 == 0)
                    Array.Resize(ref bytes, bytes.Length / 2);
                else
                    bytes[random.Next(bytes.Length)] ^= (byte)(1 << random.Next(8));
                File.WriteAllBytes(file, bytes);
                try
                {
                    Convert(Uneven(), "cloud", InFiles());
                    Prove(Uneven(), "cloud");
                    Directory.Delete(Target("cloud"), true);
                }
                catch (PointCloudException)
                {
                    Assert.That(Directory.Exists(Target("cloud")), Is.False);
                }
                Assert.That(Directory.Exists(part), Is.False, file);
            }
        }

        [Test]
        public void Convert_TwoOfOneTarget_TheSecondIsRefused()
        {
            var first = new CoroutineStack(ConvertCloud.Run(new[] { Uneven() }, Target("cloud"), InFiles(), r => { }, null));
            for (int i = 0; i < 30 && first.MoveNext(); i++)
                first.Current.Complete();
            Assert.That(() => Convert(Uneven(), "cloud", InFiles()), Throws.TypeOf<PointCloudException>().With.Message.Contains(
                "is being built by process " + System.Diagnostics.Process.GetCurrentProcess().Id + " on "));
            while (first.MoveNext())
                first.Current.Complete();
            first.Dispose();
            Prove(Uneven(), "cloud");
        }

        [Test]
        public void Convert_CancelledWithTemporaryFiles_LeavesNothing()
        {
            string part = Target("cloud") + StoreFormat.UnfinishedSuffix;
            var work = new CoroutineStack(ConvertCloud.Run(new[] { Uneven() }, Target("cloud"), InFiles(), r => { }, null));
            while (!File.Exists(Path.Combine(part, BuildFiles.JournalName)) && work.MoveNext())
                work.Current.Complete();
            for (int i = 0; i < 20 && work.MoveNext(); i++)
                work.Current.Complete();
            work.Dispose();
            FileChanges.AwaitDeletes();
            Assert.That(Directory.GetFileSystemEntries(Folder.Path), Is.Empty);
        }

        [TestCase(true, Sampler.Random), TestCase(false, Sampler.Random), TestCase(true, Sampler.Poisson)]
        [TestCase(false, Sampler.Average)]
        public void Convert_BeforeTheFirstChunk_ShowsPlaceholdersThatChunksReplace(bool inFiles, Sampler sampler)
        {
            var settings = inFiles ? InFiles() : InMemory();
            settings.SecondsToFirstGeneration = 0;
            settings.SecondsPerGeneration = 0;
            settings.Sampler = sampler;
            settings.MemoryBytes *= inFiles ? 4 : 1;
            long generation = 0, first = 0, last = 0;
            foreach (long next in Generations(settings))
            {
                generation = next;
                last = Verified("cloud").Points;
                if (generation > 1)
                    continue;
                first = last;
                using var cloud = CloudFolder.Open(Target("cloud"));
                Assert.That(cloud.Manifest.ChunkCount, Is.Zero);
                var size = cloud.Manifest.BoundsMax - cloud.Manifest.BoundsMin;
                Assert.That(Math.Min(size.X, size.Y), Is.GreaterThan(99000));
            }
            Assert.That(generation, Is.GreaterThan(1));
            // A sample of several slices.
            Assert.That(first, Is.InRange(inFiles ? 1000 : 24000, Points / 2));
            Assert.That(last, Is.InRange(first + 1, Points - 1));
            Prove(Uneven(), "cloud");
        }

        [TestCase(true), TestCase(false)]
        public void Convert_Unfinished_CanBeOpenedAndVerified(bool inFiles)
        {
            var settings = inFiles ? InFiles() : InMemory();
            settings.SecondsPerGeneration = 0;
            settings.MemoryBytes *= inFiles ? 4 : 1;
            long points = 0;
            int generations = 0;
            foreach (long _ in Generations(settings))
            {
                if (generations++ % 8 != 0)
                    continue;
                var result = Verified("cloud");
                Assert.That(result.IsBuilding, Is.True);
                Assert.That(result.Points, Is.InRange(Math.Max(1, points), Points - 1));
                points = result.Points;
            }
            Assert.That(generations, Is.GreaterThan(0));
            Prove(Uneven(), "cloud");
            Assert.That(Directory.GetFiles(Target("cloud")), Has.Length.EqualTo(4));
        }

        IEnumerable<long> Generations(ConvertSettings settings)
        {
            string manifest = Path.Combine(Target("cloud") + StoreFormat.UnfinishedSuffix, StoreFormat.ManifestName);
            long generation = 0;
            using var work = new CoroutineStack(ConvertCloud.Run(new[] { Uneven() }, Target("cloud"), settings, r => { }, null));
            while (work.MoveNext())
            {
                work.Current.Complete();
                var said = File.Exists(manifest) ? ReadManifest(manifest) : null;
                if (said != null && said.IsBuilding && said.Generation != generation)
                    yield return generation = said.Generation;
            }
        }

        /// <summary>Null where a thread of the pool has just given the folder its final name.</summary>
        static CloudManifest ReadManifest(string path)
        {
            try
            {
                return CloudManifest.FromJson(File.ReadAllText(path), path);
            }
            catch (DirectoryNotFoundException)
            {
                return null;
            }
        }

        VerifyResult Verified(string name, params PointReader[] sources)
        {
            var result = new VerifyResult();
            JobCoroutine.RunToEnd(VerifyCloud.Run(Target(name), sources, result, null));
            Assert.That(result.Problems, Is.Empty);
            return result;
        }

        [TestCase(1000L, 928L << 20, false, 200000L)]
        [TestCase(20000000L, 928L << 20, false, 1000000L)]
        [TestCase(20000000L, 580L << 20, false, 1000000L)]
        [TestCase(20000000L, 204L << 20, true, 1000000L)]
        [TestCase(1L << 40, 928L << 20, true, 1000000L)]
        [TestCase(1L << 40, 1L << 20, true, 1000000L)]
        public void Plan_AnyNumberOfPoints_StaysWithinItsMemory(long points, long memory, bool isStored, long pointsPerChunk)
        {
            const int stride = 20;
            var plan = MemoryPlan.For(points, stride, new ConvertSettings { MemoryBytes = memory });
            Assert.That(plan.UsesTemporaryFiles, Is.EqualTo(isStored));
            Assert.That(plan.PointsPerChunk, Is.EqualTo(pointsPerChunk));
            Assert.That(plan.MaxPointsPerPlannedCube, Is.GreaterThanOrEqualTo(plan.PointsPerPlannedCube));
            if (isStored && memory > 8 << 20)
            {
                long pages = plan.MaxPages + plan.MaxWaitingPages;
                Assert.That(plan.ReadBytes + pages * RecordPages.PageBytes(stride), Is.LessThanOrEqualTo(memory));
                Assert.That(points / plan.MaxPointsPerPlannedCube * 16, Is.LessThanOrEqualTo(plan.MaxPages + 16));
            }
        }

        [Test]
        public void Plan_LargeRecords_HasSmallerChunksThatNeedAsMuchMemory([Values] Sampler sampler)
        {
            foreach (int stride in new[] { 12, 20, 40, 80, 200 })
            {
                var plan = MemoryPlan.For(1L << 34, stride, new ConvertSettings { Sampler = sampler });
                Assert.That(plan.PointsPerChunk * plan.IndexBytesPerPoint, Is.InRange(54 << 20, 192 << 20));
                Assert.That(plan.MinMemoryBytes, Is.LessThanOrEqualTo(204 << 20), "300MiB are enough");
            }
        }

        /// <summary>Copies a folder as it is at one moment, though another thread writes and renames files in it.</summary>
        static void CopyWhileWritten(string from, string to)
        {
            IEnumerable<(string, long, DateTime)> State() => Directory.GetFiles(from, "*", SearchOption.AllDirectories)
                .OrderBy(f => f, StringComparer.Ordinal).Select(f => (f, new FileInfo(f).Length, File.GetLastWriteTimeUtc(f)));
            for (bool isSame = false; !isSame;)
            {
                try
                {
                    var before = State().ToList();
                    Copy(from, to);
                    isSame = State().SequenceEqual(before);
                }
                catch (IOException)
                {
                    // A file has got another name.
                }
                if (!isSame && Directory.Exists(to))
                    Directory.Delete(to, true);
            }
        }

        static void Copy(string from, string to)
        {
            Directory.CreateDirectory(to);
            foreach (string folder in Directory.GetDirectories(from))
                Copy(folder, Path.Combine(to, Path.GetFileName(folder)));
            foreach (string file in Directory.GetFiles(from))
                if (Path.GetFileName(file) != "build.lock")
                    File.Copy(file, Path.Combine(to, Path.GetFileName(file)), true);
        }
    }
}
