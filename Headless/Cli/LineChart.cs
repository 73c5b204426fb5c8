using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Net;
using System.Text;

namespace FastPoints.Cli
{
    /// <summary>
    /// A line chart as SVG: linear or logarithmic axes, a legend, a marker of its own for each series, legible on light and on
    /// dark pages.
    /// </summary>
    /// <remarks>What a logarithmic axis cannot show (zero or less) stands on its lower end, with a hollow marker; what is not
    /// finite is left out.</remarks>
    public sealed class LineChart(string title, string xLabel, string yLabel)
    {
        const int HeightPx = 400, Left = 74, Top = 38, Bottom = 52;
        const int PlotWidth = 490, PlotHeight = HeightPx - Top - Bottom;
        const int LegendLine = 20, LegendLeft = 16, LegendText = 34;

        /// <summary>About what a letter of the legend takes, in most people's fonts.</summary>
        const double LetterPx = 6.8;

        /// <summary>Fewer decades than this get ticks at 2 and 5 as well.</summary>
        const double FewDecades = 3;

        // Okabe and Ito's colours, which most people can tell apart: darkened for light pages, lightened for dark ones.
        static readonly string[] s_onLight =
            ["#0072b2", "#444444", "#d55e00", "#009e73", "#b05b8f", "#a87f00", "#2f97c9", "#8a5a2b"];
        static readonly string[] s_onDark =
            ["#56a9e8", "#dddddd", "#ff8a3c", "#2fd0a0", "#e59ac6", "#f0d040", "#8fd3f5", "#c99a6b"];

        static readonly string s_style = """
            .chart text { font: 12px system-ui, sans-serif; fill: #333; } .chart .title { font-size: 14px; font-weight: 600; }
            .chart .page { fill: #fff; } .chart .grid { stroke: #e4e4e4; } .chart .axis { stroke: #777; fill: none; }
            .chart .line { fill: none; stroke-width: 2; stroke-linejoin: round; } .chart .dash { stroke-dasharray: 6 4; }

            """ + Colors(s_onLight) + """
            @media (prefers-color-scheme: dark) {
            .chart text { fill: #ccc; } .chart .page { fill: #181818; } .chart .grid { stroke: #333; }
            .chart .axis { stroke: #999; }

            """ + Colors(s_onDark) + "} .chart .mark.hollow { fill: none; }";

        static readonly CultureInfo s_c = CultureInfo.InvariantCulture;

        readonly List<Series> m_series = [];

        public bool LogX { get; init; }
        public bool LogY { get; init; }

        /// <param name="isDashed">For what the others are measured by.</param>
        public void Add(string name, IEnumerable<(double X, double Y)> points, bool isDashed = false) =>
            m_series.Add(new Series(name, points.Where(p => double.IsFinite(p.X) && double.IsFinite(p.Y)).ToList(), isDashed));

        static string Colors(string[] colors) => string.Concat(colors.Select((color, i) =>
            $".chart .c{i} .line {{ stroke: {color}; }} "
            + $".chart .c{i} .mark {{ fill: {color}; stroke: {color}; stroke-width: 1.5; }}\n"));

        public byte[] ToBytes() => Encoding.UTF8.GetBytes("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n" + ToSvg());

