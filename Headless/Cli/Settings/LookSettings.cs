namespace FastPoints.Cli.Settings;

public sealed class LookSettings
{
    readonly Option<string?> m_style = new("--style")
    {
        HelpName = "k=v,...",
        Description = PictureOptions.StyleHelp + ".",
    };
    readonly Option<string?> m_up = new("--up")
    {
        HelpName = "x|y|z|-x|-y|-z",
        Description = "The axis that points up (default: z; of PLY by the plane that most points lie in).",
    };
    readonly Option<bool> m_plain = new("--plain") { Description = "No legend and no scale bar on the picture." };

    public LookSettings(Command command)
    {
        command.Add(m_style);
        command.Add(m_up);
        command.Add(m_plain);
    }

    public bool IsPlain(ParseResult parsed) => parsed.GetValue(m_plain);

    public PictureOptions Read(ParseResult parsed)
    {
        var options = new PictureOptions { GuessesUpAxis = true };
        foreach (string pair in parsed.GetValue(m_style)?.Split(',') ?? [])
        {
            int equals = pair.IndexOf('=');
            if (equals < 1)
                throw new UsageException("--style: wanted k=v, got " + pair);
            if (!options.TrySetStyle(pair[..equals].Trim(), pair[(equals + 1)..].Trim(), out string error))
                throw new UsageException("--style: " + error);
        }
        if (parsed.GetValue(m_up) is { } up && !options.TrySetStyle("up", up, out string wrong))
            throw new UsageException("--up: " + wrong);
        return options;
    }
}
