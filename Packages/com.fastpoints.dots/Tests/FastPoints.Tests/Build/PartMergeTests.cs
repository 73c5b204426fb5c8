using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Build;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Store;
using FastPoints.Tests.Nodes;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Build
{
    /// <summary>Upper levels and hierarchy that were made in parts are those of one build.</summary>
    public class PartMergeTests : FolderTests
    {
        static readonly PositionTransform s_centimetres = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01) };

        ConvertSettings m_settings;
        ConvertResult m_made;
        RecordLayout m_records;

        /// <summary>The finished chunks of one build, as they are before the merge.</summary>
        string[] m_chunks;
        GridCube[] m_cubes;

        string Target => Folder.File("whole" + StoreFormat.FolderExtension);

        /// <summary>Converts a filled cube with a dense corner, and many points at one place.</summary>
        void Convert(Sampler sampler, int count = 40000)
        {
            var random = new Unity.Mathematics.Random(5);
            var positions = new int3[count];
            for (int i = 0; i < count; i++)
                positions[i] = i % 3 == 0 ? new int3(70000, 60000, 50000) + random.NextInt3(3000)
                    : i % 10 == 1 ? new int3(31, 32, 33) : random.NextInt3(100000);
            m_settings = new ConvertSettings
            {
                Sampler = sampler,
                CellsLog2 = 4,
                MaxPointsPerLeaf = 100,
                PointsPerChunk = 600,
                PointsPerRegion = 2500,
                MemoryBytes = 1 << 19,
                SecondsPerGeneration = 1e9,
                SecondsToFirstGeneration = 1e9,
            };
            var reader = MemoryReader.Of(positions, s_centimetres, 2000);
            var progress = new StageProgress();
            string tops = Folder.File("chunks");
            var work = new CoroutineStack(
                ConvertCloud.Run(new[] { reader }, Target, m_settings, r => m_made = r, progress));
            while (work.MoveNext())
            {
                work.Current.Complete();
                if (progress.Current != BuildStages.Merge || Directory.Exists(tops))
                    continue;
                Directory.CreateDirectory(tops);
                foreach (string file in Directory.GetFiles(
                    Path.Combine(Target + StoreFormat.PartSuffix, BuildFiles.TopFolderName)))
                    File.Copy(file, Path.Combine(tops, Path.GetFileName(file)));
            }
            m_chunks = Directory.GetFiles(tops).OrderBy(f => f, StringComparer.Ordinal).ToArray();
            m_records = GridChoice.Choose(new[] { reader.Info }, new SampleStatistics[1], m_made.Manifest.Attributes.BytesPerPoint)
                .Records;
            TestContext.WriteLine(m_chunks.Length + " chunks, temporary " + m_made.TemporaryBytesPeak + " " + m_made.Manifest.Points);
            m_cubes = m_chunks.Select((_, i) => ChunkOf(i, false).Chunk.Container.Cube).ToArray();
        }

        BuildPart PartOf(GridCube whole, GridCube cube) => new BuildPart
        {
            CloudId = m_made.Manifest.CloudId,
            Points = m_made.Manifest.Points,
            PointsPerChunk = m_settings.PointsPerChunk,
            Grid = m_made.Manifest.Grid,
            Records = m_records,
            Attributes = m_made.Manifest.Attributes,
            Divisors = m_made.Manifest.Divisors,
            Whole = whole,
            Cube = cube,
        };

        (ChunkResult Chunk, NativeArray<byte> Records) ChunkOf(int number, bool isLoaded)
        {
            int stride = m_records.ForTops(m_made.Manifest.HasAverages).StrideBytes;
            using var bytes = new NativeArray<byte>(File.ReadAllBytes(m_chunks[number]), Allocator.Persistent);
            var chunk = ChunkResult.FromBytes(bytes, number, m_made.Manifest.CloudId, m_made.BytesOfPlane.Length, stride);
            if (!isLoaded)
                return (chunk, default);
            chunk.Table = new NativeArray<byte>(bytes.GetSubArray(chunk.TableOffset, chunk.TableBytes), Allocator.Persistent);
            int records = chunk.TopPoints * stride;
            return (chunk, new NativeArray<byte>(bytes.GetSubArray(bytes.Length - records, records), Allocator.Persistent));
        }

        /// <summary>What a build of a part does when its chunks are finished.</summary>
        /// <param name="collects">Whether the chunks are in a cube whose upper levels are wanted.</param>
        PartInput Build(BuildPart part, IEnumerable<int> chunks, string name, bool collects = true)
        {
            string folder = Folder.File(name);
            var owned = new List<IDisposable>();
            using (var build = new BuildContext(part, new PointReader[0], folder, m_settings, null))
            using (var store = new NativeStoreLayout(part.ToManifest(m_settings.Sampler).CreateLayout()))
            using (var merge = new UpperMerge(build, store, part.ToManifest(m_settings.Sampler)))
            {
                var result = new PartResult(part.Attributes.Count, store.Layout.Planes.Count);
                foreach (int number in chunks)
                {
                    // In memory, or in files.
                    var (chunk, records) = ChunkOf(number, number % 2 == 0);
                    if (records.IsCreated)
                        owned.Add(records);
                    else
                        File.Copy(m_chunks[number], build.Folder.PathOf(BuildFiles.TopPath(number)));
                    owned.Add(chunk);
                    merge.Add(chunk, records);
                    result.Checksum += chunk.Checksum;
                    result.Include(chunk.LowestSideLog2, chunk.BytesOfPlane);
                    result.Statistics.Include(new PointStatistics
                    {
                        Count = chunk.TopPoints + chunk.PointCount,
                        Min = m_made.Manifest.BoundsMin,
                        Max = m_made.Manifest.BoundsMax,
                    });
                }
                if (collects)
                    JobCoroutine.RunToEnd(merge.Collect(part.Cube, null));
                result.Include(merge.LowestSideLog2, merge.BytesOfPlane);
                JobCoroutine.RunToEnd(PartFile.Write(build.Folder, part.Cube, part.CloudId, merge, result));
                build.Folder.Keep();
            }
            foreach (var one in owned)
                one.Dispose();
            return InputOf(name);
        }

        PartInput Merge(BuildPart part, IReadOnlyList<PartInput> inputs, string name, Action<PartResult> take)
        {
            JobCoroutine.RunToEnd(PartMerge.Run(part, inputs, Folder.File(name), m_settings, take, null));
            return InputOf(name);
        }

        PartInput InputOf(string name) => new PartInput
        {
            TopsPath = Path.Combine(Folder.File(name) + StoreFormat.PartSuffix, PartFile.TopsName),
            NodesPath = Path.Combine(Folder.File(name) + StoreFormat.PartSuffix, PartFile.NodesName),
        };

        CloudManifest Commit(IEnumerable<string> nodesPaths)
        {
            var manifest = m_made.Manifest.Clone();
            (manifest.Root, manifest.NodeCount, manifest.ChunkCount, manifest.HierarchyBytes) = (default, 0, 0, 0);
            JobCoroutine.RunToEnd(PartMerge.Commit(nodesPaths.ToArray(), manifest, Folder.File("commit"), null));
            return manifest;
        }

        /// <summary>Cuts a cube into at least this many that hold chunks, and some that hold none.</summary>
        /// <param name="merges">Receives the cubes that were cut: each holds several of the others.</param>
        List<GridCube> Cut(GridCube whole, int parts, uint seed, List<GridCube> merges)
        {
            var random = new Unity.Mathematics.Random(seed);
            var cubes = new List<GridCube> { whole };
            while (cubes.Count(c => m_cubes.Any(c.Contains)) < parts)
            {
                var large = cubes.Where(c => m_cubes.Count(c.Contains) > 1 && c.SideLog2 > 0 && !m_cubes.Contains(c)).ToList();
                var cut = large[random.NextInt(large.Count)];
                cubes.Remove(cut);
                merges.Add(cut);
                for (int octant = 0; octant < 8; octant++)
                    cubes.Add(cut.Child(octant));
            }
            return cubes;
        }

        IEnumerable<int> In(GridCube cube) => Enumerable.Range(0, m_cubes.Length).Where(i => cube.Contains(m_cubes[i]));

        void AssertSame(CloudManifest manifest, PartResult result)
        {
            var wanted = m_made.Manifest;
            Assert.That(manifest.Root, Is.EqualTo(wanted.Root));
            var upper = Directory.GetFiles(Path.GetDirectoryName(Target), "*.bin", SearchOption.AllDirectories)
                .Where(f => Path.GetFileName(Path.GetDirectoryName(f)) == StoreFormat.UpperFolderName).ToLookup(Path.GetFileName);
            var names = Directory.GetFiles(Path.Combine(Target, StoreFormat.UpperFolderName)).Select(Path.GetFileName).ToArray();
            Assert.That(upper.Select(f => f.Key), Is.EquivalentTo(names));
            Assert.That(names.Length, Is.GreaterThan(8), "there are regions of regions");
            foreach (var files in upper)
            {
                Assert.That(files.Count(), Is.EqualTo(2), files.Key + " is of one part, and of one build");
                Assert.That(File.ReadAllBytes(files.First()), Is.EqualTo(File.ReadAllBytes(files.Last())), files.Key);
            }
            Assert.That(File.ReadAllBytes(Path.Combine(Folder.File("commit") + StoreFormat.PartSuffix, StoreFormat.HierarchyName)),
                Is.EqualTo(File.ReadAllBytes(Path.Combine(Target, StoreFormat.HierarchyName))));
            Assert.That(manifest.ToJson(), Is.EqualTo(wanted.ToJson()));
            Assert.That(result.Checksum, Is.EqualTo(wanted.Checksum));
            Assert.That(result.Statistics.Count, Is.EqualTo(wanted.Points));
            Assert.That(result.BytesOfPlane, Is.EqualTo(m_made.BytesOfPlane));
            Assert.That(wanted.Root.SideLog2 - result.LowestSideLog2 + 1, Is.EqualTo(m_made.LevelCount));
        }

        /// <param name="levels">Of merges; of more than one, one for each cube that was cut.</param>
        [Test]
        public void Parts_AnyCut_MakeTheBytesOfOneBuild([Values(2, 5, 17)] int parts, [Values] bool mergesOften,
            [Values(Sampler.Average, Sampler.Random)] Sampler sampler)
        {
            Convert(sampler);
            var root = m_made.Manifest.Root;
            // The plan's cube is larger.
            var whole = new GridCube(root.Corner - new Grid3(root.Side, 0, root.Side), root.SideLog2 + 1);
            var merges = new List<GridCube>();
            var inputs = Cut(whole, parts, (uint)parts, merges)
                .Select((cube, i) => (cube, Build(PartOf(whole, cube), In(cube), "build" + i))).ToList();
            if (!mergesOften)
                merges = new List<GridCube> { whole };
            var nodes = inputs.Select(i => i.Item2.NodesPath).ToList();
            PartResult result = null;
            foreach (var cube in merges.OrderBy(c => c.SideLog2).ToList())
            {
                var below = inputs.Where(i => cube.Contains(i.cube)).OrderByDescending(i => i.Item2.NodesPath.GetHashCode()).ToList();
                var merged = Merge(PartOf(whole, cube), below.Select(b => b.Item2).ToList(), "merge" + nodes.Count, r => result = r);
                inputs.RemoveAll(below.Contains);
                inputs.Add((cube, merged));
                nodes.Add(merged.NodesPath);
            }
            nodes.Reverse();
            AssertSame(Commit(nodes), result);
        }

        [Test]
        public void Parts_PointsOutsideThePlansCube_MakeTheBytesOfOneBuild([Values(0, 7)] int octant)
        {
            Convert(Sampler.Poisson);
            var whole = m_made.Manifest.Root.Child(octant);
            var part = PartOf(whole, whole);
            var inputs = new List<PartInput>();
            for (int child = 0; child < 8; child++)
                inputs.Add(Build(PartOf(whole, whole.Child(child)), In(whole.Child(child)), "build" + child));
            inputs.Add(Build(part, Enumerable.Range(0, m_cubes.Length).Except(In(whole)), "outside", false));
            PartResult result = null;
            var merged = Merge(part, inputs, "merge", r => result = r);
            AssertSame(Commit(inputs.Append(merged).Select(i => i.NodesPath)), result);
        }
    }
}
