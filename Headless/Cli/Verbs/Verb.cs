namespace FastPoints.Cli.Verbs;

public abstract class Verb
{
    protected Verb(Command command)
    {
        Command = command;
        command.SetAction(_ => 0);
    }

    public Command Command { get; }
    public abstract IReadOnlyList<(string Line, string What)> Examples { get; }
    public abstract void Run(ParseResult parsed, CliRun run);

    public bool IsInvoked(ParseResult parsed) => parsed.Action == Command.Action;
}
