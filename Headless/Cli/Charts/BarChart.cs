namespace FastPoints.Cli.Charts;

public static class BarChart
{
    const int Width = 400, Left = 12, Right = 12, Top = 34, PlotHeight = 120, RowPx = 22, NameWidth = 132;
    const int Bins = 56;
    const double OutlierShare = 0.002;

    static readonly CultureInfo s_invariant = CultureInfo.InvariantCulture;

    public static string Histogram(string title, IEnumerable<double> values, string unit)
    {
        double[] sorted = values.Where(double.IsFinite).Order().ToArray();
        var svg = new StringBuilder();
        ChartSvg.Begin(svg, title, Width, Top + PlotHeight + 44, Left);
        if (sorted.Length == 0)
            return svg.Append("</svg>\n").ToString();
        int outliers = (int)(sorted.Length * OutlierShare);
        double low = sorted[outliers], high = sorted[sorted.Length - 1 - outliers];
        if (!(high > low))
            (low, high) = (low - 0.5, low + 0.5);
        // Whole numbers get bins of whole numbers: otherwise some hold more of them than others.
        double bin = (high - low) / Bins;
        if (sorted.All(v => v == Math.Floor(v)))
            (bin, low) = (Math.Ceiling(Math.Max(bin, 1)), low - 0.5);
        int[] counts = new int[(int)Math.Ceiling((high - low) / bin + 1e-9)];
        foreach (double value in sorted.AsSpan(outliers, sorted.Length - 2 * outliers))
            counts[Math.Clamp((int)((value - low) / bin), 0, counts.Length - 1)]++;
        high = low + bin * counts.Length;
        double XOf(double value) => Left + (value - low) / (high - low) * (Width - Left - Right);
        svg.Append("<path class=\"bar\" d=\"");
        for (int i = 0; i < counts.Length; i++)
        {
            double x = XOf(low + i * bin), width = XOf(low + (i + 1) * bin) - x, max = counts.Max();
            double y = PlotHeight * counts[i] / max;
            svg.Append(s_invariant, $"M{x:0.##} {Top + PlotHeight}v{-y:0.##}h{Math.Max(0.6, width - 0.6):0.##}v{y:0.##}z");
        }
        svg.Append("\"/>\n");
        ChartSvg.Line(svg, "axis", Left, Top + PlotHeight, Width - Right, Top + PlotHeight);
        var ticks = ChartAxis.Of([low, high], false, 0, 1).Ticks.Where(t => t >= low && t <= high).ToList();
        int letters = ticks.Count == 0 ? 0 : ticks.Max(t => ChartSvg.Label(t).Length), every = 1;
        while (ticks.Count / every * (letters + 2) * ChartSvg.CharWidthPx > Width)
            every++;
        foreach (double tick in ticks.Where((_, i) => i % every == 0))
        {
            string label = ChartSvg.Label(tick);
            double half = label.Length * ChartSvg.CharWidthPx / 2;
            ChartSvg.Line(svg, "axis", XOf(tick), Top + PlotHeight, XOf(tick), Top + PlotHeight + 4);
            ChartSvg.Text(svg, Math.Clamp(XOf(tick), half, Width - half), Top + PlotHeight + 18, "middle", label);
        }
        ChartSvg.Text(svg, Width / 2.0, Top + PlotHeight + 37, "middle", unit);
        return svg.Append("</svg>\n").ToString();
    }

    public static string Rows(string title, IReadOnlyList<(string Name, double Amount, string Text)> rows)
    {
        var svg = new StringBuilder();
        ChartSvg.Begin(svg, title, Width, Top + rows.Count * RowPx + 4, Left);
        double max = rows.Select(r => r.Amount).DefaultIfEmpty().Max();
        double text = rows.Select(r => r.Text.Length).DefaultIfEmpty().Max() * ChartSvg.CharWidthPx;
        double plot = Width - NameWidth - Right - 8 - text;
        for (int i = 0; i < rows.Count; i++)
        {
            double y = Top + i * RowPx, width = max > 0 ? Math.Max(1, plot * rows[i].Amount / max) : 1;
            string name = rows[i].Name.Length <= 20 ? rows[i].Name : rows[i].Name[..19] + "…";
            ChartSvg.Text(svg, NameWidth - 6, y + 13, "end", name);
            svg.Append(s_invariant,
                $"<rect class=\"bar\" x=\"{NameWidth}\" y=\"{y + 2:0.#}\" width=\"{width:0.#}\" height=\"15\"/>\n");
            ChartSvg.Text(svg, NameWidth + width + 6, y + 13, "start", rows[i].Text);
        }
        return svg.Append("</svg>\n").ToString();
    }
}
