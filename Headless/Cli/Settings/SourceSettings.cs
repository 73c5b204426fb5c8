namespace FastPoints.Cli.Settings;

public sealed class SourceSettings
{
    readonly ValueOption<string?> m_columns = new("--columns", "x,y,z,...",
        "What the columns of a text file are: x, y, z, i, r, g, b, nx, ny, nz or any other name; - leaves one out (default: "
            + "by its header, or guessed; info says what was taken).");

    readonly ValueOption<string?> m_unit = new("--unit", "m|ft|us-ft|METRES",
        "What a unit of the coordinates is, whatever the files say: a name of PROJ's, or its length in metres. A converted "
            + "cloud keeps it.");
    readonly ValueOption<string?> m_crs = new("--crs", "EPSG:N",
        "The coordinate system, whatever the files say: EPSG:2229, EPSG:2229+5703 with heights, WKT, or a PROJ string. "
            + "Points are not moved.");

    readonly Flag m_recursive = new("--recursive", "Look into the folders of a folder, too.");

    public SourceSettings(Command command)
    {
        command.Add(m_recursive, m_columns, m_unit, m_crs);
    }

    public ReadOptions Read(ParseResult parsed)
    {
        var options = new ReadOptions
        {
            CoordinateSystem = parsed.GetValue(m_crs),
            IsRecursive = parsed.GetValue(m_recursive),
        };
        if (options.CoordinateSystem is { } crs && !CrsText.Read(crs, new CoordinateSystem()))
            throw new UsageException("--crs: wanted EPSG:2229, WKT or a PROJ string, got " + crs);
        if (parsed.GetValue(m_unit) is { } unit)
        {
            options.MetresPerUnit = CrsText.MetresOfUnit(unit);
            if (options.MetresPerUnit == 0)
                throw new UsageException("--unit: wanted m, ft, us-ft, another name of PROJ's or its metres, got " + unit);
        }
        string? columns = parsed.GetValue(m_columns);
        if (columns == null)
            return options;
        var names = columns.Split(',');
        if (!XyzNames.HavePosition(XyzNames.Of(names, names.Length)))
            throw new UsageException("--columns: wanted x, y and z among them, got " + columns);
        options.TextColumns = names;
        return options;
    }
}
