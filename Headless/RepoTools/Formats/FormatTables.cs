namespace FastPoints.RepoTools.Formats;

public static class FormatTables
{
    public const string Attribute = "DiskFormatAttribute";

    public static IReadOnlyList<string> Compare(string markdown, IEnumerable<TypeDefinition> structs)
    {
        Dictionary<string, List<(int Offset, int Bytes, string Field)>> tables = Parse(markdown);
        var problems = new List<string>();
        foreach (TypeDefinition type in structs)
        {
            if (!tables.TryGetValue(type.Name, out List<(int Offset, int Bytes, string Field)>? rows))
            {
                problems.Add($"{type.Name}: no table under a heading with `{type.Name}`");
                continue;
            }
            FieldLayout layout = FieldLayout.Of(type);
            List<(int, int, string)> wanted = layout.Fields.Select(f => (f.Offset, f.Size, f.Name)).ToList();
            List<(int, int, string)> have = rows.Where(r => r.Field.Length > 0).ToList();
            problems.AddRange(wanted.Except(have).Select(w => $"{type.Name}: the struct has {Show(w)}, the table does not"));
            problems.AddRange(have.Except(wanted).Select(h => $"{type.Name}: the table has {Show(h)}, the struct does not"));
            int end = rows.Count == 0 ? 0 : rows.Max(r => r.Offset + r.Bytes);
            if (end != layout.Size)
                problems.Add($"{type.Name}: the table ends at {end}, the struct has {layout.Size} bytes");
        }
        return problems;
    }

    private static string Show((int Offset, int Bytes, string Field) row) => $"{row.Field} at {row.Offset}, {row.Bytes} bytes";

    private static Dictionary<string, List<(int Offset, int Bytes, string Field)>> Parse(string markdown)
    {
        var tables = new Dictionary<string, List<(int, int, string)>>(StringComparer.Ordinal);
        List<(int, int, string)>? current = null;
        foreach (string line in markdown.Split('\n'))
        {
            Match heading = Regex.Match(line, @"^#+ .*`(\w+)`");
            if (heading.Success)
                tables[heading.Groups[1].Value] = current = new List<(int, int, string)>();
            else if (line.StartsWith('#'))
                current = null;
            Match row = Regex.Match(line, @"^\| *(\d+) *\| *(\d+) *\| *(?:`(\w+)`)?[^|]*\|");
            if (row.Success)
                current?.Add((int.Parse(row.Groups[1].Value, null), int.Parse(row.Groups[2].Value, null), row.Groups[3].Value));
        }
        return tables;
    }
}
