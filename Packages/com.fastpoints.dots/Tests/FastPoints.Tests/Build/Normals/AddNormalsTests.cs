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

namespace FastPoints.Tests.Build
{
    public class AddNormalsTests : FolderTests
    {
        const double Radius = 10;

        string Cloud => Folder.File("sphere.fastpoints");

        int m_points;

        [SetUp]
        public void Convert() => ConvertText(60000, 9, (_, _) => "");

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
            var settings = new NormalSettings { PointsPerCube = 3000 };
            Run(settings);
            Assert.That(CubesOf(settings).Count, Is.GreaterThan(20));
            var cut = NormalsOf(Cloud).ToDictionary(n => n.Place, n => n.Normal);
            var places = cut.Keys.ToArray();
            ushort[] whole = NormalEstimatorTests.Estimate(places, new NormalSettings().Neighbours);
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

        /// <summary>Containers of jobs in flight must not be freed.</summary>
        [Test]
        public void Run_CancelledAnywhere_AwaitsItsJobs([Values(false, true)] bool ofFiles)
        {
            Convert(10000, 5, ofFiles ? InwardsOrNone : (Func<double3, int, double3>)((_, _) => 0));
            bool isDone = false;
            // Without workers a job is in flight until it is awaited.
            using var workers = new WorkerCount(0);
            for (int stop = 1; !isDone; stop++)
            {
                using var work = new CoroutineStack(AddNormals.Run(Cloud, null, null, null));
                for (int jobs = 0; jobs < stop && !isDone; jobs += work.Current.Equals(default) ? 0 : 1)
                {
                    work.Current.Complete();
                    isDone = !work.MoveNext();
                }
            }
            Assert.That(Problems(), Is.Empty);
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

        /// <summary>Inwards, of any length, and none for every tenth point.</summary>
        static double3 InwardsOrNone(double3 place, int i) => i % 10 == 0 ? 0 : -0.25 * place;

        [Test]
        public void Run_FilesHaveNormals_StoresThese()
        {
            Convert(20000, 5, InwardsOrNone);
            Run();
            var normals = NormalsOf(Cloud);
            Assert.That(normals.Count(n => n.Normal == OctahedralNormal.None), Is.EqualTo(2000));
            foreach (var (place, normal) in normals)
                if (normal != OctahedralNormal.None)
                    Assert.That(math.dot((double3)OctahedralNormal.Decode(normal), -place / Radius), Is.GreaterThan(0.9998));
            Assert.That(Orientation(), Is.EqualTo(NormalOrientations.OfSource));
            Assert.That(Problems(), Is.Empty);
        }

        [Test]
        public void Run_FilesHaveOnlyRoomForNormals_EstimatesThem()
        {
            Convert(20000, 5, (_, _) => 0);
            Run();
            Assert.That(NormalsOf(Cloud).All(n => n.Normal != OctahedralNormal.None));
            Assert.That(Orientation(), Is.EqualTo(NormalOrientations.Viewer));
        }

        [TestCase("PROJCS[\"UTM\",GEOGCS[\"WGS 84\",UNIT[\"degree\",0.0174532925]],UNIT[\"metre\",1]]", 0, NormalOrientations.Up)]
        [TestCase("GEOGCS[\"WGS 84\",UNIT[\"degree\",0.0174532925]]", 0, NormalOrientations.Up)]
        [TestCase("LOCAL_CS[\"site\",UNIT[\"metre\",1]]", 0, NormalOrientations.Viewer)]
        [TestCase("GEOCCS[\"WGS 84\",UNIT[\"metre\",1]]", 0, NormalOrientations.Viewer)]
        [TestCase(null, 32633, NormalOrientations.Up)]
        [TestCase(null, 4978, NormalOrientations.Viewer)]
        public void Run_CoordinateSystem_SaysWhetherTheyPointUp(string wkt, int epsg, string wanted)
        {
            string file = Path.Combine(Cloud, StoreFormat.ManifestName);
            var manifest = CloudManifest.FromJson(File.ReadAllText(file), file);
            (manifest.CrsWkt, manifest.CrsEpsg) = (wkt, epsg);
            File.WriteAllText(file, manifest.ToJson());
            Run();
            Assert.That(Orientation(), Is.EqualTo(wanted));
        }

        [Test]
        public void Run_ScansOfKnownPlaces_PointToTheirScanner()
        {
            // The left half of the sphere is seen from within, the other from far outside.
            var places = new List<double3>();
            ConvertText(20000, 5, (p, _) =>
            {
                places.Add(p);
                return "";
            });
            string ScanOf(string at, Func<double3, bool> isSeen, double3 from)
            {
                var seen = places.Where(isSeen).Select(p => p - from).ToArray();
                return seen.Length + "\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n" + at + " 1\n" +
                    string.Concat(seen.Select(p => FormattableString.Invariant($"{p.x:F6} {p.y:F6} {p.z:F6} 0.5\n")));
            }
            Convert(Folder.Write("scans.ptx", ScanOf("-3 0 0", p => p.x < 0, new double3(-3, 0, 0)) +
                ScanOf("1000 0 0", p => p.x >= 0, new double3(1000, 0, 0))));
            Run();
            foreach (var (place, normal) in NormalsOf(Cloud))
                if (math.abs(place.x) > 0.5)
                    Assert.That(math.dot((double3)OctahedralNormal.Decode(normal), place) * place.x, Is.Positive);
            Assert.That(Orientation(), Is.EqualTo(NormalOrientations.Scanner));
            Assert.That(Problems(), Is.Empty);
        }

        [Test]
        public void ChooseBatches_FewPointsEach_HaveAllNodes()
        {
            using var folder = CloudFolder.Open(Cloud);
            using var cubes = new NormalCubes(folder, new NormalSettings { PointsPerCube = 10000 });
            long points = 0, nodes = 0;
            int batches = 0;
            foreach (int chosen in cubes.ChooseBatches())
                (points, nodes, batches) = (points + cubes.Points, nodes + chosen, batches + 1);
            Assert.That((points, nodes), Is.EqualTo((60000, folder.Manifest.NodeCount)));
            Assert.That(batches, Is.InRange(3, 6));
        }

        [Test]
        public void NormalsOfFiles_NoDirection_IsNone()
        {
            var schema = new PointSchema(new[]
            {
                new PointAttribute(AttributeNames.NormalX, AttributeType.Float64),
                new PointAttribute(AttributeNames.NormalY, AttributeType.Float32),
                new PointAttribute(AttributeNames.NormalZ, AttributeType.Int16, 0.5, 1),
            });
            var inputs = new (double X, float Y, short Z, float3 Wanted)[]
            {
                (1e-300, 0, -2, new float3(1, 0, 0)), (0, 3, 6, new float3(0, 0.6f, 0.8f)),
                (1e300, -1, 5, new float3(1, 0, 0)), (0, 0, -2, 0), (double.NaN, 0, 1, 0), (0, float.NegativeInfinity, 1, 0),
            };
            using var batch = new PointBatch(schema, inputs.Length, Allocator.Persistent) { Count = inputs.Length };
            batch.Column<double>(0).GetSubArray(0, inputs.Length).CopyFrom(inputs.Select(i => i.X).ToArray());
            batch.Column<float>(1).GetSubArray(0, inputs.Length).CopyFrom(inputs.Select(i => i.Y).ToArray());
            batch.Column<short>(2).GetSubArray(0, inputs.Length).CopyFrom(inputs.Select(i => i.Z).ToArray());
            using var normals = new NativeArray<ushort>(inputs.Length, Allocator.Persistent);
            PackSourceNormalsJob.Of(batch, schema.Select(a => a.Name).ToArray(), normals).Schedule(0, batch.Count, default)
                .Complete();
            Assert.That(normals.ToArray(), Is.EqualTo(inputs.Select(i => i.Wanted.Equals(default) ? OctahedralNormal.None
                : OctahedralNormal.Encode(i.Wanted))));
        }

        string Orientation()
        {
            using var folder = CloudFolder.Open(Cloud);
            return folder.Manifest.NormalOrientation;
        }

        void Convert(int count, uint seed, Func<double3, int, double3> normalOf) => ConvertText(count, seed, (p, i) =>
        {
            var n = normalOf(p, i);
            return FormattableString.Invariant($" {n.x:F6} {n.y:F6} {n.z:F6}");
        }, head: "x y z nx ny nz\n");

        void ConvertText(int count, uint seed, Func<double3, int, string> restOfLine, double noise = 0, string head = "")
        {
            m_points = count;
            var random = new Unity.Mathematics.Random(seed);
            var text = new StringWriter();
            text.Write(head);
            for (int i = 0; i < count; i++)
            {
                double z = random.NextDouble(-1, 1), angle = 2 * Math.PI * random.NextDouble(), r = Math.Sqrt(1 - z * z);
                double gauss = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
                var p = (Radius + noise * gauss) * new double3(r * Math.Cos(angle), r * Math.Sin(angle), z);
                text.WriteLine(FormattableString.Invariant($"{p.x:F6} {p.y:F6} {p.z:F6}") + restOfLine(p, i));
            }
            Convert(Folder.Write("sphere.xyz", text.ToString()));
        }

        void Convert(string file)
        {
            using var reader = PointReaders.Open(file);
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, Cloud, new ConvertSettings { PointsPerChunk = 8000 },
                _ => { }, null));
        }

