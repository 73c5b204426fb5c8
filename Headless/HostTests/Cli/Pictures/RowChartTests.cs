namespace FastPoints.HostTests.Cli.Pictures;

public sealed class RowChartTests
{
    static XElement Drawn(RowChart chart) => XDocument.Parse(Encoding.UTF8.GetString(chart.ToBytes())).Root!;

    static double[] Circles(XElement svg, string attribute) => svg.Descendants().Where(e => e.Name.LocalName == "circle")
        .Select(e => double.Parse(e.Attribute(attribute)!.Value, CultureInfo.InvariantCulture)).ToArray();

    [Test]
    public void Rows_OfSamples_AreMarkersAlongOneAxis()
    {
        var chart = new RowChart("a < b", "ms", "error");
        chart.Add("first", "exact", [1, 2, 3]);
        chart.Add("second", "30 dB", [2]);

        var svg = Drawn(chart);
        double[] x = Circles(svg, "cx"), y = Circles(svg, "cy");

        Assert.That(x[1] - x[0], Is.EqualTo(x[2] - x[1]).Within(0.2).And.GreaterThan(0));
        Assert.That(x[3], Is.EqualTo(x[1]), "the same value in another row");
        Assert.That(y[3], Is.GreaterThan(y[2]));
        Assert.That(svg.Descendants().Where(e => e.Name.LocalName == "text").Select(e => e.Value),
            Is.SupersetOf(new[] { "a < b", "ms", "error", "first", "exact", "second", "30 dB" }));
    }

    [Test]
    public void LogAxis_Decades_HaveEqualWidths()
    {
        var chart = new RowChart("t", "ms", "error") { LogX = true };
        chart.Add("row", "", [0.1, 1, 10]);

        double[] x = Circles(Drawn(chart), "cx");

        Assert.That(x[2] - x[1], Is.EqualTo(x[1] - x[0]).Within(0.2));
    }

    [Test]
    public void Rows_WithoutSamples_AreAnEmptyChart()
    {
        var chart = new RowChart("t", "x", "head", "now", "earlier") { Reference = 1 };
        chart.Add("none", "", [], []);

        Assert.That(Circles(Drawn(chart), "cx"), Has.Length.EqualTo(1), "that of the legend");
    }
}
