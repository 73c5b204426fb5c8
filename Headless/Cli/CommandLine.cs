using System.CommandLine.Help;
using System.CommandLine.Invocation;
using FastPoints.Cli.Verbs;
using StandIns.Engine;

namespace FastPoints.Cli;

/// <summary>From arguments to an exit status. Everything that the command line says goes through the writers given
/// here.</summary>
public static class CommandLine
{
    /// <param name="errorIsTerminal">Whether progress may be redrawn in place.</param>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public static int Run(IReadOnlyList<string> args, TextWriter output, TextWriter error, bool errorIsTerminal,
        CancellationToken cancellation)
    {
        ZstandardDecompressor.Register();
        var verbs = AllVerbs();
        var root = verbs[0].Command;
        foreach (var verb in verbs.Skip(1))
            root.Add(verb.Command);
        // --help belongs to every command, and is one option: its action is replaced, and its text is ours.
        root.Options.OfType<HelpOption>().Single().Action = new HelpTextAction(verbs);

        var parsed = root.Parse(args, new ParserConfiguration { EnablePosixBundling = false, ResponseFileTokenReplacer = null });
        if (parsed.Errors.Count > 0 && parsed.Action is ParseErrorAction or null)
            return WrongUsage(error, parsed.CommandResult.Command, parsed.Errors[0].Message);
        if (UnknownOption(parsed) is { } unknown)
            return WrongUsage(error, parsed.CommandResult.Command, "unknown option " + unknown);
        var chosen = verbs.FirstOrDefault(v => v.Command == parsed.CommandResult.Command);
        if (chosen == null || !chosen.IsAsked(parsed))
            return parsed.Invoke(new InvocationConfiguration
            {
                Output = output,
                Error = error,
                EnableDefaultExceptionHandler = false,
                ProcessTerminationTimeout = null,
            });
        return Run(chosen, parsed, output, error, errorIsTerminal, cancellation);
    }

    /// <summary>The main job first.</summary>
    static List<Verb> AllVerbs() =>
    [
        new MainJob(), new InfoVerb(), new PreviewVerb(), new ConvertVerb(), new VerifyVerb(),
        new PictureVerb(), new FlyVerb(), new DemoCloudVerb(), new BenchVerb(),
    ];

    static int WrongUsage(TextWriter error, Command command, string what)
    {
        error.WriteLine("fastpoints: " + what);
        error.WriteLine("usage: " + HelpText.Usage(command) + "   (more: " + HelpText.Path(command) + " --help)");
        return ExitStatus.Usage;
    }

    /// <summary>What looks like an option and is none is taken for a file by the parser. A file of such a name is
    /// ./-name.</summary>
    static string? UnknownOption(ParseResult parsed)
    {
        foreach (var argument in parsed.CommandResult.Command.Arguments)
            foreach (var token in parsed.GetResult(argument)?.Tokens ?? [])
                if (token.Value.StartsWith('-'))
                    return token.Value;
        return null;
    }

    static int Run(Verb verb, ParseResult parsed, TextWriter output, TextWriter error, bool errorIsTerminal,
        CancellationToken cancellation)
    {
        string? json = parsed.GetValue(verb.JsonOption);
        bool quiet = parsed.GetValue(verb.QuietOption);
        var run = new CliRun(json == "-" ? TextWriter.Null : output, error, quiet, json, cancellation);
        using var display = quiet ? null : new ProgressDisplay(run.Progress, error, errorIsTerminal);
        int status;
        Failure? failure = null;
        try
        {
            Threads.Use(parsed.GetValue(verb.ThreadsOption));
            if (json != null)
                OutputNames.RefuseCloud("--json", "a summary", json);
            verb.Run(parsed, run);
            // What a job throws is logged, and the work goes on: what comes of it is not to be trusted.
            LoggedExceptions.ThrowFirst();
            status = ExitStatus.Done;
        }
        catch (Exception e)
        {
            display?.Clear();
            if (e is UsageException)
                return WrongUsage(error, verb.Command, e.Message);
            failure = Failure.Of(e, run.Inputs);
            status = failure.Status;
            error.WriteLine("fastpoints: " + failure.Message);
        }
        display?.Clear();
        if (json == null)
            return status;
        try
        {
            Summary.Write(json, output, verb.Command is RootCommand ? "" : verb.Command.Name, run, failure);
        }
        catch (PointCloudException e)
        {
            error.WriteLine("fastpoints: " + e.Message);
            return ExitStatus.Failed;
        }
        return status;
    }

    sealed class HelpTextAction(List<Verb> verbs) : SynchronousCommandLineAction
    {
        public override bool ClearsParseErrors => true;

        public override int Invoke(ParseResult parsed)
        {
            HelpText.Write(parsed.InvocationConfiguration.Output, verbs, parsed.CommandResult.Command);
            return ExitStatus.Done;
        }
    }
}
