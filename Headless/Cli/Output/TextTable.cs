namespace FastPoints.Cli.Output;

public sealed class TextTable
{
    readonly List<string[]> m_rows = [];

    public TextTable(params string[] headers) => m_rows.Add(headers);

    public IReadOnlyList<string[]> Rows => m_rows;

    public void Add(params string[] cells) => m_rows.Add(cells);

    public void Write(TextWriter writer, string indent)
    {
        int columns = m_rows.Max(r => r.Length);
        var widths = new int[columns];
        foreach (var row in m_rows)
            for (int i = 0; i < row.Length; i++)
                widths[i] = Math.Max(widths[i], row[i].Length);
        foreach (var row in m_rows)
        {
            var cells = row.Select((cell, i) => i == 0 ? cell.PadRight(widths[i]) : cell.PadLeft(widths[i]));
            writer.WriteLine((indent + string.Join("  ", cells)).TrimEnd());
        }
    }
}
