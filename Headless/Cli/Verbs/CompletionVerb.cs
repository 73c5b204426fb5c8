namespace FastPoints.Cli.Verbs;

public sealed class CompletionVerb : Verb
{
    readonly Argument<string> m_shell = new("SHELL") { Description = "bash, zsh, fish or powershell." };

    public CompletionVerb() : base(new Command("completion", "Print a script that completes verbs and options in a shell."))
    {
        Command.Add(m_shell);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints completion bash >> ~/.bashrc", "for bash, from the next start on"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        run.Begin([]);
        run.Out.Write(ScriptOf(parsed.GetRequiredValue(m_shell)));
    }

    static string ScriptOf(string shell) => shell switch
    {
        "bash" or "zsh" or "fish" => EmbeddedText.Of("completion." + shell),
        "powershell" => EmbeddedText.Of("completion.ps1"),
        _ => throw new UsageException("completion: wanted bash, zsh, fish or powershell, got " + shell),
    };
}
