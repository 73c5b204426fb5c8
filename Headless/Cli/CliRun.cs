using System.Diagnostics;

namespace FastPoints.Cli;

/// <summary>One call of a verb: where it speaks to, how far it is, and what its summary will say.</summary>
public sealed class CliRun(TextWriter output, TextWriter error, RunSettings settings, CancellationToken cancellation)
{
    readonly Stopwatch m_watch = Stopwatch.StartNew();
    readonly HashSet<string> m_warned = [];

    /// <summary>For people; swallows everything when the summary goes to standard output.</summary>
    public TextWriter Out { get; } = settings.Json == "-" ? TextWriter.Null : output;

    public RunSettings Settings => settings;
    public StageProgress Progress { get; } = new();
    public CancellationToken Cancellation { get; } = cancellation;

    /// <summary>Cancelled as well where a build that ends early is not to be kept.</summary>
    public CancellationToken Discard { get; init; }

    /// <summary>Whether a build that ends early is deleted.</summary>
    public bool IsDiscarding
    {
        get => field || Discard.IsCancellationRequested;
        set;
    }

    /// <summary>The line that was typed: a build that was stopped goes on by the same.</summary>
    public string Line { get; init; } = "";

    public List<string> Inputs { get; } = [];
    public List<string> Warnings { get; } = [];

    /// <summary>Of all sources together.</summary>
    public PointsAccount Points { get; } = new();

    /// <summary>Whether a source had anything to say against itself.</summary>
    public bool HasOddSources { get; private set; }

    /// <summary>The first of the clouds that failed where others went on.</summary>
    public Failure? FirstFailure { get; private set; }

    public double Seconds => m_watch.Elapsed.TotalSeconds;

    /// <summary>Writes the verb's own keys; set as soon as they are known, so that a failed run says what it found.</summary>
    public Action<Utf8JsonWriter>? WriteKeys { get; set; }

    /// <summary>Takes down what is read and what will be written, before either is done.</summary>
    /// <exception cref="UsageException">An output would be written over an input, or over what is not this tool's.</exception>
    public void Begin(IEnumerable<string> inputs, params IEnumerable<string> outputs)
    {
        Inputs.AddRange(inputs);
        foreach (string path in settings.Json is null or "-" ? outputs : outputs.Append(settings.Json))
        {
            OutputNames.RefuseInputs(path, Inputs);
            OutputNames.RefuseForeign(path, settings.IsForced);
        }
    }

    /// <summary>Runs work on this thread until it is done, or cancelled.</summary>
    public void RunSteps(IEnumerator<JobStep> work) => JobCoroutine.RunToEnd(work, Cancellation);

    /// <summary>One of several clouds: where it is bad input, the others go on, and the run fails in the end.</summary>
    /// <returns>How it failed; null where it did not.</returns>
    public Failure? Try(Action work)
    {
        try
        {
            work();
            return null;
        }
        catch (Exception e) when (Failure.Of(e, Inputs) is { Status: ExitStatus.BadInput } failure)
        {
            Progress.End();
            Progress.Group = null;
            error.WriteLine("fastpoints: " + failure.Message);
            FirstFailure ??= failure;
            return failure;
        }
    }

    /// <summary>Takes over what a source has to say against itself; each line once.</summary>
    /// <param name="isShown">Whether people have read it already, with the source's facts.</param>
    public void Warn(SourceInfo info, bool isShown = false)
    {
        // What a file marks as invalid is a warning, and nothing odd.
        HasOddSources |= info.Warnings.Count > (info.PointsMarkedInvalid > 0 ? 1 : 0);
        foreach (var warning in info.Warnings)
            Warn(warning.ToString(), isShown);
    }

    public void Warn(string line, bool isShown = false)
    {
        if (!m_warned.Add(line))
            return;
        Warnings.Add(line);
        if (!settings.IsQuiet && !isShown)
            error.WriteLine("fastpoints: warning: " + line);
    }
}
