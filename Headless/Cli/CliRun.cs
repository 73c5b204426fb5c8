namespace FastPoints.Cli;

public sealed class CliRun(TextWriter output, TextWriter error, RunSettings settings, CancellationToken cancellation)
{
    readonly Stopwatch m_watch = Stopwatch.StartNew();
    readonly HashSet<string> m_warned = [];
    public TextWriter StandardOutput { get; } = output;
    public StandardStreams Standard { get; } = new();
    public TextWriter Out { get; private set; } = settings.Json == "-" ? TextWriter.Null : output;
    public RunSettings Settings => settings;
    public StageProgress Progress { get; } = new();
    public CancellationToken Cancellation { get; } = cancellation;
    public CancellationToken Discard { get; init; }

    public bool IsDiscarding
    {
        get => field || Discard.IsCancellationRequested;
        set;
    }

    public string CommandLine { get; init; } = "";
    public List<string> Inputs { get; } = [];
    public List<string> Warnings { get; } = [];
    public PointCounts Points { get; } = new();
    internal List<Loss> Losses { get; } = [];
    public bool HasSourceWarnings { get; private set; }

    /// <summary>No points were requested, or none lie in the requested region.</summary>
    public bool IsEmpty { get; private set; }
    public Failure? FirstFailure { get; private set; }
    public double Seconds => m_watch.Elapsed.TotalSeconds;

    /// <summary>Writes the verb's own keys; set as soon as they are known, so that a failed run reports what it found.</summary>
    public Action<Utf8JsonWriter>? WriteKeys { get; set; }

    /// <returns>The inputs, with a file in place of standard input.</returns>
    public string[] Begin(IEnumerable<string> inputs, params IEnumerable<string> outputs)
    {
        string[] named = inputs.ToArray();
        Inputs.AddRange(named.Select(SourcePath.WithoutQuery));
        foreach (string path in settings.Json is null or "-" ? outputs : outputs.Append(settings.Json))
        {
            if (StandardStreams.IsOutput(path))
            {
                if (settings.Json == "-")
                    throw new UsageException("--json and --output: only one of them can be standard output");
                Out = TextWriter.Null;
                continue;
            }
            OutputNames.RefuseInputs(path, Inputs);
            OutputNames.RefuseForeign(path, settings.IsForced);
        }
        return named.Select(i => StandardStreams.IsInput(i) ? Standard.Receive(this) : i).ToArray();
    }

    public void RunSteps(IEnumerator<JobStep> work) => JobCoroutine.RunToEnd(work, Cancellation);

    public Failure? TryInput(Action work)
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

    public void Warn(SourceInfo info, bool isAlreadyShown = false)
    {
        // Points that the file itself marks as invalid do not count.
        HasSourceWarnings |= info.Warnings.Count > (info.PointsMarkedInvalid > 0 ? 1 : 0);
        foreach (var warning in info.Warnings)
            Warn(warning.ToString(), isAlreadyShown);
    }

    internal void Report(IEnumerable<Loss> losses)
    {
        foreach (var loss in losses)
        {
            if (Losses.Contains(loss))
                continue;
            Losses.Add(loss);
            Warn(loss.ToString());
        }
    }

    public void WriteLosses(Utf8JsonWriter json)
    {
        json.WriteObjects("losses", Losses, loss =>
        {
            json.WriteString("what", loss.What);
            json.WriteString("where", loss.Where);
            json.WriteString("why", loss.Reason);
        });
    }

    internal void WarnOfFailures(StreamContext stream)
    {
        while (stream.TryTakeFailure(out var failure))
        {
            HasSourceWarnings = true;
            Warn(failure.ToString());
        }
    }

    /// <summary>Warns of an empty output, which --strict takes for a failure.</summary>
    internal void WarnEmpty(string output, string what, long points, BoundsGeo bounds, IReadOnlyList<ClipBox> clips)
    {
        static BoundsGeo Of(ClipBox box)
        {
            var half = new double3(box.EdgesWorld.c0.x, box.EdgesWorld.c1.y, box.EdgesWorld.c2.z) / 2;
            return new BoundsGeo(box.CenterWorld - half, box.CenterWorld + half);
        }
        IsEmpty = true;
        Warn(output + ": no point is " + what + (points > 0 ? " of " + NumberFormat.Count(points) + ", which" : "; they")
            + " lie in " + NumberFormat.Box(bounds) + (clips.Count == 0 ? "" : "; wanted "
            + string.Join(", ", clips.Select(c => (c.Cuts ? "not " : "") + NumberFormat.Box(Of(c))))));
    }

    public void Warn(string line, bool isAlreadyShown = false)
    {
        if (!m_warned.Add(line))
            return;
        Warnings.Add(line);
        if (!settings.IsQuiet && !isAlreadyShown)
            error.WriteLine("fastpoints: warning: " + line);
    }
}
