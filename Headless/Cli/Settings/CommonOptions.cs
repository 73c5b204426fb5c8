namespace FastPoints.Cli.Settings;

/// <param name="Json">Where the summary goes: a file, - or null.</param>
public sealed record RunSettings(string? Json = null, bool IsQuiet = false, bool IsForced = false, bool IsStrict = false,
    bool AllowsHttp = false);

public sealed class CommonOptions
{
    readonly ValueOption<string?> m_json = new("--json", "FILE",
        "Write a summary of the run as JSON; - for standard output, which then holds nothing else.");
    readonly Option<long?> m_threads = Counts.Optional("--threads",
        "Threads that work (default: one a core, and no more). Results do not depend on it.");
    readonly Flag m_quiet = new("--quiet",
        "No progress and no warnings on standard error; errors only. The summary has the warnings all the same.");
    readonly Flag m_force = new("--force",
        "Write over what this tool did not make, made of other sources, or exported before it was edited. Never over an "
            + "input.");
    readonly Flag m_strict = new("--strict",
        "End with 4 where a source has fewer points than it claims, anything is odd about it, or no point comes out.");
    readonly Flag m_allowHttp = new("--allow-http",
        "Read from http:// too, which anybody on the way can see and change. This machine's own servers need no permission.");

    public CommonOptions(Command root)
    {
        foreach (var option in All)
        {
            option.Recursive = true;
            root.Add(option);
        }
    }

    public IReadOnlyList<Option> All => [m_json, m_threads, m_quiet, m_force, m_strict, m_allowHttp];

    public RunSettings Read(ParseResult parsed) => new(parsed.GetValue(m_json), parsed.GetValue(m_quiet),
        parsed.GetValue(m_force), parsed.GetValue(m_strict), parsed.GetValue(m_allowHttp));

    public string? UseThreads(ParseResult parsed) => Threads.Use(parsed.GetValue(m_threads));
}
