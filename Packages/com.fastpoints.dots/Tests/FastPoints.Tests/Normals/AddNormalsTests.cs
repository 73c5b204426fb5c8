using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Build;
using FastPoints.Drawing;
using FastPoints.Export;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests
{
    public class AddNormalsTests : FolderTests
    {
        const double Radius = 10;

        string Cloud => Folder.File("sphere.fastpoints");

        [SetUp]
        public void Convert() => Convert(60000, 9);

        [Test]
        public void Run_Sphere_StoresItsNormals()
        {
            Run();
            var normals = NormalsOf(Cloud);
            Assert.That(normals.Count, Is.EqualTo(60000));
            var errors = normals.Select(n => NormalEstimatorTests.DegreesBetween(n.Normal, n.Place)).ToArray();
            Assert.That(NormalEstimatorTests.Median(errors), Is.LessThan(1));
            Assert.That(errors.Max(), Is.LessThan(10));
            Assert.That(normals.Min(n => OctahedralNormal.Decode(n.Normal).z), Is.GreaterThan(-0.01), "they point up");
        }

        [Test]
        public void Run_CutIntoCubes_IsAsOfTheWhole()
        {
            Run();
            var cut = NormalsOf(Cloud).ToDictionary(n => n.Place, n => n.Normal);
            var places = cut.Keys.ToArray();
            ushort[] whole = NormalEstimatorTests.Estimate(places, NormalSettings.DefaultNeighbours);
            int differing = places.Where((p, i) => cut[p] != whole[i]).Count();
            // What float's rounding takes to another code.
            Assert.That(differing, Is.LessThan(places.Length / 1000));
        }

        [Test]
        public void Run_LeavesPointsAndChecksumAsTheyWere()
        {
            string before = CloudFolder.Open(Cloud).Manifest.ToJson();
            var chunks = FilesOf("chunks").Concat(FilesOf("upper")).ToDictionary(f => f, File.ReadAllBytes);
            Run();
            Assert.That(FilesOf("chunks").Concat(FilesOf("upper")), Is.EquivalentTo(chunks.Keys));
            foreach (var (file, bytes) in chunks)
                Assert.That(File.ReadAllBytes(file), Is.EqualTo(bytes));
            using var folder = CloudFolder.Open(Cloud);
            var was = CloudManifest.FromJson(before, "before");
            Assert.That(folder.Manifest.Checksum, Is.EqualTo(was.Checksum));
            Assert.That(folder.Manifest.CloudId, Is.EqualTo(was.CloudId));
            Assert.That(folder.Manifest.Generation, Is.EqualTo(was.Generation + 1));
            Assert.That(Problems(), Is.Empty);
            Assert.That(File.Exists(Path.Combine(Cloud, CloudFolderWriter.LockName)), Is.False);
        }

        [Test]
        public void Run_Again_ReplacesThem()
        {
            Run();
            var first = NormalsOf(Cloud);
            Run();
            Assert.That(NormalsOf(Cloud), Is.EqualTo(first));
            Assert.That(Problems(), Is.Empty);
            Assert.That(Directory.GetDirectories(Path.Combine(Cloud, StoreFormat.LayerFolderName)).Select(Path.GetFileName),
                Is.EqualTo(new[] { "2" }));
            Assert.That(Directory.GetFiles(Cloud, "hierarchy*").Select(Path.GetFileName),
                Is.EqualTo(new[] { "hierarchy-3.bin" }));
        }

        [Test]
        public void Run_StoppedAnywhere_LeavesTheCloudAndTheNextRunClears([Values(false, true)] bool hasNormals)
        {
            if (hasNormals)
                Run();
            string manifest = File.ReadAllText(Path.Combine(Cloud, StoreFormat.ManifestName));
            for (int stop = 0; ; stop += 1 + stop / 6)
            {
                int left = stop;
                FileChanges.Intercept = (change, path, _) =>
                {
                    // A process that was killed does not hold its lock.
                    if (change != FileChange.Open && !path.Contains(CloudFolderWriter.LockName) && left-- <= 0)
                        throw new NotSupportedException("stopped before " + change + " of " + path);
                };
                try
                {
                    Run();
                    break;
                }
                catch (PointCloudException)
                {
                    FileChanges.Intercept = null;
                    Assert.That(Problems(), Is.Empty, "stopped after " + stop + " changes");
                    if (File.ReadAllText(Path.Combine(Cloud, StoreFormat.ManifestName)) != manifest)
                        break;
                }
                finally
                {
                    FileChanges.Intercept = null;
                }
            }
            Run();
            Assert.That(Problems(), Is.Empty);
            Assert.That(Directory.GetDirectories(Path.Combine(Cloud, StoreFormat.LayerFolderName)).Length, Is.EqualTo(1));
            Assert.That(Directory.GetFiles(Cloud, "hierarchy*").Length, Is.EqualTo(1));
        }

        [TestCase("layers")]
        [TestCase("hierarchy-2.bin")]
        public void Verify_DamagedNormals_AreFound(string where)
        {
            Run();
            string file = Directory.GetFiles(Cloud, "*.bin", SearchOption.AllDirectories).First(f => f.Contains(where));
            byte[] bytes = File.ReadAllBytes(file);
            bytes[bytes.Length / 2] ^= 1;
            File.WriteAllBytes(file, bytes);
            Assert.That(Problems(), Is.Not.Empty);
        }

        [Test]
        public void Export_CloudWithNormals_IsAsWithout()
        {
            string before = Folder.File("before.las"), after = Folder.File("after.las");
            Export(before);
            Run();
            Export(after);
            Assert.That(File.ReadAllBytes(after), Is.EqualTo(File.ReadAllBytes(before)));
        }

        void Convert(int count, uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var text = new StringWriter();
            for (int i = 0; i < count; i++)
            {
                double z = random.NextDouble(-1, 1), angle = 2 * Math.PI * random.NextDouble(), r = Math.Sqrt(1 - z * z);
                text.WriteLine(FormattableString.Invariant(
                    $"{Radius * r * Math.Cos(angle):F6} {Radius * r * Math.Sin(angle):F6} {Radius * z:F6}"));
            }
            using var reader = PointReaders.Open(Folder.Write("sphere.xyz", text.ToString()));
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, Cloud, new ConvertSettings { PointsPerChunk = 8000 },
                _ => { }, null));
        }

        void Run() => JobCoroutine.RunToEnd(AddNormals.Run(Cloud, default, null, null));

        void Export(string path)
        {
            using var reader = ConvertedReader.Open(Cloud);
            JobCoroutine.RunToEnd(ExportCloud.Run(reader, path, new ExportSettings(), _ => { }, null));
        }

        IReadOnlyList<string> Problems()
        {
            var result = new VerifyResult();
            JobCoroutine.RunToEnd(VerifyCloud.Run(Cloud, new PointReader[0], result, null));
            Assert.That(result.Ok ? 60000 : result.Points, Is.EqualTo(result.Points));
            return result.Problems;
        }

        IEnumerable<string> FilesOf(string folder) => Directory.GetFiles(Path.Combine(Cloud, folder));

        internal static unsafe List<(double3 Place, ushort Normal)> NormalsOf(string cloud)
        {
            using var folder = CloudFolder.Open(cloud);
            var all = new List<(double3, ushort)>();
            int page = 0;
            ulong* values = stackalloc ulong[5 * PlaneShape.MaxPointsPerBlock];
            foreach (var table in folder.LoadAll())
            {
                byte[] points = File.ReadAllBytes(folder.PathOf(page));
                byte[] normals = File.ReadAllBytes(folder.PathOfComputed(page++));
                fixed (byte* ofPoints = points, ofNormals = normals)
                    for (int n = 0; n < table.Nodes.Length; n++)
                    {
                        var node = table.Nodes[n];
                        var plane = table.Nodes[node.PlaneNode];
                        int first = node.PlaneNode * table.PlaneCount;
                        var position = new PlaneView(ofPoints + table.Planes[first].OffsetBytes,
                            PlaneShape.OfPositions(node.IsWide), plane.PlaneBlocks);
                        var normal = new PlaneView(ofNormals + table.Planes[first + table.PlaneCount - 1].OffsetBytes,
                            new PlaneShape(2, 0), plane.PlaneBlocks);
                        for (int b = node.FirstBlock; b < node.FirstBlock + node.BlockCount; b++)
                            for (int i = 0; i < position.PointsOf(b); i++)
                                all.Add((folder.Manifest.Grid.ToGeo(plane.Corner + new Grid3((long)position.ValueAt(b, 0, i),
                                    (long)position.ValueAt(b, 1, i), (long)position.ValueAt(b, 2, i))),
                                    (ushort)(normal.ValueAt(b, 0, i) | normal.ValueAt(b, 1, i) << 8)));
                    }
            }
            return all;
        }
    }
}
