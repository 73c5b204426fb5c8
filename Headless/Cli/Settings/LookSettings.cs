namespace FastPoints.Cli.Settings;

public sealed class LookSettings
{
    readonly ValueOption<string?> m_style = new("--style", "k=v,...", PictureStyle.Help + ".");
    readonly ValueOption<string?> m_up = new("--up", "x|y|z|-x|-y|-z",
        "The axis that points up (default: z; of PLY by the plane that most points lie in).");
    readonly Flag m_plain = new("--plain", "No legend and no scale bar on the picture.");

    public LookSettings(Command command) => command.Add(m_style, m_up, m_plain);

    public static void ResolveColor(PictureOptions options, PointSchema schema, string path)
    {
        if (options.ColorAttribute is { } asked)
            options.ColorAttribute = schema.Select(a => a.Name)
                .FirstOrDefault(n => n.Equals(asked, System.StringComparison.OrdinalIgnoreCase)) ?? throw Missing(asked);
        string? wanted = options.ColorAttribute ?? (options.Color == ColorMode.Rgb ? AttributeNames.Red
            : ColorModes.AttributeOf(options.Color));
        if (wanted != null && !schema.Has(wanted))
            throw Missing(wanted);

        UsageException Missing(string name) => new("--style: " + SourcePath.WithoutQuery(path)
            + " has no " + name + " to colour by; it has "
            + string.Join(", ", schema.Select(a => a.Name)));
    }

    /// <summary>The same for streamed clouds, whose shaders support only some attributes.</summary>
    public static void RequireStreamable(PictureOptions options, PointSchema schema, string path)
    {
        ResolveColor(options, schema, path);
        if (options.ColorAttribute is { } name)
            throw new UsageException("--style: colours by " + name + " are for pictures of one cloud, whole and without --gpu");
    }

    public bool IsPlain(ParseResult parsed) => parsed.GetValue(m_plain);

    public PictureOptions Read(ParseResult parsed)
    {
        var options = new PictureOptions { GuessesUpAxis = true };
        // A value may have commas: only what follows one and has a key begins another pair.
        foreach (string pair in parsed.GetValue(m_style) is { } style ? Regex.Split(style, ",(?=[^,]*=)") : [])
        {
            int equals = pair.IndexOf('=');
            if (equals < 1)
                throw new UsageException("--style: wanted k=v, got " + pair);
            if (options.SetStyle(pair[..equals].Trim(), pair[(equals + 1)..].Trim()) is { } error)
                throw new UsageException("--style: " + error);
        }
        if (parsed.GetValue(m_up) is { } up && options.SetStyle("up", up) is { } wrong)
            throw new UsageException("--up: " + wrong);
        return options;
    }
}
