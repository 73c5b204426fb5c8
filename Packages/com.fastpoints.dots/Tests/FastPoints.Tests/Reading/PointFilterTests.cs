using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Reading
{
    public class PointFilterTests
    {
        static PointBatch Points(int count, Func<int, double3> at) =>
            TestBatches.OfPositions(Enumerable.Range(0, count).Select(at).ToArray());

        static List<double3> Left(PointFilter filter, PointBatch batch, PositionTransform transform, long first = 0)
        {
            using (filter)
            using (var slot = new FilterSlot(filter, batch, transform))
            using (var decoded = new NativeReference<DecodeResult>(Allocator.Persistent))
            {
                var result = decoded;
                result.Value = new DecodeResult { Points = batch.Count };
                slot.Schedule(decoded, new BlockRange(0, 0, batch.Count), first, default).Complete();
                var left = new List<double3>();
                for (int i = 0; i < slot.Result.Value.Points; i++)
                    left.Add(PositionAt(batch, transform, i));
                return left;
            }
        }

        static unsafe double3 PositionAt(PointBatch batch, PositionTransform transform, int index)
        {
            var bytes = (byte*)Unity.Collections.LowLevel.Unsafe.NativeArrayUnsafeUtility.GetUnsafeReadOnlyPtr(batch.Bytes);
            return PositionColumns.Of(batch).GeoAt(bytes, transform, index);
        }

        static void IsFiltered(PointFilter filter, PointBatch batch, Func<double3, int, bool> isWanted)
        {
            var all = Enumerable.Range(0, batch.Count).Select(i => PositionAt(batch, PositionTransform.Identity, i)).ToList();
            var left = Left(filter, batch, PositionTransform.Identity);
            Assert.That(left.Select(Text), Is.EqualTo(all.Where((p, i) => isWanted(p, i)).Select(Text)));
        }

        static string Text(double3 p) => p.x.ToString("R") + " " + p.y.ToString("R") + " " + p.z.ToString("R");

        static PointFilter Where(string expression)
        {
            var filter = new PointFilter();
            filter.Add(expression);
            return filter;
        }

        /// <summary>A condition at random, and what it means.</summary>
        static (string Text, Func<double3, bool> Holds) Condition(System.Random random, int depth)
        {
            int kind = depth == 0 ? 0 : random.Next(4);
            if (kind == 0)
            {
                int axis = random.Next(3), op = random.Next(6);
                double than = random.Next(-3, 4);
                string text = "XYZ"[axis] + new[] { "==", "!= ", " < ", " <=", ">", " >= " }[op] +
                    than.ToString(CultureInfo.InvariantCulture);
                return (text, p => op == 0 ? p[axis] == than : op == 1 ? p[axis] != than : op == 2 ? p[axis] < than
                    : op == 3 ? p[axis] <= than : op == 4 ? p[axis] > than : p[axis] >= than);
            }
            var left = Condition(random, depth - 1);
            if (kind == 1)
                return ("!(" + left.Text + ")", p => !left.Holds(p));
            var right = Condition(random, depth - 1);
            return kind == 2 ? ("(" + left.Text + ") && (" + right.Text + ")", p => left.Holds(p) && right.Holds(p))
                : ("(" + left.Text + " || " + right.Text + ")", (Func<double3, bool>)(p => left.Holds(p) || right.Holds(p)));
        }

        [Test]
        public void Where_AnyCondition_MatchesPointByPoint([Range(0, 19)] int seed)
        {
            var random = new System.Random(seed);
            double[] values = { -3, -2, -1, 0, 1, 2, 3, double.NaN, double.PositiveInfinity, double.NegativeInfinity };
            double Any() => values[random.Next(values.Length)];
            using var batch = Points(20000, _ => new double3(Any(), Any(), Any()));
            var condition = Condition(random, 5);
            IsFiltered(Where(condition.Text), batch, (p, _) => condition.Holds(p));
        }

        [Test]
        public void Where_AndBindsMoreThanOr()
        {
            using (var batch = Points(1000, i => new double3(i % 2, i / 2 % 2, i / 4 % 2)))
                IsFiltered(Where("X==1 || Y==1 && Z==1"), batch, (p, _) => p.x == 1 || p.y == 1 && p.z == 1);
        }

        [Test]
        public void Where_ScaledValues_EqualTheirText()
        {
            var transform = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01), Offset = new double3(500000, 0, 0) };
            using (var batch = Points(100, i => new double3(i, i, i)))
                for (int i = 0; i < 100; i++)
                {
                    string x = (500000 + i / 100m).ToString(CultureInfo.InvariantCulture);
                    string y = (i / 100m).ToString(CultureInfo.InvariantCulture);
                    using (var again = Points(100, n => new double3(n, n, n)))
                        Assert.That(Left(Where("X == " + x + " && !(Y < " + y + ") && Y <= " + y), again, transform).Count,
                            Is.EqualTo(1), x);
                }
        }

        [TestCase("X >", "an attribute or a number at character 4, got the end", 3)]
        [TestCase("X > 1 &", "&&, || or the end at character 7, got '&'", 6)]
        [TestCase("(X > 1", ") at character 7", 6)]
        [TestCase("X = 1", "==, !=, <, <=, > or >= at character 3", 2)]
        [TestCase("1.2.3 < X", "an attribute or a number at character 1", 0)]
        [TestCase("", "an attribute or a number at character 1", 0)]
        [TestCase("X > 1 Y < 2", "&&, || or the end at character 7", 6)]
        [TestCase("\"X > 1", "a name that ends in \" at character 1", 0)]
        public void Where_WrongCondition_NamesTheCharacter(string text, string message, int caret)
        {
            var e = Assert.Throws<FormatException>(() => FilterExpression.Parse(text));
            Assert.That(e.Message, Does.Contain(message));
            Assert.That(e.Message.Split('\n').Last(), Is.EqualTo("  " + new string(' ', caret) + "^"));
        }

        [Test]
        public void Where_DeepOrLong_IsBounded()
        {
            string deep = new string('(', 32) + "X==0" + new string(')', 32);
            Assert.DoesNotThrow(() => FilterExpression.Parse(deep));
            Assert.Throws<FormatException>(() => FilterExpression.Parse("(" + deep + ")"));
            Assert.Throws<FormatException>(() => FilterExpression.Parse(new string('!', 1_000_000) + "X==0"));
            Assert.Throws<FormatException>(() => FilterExpression.Parse(string.Join("||", Enumerable.Repeat("X==0", 513))));
            string waiting = "X==0";
            for (int i = 0; i < 32; i++)
                waiting = "Y==1 || Z==2 && (" + waiting + ")";
            using (var batch = Points(600, i => new double3(i % 2, i % 3, i % 5)))
                IsFiltered(Where(waiting), batch, (p, _) => p.y == 1 || p.z == 2 && p.x == 0);
        }

        [Test]
        public void EveryNth_OfASource_CountsFromItsFirstPoint([Values(1, 2, 7, 20000)] int nth, [Values(0, 3, 8191)] int first)
        {
            using (var batch = Points(20000, i => new double3(i, 0, 0)))
                Assert.That(Left(new PointFilter { EveryNth = nth }, batch, PositionTransform.Identity, first)
                    .Select(p => (int)p.x), Is.EqualTo(Enumerable.Range(0, 20000).Where(i => (i + first) % nth == 0)));
        }

        /// <summary>Exact, for whole numbers: an even-odd count of each polygon's rings, whose edges belong.</summary>
        static bool IsIn(int2[][][] polygons, double3 p)
        {
            long x = (long)p.x, y = (long)p.y;
            foreach (var polygon in polygons)
            {
                bool isInside = false;
                foreach (var ring in polygon)
                    for (int i = 0; i < ring.Length; i++)
                    {
                        int2 a = ring[i], b = ring[(i + 1) % ring.Length];
                        long cross = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
                        if (cross == 0 && x >= Math.Min(a.x, b.x) && x <= Math.Max(a.x, b.x) && y >= Math.Min(a.y, b.y) &&
                            y <= Math.Max(a.y, b.y))
                            return true;
                        if (a.y > y != b.y > y && cross > 0 == b.y > a.y)
                            isInside = !isInside;
                    }
                if (isInside)
                    return true;
            }
            return false;
        }

        static FilterPolygons Of(IEnumerable<IEnumerable<int2[]>> polygons) => FilterPolygons.Of(
            polygons.Select(polygon => polygon.Select(r => r.Select(p => new double2(p.x, p.y)).ToArray())));

        [Test]
        public void Polygon_AnyRings_MatchesExactArithmetic([Range(0, 19)] int seed)
        {
            var random = new System.Random(seed);
            // Few places: vertices fall on edges, on points and on one another, and rings are lines or single points.
            int size = seed < 10 ? 6 : 200;
            int2[] Ring() => Enumerable.Range(0, random.Next(1, 9)).Select(_ => new int2(random.Next(size), random.Next(size)))
                .ToArray();
            var polygons = Enumerable.Range(0, random.Next(1, 5)).Select(_ =>
                Enumerable.Range(0, random.Next(1, 4)).Select(__ => Ring()).ToArray()).ToArray();
            using (var batch = Points(20000, _ => new double3(random.Next(-1, size + 1), random.Next(-1, size + 1), 0)))
                IsFiltered(new PointFilter { Polygons = Of(polygons) }, batch, (p, _) => IsIn(polygons, p));
        }

        [Test]
        public void Hash_OtherClips_IsAnother()
        {
            static ulong HashOf(params LocalClip[] clips) => new PointFilter { Clips = clips }.Hash;
            var keeps = new LocalClip { ToBox = double3x3.identity };
            var cuts = new LocalClip { ToBox = double3x3.identity, Cuts = true };
            var moved = new LocalClip { ToBox = double3x3.identity, Offset = new double3(1, 0, 0) };
            Assert.That(new[] { HashOf(), HashOf(keeps), HashOf(cuts), HashOf(moved), HashOf(keeps, cuts) }, Is.Unique);
            Assert.That(HashOf(keeps, cuts), Is.EqualTo(HashOf(keeps, cuts)));
        }

        [Test]
        public void Polygon_PositionsWithoutANumber_AreOutside()
        {
            using (var batch = TestBatches.OfPositions(new double3(double.NaN, 1, 0), new double3(1, double.NaN, 0),
                new double3(1, double.PositiveInfinity, 0), new double3(1, 1, double.NaN)))
                Assert.That(Left(new PointFilter
                {
                    Polygons = Of(new[] { new[] { new[] { default, new int2(2, 0), new int2(2, 2), new int2(0, 2) } } }),
                }, batch, PositionTransform.Identity).Count, Is.EqualTo(1));
        }

        [Test]
        public void Polygon_ManyVertices_TestsFewEdgesPerPoint()
        {
            const int vertices = 100_000;
            var ring = Enumerable.Range(0, vertices).Select(i =>
            {
                math.sincos(2 * Math.PI * i / vertices, out double sine, out double cosine);
                return (1000 + 5 * (i % 2)) * new double2(cosine, sine);
            }).ToArray();
            var random = new System.Random(1);
            using var batch = Points(200_000, _ => new double3(random.NextDouble() * 2400 - 1200,
                random.NextDouble() * 2400 - 1200, 0));
            int inner = 0, outer = 0;
            for (int i = 0; i < batch.Count; i++)
            {
                double radius = math.length(PositionAt(batch, PositionTransform.Identity, i));
                inner += radius < 999.9 ? 1 : 0;
                outer += radius < 1005 ? 1 : 0;
            }
            var polygons = FilterPolygons.Of(new[] { new[] { ring } });
            Assert.That(polygons.EdgesOfSlabs.Length, Is.LessThan(9 * vertices));
            var watch = Stopwatch.StartNew();
            Assert.That(Left(new PointFilter { Polygons = polygons }, batch, PositionTransform.Identity).Count,
                Is.InRange(inner, outer));
            Assert.That(watch.Elapsed.TotalSeconds, Is.LessThan(10), "one by one they are 2e10 comparisons");
        }
    }
}