        /// <summary>Without a seam a picture of the error shows no cubes.</summary>
        [Test]
        public void Run_FacesOfCubes_HaveNoLargerErrors()
        {
            double spacing = Radius * Math.Sqrt(4 * Math.PI / 60000);
            ConvertText(60000, 3, (_, _) => "", 0.3 * spacing);
            var settings = new NormalSettings { PointsPerCube = 3000 };
            Run(settings);
            var cubes = CubesOf(settings);
            double[] ends = { 1, 2, 4, double.PositiveInfinity };
            var errors = ends.Select(_ => new List<double>()).ToArray();
            foreach (var (place, normal) in NormalsOf(Cloud))
            {
                var (min, max) = cubes.Single(c => math.all(place >= c.Min) && math.all(place < c.Max));
                double distance = math.cmin(math.min(place - min, max - place)) / spacing;
                errors[Array.FindIndex(ends, end => distance < end)].Add(NormalEstimatorTests.DegreesBetween(normal, place));
            }
            double all = NormalEstimatorTests.Median(errors.SelectMany(e => e).ToArray());
            for (int i = 0; i < ends.Length; i++)
            {
                var sorted = errors[i].OrderBy(e => e).ToArray();
                double median = sorted[sorted.Length / 2];
                TestContext.WriteLine("less than " + ends[i] + " spacings from a face: " + sorted.Length + " points, median " +
                    median + ", 95 % " + sorted[sorted.Length * 95 / 100] + " degrees");
                Assert.That(median, Is.EqualTo(all).Within(3).Percent);
            }
        }

