using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.CommandLine.Parsing;
using FastPoints.Cli.Verbs;
using StandIns.Engine;

namespace FastPoints.Cli;

public static class CommandLine
{
    public static int Run(IReadOnlyList<string> args, TextWriter output, TextWriter error, bool errorIsTerminal,
        CancellationToken cancellation, CancellationToken discard = default)
    {
        ZstandardDecompressor.Register();
        var verbs = AllVerbs();
        var root = verbs[0].Command;
        foreach (var verb in verbs.Skip(1))
            root.Add(verb.Command);
        var common = new CommonOptions(root);
        // --help belongs to every command, and is one option: its action is replaced, and its text is ours.
        root.Options.OfType<HelpOption>().Single().Action = new HelpTextAction(verbs, common);

        if (args is ["help", "--man"])
        {
            HelpText.WriteManual(output, verbs, common);
            return ExitStatus.Done;
        }
        args = args.ToArray() switch
        {
            ["help", .. var rest] => [.. rest, "--help"],
            ["version"] => ["--version"],
            var same => same,
        };
        var parsed = root.Parse(args, new ParserConfiguration { EnablePosixBundling = false, ResponseFileTokenReplacer = null });
        var asked = parsed.CommandResult.Command;
        if (FindUsageError(parsed, verbs) is { } misread)
            return ReportUsageError(error, asked, misread);
        var chosen = verbs.FirstOrDefault(v => v.Command == asked);
        if (chosen == null || !chosen.IsAsked(parsed))
            return parsed.Invoke(new InvocationConfiguration
            {
                Output = output,
                Error = error,
                EnableDefaultExceptionHandler = false,
                ProcessTerminationTimeout = null,
            });
        var run = new CliRun(output, error, common.Read(parsed), cancellation)
        {
            Discard = discard,
            Line = "./fastpoints " + string.Join(" ", args.Select(Quoted)),
        };
        return Run(chosen, parsed, common, run, error, errorIsTerminal);
    }

    static List<Verb> AllVerbs() =>
    [
        new DefaultVerb(), new InfoVerb(), new PreviewVerb(), new ConvertVerb(), new VerifyVerb(),
        new ExportVerb(), new PictureVerb(), new FlyVerb(), new DemoCloudVerb(), new BenchVerb(), new CompletionVerb(),
    ];

    static int ReportUsageError(TextWriter error, Command command, string what)
    {
        error.WriteLine("fastpoints: " + what);
        error.WriteLine("usage: " + HelpText.Usage(command) + "   (more: " + HelpText.Path(command) + " --help)");
        return ExitStatus.Usage;
    }

    static string Quoted(string word) =>
        word.Length > 0 && word.All(c => char.IsLetterOrDigit(c) || "-_./,:=+@%".Contains(c)) ? word
            : "'" + word.Replace("'", "'\\''", StringComparison.Ordinal) + "'";

    static string? FindUsageError(ParseResult parsed, List<Verb> verbs)
    {
        var command = parsed.CommandResult.Command;
        // A completion request: the arguments may be incomplete.
        if (parsed.Tokens.Any(t => t.Type == TokenType.Directive))
            return null;
        if (parsed.Errors.Count > 0 && parsed.Action is ParseErrorAction or null)
            return parsed.Errors[0].Message;
        // Behind -- are files only, whatever they are called.
        int plain = parsed.Tokens.SkipWhile(t => t.Type != TokenType.DoubleDash).Skip(1).Count();
        var words = command.Arguments.SelectMany(a => parsed.GetResult(a)?.Tokens ?? []).ToList();
        foreach (var word in words.Take(words.Count - plain))
            if (word.Value.StartsWith('-'))
                return "unknown option " + word.Value + Suggestion(word.Value, parsed.RootCommandResult.Command.Options
                    .Where(o => o.Recursive).Concat(command.Options).SelectMany(o => o.Aliases.Append(o.Name)));
        var root = parsed.RootCommandResult;
        if (command is not RootCommand)
        {
            // Arguments before the verb are parsed, but no command uses them.
            if (root.Children.OfType<ArgumentResult>().SelectMany(a => a.Tokens).FirstOrDefault() is { } file)
                return file.Value + " stands before the verb " + command.Name + ", which takes what is behind it";
            return root.Children.OfType<OptionResult>().FirstOrDefault(o => !o.Implicit && !o.Option.Recursive) is { } option
                ? option.Option.Name + " stands before the verb " + command.Name + ", which takes what is behind it" : null;
        }
        string? first = plain < words.Count ? words[0].Value : null;
        bool isName = first != null && first.All(c => char.IsAsciiLetterLower(c) || c == '-') && !Path.Exists(first);
        var names = verbs.Skip(1).Select(v => v.Command.Name).Concat(["help", "version"]);
        string suggestion = isName ? Suggestion(first!, names) : "";
        return suggestion.Length > 0 ? "no file and no verb is called " + first + suggestion : null;
    }

    static string Suggestion(string word, IEnumerable<string> known)
    {
        string? nearest = known.Where(k => Distance(word, k) <= Math.Max(1, word.Length / 2)).MinBy(k => Distance(word, k));
        return nearest == null ? "" : ": did you mean " + nearest + "?";
    }

    static int Distance(string a, string b)
    {
        var row = Enumerable.Range(0, b.Length + 1).ToArray();
        for (int i = 1; i <= a.Length; i++)
        {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.Length; j++)
            {
                int changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.Min(changed, 1 + Math.Min(row[j], row[j - 1]));
            }
        }
        return row[^1];
    }

    static int Run(Verb verb, ParseResult parsed, CommonOptions common, CliRun run, TextWriter error, bool errorIsTerminal)
    {
        string? json = run.Settings.Json;
        using var display = run.Settings.IsQuiet ? null : new ProgressDisplay(run.Progress, error, errorIsTerminal);
        Failure? failure;
        try
        {
            if (common.UseThreads(parsed) is { } note)
                run.Warn(note);
            if (json != null)
                OutputNames.RefuseOther("--json", "a summary", json);
            verb.Run(parsed, run);
            // An exception in a job is only logged: fail here, since the result may be wrong.
            LoggedExceptions.ThrowFirst();
            failure = run.FirstFailure ?? (run.Settings.IsStrict ? Failure.OfStrict(run) : null);
            if (failure != null && failure != run.FirstFailure)
                error.WriteLine("fastpoints: " + failure.Message);
        }
        catch (Exception e)
        {
            display?.Clear();
            if (e is UsageException)
                return ReportUsageError(error, verb.Command, e.Message);
            failure = Failure.Of(e, run.Inputs);
            error.WriteLine("fastpoints: " + failure.Message);
        }
        display?.Clear();
        // Wait for deletions of leftovers of other builds.
        FileChanges.AwaitDeletes();
        int status = failure?.Status ?? ExitStatus.Done;
        if (json == null)
            return status;
        try
        {
            Summary.Write(json, run.StandardOutput, verb.Command is RootCommand ? "" : verb.Command.Name, run, failure);
        }
        catch (PointCloudException e)
        {
            error.WriteLine("fastpoints: " + e.Message);
            return ExitStatus.Failed;
        }
        return status;
    }

    sealed class HelpTextAction(List<Verb> verbs, CommonOptions common) : SynchronousCommandLineAction
    {
        public override bool ClearsParseErrors => true;

        public override int Invoke(ParseResult parsed)
        {
            HelpText.Write(parsed.InvocationConfiguration.Output, verbs, parsed.CommandResult.Command, common);
            return ExitStatus.Done;
        }
    }
}
