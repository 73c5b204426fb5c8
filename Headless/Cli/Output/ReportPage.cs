namespace FastPoints.Cli.Output;

public sealed class ReportPage(string title, string? lead = null)
{
    const string Policy = "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

    readonly StringBuilder m_body = new();
    readonly List<string> m_scripts = [];

    public static string Escape(string text) => WebUtility.HtmlEncode(text);

    /// <summary>Long names of one word break behind their underscores and slashes, not within parts.</summary>
    static string Breakable(string text) => Escape(text).Replace("_", "_<wbr>").Replace("/", "/<wbr>");

    public void Html(string html) => m_body.Append(html).Append('\n');

    public void View(string json, byte[] png, string alt, string time, string noteHtml, string unit)
    {
        string[] parts = EmbeddedText.Of("view.html").Replace("{alt}", Escape(alt)).Replace("{time}", Escape(time))
            .Replace("{note}", noteHtml).Replace("{unit}", Escape(unit))
            .Replace("{png}", System.Convert.ToBase64String(png)).Split("{data}");
        m_body.Append(parts[0]).Append(json).Append(parts[1]);
        m_scripts.AddRange(["points.js", "camera.js", "renderer.js", "colors.js", "tools.js", "view.js"]);
    }

    public void Tiles(IEnumerable<(string Name, string Value)> tiles) =>
        Html("<dl class=\"tiles\">" + string.Concat(tiles.Select(t =>
            $"<div><dt>{Escape(t.Name)}</dt><dd>{Breakable(t.Value)}</dd></div>\n")) + "</dl>");

    public void Row(IEnumerable<string> html) => Html("<div class=\"row\">" + string.Concat(html.Select(h =>
        "<figure>" + h + "</figure>\n")) + "</div>");

    public void Commands(IEnumerable<(string Purpose, string Line)> lines)
    {
        Html("<ul class=\"lines\">" + string.Concat(lines.Select(l => $"<li>{Escape(l.Purpose)}<div class=\"copy\"><code>"
            + $"{Escape(l.Line)}</code><button type=\"button\">Copy</button></div></li>\n")) + "</ul>");
        m_scripts.Add("page.js");
    }

    public void Heading(string text) => m_body.Append("<h2>").Append(Escape(text)).Append("</h2>\n");
    public void Paragraph(string text) => m_body.Append("<p>").Append(Escape(text)).Append("</p>\n");
    public void Warning(string text) => m_body.Append("<p class=\"warning\">").Append(Escape(text)).Append("</p>\n");

    public void Facts(IEnumerable<(string Name, string Value)> facts)
    {
        m_body.Append("<table class=\"facts\">\n");
        foreach (var (name, value) in facts)
            m_body.Append("<tr><td>").Append(Escape(name)).Append("</td><td>").Append(Breakable(value)).Append("</td></tr>\n");
        m_body.Append("</table>\n");
    }

    public void Chart(LineChart chart) => Html("<figure class=\"rows\">\n" + chart.ToSvg() + "</figure>");
    public void Chart(RowChart chart) => Html("<figure class=\"rows\">\n" + chart.ToSvg() + "</figure>");

    public void Charts(IEnumerable<LineChart> charts) => Row(charts.Select(c => c.ToSvg()));

    public void Pictures(IEnumerable<(byte[] Png, string Caption)> pictures)
    {
        m_body.Append("<div class=\"row\">\n");
        foreach (var (png, caption) in pictures)
            Picture(png, caption);
        m_body.Append("</div>\n");
    }

    public void Table(TextTable table)
    {
        m_body.Append("<div class=\"wide\"><table>\n");
        string cell = "th";
        foreach (var row in table.Rows)
        {
            m_body.Append("<tr>");
            foreach (string text in row)
                m_body.Append('<').Append(cell).Append('>').Append(Escape(text)).Append("</").Append(cell).Append('>');
            m_body.Append("</tr>\n");
            cell = "td";
        }
        m_body.Append("</table></div>\n");
    }

    public void Picture(byte[] png, string caption)
    {
        m_body.Append("<figure><img alt=\"").Append(Escape(caption)).Append("\" src=\"data:image/png;base64,")
            .Append(System.Convert.ToBase64String(png)).Append("\">\n<figcaption>").Append(Escape(caption))
            .Append("</figcaption></figure>\n");
    }

    public byte[] ToBytes()
    {
        var page = new MemoryStream();
        using (var writer = new StreamWriter(page))
        {
            writer.Write(Head());
            foreach (var chunk in m_body.GetChunks())
                writer.Write(chunk.Span);
            writer.Write("</main>\n" + string.Concat(m_scripts.Select(name => $"<script>\n{EmbeddedText.Of(name)}</script>\n"))
                + "</body>\n</html>\n");
        }
        return page.ToArray();
    }

    string Head() => "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        + $"<meta http-equiv=\"Content-Security-Policy\" content=\"{Policy}\">\n"
        + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n"
        + $"<title>{Escape(title)}</title>\n<style>\n{EmbeddedText.Of("page.css")}</style>\n</head>\n<body>\n<main>\n"
        + $"<h1>{Escape(title)}</h1>\n" + (lead == null ? "" : $"<p class=\"lead\">{Escape(lead)}</p>\n");
}