        List<(double3 Min, double3 Max)> CubesOf(NormalSettings settings)
        {
            using var folder = CloudFolder.Open(Cloud);
            using var cubes = new NormalCubes(folder, settings);
            return cubes.Cubes().Select(cube => (folder.Manifest.Grid.ToGeo(cube.Corner),
                folder.Manifest.Grid.ToGeo(cube.Corner + new Grid3(cube.Side, cube.Side, cube.Side)))).ToList();
        }

        void Run(NormalSettings settings = null) =>
            JobCoroutine.RunToEnd(AddNormals.Run(Cloud, settings, null, null));

        void Export(string path)
        {
            using var reader = ConvertedReader.Open(Cloud);
            JobCoroutine.RunToEnd(ExportCloud.Run(reader, path, new ExportSettings(), _ => { }, null));
        }

        IReadOnlyList<string> Problems()
        {
            var result = new VerifyResult();
            JobCoroutine.RunToEnd(VerifyCloud.Run(Cloud, new PointReader[0], result, null));
            Assert.That(result.Ok ? m_points : result.Points, Is.EqualTo(result.Points));
            return result.Problems;
        }

        IEnumerable<string> FilesOf(string folder) => Directory.GetFiles(Path.Combine(Cloud, folder));

        internal static unsafe List<(double3 Place, ushort Normal)> NormalsOf(string cloud)
        {
            using var folder = CloudFolder.Open(cloud);
            var all = new List<(double3, ushort)>();
            int page = 0;
            ulong* values = stackalloc ulong[5 * PlaneShape.MaxPointsPerBlock];
            foreach (var table in folder.EachTable())
            {
                byte[] points = File.ReadAllBytes(folder.PlanesPathOf(page));
                byte[] normals = File.ReadAllBytes(folder.PathOfComputed(page++));
                fixed (byte* ofPoints = points, ofNormals = normals)
                    for (int n = 0; n < table.Nodes.Length; n++)
                    {
                        var node = table.Nodes[n];
                        var plane = table.Nodes[node.PlaneNode];
                        int first = node.PlaneNode * table.PlaneCount;
                        var position = new PlaneView(ofPoints + table.PlaneRanges[first].OffsetBytes,
                            PlaneShape.OfPositions(node.IsWide), plane.PlaneBlocks);
                        var normal = new PlaneView(ofNormals + table.PlaneRanges[first + table.PlaneCount - 1].OffsetBytes,
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
