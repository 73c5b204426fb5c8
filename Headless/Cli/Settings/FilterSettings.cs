namespace FastPoints.Cli.Settings;

public sealed class FilterSettings
{
    const string PolygonOption = "--polygon";

    readonly ValueOption<string?> m_classes = new("--classes", "N,...", "Only points of these classes.");
    readonly ValueOption<string?> m_returns = new("--returns", "first|last|N",
        "Only first returns, last ones (whose number is that of their pulse's returns), or those of a number.");
    readonly Option<long?> m_everyNth = Counts.Optional("--every-nth", "Only every N-th point in the source's order, from the "
        + "first.");
    readonly ValueOption<string?> m_polygon = new(PolygonOption, "FILE",
        "Only points in a polygon or any of several: GeoJSON or WKT, POLYGON or MULTIPOLYGON, holes too, in the file's "
            + "horizontal coordinates. The rings of each count even-odd; points on an edge belong.");
    readonly ValueOption<string?> m_where = new("--where", "CONDITION",
        "Only points for which it holds: comparisons (== != < <= > >=) of attributes and numbers, joined by &&, || and !, "
            + "with parentheses. Attributes are named as info names them (in \"\" where a name is no word), X, Y and Z too, "
            + "and have their own units.");

    public FilterSettings(Command command)
    {
        command.Add(m_classes, m_returns, m_everyNth, m_polygon, m_where);
    }

    /// <returns>An option's value as it is elsewhere: of a polygon the whole path.</returns>
    public static string Anywhere(Option option, string value) => option.Name == PolygonOption ? SourcePath.Full(value) : value;

    /// <returns>The filter for <paramref name="reader"/>; null for all points.</returns>
    internal PointFilter? Read(ParseResult parsed, PointReader reader)
    {
        var filter = new PointFilter { EveryNth = parsed.GetValue(m_everyNth) ?? 0 };
        try
        {
            if (parsed.GetValue(m_classes) is { } classes)
                Add(filter, reader, "--classes", string.Join(" || ", classes.Split(',').Select(ParseClass).Distinct()
                    .Select(c => AttributeNames.Classification + " == " + c)));
            if (parsed.GetValue(m_returns) is { } returns)
                Add(filter, reader, "--returns", ReturnsCondition(returns));
            if (parsed.GetValue(m_where) is { } where)
                Add(filter, reader, "--where", where);
            if (parsed.GetValue(m_polygon) is { } polygon)
                filter.Polygons = PolygonFile.Read(polygon);
            return filter.IsEmpty ? null : filter;
        }
        catch
        {
            filter.Dispose();
            throw;
        }
    }

    static void Add(PointFilter filter, PointReader reader, string option, string expression)
    {
        try
        {
            filter.Add(expression);
        }
        catch (FormatException e)
        {
            throw new UsageException(option + ": " + e.Message);
        }
        if (filter.Attributes.FirstOrDefault(a => !reader.Info.Schema.Has(a)) is { } unknown)
            throw new UsageException(option + ": " + reader.Info.ShownPath + " has no " + unknown + "; it has "
                + string.Join(", ", reader.Info.Schema.Select(a => a.Name)));
    }

    static string ReturnsCondition(string text) => text switch
    {
        "first" => AttributeNames.ReturnNumber + " == 1",
        "last" => AttributeNames.ReturnNumber + " == " + AttributeNames.NumberOfReturns,
        _ when int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number <= 15 =>
            AttributeNames.ReturnNumber + " == " + number,
        _ => throw new UsageException("--returns: wanted first, last or a number up to 15, got " + text),
    };

    static int ParseClass(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number <= byte.MaxValue ? number
            : throw new UsageException("--classes: wanted numbers from 0 to 255, got " + text);
}
