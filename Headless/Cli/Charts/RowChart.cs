namespace FastPoints.Cli.Charts;

public sealed class RowChart(string title, string xLabel, string textHead, params string[] series)
{
    const int Top = 62, Bottom = 46, PlotWidth = 430, LanePx = 15, RowGap = 11, Gap = 12, HeadY = 54;

    static readonly CultureInfo s_invariant = CultureInfo.InvariantCulture;

    readonly List<Row> m_rows = [];

    public bool LogX { get; init; }
    public double? Reference { get; init; }

    public void Add(string name, string text, params IReadOnlyList<double>[] lanes) =>
        m_rows.Add(new Row(name, text, lanes.Select(l => l.Where(double.IsFinite).ToArray()).ToArray()));

    public byte[] ToBytes() => Encoding.UTF8.GetBytes(ChartSvg.Declaration + ToSvg());

    public string ToSvg()
    {
        int left = WidthOf(m_rows.Select(r => r.Name)) + 2 * Gap;
        int right = left + PlotWidth;
        int width = right + Gap + WidthOf(m_rows.Select(r => r.Text).Append(textHead)) + Gap;
        int rowPx = LanePx * series.Length + RowGap;
        int bottom = Top + Math.Max(1, m_rows.Count) * rowPx;
        var values = m_rows.SelectMany(r => r.Lanes).SelectMany(l => l);
        var x = ChartAxis.Of(Reference is { } at ? values.Append(at) : values, LogX, left, right);
        var svg = new StringBuilder();
        ChartSvg.Begin(svg, title, width, bottom + Bottom, Gap);
        Legend(svg, left);
        ChartSvg.Text(svg, right + Gap, HeadY, "start", textHead);
        foreach (double tick in x.Ticks)
        {
            ChartSvg.Line(svg, "grid", x.At(tick), Top, x.At(tick), bottom);
            ChartSvg.Text(svg, x.At(tick), bottom + 18, "middle", ChartSvg.Label(tick));
        }
        ChartSvg.Text(svg, left + PlotWidth / 2.0, bottom + 37, "middle", xLabel);
        if (Reference is { } reference)
            ChartSvg.Line(svg, "axis dash", x.At(reference), Top, x.At(reference), bottom);
        for (int i = 0; i < m_rows.Count; i++)
            Draw(svg, m_rows[i], Top + i * rowPx, rowPx, left, x);
        svg.Append(s_invariant,
            $"<rect class=\"axis\" x=\"{left}\" y=\"{Top}\" width=\"{PlotWidth}\" height=\"{bottom - Top}\"/>\n");
        return svg.Append("</svg>\n").ToString();
    }

    void Legend(StringBuilder svg, double x)
    {
        for (int i = 0; i < series.Length && series.Length > 1; i++)
        {
            svg.Append(s_invariant, $"<g class=\"c{i % ChartSvg.ColorCount}\">\n");
            ChartSvg.Mark(svg, i, x + 5, HeadY - 4, true);
            ChartSvg.Text(svg, x + 14, HeadY, "start", series[i]);
            svg.Append("</g>\n");
            x += 14 + series[i].Length * ChartSvg.CharWidthPx + 2 * Gap;
        }
    }

    static void Draw(StringBuilder svg, Row row, double top, int rowPx, int left, ChartAxis x)
    {
        double middle = top + rowPx / 2.0;
        ChartSvg.Text(svg, left - Gap, middle + 4, "end", row.Name);
        ChartSvg.Text(svg, left + PlotWidth + Gap, middle + 4, "start", row.Text);
        for (int i = 0; i < row.Lanes.Length; i++)
        {
            double[] lane = row.Lanes[i];
            if (lane.Length == 0)
                continue;
            double y = top + RowGap / 2.0 + (i + 0.5) * LanePx, median = x.At(Benchmarks.WorkloadSamples.Median(lane));
            svg.Append(s_invariant, $"<g class=\"c{i % ChartSvg.ColorCount}\">\n");
            ChartSvg.Line(svg, "line", x.At(lane.Min()), y, x.At(lane.Max()), y);
            ChartSvg.Line(svg, "line", median, y - LanePx / 2.0 + 1, median, y + LanePx / 2.0 - 1);
            foreach (double value in lane)
                ChartSvg.Mark(svg, i, x.At(value), y, isFilled: false);
            svg.Append("</g>\n");
        }
    }

    static int WidthOf(IEnumerable<string> texts) =>
        (int)(texts.Select(t => t.Length).DefaultIfEmpty().Max() * ChartSvg.CharWidthPx);

    sealed record Row(string Name, string Text, double[][] Lanes);
}
