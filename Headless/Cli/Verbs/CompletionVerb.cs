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
        run.Out.Write(ScriptOf(parsed.GetRequiredValue(m_shell)).ReplaceLineEndings("\n"));
    }

    static string ScriptOf(string shell) => shell switch
    {
        // Words are completed from the verbs and options; if there are none, from files.
        "bash" => """
            _fastpoints() {
              local IFS=$'\n' program=${COMP_WORDS[0]}
              local at=$((COMP_POINT - ${#program} - 1))
              local known="$("$program" "[suggest:$at]" "${COMP_LINE#"$program "}" 2>/dev/null)"
              COMPREPLY=($(compgen -W "$known" -- "${COMP_WORDS[COMP_CWORD]}"))
            }
            complete -o default -F _fastpoints fastpoints ./fastpoints

            """,
        "zsh" => """
            _fastpoints() {
              local -a known
              local at=$((CURSOR - ${#words[1]} - 1))
              known=("${(@f)$("${words[1]}" "[suggest:$at]" "${BUFFER#"${words[1]} "}" 2>/dev/null)}")
              compadd -a known
              _files
            }
            compdef _fastpoints fastpoints ./fastpoints

            """,
        "fish" => """
            function __fastpoints
              set -l words (commandline -opc)
              set -l line (string replace -- "$words[1] " "" (commandline -cp))
              $words[1] "[suggest:"(string length -- "$line")"]" "$line" 2>/dev/null
            end
            complete -c fastpoints -a "(__fastpoints)"

            """,
        "powershell" => """
            Register-ArgumentCompleter -Native -CommandName fastpoints -ScriptBlock {
              param($word, $line, $at)
              $program = $line.CommandElements[0].Value
              $typed = $line.ToString().Substring($program.Length).TrimStart()
              & $program "[suggest:$($at - $line.Extent.StartOffset - $program.Length - 1)]" $typed |
                Where-Object { $_ -like "$word*" } |
                ForEach-Object { [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_) }
            }

            """,
        _ => throw new UsageException("completion: wanted bash, zsh, fish or powershell, got " + shell),
    };
}
