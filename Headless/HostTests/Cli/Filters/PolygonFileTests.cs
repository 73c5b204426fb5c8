namespace FastPoints.HostTests.Cli.Filters;

public class PolygonFileTests
{
    static string Wkt(int2[][][] polygons) => "MULTIPOLYGON Z (" + string.Join(", ", polygons.Select(polygon =>
        "(" + string.Join(",", polygon.Select(r => "(" + string.Join(",", r.Select(p => p.x + " " + p.y + " 7")) + ")")) +
        ")")) + ")";

    static string GeoJson(int2[][][] polygons) => "{\"type\":\"FeatureCollection\",\"features\":[" + string.Join(",",
        polygons.Select(polygon => "{\"type\":\"Feature\",\"properties\":null,\"geometry\":{\"type\":\"Polygon\"," +
            "\"coordinates\":[" + string.Join(",", polygon.Select(r => "[" + string.Join(",", r.Select(p =>
                "[" + p.x + "," + p.y + "]")) + "]")) + "]}}")) + "]}";

    [Test]
    public void Parse_AnyRings_AreThoseOfTheText([NUnit.Framework.Range(0, 9)] int seed)
    {
        var random = new System.Random(seed);
        var polygons = Enumerable.Range(0, random.Next(1, 5)).Select(_ => Enumerable.Range(0, random.Next(1, 4)).Select(_ =>
            Enumerable.Range(0, random.Next(1, 9)).Select(_ => new int2(random.Next(-9, 99), random.Next(200))).ToArray())
            .ToArray()).ToArray();
        foreach (string text in new[] { Wkt(polygons), "SRID=28992;" + Wkt(polygons), "\uFEFF " + GeoJson(polygons) })
        {
            using var parsed = PolygonFile.Parse(text);
            Assert.That(parsed.Rings.Select(r => r.Polygon + ":" + string.Join(' ', r.Vertices)), Is.EqualTo(polygons.SelectMany(
                (rings, i) => rings.Select(r => 1 + i + ":" + string.Join(' ', r.Select(v => new double2(v.x, v.y)))))), text);
        }
    }

    [TestCase("POINT(1 2)"), TestCase("POLYGON((1 2"), TestCase("POLYGON((1))"), TestCase("POLYGON((1 x))")]
    [TestCase("{}"), TestCase("{\"type\":\"Point\",\"coordinates\":[1,2]}"), TestCase("[1]"), TestCase("")]
    [TestCase("{\"type\":7}")]
    [TestCase("{\"type\":\"Polygon\",\"coordinates\":[[[1]]]}"), TestCase("{\"type\":\"FeatureCollection\",\"features\":[]}")]
    [TestCase("{\"type\":\"Polygon\",\"coordinates\":[[[1e999,1]]]}"), TestCase("POLYGON((1 2)) x"), TestCase("{\"type\":")]
    public void Parse_Invalid_IsNamed(string text) => Assert.Throws<FormatException>(() => PolygonFile.Parse(text));
}
