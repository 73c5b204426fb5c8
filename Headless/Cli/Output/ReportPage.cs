using System.Net;

namespace FastPoints.Cli.Output;

/// <summary>The page of the main job: one file with everything in it, pictures too.</summary>
public sealed class ReportPage(string title)
{
    const string Style = """
        body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 72rem; padding: 0 1rem;
          color: #222; background: #fff; }
        h1 { font-size: 1.6rem; } h2 { font-size: 1.15rem; margin-top: 2rem; border-bottom: 1px solid #ddd; }
        table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
        td, th { padding: .15rem .9rem .15rem 0; text-align: right; font-weight: normal; white-space: pre-wrap;
          vertical-align: top; }
        th { color: #666; } td:first-child, th:first-child { text-align: left; } table.facts td { text-align: left; }
        table.facts td:first-child { color: #666; white-space: nowrap; } img { max-width: 100%; border: 1px solid #ddd; }
        .row { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 1rem; }
        .row figure { margin: 0; }
        .row svg { width: 100%; height: auto; } .rows svg { max-width: 100%; height: auto; } .wide { overflow-x: auto; }
        .wide td, .wide th { padding-right: .6rem; font-size: 13px; }
        .warning { color: #8a4b00; } figcaption { color: #666; } figure { margin: 1rem 0; }
        @media (prefers-color-scheme: dark) { body { color: #ddd; background: #181818; } h2, img { border-color: #444; }
          th, figcaption, table.facts td:first-child { color: #999; } .warning { color: #f0b060; } }
        """;

    readonly StringBuilder m_body = new();

    static string Escape(string text) => WebUtility.HtmlEncode(text);
    public void Heading(string text) => m_body.Append("<h2>").Append(Escape(text)).Append("</h2>\n");
    public void Paragraph(string text) => m_body.Append("<p>").Append(Escape(text)).Append("</p>\n");
    public void Warning(string text) => m_body.Append("<p class=\"warning\">").Append(Escape(text)).Append("</p>\n");

    public void Facts(IEnumerable<(string Name, string Value)> facts)
    {
        m_body.Append("<table class=\"facts\">\n");
        foreach (var (name, value) in facts)
            m_body.Append("<tr><td>").Append(Escape(name)).Append("</td><td>").Append(Escape(value)).Append("</td></tr>\n");
        m_body.Append("</table>\n");
    }

    /// <summary>As <see cref="Table"/>, in smaller print; scrolls where the page is too narrow for it.</summary>
    public void WideTable(TextTable table)
    {
        m_body.Append("<div class=\"wide\">\n");
        Table(table);
        m_body.Append("</div>\n");
    }

    public void Chart(RowChart chart) => m_body.Append("<figure class=\"rows\">\n").Append(chart.ToSvg()).Append("\n</figure>\n");

    /// <summary>Charts side by side, as many as fit.</summary>
    public void Charts(IEnumerable<LineChart> charts)
    {
        m_body.Append("<div class=\"row\">\n");
        foreach (var chart in charts)
            m_body.Append("<figure>").Append(chart.ToSvg()).Append("</figure>\n");
        m_body.Append("</div>\n");
    }

    /// <summary>Pictures side by side, as many as fit.</summary>
    public void Pictures(IEnumerable<(byte[] Png, string Caption)> pictures)
    {
        m_body.Append("<div class=\"row\">\n");
        foreach (var (png, caption) in pictures)
            Picture(png, caption);
        m_body.Append("</div>\n");
    }

    public void Table(TextTable table)
    {
        m_body.Append("<table>\n");
        string cell = "th";
        foreach (var row in table.Rows)
        {
            m_body.Append("<tr>");
            foreach (string text in row)
                m_body.Append('<').Append(cell).Append('>').Append(Escape(text)).Append("</").Append(cell).Append('>');
            m_body.Append("</tr>\n");
            cell = "td";
        }
        m_body.Append("</table>\n");
    }

    public void Picture(byte[] png, string caption)
    {
        m_body.Append("<figure><img alt=\"").Append(Escape(caption)).Append("\" src=\"data:image/png;base64,")
            .Append(System.Convert.ToBase64String(png)).Append("\">\n<figcaption>").Append(Escape(caption))
            .Append("</figcaption></figure>\n");
    }

    public void Chart(LineChart chart) => m_body.Append("<figure>\n").Append(chart.ToSvg()).Append("\n</figure>\n");

    public byte[] ToBytes() => Encoding.UTF8.GetBytes(string.Create(CultureInfo.InvariantCulture,
        $"<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        + $"<title>{Escape(title)}</title>\n<style>\n{Style}\n</style>\n"
        + $"</head>\n<body>\n<h1>{Escape(title)}</h1>\n{m_body}</body>\n</html>\n"));
}
