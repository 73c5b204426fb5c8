using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using FastPoints.Build;
using FastPoints.Export;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Tests.Las;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using Random = System.Random;

namespace FastPoints.Tests.Export
{
    /// <summary>Against operations that are applied to one point after another.</summary>
    public unsafe partial class EditedCloudTests : FolderTests
    {
        static readonly string[] s_names =
        {
            AttributeNames.Intensity, AttributeNames.Classification, AttributeNames.Red, AttributeNames.Green,
            AttributeNames.Blue, AttributeNames.PointSourceId,
        };

        sealed class Point
        {
            public Grid3 At;
            public double[] Values;
            public bool IsHidden;
            public bool IsDeleted;

            public override string ToString() => At + ": " + string.Join(" ", Values);
        }

        struct Condition
        {
            public string Text;
            public Func<Point, bool> Holds;
        }

        static readonly Condition[] s_conditions =
        {
            new Condition
            {
                Text = "Classification == 2 || Intensity > 40000",
                Holds = p => p.Values[1] == 2 || p.Values[0] > 40000,
            },
            new Condition { Text = "!(Classification < 16)", Holds = p => p.Values[1] >= 16 },
            new Condition { Text = "Red < Green && Blue != 0", Holds = p => p.Values[2] < p.Values[3] && p.Values[4] != 0 },
            new Condition { Text = "Classification == 7", Holds = p => p.Values[1] == 7 },
        };

        string Cloud => Folder.File("scan.fastpoints");

