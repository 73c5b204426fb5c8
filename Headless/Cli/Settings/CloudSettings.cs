namespace FastPoints.Cli.Settings;

public sealed class CloudSettings
{
    readonly ValueOption<string> m_sampler = new("--sampler", "NAME",
        "Which points stand for the others: random, one a cell by chance; poisson, evenly spaced; average, as poisson with "
            + "colour and intensity averaged besides (default: poisson).", "poisson");
    readonly ValueOption<string?> m_attributes = new("--attributes", "A,B,...",
        "Attributes to keep beside the position (default: all).");

    // For tests and tuning: they change what is stored, and no figure is given for other values.
    readonly Option<long?> m_chunkPoints = Counts.Optional("--chunk-points", "The most points of a chunk.");
    readonly Option<long?> m_leafPoints = Counts.Optional("--leaf-points", "About how many points a leaf has.");
    readonly FilterSettings m_filter;
    readonly SourceSettings m_source;
    readonly List<Option> m_options;

    public CloudSettings(Command command)
    {
        int before = command.Options.Count;
        m_chunkPoints.Hidden = m_leafPoints.Hidden = true;
        command.Add(m_sampler, m_attributes, m_chunkPoints, m_leafPoints);
        m_filter = new FilterSettings(command);
        m_source = new SourceSettings(command);
        m_options = command.Options.Skip(before).ToList();
    }

    public ConvertSettings Read(ParseResult parsed)
    {
        string name = parsed.GetValue(m_sampler)!;
        if (!System.Enum.TryParse<Sampler>(name, ignoreCase: true, out var sampler) || !System.Enum.IsDefined(sampler))
            throw new UsageException("--sampler: wanted random, poisson or average, got " + name);
        return new ConvertSettings
        {
            Sampler = sampler,
            Attributes = parsed.GetValue(m_attributes)?.Split(',', System.StringSplitOptions.RemoveEmptyEntries),
            PointsPerChunk = parsed.GetValue(m_chunkPoints) ?? 0,
            TargetPointsPerLeaf = Counts.ToInt(parsed.GetValue(m_leafPoints) ?? 0),
        };
    }

    public ReadOptions ReadOptions(ParseResult parsed) => m_source.Read(parsed);

    /// <returns>The filter for <paramref name="reader"/>; null for all points.</returns>
    internal PointFilter? Filter(ParseResult parsed, PointReader reader) => m_filter.Read(parsed, reader);

    public static void RequireAttributes(ConvertSettings settings, PointReader reader)
    {
        if (settings.Attributes?.FirstOrDefault(a => !reader.Info.Schema.Has(a)) is { } unknown)
            throw new UsageException("--attributes: " + reader.Info.ShownPath + " has no " + unknown + "; it has "
                + string.Join(", ", reader.Info.Schema.Select(a => a.Name)));
    }

    /// <returns>The options as words that <see cref="Parse"/> reads elsewhere.</returns>
    public IReadOnlyList<string> ToWords(ParseResult parsed)
    {
        var words = new List<string>();
        foreach (var option in m_options)
            if (parsed.GetResult(option) is { Implicit: false } given)
                words.AddRange(given.Tokens.Count == 0 ? [option.Name]
                    : given.Tokens.Select(t => option.Name + "=" + FilterSettings.Anywhere(option, t.Value)));
        return words;
    }

    public static (CloudSettings Settings, ParseResult Parsed) Parse(IReadOnlyList<string> words, string path)
    {
        var command = new Command("settings");
        var settings = new CloudSettings(command);
        var parsed = command.Parse(words,
            new ParserConfiguration { EnablePosixBundling = false, ResponseFileTokenReplacer = null });
        return parsed.Errors.Count == 0 ? (settings, parsed)
            : throw new PointCloudException(FailureCode.BadInput, path, -1, "its settings: " + parsed.Errors[0].Message);
    }
}
