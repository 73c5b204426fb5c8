namespace FastPoints.Cli.Verbs;

/// <summary>One verb: its options, its examples, and what it does. A new one is a class and a line in
/// <see cref="CommandLine"/>.</summary>
public abstract class Verb
{
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
}
