namespace FastPoints.HostTests.Cli.Pictures;

public sealed class LineChartTests
{
    static XElement Drawn(LineChart chart) => XDocument.Parse(Encoding.UTF8.GetString(chart.ToBytes()).TrimStart('\uFEFF')).Root!;

    static string[] Texts(XElement svg) =>
        svg.Descendants().Where(e => e.Name.LocalName == "text").Select(e => e.Value).ToArray();

    static double[][] Polyline(XElement svg) => svg.Descendants().Single(e => e.Name.LocalName == "polyline").Attribute("points")!
        .Value.Split(' ', System.StringSplitOptions.RemoveEmptyEntries)
        .Select(p => p.Split(',').Select(v => double.Parse(v, System.Globalization.CultureInfo.InvariantCulture)).ToArray())
        .ToArray();

    [Test]
    public void LogAxes_PowersOfTen_AreEquidistant()
    {
        var chart = new LineChart("a < b & c", "seconds", "error") { LogX = true, LogY = true };
        chart.Add("ours", [(0.01, 1000), (0.1, 100), (1, 10), (10, 1)]);
        var svg = Drawn(chart);
        var points = Polyline(svg);
        for (int i = 2; i < points.Length; i++)
            for (int axis = 0; axis < 2; axis++)
                Assert.That(points[i][axis] - points[i - 1][axis], Is.EqualTo(points[1][axis] - points[0][axis]).Within(0.21));
        Assert.That(points[1][0], Is.GreaterThan(points[0][0]));
        Assert.That(points[1][1], Is.GreaterThan(points[0][1]), "less lies below");
        Assert.That(Texts(svg), Is.SupersetOf(new[] { "a < b & c", "seconds", "error", "ours", "0.01", "10", "1,000" }));
    }

    [Test]
    public void LogAxis_ZeroAndNonFinite_IsClampedOrSkipped()
    {
        var chart = new LineChart("t", "x", "y") { LogX = true, LogY = true };
        chart.Add("one", [(1, 1), (2, 0), (3, double.NaN), (double.PositiveInfinity, 1)]);
        var svg = Drawn(chart);
        Assert.That(Polyline(svg).Length, Is.EqualTo(2));
        Assert.That(svg.Descendants().Count(e => ((string)e.Attribute("class"))?.Contains("hollow") == true), Is.EqualTo(1));
    }

    [Test]
    public void LogAxis_BetweenRoundNumbers_HasNumbers()
    {
        var chart = new LineChart("t", "points", "dB") { LogX = true };
        chart.Add("one", [(20_100, 30), (20_900, 40)]);
        Assert.That(Texts(Drawn(chart)).Count(t => t.StartsWith("20,", StringComparison.Ordinal)), Is.GreaterThan(1));
    }

    [Test]
    public void NothingToDraw_IsAnEmptyChart()
    {
        var chart = new LineChart("t", "x", "y") { LogY = true };
        chart.Add("none", []);
        Assert.That(Texts(Drawn(chart)), Does.Contain("none"));
    }

    [Test]
    public void LinearAxis_Fractions_StartAtZero()
    {
        var chart = new LineChart("t", "x", "y");
        chart.Add("one", [(1, 0.1), (2, 0.9)]);
        Assert.That(Texts(Drawn(chart)), Is.SupersetOf(new[] { "0", "0.2", "0.8" }));
    }
}
