using System.CommandLine.Help;
using System.CommandLine.Invocation;
using StandIns.Engine;

namespace FastPoints.Cli;

public static class CommandLine
{
    /// <param name="discardBuild">If cancelled, an interrupted build is not kept for a resume.</param>
    public static int Run(IReadOnlyList<string> args, TextWriter output, TextWriter error, bool errorIsTerminal,
        CancellationToken cancellation, CancellationToken discardBuild = default)
    {
        ZstandardDecompressor.Register();
        HttpFile.Register();
        RangeExchange.HttpVersion = System.Net.HttpVersion.Version20;
        var verbs = AllVerbs();
        var root = verbs[0].Command;
        foreach (var verb in verbs.Skip(1))
            root.Add(verb.Command);
        var common = new CommonOptions(root);
        // --help is one option of every command: its action is replaced by our text.
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
        IReadOnlyList<string> words;
        try
        {
            words = S3Addresses.Resolve(args);
        }
        catch (UsageException e)
        {
            return ReportUsageError(error, root, e.Message);
        }
        var parsed = root.Parse(words, new ParserConfiguration { EnablePosixBundling = false, ResponseFileTokenReplacer = null });
        var command = parsed.CommandResult.Command;
        if (FindUsageError(parsed, verbs) is { } usageError)
            return ReportUsageError(error, command, usageError);
        var chosen = verbs.FirstOrDefault(v => v.Command == command);
        if (chosen == null || !chosen.IsInvoked(parsed))
            return parsed.Invoke(new InvocationConfiguration
            {
                Output = output,
                Error = error,
                EnableDefaultExceptionHandler = false,
                ProcessTerminationTimeout = null,
            });
        var run = new CliRun(output, error, common.Read(parsed), cancellation)
        {
            Discard = discardBuild,
            CommandLine = "./fastpoints " + string.Join(" ", args.Select(SourcePath.WithoutQuery).Select(Quoted)),
        };
        return Run(chosen, parsed, common, run, error, errorIsTerminal);
    }

    static List<Verb> AllVerbs() =>
    [
        new DefaultVerb(), new InfoVerb(), new PreviewVerb(), new ConvertVerb(), new VerifyVerb(),
        new ExportVerb(), new PictureVerb(), new FlyVerb(), new DemoCloudVerb(), new BenchVerb(), new PublishVerb(),
        new EditVerb(), new SurfaceVerb(), new UpgradeVerb(), new PlanVerb(), new BuildVerb(), new MergeVerb(), new CommitVerb(),
        new ClusterVerb(), new CacheVerb(), new CompletionVerb(),
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
        // After -- there are only files, whatever their names.
        int countAfterDashes = parsed.Tokens.SkipWhile(t => t.Type != TokenType.DoubleDash).Skip(1).Count();
        var words = command.Arguments.SelectMany(a => parsed.GetResult(a)?.Tokens ?? []).ToList();
        bool isWrong = parsed.Errors.Count > 0 && parsed.Action is ParseErrorAction or null;
        // Reported before missing arguments.
        foreach (string word in words.SkipLast(countAfterDashes).Select(t => t.Value)
            .Concat(isWrong ? parsed.UnmatchedTokens : []))
            if (word.StartsWith('-') && !StandardStreams.IsInput(word))
                return "unknown option " + word + Suggestion(word, command, parsed.RootCommandResult.Command);
        if (isWrong)
            return parsed.Errors[0].Message;
        var root = parsed.RootCommandResult;
        if (command is not RootCommand)
        {
            // Arguments before the verb are parsed, but no command uses them.
            if (root.Children.OfType<ArgumentResult>().SelectMany(a => a.Tokens).FirstOrDefault() is { } file)
                return file.Value + " stands before the verb " + command.Name + ", which takes what is behind it";
            return root.Children.OfType<OptionResult>().FirstOrDefault(o => !o.Implicit && !o.Option.Recursive) is { } option
                ? option.Option.Name + " stands before the verb " + command.Name + ", which takes what is behind it" : null;
        }
        string? first = countAfterDashes < words.Count ? words[0].Value : null;
        bool isName = first != null && first.All(c => char.IsAsciiLetterLower(c) || c == '-') && !Path.Exists(first);
        var names = verbs.Skip(1).Select(v => v.Command.Name).Concat(["help", "version"]);
        string suggestion = isName ? Suggestion(first!, names) : "";
        return suggestion.Length > 0 ? "no file and no verb is called " + first + suggestion : null;
    }

