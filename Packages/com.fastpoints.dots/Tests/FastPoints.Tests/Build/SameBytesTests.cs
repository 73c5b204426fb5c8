using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Build;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Tests.Nodes;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Build
{
    /// <summary>What is stored depends on sources and settings alone.</summary>
    public class SameBytesTests : FolderTests
    {
        static readonly PositionTransform s_centimetres = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01) };

        /// <summary>A terrain with a dense corner, many points at one position, and outliers that no sample knows of.</summary>
        public static int3[] Terrain(int count)
        {
            var random = new Unity.Mathematics.Random(5);
            var positions = new int3[count];
            for (int i = 0; i < count; i++)
                positions[i] = i % 5 == 0 ? new int3(70000, 60000, 500) + random.NextInt3(3000)
                    : i % 50 == 1 ? new int3(31, 32, 33) : random.NextInt3(new int3(100000, 100000, 1000));
            positions[count * 2 / 3] = new int3(-300000000, 7, 7);
            positions[count * 2 / 3 + 1] = new int3(-300000000, 7, 9);
            return positions;
        }

        static MemoryReader Reader(int count = 4000) => MemoryReader.Of(Terrain(count), s_centimetres, 2000);

        string Target(string name) => Folder.File(name + StoreFormat.FolderExtension);

        ConvertResult Convert(string name, ConvertSettings settings, params PointReader[] readers)
        {
            ConvertResult result = null;
            JobCoroutine.RunToEnd(ConvertCloud.Run(readers, Target(name), settings, r => result = r, null));
            return result;
        }

        Dictionary<string, byte[]> Files(string name) => Directory.GetFiles(Target(name), "*", SearchOption.AllDirectories)
            .ToDictionary(file => file.Substring(Target(name).Length), File.ReadAllBytes);

        void AssertSame(string got, string wanted)
        {
            var files = Files(got);
            Assert.That(files.Keys, Is.EquivalentTo(Files(wanted).Keys));
            foreach (var file in Files(wanted))
                Assert.That(files[file.Key], Is.EqualTo(file.Value), got + file.Key);
        }

        [Test]
        public void Convert_LittleMemoryAndManyWorkers_WritesTheSameBytes([Values] Sampler sampler) =>
            AssertSameWith(sampler, (7, 1));

        [Test, Category("Long"), Explicit]
        public void Convert_AnyMemoryAndWorkers_WritesTheSameBytes([Values] Sampler sampler) =>
            AssertSameWith(sampler, (1, 928), (7, 24), (1, 4));

        void AssertSameWith(Sampler sampler, params (int Workers, int Megabytes)[] limits)
        {
            const int count = 450000;
            ConvertSettings Settings(int megabytes) => new ConvertSettings
            {
                Sampler = sampler,
                MemoryBytes = megabytes << 20,
            };
            var wanted = Convert("wanted", Settings(928), Reader(count));
            Assert.That(wanted.Manifest.ChunkCount, Is.GreaterThan(3));
            Assert.That(wanted.TemporaryBytesPeak, Is.Zero);
            foreach (var (workers, megabytes) in limits)
            {
                using var threads = new WorkerCount(workers);
                string name = "m" + megabytes + "w" + workers;
                var made = Convert(name, Settings(megabytes), Reader(count));
                Assert.That(made.TemporaryBytesPeak, megabytes == 928 ? Is.Zero : Is.GreaterThan(0));
                AssertSame(name, "wanted");
            }
        }

        /// <summary>With so little memory, a cube of the first partition has several base cells.</summary>
        [Test]
        public void Convert_FirstPartitionCoarserThanBaseCells_WritesTheSameBytes([Values(1500, 4500)] int pointsPerChunk)
        {
            foreach (int megabytes in new[] { 928, 1 })
                Convert("m" + megabytes, new ConvertSettings
                {
                    PointsPerChunk = pointsPerChunk,
                    MemoryBytes = megabytes << 20,
                }, Reader(200000));
            AssertSame("m1", "m928");
        }

        [Test]
        public void Convert_UnevenPoints_MakesChunksOfTheLargestCubesByExactCount()
        {
            const int pointsPerChunk = 10000;
            var positions = Terrain(300000);
            // Smaller leaves: a chunk that is its top whole is none in the hierarchy.
            Convert("cloud", new ConvertSettings { PointsPerChunk = pointsPerChunk, TargetPointsPerLeaf = 500, CellsLog2 = 4 },
                MemoryReader.Of(positions, s_centimetres, 2000));
            using var folder = CloudFolder.Open(Target("cloud"));
            var (root, origin) = (folder.Manifest.Root, folder.Manifest.Grid.Origin);
            var steps = Array.ConvertAll(positions, p => new Grid3(p.x, p.y, p.z));
            int CountIn(GridCube cube) => steps.Count(cube.Contains);
            Assert.That(math.all(origin == 0));
            Assert.That(CountIn(root), Is.EqualTo(positions.Length));
            int page = 0, largest = 0;
            var chunks = folder.EachTable().Select(_ => folder.PlanesContainerOf(page++))
                .Where(c => c.Kind == ContainerKind.Chunk).ToList();
            Assert.That(chunks.Count, Is.GreaterThan(30));
            foreach (var chunk in chunks)
            {
                var parent = root;
                while (parent.SideLog2 > chunk.SideLog2 + 1)
                    parent = parent.Child(parent.OctantOf(chunk.Corner));
                int count = CountIn(chunk.Cube);
                largest = Math.Max(largest, count);
                Assert.That(count, Is.InRange(1, pointsPerChunk), chunk.Cube.ToString());
                Assert.That(CountIn(parent), Is.GreaterThan(pointsPerChunk), chunk.Cube.ToString());
            }
            Assert.That(largest, Is.GreaterThan(pointsPerChunk / 2));
        }

        [Test]
        public void BaseCells_OfAGrownRoot_FillIt()
        {
            using var none = new NativeArray<long>(1, Allocator.Temp);
            var cube = new GridCube(new Grid3(-8, 0, 16), 4);
            using var map = PartitionMap.Plan(cube, 0, none, 0);
            map.BaseCells = Enumerable.Range(0, 16).Select(i => i < 8 ? cube.Child(0).Child(i) : cube.Child(i - 8))
                .Where((_, i) => i != 8).ToArray();
            var shells = RootCube.Grow(cube, new Grid3(-30, 0, 16), new Grid3(7, 40, 31));
            var cells = new BaseCells(cube, map.BaseCells, shells);
            Assert.That(cells.Root, Is.EqualTo(shells[shells.Length - 1]));
            Assert.That(cells.Around, Has.Length.EqualTo(7 * shells.Length));
            Assert.That(cells.In(cells.Root).Sum(c => math.pow(8.0, c.SideLog2)), Is.EqualTo(math.pow(8.0, cells.Root.SideLog2)));
            Assert.That(cells.In(cube), Is.EqualTo(map.BaseCells));
            var random = new Unity.Mathematics.Random(3);
            for (int i = 0; i < 1000; i++)
            {
                var at = random.NextInt3((int)cells.Root.Side);
                var position = cells.Root.Corner + new Grid3(at.x, at.y, at.z);
                Assert.That(cells.At(position).Contains(position), position.ToString());
            }
        }

        [Test]
        public void Convert_SourcesMovedAndTouched_WritesTheSameBytes()
        {
            var random = new Unity.Mathematics.Random(7);
            for (int tile = 0; tile < 3; tile++)
                Folder.Write("here/tile" + tile + ".xyz", string.Concat(Enumerable.Range(0, 5000).Select(_ =>
                    random.NextInt(1000) + " " + random.NextInt(1000) + " " + random.NextInt(100) + "\n")));
            void ConvertAll(string folder, string name)
            {
                using (var one = PointReaders.Open(Folder.File(folder + "/tile1.xyz")))
                    Convert(name + "1", new ConvertSettings(), one);
                using var all = PointReaders.Open(Directory.GetFiles(Folder.File(folder)).OrderBy(f => f).ToArray());
                Convert(name, new ConvertSettings { PointsPerChunk = 3000 }, all);
            }
            ConvertAll("here", "before");
            Directory.Move(Folder.File("here"), Folder.File("elsewhere"));
            foreach (string file in Directory.GetFiles(Folder.File("elsewhere")))
                File.SetLastWriteTimeUtc(file, new DateTime(2001, 2, 3, 4, 5, 6, DateTimeKind.Utc));
            ConvertAll("elsewhere", "after");
            AssertSame("after", "before");
            AssertSame("after1", "before1");
        }

        [Test]
        public void CloudId_OtherContentOrSettings_Differs()
        {
            var ids = new Dictionary<ulong, string>();
            void Add(string name, PointReader reader, ConvertSettings settings = null)
            {
                using (reader)
                    ids.Add(Convert(name, settings ?? new ConvertSettings(), reader).Manifest.CloudId, name);
            }
            var moved = Terrain(4000);
            moved[1234].z++;
            var named = Reader();
            named.Info.Path = "elsewhere/other";
            var sized = Reader();
            sized.Info.FileBytes++;
            var headed = Reader();
            headed.Info.HeadHash++;
            var filtered = Reader();
            filtered.Filter = 7;
            Add("plain", Reader());
            Add("a position", MemoryReader.Of(moved, s_centimetres, 2000));
            Add("a point", Reader(4001));
            Add("name", named);
            Add("size", sized);
            Add("head", headed);
            Add("filter", filtered);
            Add("attributes", Reader(), new ConvertSettings { Attributes = new[] { AttributeNames.Intensity } });
            Add("cells", Reader(), new ConvertSettings { CellsLog2 = 5 });
            Add("leaf", Reader(), new ConvertSettings { TargetPointsPerLeaf = 1000 });
            Add("chunks", Reader(), new ConvertSettings { PointsPerChunk = 1000 });
            foreach (var sampler in new[] { Sampler.Random, Sampler.Average })
                Add(sampler.ToString(), Reader(), new ConvertSettings { Sampler = sampler });
            var again = Reader();
            again.Info.Path = "elsewhere/" + again.Info.Path;
            Assert.That(ids[Convert("again", new ConvertSettings { MemoryBytes = 1 << 20 }, again).Manifest.CloudId],
                Is.EqualTo("plain"));
        }

        [Test]
        public void Convert_LimitBelowOneChunk_IsRefusedBeforeReading()
        {
            var settings = new ConvertSettings { MemoryBytes = 64 << 20, ProcessBytes = 96 << 20 };
            using (var reader = new VirtualReader(1L << 32))
                Failures.Of(() => Convert("cloud", settings, reader),
                    FailureCode.Unsupported, "memory for a chunk", "wanted at least 2", "got 160MiB");
            FileChanges.AwaitDeletes();
            Assert.That(Directory.GetFileSystemEntries(Folder.Path), Is.Empty);
        }
    }
}
