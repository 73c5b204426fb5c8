namespace FastPoints.HostTests.Cli;

[Platform(Exclude = "Win")]
public sealed class CompletionTests
{
    [TestCase("bash", "COMP_WORDS=(fastpoints {0}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); COMP_LINE='fastpoints {0}'; "
        + "COMP_POINT=${{#COMP_LINE}}; _fastpoints; printf '%s\\n' \"${{COMPREPLY[@]}}\"", "complete() {{ :; }}; ")]
    [TestCase("zsh", "words=(fastpoints {0}) BUFFER='fastpoints {0}'; CURSOR=$#BUFFER; _fastpoints",
        "compdef() {{ :; }}; _files() {{ :; }}; compadd() {{ print -l -- ${{(P)2}}; }}; ")]
    [TestCase("fish", "complete -C 'fastpoints {0}'", "")]
    [TestCase("pwsh", "(TabExpansion2 'fastpoints {0}').CompletionMatches.CompletionText", "")]
    public void Script_InItsShell_CompletesVerbsAndOptions(string shell, string ask, string before)
    {
        if (!(Environment.GetEnvironmentVariable("PATH") ?? "").Split(':').Any(f => File.Exists(Path.Combine(f, shell))))
            Assert.Ignore("no " + shell + " here, its completion is not tried; with root: apt-get install " + shell);
        using var scratch = new ScratchFolder();
        File.CreateSymbolicLink(scratch["fastpoints"], Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"));
        string script = CliCall.Of("completion", shell == "pwsh" ? "powershell" : shell).Output;
        foreach (var (typed, word) in new[] { ("previ", "preview"), ("convert --mem", "--memory") })
        {
            var start = new ProcessStartInfo(shell) { RedirectStandardOutput = true, RedirectStandardError = true };
            start.Environment["PATH"] = scratch.Root + ":" + start.Environment["PATH"];
            start.ArgumentList.Add("-c");
            start.ArgumentList.Add(string.Format(CultureInfo.InvariantCulture, before, typed) + script + "\n"
                + string.Format(CultureInfo.InvariantCulture, ask, typed));
            using var process = Process.Start(start);
            var error = process.StandardError.ReadToEndAsync();
            string said = process.StandardOutput.ReadToEnd();
            Assert.That(said.Split('\n').Select(l => l.Split('\t')[0].Trim()), Does.Contain(word), error.Result);
        }
    }
}
