namespace FastPoints.Cli.Settings;

public sealed class SourceSettings
{
    readonly Option<string?> m_columns = new("--columns")
    {
        HelpName = "x,y,z,...",
        Description = "What the columns of a text file are: x, y, z, i, r, g, b, nx, ny, nz or any "
            + "other name; - leaves one out (default: by its header, or guessed; info says what was taken).",
    };

    public SourceSettings(Command command) => command.Add(m_columns);

    public ReadOptions Read(ParseResult parsed)
    {
        string? columns = parsed.GetValue(m_columns);
        if (columns == null)
            return new ReadOptions();
        var names = columns.Split(',');
        foreach (string axis in new[] { "x", "y", "z" })
            if (System.Array.FindIndex(names, n => n.Trim().Equals(axis, System.StringComparison.OrdinalIgnoreCase)) < 0)
                throw new UsageException("--columns: wanted x, y and z among them, got " + columns);
        return new ReadOptions { TextColumns = names };
    }
}