    /// <summary>What other programs call it, or the parts of --style.</summary>
    static readonly (string Words, string Meant)[] s_synonyms =
    [
        ("out dest destination", "--output"), ("overwrite replace yes", "--force"), ("jobs cores workers", "--threads"),
        ("silent", "--quiet"), ("bbox bounds box crop extent", "--clip"), ("filter query expression", "--where"),
        ("class classes", "--classes"), ("class classes", "--style classes=N"), ("color colour", "--style color=NAME"),
        ("color", "--colour"),
        ("gradient", "--style gradient=NAME"), ("background", "--style background=RRGGBB"), ("edl", "--style edl=on"),
        ("point-size", "--style size=PIXELS"), ("resolution width height", "--size"), ("camera", "--eye"),
        ("look-at lookat", "--target"), ("top bottom front back left right side iso", "--view"), ("epsg srs", "--crs"),
        ("fields dimensions", "--attributes"), ("nth stride thin", "--every-nth"), ("first last", "--returns"),
        ("limit max-points points", "--budget"), ("limit max-points budget", "--points"),
    ];

    static string Suggestion(string word, Command command, Command root)
    {
        string optionName = word.TrimStart('-').Split('=')[0];
        var options = root.Options.Where(o => o.Recursive).Concat(command.Options).Select(o => o.Name)
            // The default verb's --points is the number of generated points.
            .Where(name => command != root || name != "--points").ToList();
        string? meant = s_synonyms.FirstOrDefault(s => s.Words.Split(' ').Contains(optionName)
            && options.Contains(s.Meant.Split(' ')[0])).Meant;
        return meant != null ? ": did you mean " + meant + "?"
            : Suggestion(optionName, options.Select(o => o.TrimStart('-')), "--");
    }

    /// <summary>An edit distance of at most a third of its letters, or of 1; or a prefix.</summary>
    static string Suggestion(string word, IEnumerable<string> known, string before = "")
    {
        int DistanceTo(string name) =>
            word.Length > 2 && name.StartsWith(word, StringComparison.Ordinal) ? 1 : Distance(word, name);
        string? nearest = known.Where(k => DistanceTo(k) <= Math.Max(1, word.Length / 3)).MinBy(DistanceTo);
        return nearest == null ? "" : ": did you mean " + before + nearest + "?";
    }

    /// <summary>Letters changed, omitted, added, or swapped with the next.</summary>
    static int Distance(string a, string b)
    {
        var rows = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++)
            for (int j = 0; j <= b.Length; j++)
            {
                rows[i, j] = i == 0 || j == 0 ? i + j : Math.Min(rows[i - 1, j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1),
                    1 + Math.Min(rows[i - 1, j], rows[i, j - 1]));
                if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                    rows[i, j] = Math.Min(rows[i, j], 1 + rows[i - 2, j - 2]);
            }
        return rows[a.Length, b.Length];
    }

    static int Run(Verb verb, ParseResult parsed, CommonOptions common, CliRun run, TextWriter error, bool errorIsTerminal)
    {
        string? json = run.Settings.Json;
        using var standard = run.Standard;
        using var display = run.Settings.IsQuiet ? null : new ProgressDisplay(run.Progress, error, errorIsTerminal);
        Failure? failure;
        try
        {
            RemoteAccess.AllowsHttp = run.Settings.AllowsHttp;
            if (common.UseThreads(parsed) is { } note)
                run.Warn(note);
            if (json != null)
                OutputNames.RefuseOtherKind("--json", "a summary", json);
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
