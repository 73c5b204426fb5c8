using FastPoints.Cli.Sources;

namespace FastPoints.HostTests.Cli.Filters;

public class PointFilterTests
{
    static PointBatch Points(int count, Func<int, double3> at) =>
        TestBatches.OfPositions(Enumerable.Range(0, count).Select(at).ToArray());

    static List<double3> Left(PointFilter filter, PointBatch batch, long first = 0)
    {
        using (filter)
        using (var slot = new FilterSlot(filter, batch, PositionTransform.Identity))
        using (var decoded = new NativeReference<DecodeResult>(new DecodeResult { Points = batch.Count }, Allocator.Persistent))
        {
            slot.Schedule(decoded, new BlockRange(0, 0, batch.Count), first, default).Complete();
            return Enumerable.Range(0, slot.Result.Value.Points).Select(i => PositionAt(batch, i)).ToList();
        }
    }

    static unsafe double3 PositionAt(PointBatch batch, int index) =>
        PositionColumns.Of(batch).GeoAt((byte*)batch.Bytes.GetUnsafeReadOnlyPtr(), PositionTransform.Identity, index);

    [Test]
    public void EveryNth_OfASource_CountsFromItsFirstPoint([Values(1, 2, 7, 20000)] int nth, [Values(0, 3, 8191)] int first)
    {
        using var batch = Points(20000, i => new double3(i, 0, 0));
        Assert.That(Left(new PointFilter { EveryNth = nth }, batch, first)
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
    public void Polygon_AnyRings_MatchesExactArithmetic([NUnit.Framework.Range(0, 19)] int seed)
    {
        var random = new System.Random(seed);
        // Few places: vertices fall on edges, on points and on one another, and rings are lines or single points.
        int size = seed < 10 ? 6 : 200;
        int2[] Ring() => Enumerable.Range(0, random.Next(1, 9)).Select(_ => new int2(random.Next(size), random.Next(size)))
            .ToArray();
        var polygons = Enumerable.Range(0, random.Next(1, 5)).Select(_ =>
            Enumerable.Range(0, random.Next(1, 4)).Select(__ => Ring()).ToArray()).ToArray();
        using var batch = Points(20000, _ => new double3(random.Next(-1, size + 1), random.Next(-1, size + 1), 0));
        var all = Enumerable.Range(0, batch.Count).Select(i => PositionAt(batch, i)).ToList();
        Assert.That(Left(new PointFilter { Polygons = Of(polygons) }, batch), Is.EqualTo(all.Where(p => IsIn(polygons, p))));
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
        using var batch = TestBatches.OfPositions(new double3(double.NaN, 1, 0), new double3(1, double.NaN, 0),
            new double3(1, double.PositiveInfinity, 0), new double3(1, 1, double.NaN));
        Assert.That(Left(new PointFilter
        {
            Polygons = Of(new[] { new[] { new[] { default, new int2(2, 0), new int2(2, 2), new int2(0, 2) } } }),
        }, batch).Count, Is.EqualTo(1));
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
            double radius = math.length(PositionAt(batch, i));
            inner += radius < 999.9 ? 1 : 0;
            outer += radius < 1005 ? 1 : 0;
        }
        var polygons = FilterPolygons.Of(new[] { new[] { ring } });
        Assert.That(polygons.RelativeEdgesOfSlabs.Length, Is.LessThan(9 * vertices));
        var watch = Stopwatch.StartNew();
        Assert.That(Left(new PointFilter { Polygons = polygons }, batch).Count,
            Is.InRange(inner, outer));
        Assert.That(watch.Elapsed.TotalSeconds, Is.LessThan(10), "one by one they are 2e10 comparisons");
    }
}
