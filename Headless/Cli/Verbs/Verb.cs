namespace FastPoints.Cli.Verbs;

/// <summary>One verb: its options, its examples, and what it does. A new one is a class and a line in
/// <see cref="CommandLine"/>.</summary>
public abstract class Verb
{
    public Option<string?> JsonOption { get; } = new("--json")
    {
        HelpName = "FILE",
        Description = "Write a summary of the run as JSON; - for standard output, which then holds nothing else.",
    };

    public Option<int?> ThreadsOption { get; } = new("--threads")
    {
        HelpName = "N",
        Description = "Threads that work (default: one a core). Results do not depend on it.",
    };

    public Option<bool> QuietOption { get; } = new("--quiet")
    {
        Description = "No progress and no warnings on standard error; errors only.",
    };

    protected Verb(Command command)
    {
        Command = command;
        command.SetAction(_ => 0);
    }

    public Command Command { get; }

    /// <summary>Whole lines to type, and what each is good for.</summary>
    public abstract IReadOnlyList<(string Line, string What)> Examples { get; }

    /// <summary>Does the work. Failures are exceptions; what was found until then goes into the summary.</summary>
    public abstract void Run(ParseResult parsed, CliRun run);

    /// <summary>Whether the arguments ask for this verb itself, and not for --help or --version.</summary>
    public bool IsAsked(ParseResult parsed) => parsed.Action == Command.Action;

    /// <summary>The options that every verb has, behind its own.</summary>
    protected void AddCommonOptions()
    {
        Command.Add(JsonOption);
        Command.Add(ThreadsOption);
        Command.Add(QuietOption);
    }
}
