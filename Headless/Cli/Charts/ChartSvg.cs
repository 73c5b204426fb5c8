namespace FastPoints.Cli.Charts;

public static class ChartSvg
{
    public const double CharWidthPx = 6.8;
    public const string Declaration = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n";

    public static int ColorCount => s_onLight.Length;

    // Okabe and Ito's colours, which most people can distinguish: darkened for light pages, lightened for dark ones.
    static readonly string[] s_onLight = ["#0072b2", "#444444", "#d55e00", "#009e73", "#b05b8f", "#a87f00", "#2f97c9", "#8a5a2b"];
    static readonly string[] s_onDark = ["#56a9e8", "#dddddd", "#ff8a3c", "#2fd0a0", "#e59ac6", "#f0d040", "#8fd3f5", "#c99a6b"];

    public static readonly string Style = """
        .chart text { font: 12px system-ui, sans-serif; fill: #333; } .chart .title { font-size: 14px; font-weight: 600; }
        .chart .page { fill: #fff; } .chart .grid { stroke: #e4e4e4; } .chart .axis { stroke: #777; fill: none; }
        .chart .line { fill: none; stroke-width: 2; stroke-linejoin: round; } .chart .dash { stroke-dasharray: 6 4; }
        .chart .bar { fill: #0072b2; }

        """ + Colors(s_onLight) + """
        @media (prefers-color-scheme: dark) {
        .chart text { fill: #ccc; } .chart .page { fill: #181818; } .chart .grid { stroke: #333; }
        .chart .axis { stroke: #999; } .chart .bar { fill: #56a9e8; }

        """ + Colors(s_onDark) + "} .chart .mark.hollow { fill: none; }";

    static readonly CultureInfo s_invariant = CultureInfo.InvariantCulture;

    static string Colors(string[] colors) => string.Concat(colors.Select((color, i) =>
        $".chart .c{i} .line {{ stroke: {color}; }} "
        + $".chart .c{i} .mark {{ fill: {color}; stroke: {color}; stroke-width: 1.5; }}\n"));

    public static void Begin(StringBuilder svg, string title, int width, int height, double titleX) =>
        svg.Append("<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" ")
            .Append(s_invariant, $"viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" ")
            .Append(s_invariant, $"role=\"img\" aria-label=\"{Escape(title)}\">\n")
            .Append("<style>\n").Append(Style).Append("\n</style>\n")
            .Append(s_invariant, $"<rect class=\"page\" width=\"{width}\" height=\"{height}\"/>\n")
            .Append(s_invariant, $"<text class=\"title\" x=\"{titleX:0.#}\" y=\"22\">{Escape(title)}</text>\n");

    public static void Mark(StringBuilder svg, int index, double x, double y, bool isFilled)
    {
        string style = isFilled ? "mark" : "mark hollow";
        switch (index % 4)
        {
            case 0:
                svg.Append(s_invariant, $"<circle class=\"{style}\" cx=\"{x:0.#}\" cy=\"{y:0.#}\" r=\"3.5\"/>\n");
                break;
            case 1:
                svg.Append(s_invariant, $"<path class=\"{style}\" d=\"M{x - 3:0.#} {y - 3:0.#}h6v6h-6z\"/>\n");
                break;
            case 2:
                svg.Append(s_invariant, $"<path class=\"{style}\" d=\"M{x:0.#} {y - 4:0.#}l4 7h-8z\"/>\n");
                break;
            default:
                svg.Append(s_invariant, $"<path class=\"{style}\" d=\"M{x:0.#} {y - 4.5:0.#}l4.5 4.5l-4.5 4.5l-4.5 -4.5z\"/>\n");
                break;
        }
    }

    public static void Line(StringBuilder svg, string style, double x1, double y1, double x2, double y2) =>
        svg.Append(s_invariant, $"<path class=\"{style}\" d=\"M{x1:0.#} {y1:0.#}L{x2:0.#} {y2:0.#}\"/>\n");

    public static void Text(StringBuilder svg, double x, double y, string anchor, string text) =>
        svg.Append(s_invariant, $"<text x=\"{x:0.#}\" y=\"{y:0.#}\" text-anchor=\"{anchor}\">{Escape(text)}</text>\n");

    public static string Escape(string text) => WebUtility.HtmlEncode(text);

    public static string Label(double value)
    {
        double size = Math.Abs(value);
        if (size >= 1e6 && size < 1e9)
            return (value / 1e6).ToString("0.###", CultureInfo.InvariantCulture) + " M";
        return size is 0 or >= 1e-4 and < 1e9
            ? value.ToString("#,0.######", CultureInfo.InvariantCulture)
            : value.ToString("0.#e+0", CultureInfo.InvariantCulture);
    }
}