        public string ToSvg()
        {
            int longest = m_series.Select(s => s.Name.Length).DefaultIfEmpty().Max();
            int width = Left + PlotWidth + LegendLeft + LegendText + (int)Math.Max(146, longest * LetterPx + 12);
            var all = m_series.SelectMany(s => s.Points).ToList();
            var x = Axis.Of(all.Select(p => p.X), LogX, Left, Left + PlotWidth);
            var y = Axis.Of(all.Select(p => p.Y), LogY, Top + PlotHeight, Top);
            var svg = new StringBuilder();
            svg.Append("<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" ")
                .Append(s_c, $"viewBox=\"0 0 {width} {HeightPx}\" width=\"{width}\" height=\"{HeightPx}\" ")
                .Append(s_c, $"role=\"img\" aria-label=\"{Escape(title)}\">\n")
                .Append("<style>\n").Append(s_style).Append("\n</style>\n")
                .Append(s_c, $"<rect class=\"page\" width=\"{width}\" height=\"{HeightPx}\"/>\n")
                .Append(s_c, $"<text class=\"title\" x=\"{Left}\" y=\"22\">{Escape(title)}</text>\n");
            foreach (double tick in x.Ticks)
            {
                double at = x.At(tick);
                Line(svg, "grid", at, Top, at, Top + PlotHeight);
                Text(svg, at, Top + PlotHeight + 18, "middle", Label(tick));
            }
            foreach (double tick in y.Ticks)
            {
                double at = y.At(tick);
                Line(svg, "grid", Left, at, Left + PlotWidth, at);
                Text(svg, Left - 8, at + 4, "end", Label(tick));
            }
            svg.Append(s_c, $"<rect class=\"axis\" x=\"{Left}\" y=\"{Top}\" width=\"{PlotWidth}\" ")
                .Append(s_c, $"height=\"{PlotHeight}\"/>\n");
            Text(svg, Left + PlotWidth / 2.0, HeightPx - 12, "middle", xLabel);
            double middle = Top + PlotHeight / 2.0;
            svg.Append(s_c, $"<text transform=\"translate(16 {middle:0.#}) rotate(-90)\" text-anchor=\"middle\">")
                .Append(Escape(yLabel)).Append("</text>\n");
            for (int i = 0; i < m_series.Count; i++)
                Draw(svg, m_series[i], i, x, y);
            return svg.Append("</svg>\n").ToString();
        }

        static void Draw(StringBuilder svg, Series series, int index, Axis x, Axis y)
        {
            string color = "c" + (index % s_onLight.Length).ToString(CultureInfo.InvariantCulture);
            string line = series.IsDashed ? "line dash" : "line";
            svg.Append(s_c, $"<g class=\"{color}\">\n");
            if (series.Points.Count > 1)
            {
                svg.Append(s_c, $"<polyline class=\"{line}\" points=\"");
                foreach (var (px, py) in series.Points)
                    svg.Append(s_c, $"{x.At(px):0.#},{y.At(py):0.#} ");
                svg.Append("\"/>\n");
            }
            foreach (var (px, py) in series.Points)
                Mark(svg, index, x.At(px), y.At(py), x.Holds(px) && y.Holds(py));
            double legendX = Left + PlotWidth + LegendLeft, legendY = Top + 10 + index * LegendLine;
            Line(svg, line, legendX, legendY, legendX + 26, legendY);
            Mark(svg, index, legendX + 13, legendY, true);
            Text(svg, legendX + LegendText, legendY + 4, "start", series.Name);
            svg.Append("</g>\n");
        }

        /// <summary>Circle, square, triangle, diamond, then again.</summary>
        static void Mark(StringBuilder svg, int index, double x, double y, bool isFilled)
        {
            string style = isFilled ? "mark" : "mark hollow";
            switch (index % 4)
            {
                case 0:
                    svg.Append(s_c, $"<circle class=\"{style}\" cx=\"{x:0.#}\" cy=\"{y:0.#}\" r=\"3.5\"/>\n");
                    break;
                case 1:
                    svg.Append(s_c, $"<path class=\"{style}\" d=\"M{x - 3:0.#} {y - 3:0.#}h6v6h-6z\"/>\n");
                    break;
                case 2:
                    svg.Append(s_c, $"<path class=\"{style}\" d=\"M{x:0.#} {y - 4:0.#}l4 7h-8z\"/>\n");
                    break;
                default:
                    svg.Append(s_c, $"<path class=\"{style}\" d=\"M{x:0.#} {y - 4.5:0.#}l4.5 4.5l-4.5 4.5l-4.5 -4.5z\"/>\n");
                    break;
            }
        }

        static void Line(StringBuilder svg, string style, double x1, double y1, double x2, double y2) =>
            svg.Append(s_c, $"<path class=\"{style}\" d=\"M{x1:0.#} {y1:0.#}L{x2:0.#} {y2:0.#}\"/>\n");

        static void Text(StringBuilder svg, double x, double y, string anchor, string text) =>
            svg.Append(s_c, $"<text x=\"{x:0.#}\" y=\"{y:0.#}\" text-anchor=\"{anchor}\">{Escape(text)}</text>\n");

        static string Escape(string text) => WebUtility.HtmlEncode(text);

        /// <summary>Up to a million and down to a ten-thousandth as people write it.</summary>
        static string Label(double value)
        {
            double size = Math.Abs(value);
            if (size >= 1e6 && size < 1e9)
                return (value / 1e6).ToString("0.###", CultureInfo.InvariantCulture) + " M";
            return size is 0 or >= 1e-4 and < 1e9
                ? value.ToString("#,0.######", CultureInfo.InvariantCulture)
                : value.ToString("0.#e+0", CultureInfo.InvariantCulture);
        }

        sealed record Series(string Name, List<(double X, double Y)> Points, bool IsDashed);

        /// <summary>From values to pixels.</summary>
        sealed class Axis
        {
            readonly bool m_isLog;
            readonly double m_low, m_high, m_lowPx, m_highPx;

            Axis(bool isLog, double low, double high, double lowPx, double highPx)
            {
                (m_isLog, m_low, m_high, m_lowPx, m_highPx) = (isLog, low, high, lowPx, highPx);
                Ticks = (isLog ? LogTicks(low, high) : LinearTicks(low, high)).ToList();
            }

            public List<double> Ticks { get; }

            public static Axis Of(IEnumerable<double> values, bool isLog, double lowPx, double highPx)
            {
                var shown = values.Where(v => !isLog || v > 0).Select(v => isLog ? Math.Log10(v) : v).ToList();
                double low = shown.Count > 0 ? shown.Min() : 0, high = shown.Count > 0 ? shown.Max() : 1;
                if (!isLog && low >= 0 && low < high / 2)
                    low = 0;
                double margin = high > low ? 0.04 * (high - low) : isLog ? 0.5 : Math.Max(0.5, Math.Abs(high) / 2);
                return new Axis(isLog, !isLog && low == 0 && high > low ? 0 : low - margin, high + margin, lowPx, highPx);
            }

            /// <summary>Whether a value has a place of its own.</summary>
            public bool Holds(double value) => !m_isLog || value > 0;

            public double At(double value)
            {
                double place = m_isLog ? value > 0 ? Math.Log10(value) : m_low : value;
                return m_lowPx + (place - m_low) / (m_high - m_low) * (m_highPx - m_lowPx);
            }

            static IEnumerable<double> LogTicks(double low, double high)
            {
                double[] steps = high - low < FewDecades ? [1, 2, 5] : [1];
                int every = Math.Max(1, (int)((high - low) / 10) + (high - low > 10 ? 1 : 0));
                for (int decade = (int)Math.Floor(low); decade <= Math.Ceiling(high); decade += every)
                    foreach (double step in steps)
                    {
                        double place = decade + Math.Log10(step);
                        if (place >= low && place <= high)
                            yield return step * Math.Pow(10, decade);
                    }
            }

            static IEnumerable<double> LinearTicks(double low, double high)
            {
                double rough = (high - low) / 6, decade = Math.Pow(10, Math.Floor(Math.Log10(rough)));
                double step = decade * (rough / decade) switch { < 1.5 => 1, < 3.5 => 2, < 7.5 => 5, _ => 10 };
                for (double tick = Math.Ceiling(low / step); tick * step <= high; tick++)
                    yield return tick * step;
            }
        }
    }
}
