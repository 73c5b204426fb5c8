namespace FastPoints.Cli.Charts;

/// <remarks>What a logarithmic axis cannot show (zero or less) stands on its lower end, with a hollow marker; what is not
/// finite is left out.</remarks>
public sealed class LineChart(string title, string xLabel, string yLabel)
{
    const int HeightPx = 400, Left = 74, Top = 38, Bottom = 52;
    const int PlotHeight = HeightPx - Top - Bottom;
    const int LegendLine = 20, LegendLeft = 16, LegendText = 34;

    static readonly CultureInfo s_invariant = CultureInfo.InvariantCulture;

    readonly List<Series> m_series = [];

    public int PlotWidth { get; init; } = 490;
    public bool HasMarkers { get; init; } = true;

    /// <summary>If there is only one series, the title may name it.</summary>
    public bool HasLegend { get; init; } = true;

    public string Title => title;
    public bool IsEmpty => m_series.All(s => s.Points.Count == 0);
    public bool LogX { get; init; }
    public bool LogY { get; init; }

    /// <param name="isDashed">For the reference series.</param>
    public void Add(string name, IEnumerable<(double X, double Y)> points, bool isDashed = false) =>
        m_series.Add(new Series(name, points.Where(p => double.IsFinite(p.X) && double.IsFinite(p.Y)).ToList(), isDashed));

    public byte[] ToBytes() => Encoding.UTF8.GetBytes(ChartSvg.Declaration + ToSvg());

    public string ToSvg()
    {
        int longest = m_series.Select(s => s.Name.Length).DefaultIfEmpty().Max();
        int legend = LegendLeft + LegendText + (int)Math.Max(146, longest * ChartSvg.CharWidthPx + 12);
        int width = Left + PlotWidth + (HasLegend ? legend : LegendLeft);
        var all = m_series.SelectMany(s => s.Points).ToList();
        var x = ChartAxis.Of(all.Select(p => p.X), LogX, Left, Left + PlotWidth);
        var y = ChartAxis.Of(all.Select(p => p.Y), LogY, Top + PlotHeight, Top);
        var svg = new StringBuilder();
        ChartSvg.Begin(svg, title, width, HeightPx, Left);
        foreach (double tick in x.Ticks)
        {
            double at = x.At(tick);
            ChartSvg.Line(svg, "grid", at, Top, at, Top + PlotHeight);
            ChartSvg.Text(svg, at, Top + PlotHeight + 18, "middle", ChartSvg.Label(tick));
        }
        foreach (double tick in y.Ticks)
        {
            double at = y.At(tick);
            ChartSvg.Line(svg, "grid", Left, at, Left + PlotWidth, at);
            ChartSvg.Text(svg, Left - 8, at + 4, "end", ChartSvg.Label(tick));
        }
        svg.Append(s_invariant, $"<rect class=\"axis\" x=\"{Left}\" y=\"{Top}\" width=\"{PlotWidth}\" ")
            .Append(s_invariant, $"height=\"{PlotHeight}\"/>\n");
        ChartSvg.Text(svg, Left + PlotWidth / 2.0, HeightPx - 12, "middle", xLabel);
        double middle = Top + PlotHeight / 2.0;
        svg.Append(s_invariant, $"<text transform=\"translate(16 {middle:0.#}) rotate(-90)\" text-anchor=\"middle\">")
            .Append(ChartSvg.Escape(yLabel)).Append("</text>\n");
        for (int i = 0; i < m_series.Count; i++)
            Draw(svg, m_series[i], i, x, y);
        return svg.Append("</svg>\n").ToString();
    }

    void Draw(StringBuilder svg, Series series, int index, ChartAxis x, ChartAxis y)
    {
        string color = "c" + (index % ChartSvg.ColorCount).ToString(CultureInfo.InvariantCulture);
        string line = series.IsDashed ? "line dash" : "line";
        svg.Append(s_invariant, $"<g class=\"{color}\">\n");
        if (series.Points.Count > 1)
        {
            svg.Append(s_invariant, $"<polyline class=\"{line}\" points=\"");
            foreach (var (px, py) in series.Points)
                svg.Append(s_invariant, $"{x.At(px):0.#},{y.At(py):0.#} ");
            svg.Append("\"/>\n");
        }
        foreach (var (px, py) in HasMarkers ? series.Points : [])
            ChartSvg.Mark(svg, index, x.At(px), y.At(py), x.CanShow(px) && y.CanShow(py));
        if (!HasLegend)
        {
            svg.Append("</g>\n");
            return;
        }
        double legendX = Left + PlotWidth + LegendLeft, legendY = Top + 10 + index * LegendLine;
        ChartSvg.Line(svg, line, legendX, legendY, legendX + 26, legendY);
        ChartSvg.Mark(svg, index, legendX + 13, legendY, true);
        ChartSvg.Text(svg, legendX + LegendText, legendY + 4, "start", series.Name);
        svg.Append("</g>\n");
    }

    sealed record Series(string Name, List<(double X, double Y)> Points, bool IsDashed);
}