        void Convert(PointReader reader, int cellsLog2 = 0) => JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, Cloud,
            new ConvertSettings { TargetPointsPerLeaf = 300, PointsPerChunk = 5000, CellsLog2 = cellsLog2 }, _ => { }, null));

        void ConvertSeeded(int points = 8000, double zScale = 0.01, int cellsLog2 = 0)
        {
            using var file = new LasTestFile { Format = 2, Offset = new[] { 5e6, 1e5, -9.5 } };
            file.Scale[2] = zScale;
            using var reader = PointReaders.Open(Folder.Write("a.las", file.RandomPoints(points).ToBytes()));
            Convert(reader, cellsLog2);
        }

        static List<Point> Read(PointReader reader, int pointsPerRange = int.MaxValue)
        {
            var all = new List<Point>();
            var names = s_names.Where(reader.Info.Schema.Has).ToArray();
            var wanted = reader.Info.Schema.Select(names.Concat(new[] { "X", "Y", "Z" }).ToArray());
            using var read = reader.CreateRead(wanted, reader.MaxPointsPerBlock, Allocator.Persistent);
            for (int block = 0; block < reader.BlockCount; block++)
                for (int first = 0; first < reader.PointsInBlock(block); first += Math.Min(pointsPerRange, 1 << 20))
                {
                    read.Begin(new BlockRange(block, first, Math.Min(pointsPerRange, reader.PointsInBlock(block) - first)));
                    read.Complete();
                    var bytes = (byte*)read.Points.Bytes.GetUnsafeReadOnlyPtr();
                    double ValueOf(string name, int i)
                    {
                        int column = wanted.IndexOf(name);
                        return column < 0 ? 0 : ColumnValues.ToDouble(bytes + read.Points.Column(column).OffsetBytes,
                            wanted[column].Type, i);
                    }
                    for (int i = 0; i < read.Points.Count; i++)
                        all.Add(new Point
                        {
                            At = new Grid3((long)ValueOf("X", i), (long)ValueOf("Y", i), (long)ValueOf("Z", i)),
                            Values = s_names.Select(n => ValueOf(n, i)).ToArray(),
                        });
                }
            return all;
        }

        static string[] Sorted(IEnumerable<Point> points)
        {
            var texts = points.Where(p => !p.IsDeleted).Select(p => p.ToString()).ToArray();
            Array.Sort(texts, string.CompareOrdinal);
            return texts;
        }

        static bool Holds(EditShape ball, Grid3 p)
        {
            long x = ball.B.X, y = ball.B.Y, z = ball.B.Z;
            var from = p - ball.A;
            if (x == y && y == z)
                return checked(from.X * from.X + from.Y * from.Y + from.Z * from.Z <= x * x);
            BigInteger a = checked(from.X * y * z), b = checked(from.Y * x * z), c = checked(from.Z * x * y);
            BigInteger all = checked(x * y * z);
            return a * a + b * b + c * c <= all * all;
        }

        static bool HoldsBox(EditShape box, Grid3 p) => p.X >= box.A.X && p.X <= box.B.X && p.Y >= box.A.Y && p.Y <= box.B.Y &&
            p.Z >= box.A.Z && p.Z <= box.B.Z;

        static bool HoldsPrism(EditOperation operation, Grid3 p)
        {
            if (!TryPlace(operation.Prism, p, out long u, out long v))
                return false;
            var crossings = new int[2];
            foreach (var (polygon, at) in operation.Rings)
                for (int i = 0; i < at.Length; i += 2)
                {
                    long u0 = at[i], v0 = at[i + 1], u1 = at[(i + 2) % at.Length], v1 = at[(i + 3) % at.Length];
                    var side = (BigInteger)(u1 - u0) * (v - v0) - (BigInteger)(v1 - v0) * (u - u0);
                    if (side == 0 && u >= Math.Min(u0, u1) && u <= Math.Max(u0, u1) && v >= Math.Min(v0, v1) &&
                        v <= Math.Max(v0, v1))
                        return true;
                    // To its right: u < u0 + (v - v0) * (u1 - u0) / (v1 - v0).
                    if (v0 > v != v1 > v && (v1 > v0 ? side > 0 : side < 0))
                        crossings[polygon]++;
                }
            return crossings.Any(n => n % 2 == 1);
        }

        static bool TryPlace(EditPrism prism, Grid3 p, out long u, out long v)
        {
            var from = p - prism.Origin;
            BigInteger Dot(Grid3 axis) => (BigInteger)from.X * axis.X + (BigInteger)from.Y * axis.Y + (BigInteger)from.Z * axis.Z;
            var depth = Dot(prism.W);
            (u, v) = (0, 0);
            if (prism.W == default)
                (u, v) = ((long)Dot(prism.U), (long)Dot(prism.V));
            else if (depth > 0)
                (u, v) = (Floor(Dot(prism.U) << 20, depth), Floor(Dot(prism.V) << 20, depth));
            return prism.W == default || depth > 0;
        }

        static long Floor(BigInteger a, BigInteger b) => (long)((a - (a % b + b) % b) / b);

        static long Apply(EditOperation operation, IEnumerable<Point> points, int fill = 257)
        {
            long changed = 0;
            var holds = operation.Conditions.Select(c => s_conditions.First(k => k.Text == c.Text).Holds).ToArray();
            foreach (var point in points)
            {
                bool isMeant = !point.IsDeleted &&
                    (operation.Boxes.Count == 0 || operation.Boxes.Any(b => HoldsBox(b, point.At))) &&
                    (operation.Balls.Count == 0 || operation.Balls.Any(b => Holds(b, point.At))) &&
                    (operation.Rings.Count == 0 || HoldsPrism(operation, point.At)) && holds.All(h => h(point));
                if (!isMeant)
                    continue;
                var (kind, red, green, blue) = (point.Values[1], point.Values[2], point.Values[3], point.Values[4]);
                if (operation.Action == EditAction.Classify)
                    kind = operation.Value[0];
                if (operation.Action == EditAction.Color)
                    (red, green, blue) = (operation.Value[0] * fill, operation.Value[1] * fill, operation.Value[2] * fill);
                bool isOther = operation.Action == EditAction.Delete || operation.Action == EditAction.Hide && !point.IsHidden ||
                    (kind, red, green, blue) != (point.Values[1], point.Values[2], point.Values[3], point.Values[4]);
                changed += isOther ? 1 : 0;
                (point.Values[1], point.Values[2], point.Values[3], point.Values[4]) = (kind, red, green, blue);
                point.IsDeleted |= operation.Action == EditAction.Delete;
                point.IsHidden |= operation.Action == EditAction.Hide;
            }
            return changed;
        }

        static Grid3 RandomIn(Random random, Grid3 min, Grid3 max) => min + new Grid3(
            (long)(random.NextDouble() * (max.X - min.X + 1)), (long)(random.NextDouble() * (max.Y - min.Y + 1)),
            (long)(random.NextDouble() * (max.Z - min.Z + 1)));

        static EditOperation RandomOperation(Random random, CloudManifest manifest, EditAction action)
        {
            Grid3 min = manifest.BoundsMin, max = manifest.BoundsMax;
            var operation = new EditOperation { Action = action };
            // Exports have 32 classes.
            operation.Value = operation.ChangedAttributes.Select(n => (byte)random.Next(32)).ToArray();
            int kinds = random.Next(1, 16);
            for (int i = random.Next(1, 4); i > 0 && (kinds & 1) != 0; i--)
            {
                Grid3 a = RandomIn(random, min, max), b = RandomIn(random, min, max);
                operation.Boxes.Add(new EditShape { A = Grid3.Min(a, b), B = Grid3.Max(a, b) });
            }
            long radius = (max.X - min.X) / 5, flat = manifest.Grid.Step.x == manifest.Grid.Step.z ? radius : radius / 10;
            for (int i = random.Next(1, 40); i > 0 && (kinds & 2) != 0; i--)
                operation.Balls.Add(new EditShape
                {
                    A = RandomIn(random, min, max),
                    B = new Grid3(radius, radius, flat),
                    IsBall = true,
                });
            if ((kinds & 4) != 0)
                AddPrism(operation, random, min, max);
            if ((kinds & 8) != 0)
                operation.Conditions.Add(FilterExpression.Parse(s_conditions[random.Next(s_conditions.Length)].Text));
            return operation;
        }

        static void AddPrism(EditOperation operation, Random random, Grid3 min, Grid3 max)
        {
            ref var prism = ref operation.Prism;
            prism.Origin = RandomIn(random, min, max);
            prism.U = RandomIn(random, new Grid3(-9, -9, -9), new Grid3(9, 9, 9));
            prism.V = RandomIn(random, new Grid3(-9, -9, -9), new Grid3(9, 9, 9));
            if (random.Next(2) == 0)
                prism.W = RandomIn(random, new Grid3(-9, -9, -9), new Grid3(9, 9, 9));
            for (int ring = 0; ring < 3; ring++)
            {
                var at = new List<long>();
                for (int i = random.Next(3, 12); i > 0; i--)
                    if (TryPlace(prism, RandomIn(random, min, max), out long u, out long v) &&
                        (prism.W == default || Math.Max(Math.Abs(u), Math.Abs(v)) < EditPrism.MaxPlace))
                        at.AddRange(new[] { u, v });
                operation.AddRing(ring / 2, at.Count > 4 ? at.ToArray() : new[] { -9L, -9, 9, -9, 0, 9 });
            }
        }

        /// <returns>The points that are left.</returns>
        List<Point> Edit(int seed, int operations)
        {
            var random = new Random(seed);
            List<Point> points;
            CloudManifest manifest;
            using (var stored = ConvertedReader.Open(Cloud))
            {
                points = Read(stored);
                manifest = stored.Manifest;
            }
            int fill = points.Any(p => p.Values.Skip(2).Take(3).Any(v => v > byte.MaxValue)) ? 257 : 1;
            for (int n = 0; n < operations; n++)
            {
                // Deleting comes last, so that there is something to change.
                var action = n > operations - 3 ? EditAction.Delete
                    : new[] { EditAction.Hide, EditAction.Classify, EditAction.Color }[random.Next(3)];
                var operation = RandomOperation(random, manifest, action);
                if (EditPlan.FindProblem(operation, manifest) != null)
                    continue;
                JobCoroutine.RunToEnd(EditCloud.Run(Cloud, operation, null));
                Assert.That(operation.PointsChanged, Is.EqualTo(Apply(operation, points, fill)), operation.ToJson());
            }
            return points;
        }

        [TestCase(1, 0.01), TestCase(2, 0.01), TestCase(3, 0.1), TestCase(4, 0.1), TestCase(5, 0.01)]
        public void Read_OfASeededCloud_EqualsBruteForce(int seed, double zScale)
        {
            ConvertSeeded(zScale: zScale);
            var points = Edit(seed, 12);
            Assert.That(points.Count(p => p.IsDeleted), Is.InRange(1, points.Count - 1));
            using var edited = ConvertedReader.OpenEdited(Cloud);
            Assert.That(Sorted(Read(edited)), Is.EqualTo(Sorted(points)));
            Assert.That(Sorted(Read(edited, 777)), Is.EqualTo(Sorted(points)), "in parts of blocks");
        }

        [Test]
        public void Read_OfAutzen_EqualsBruteForce([Values(1, 2)] int seed)
        {
            using var reader = PointReaders.Open(TestData.PathOrIgnore("data/samples/laz/autzen_trim.laz"));
            Convert(reader);
            var points = Edit(seed, 8);
            using var edited = ConvertedReader.OpenEdited(Cloud);
            Assert.That(Sorted(Read(edited)), Is.EqualTo(Sorted(points)));
        }

        // The pyramid's sides are planes through the eye and two corners.
        [TestCase(1e3), TestCase(4e5), TestCase(1e9)]
        public void DeleteInLasso_ThroughAPolygon_IsWhatLiesBetweenItsPlanes(double distance)
        {
            ConvertSeeded();
            using var stored = ConvertedReader.Open(Cloud);
            var (points, manifest) = (Read(stored), stored.Manifest);
            var size = manifest.BoundsGeo.Size;
            double3 forward = math.normalize(new double3(-2, 1, -1.5)), right = math.normalize(math.cross(forward, size));
            var eye = manifest.BoundsGeo.Min + size * 0.4 - forward * distance;
            double wide = math.cmax(size) * 0.3;
            var corners = new double3[5];
            for (int i = 0; i < corners.Length; i++)
            {
                math.sincos(-2 * math.PI_DBL * i / corners.Length, out double sine, out double cosine);
                corners[i] = eye + (forward * distance + (right * cosine + math.cross(right, forward) * sine) * wide) * (i + 1);
            }
            double Inside(Point point) => Enumerable.Range(0, 5).Min(i => math.dot(manifest.Grid.ToGeo(point.At) - eye,
                math.normalize(math.cross(corners[i] - eye, corners[(i + 1) % 5] - eye))));
            long deleted = 0;
            JobCoroutine.RunToEnd(PointCloudEdits.DeleteInLasso(Cloud, eye, corners, count => deleted = count));
            using var edited = ConvertedReader.OpenEdited(Cloud);
            var left = new HashSet<string>(Sorted(Read(edited)));
            Assert.That(deleted, Is.EqualTo(points.Count - left.Count).And.InRange(200, points.Count - 200));
            foreach (var point in points.Where(p => math.abs(Inside(p)) > 2 * math.cmax(manifest.Grid.Step) + 1e-6 * wide))
                Assert.That(left.Contains(point.ToString()), Is.EqualTo(Inside(point) < 0), point + ": " + Inside(point));
        }

        [Test]
        public void UndoAll_ThenRedoAll_IsAsStoredAndAsEdited()
        {
            ConvertSeeded(5000);
            var points = Edit(6, 6);
            string[] stored, edited;
            using (var reader = ConvertedReader.Open(Cloud))
                stored = Sorted(Read(reader));
            using (var reader = ConvertedReader.OpenEdited(Cloud))
                edited = Sorted(Read(reader));
            Assert.That(edited, Is.EqualTo(Sorted(points)).And.Not.EqualTo(stored));
            for (int left = EditCloud.GoTo(Cloud, -1); left > 0; left--)
                Assert.That(EditCloud.GoTo(Cloud, left - 1), Is.EqualTo(left - 1));
            using (var reader = ConvertedReader.OpenEdited(Cloud))
            {
                Assert.That(reader.Edits, Is.Null);
                Assert.That(Sorted(Read(reader)), Is.EqualTo(stored));
            }
            Assert.That(EditCloud.GoTo(Cloud, 6), Is.EqualTo(6));
            using (var reader = ConvertedReader.OpenEdited(Cloud))
                Assert.That(Sorted(Read(reader)), Is.EqualTo(edited));
        }

        [Test]
        public void Run_Twice_ChangesNothingMore()
        {
            ConvertSeeded(5000);
            foreach (var action in new[] { EditAction.Hide, EditAction.Classify, EditAction.Color, EditAction.Delete })
            {
                EditOperation NewOperation()
                {
                    var operation = new EditOperation { Action = action };
                    operation.Value = new byte[] { 77, 0, 3 }.Take(operation.ChangedAttributes.Length).ToArray();
                    operation.Conditions.Add(FilterExpression.Parse("Intensity > 40000"));
                    return operation;
                }
                EditOperation first = NewOperation(), second = NewOperation();
                JobCoroutine.RunToEnd(EditCloud.Run(Cloud, first, null));
                byte[] journal = File.ReadAllBytes(Cloud + ".edits");
                JobCoroutine.RunToEnd(EditCloud.Run(Cloud, second, null));
                Assert.That(first.PointsChanged, Is.GreaterThan(1000));
                Assert.That(second.PointsChanged, Is.Zero);
                Assert.That(File.ReadAllBytes(Cloud + ".edits"), Is.EqualTo(journal));
            }
        }

        [TestCase("out.las"), TestCase("out.copc.laz")]
        public void Export_OfAnEditedCloud_EqualsBruteForce(string name)
        {
            ConvertSeeded();
            var points = Edit(9, 8);
            using (var edited = ConvertedReader.OpenEdited(Cloud))
                JobCoroutine.RunToEnd(ExportCloud.Run(edited, Folder.File(name), new ExportSettings(), _ => { }, null));
            using var reader = ReadPoints.Open(Folder.File(name));
            ReadPoints.IndexBlocks(reader);
            Assert.That(Sorted(Read(reader)), Is.EqualTo(Sorted(points)));
        }

        [Test]
        public void Convert_OfAnEditedCloud_MakesOneWithTheSamePoints()
        {
            ConvertSeeded();
            var points = Edit(11, 8);
            string target = Folder.File("baked.fastpoints");
            using (var edited = ConvertedReader.OpenEdited(Cloud))
                JobCoroutine.RunToEnd(ConvertCloud.Run(new PointReader[] { edited }, target, new ConvertSettings(), _ => { },
                    null));
            using var baked = ConvertedReader.OpenEdited(target);
            using var stored = ConvertedReader.Open(Cloud);
            Assert.That(baked.Manifest.CloudId, Is.Not.EqualTo(stored.Manifest.CloudId));
            Assert.That(Sorted(Read(baked)), Is.EqualTo(Sorted(points)));
            Assert.That(VerifyProblems(target), Is.Empty);
        }

        static List<string> VerifyProblems(string cloud)
        {
            var result = new VerifyResult();
            JobCoroutine.RunToEnd(VerifyCloud.Run(cloud, Array.Empty<PointReader>(), result, null));
            return result.Problems.ToList();
        }

        [Test]
        public void OpenEdited_WithEditsOfAnotherCloud_IsRefused()
        {
            ConvertSeeded(3000);
            Edit(1, 3);
            Directory.Delete(Cloud, true);
            ConvertSeeded(3001);
            Assert.That(Assert.Throws<PointCloudException>(() => ConvertedReader.OpenEdited(Cloud)).Message,
                Does.Contain("another cloud"));
            ConvertedReader.Open(Cloud).Dispose();
        }
    }
}
