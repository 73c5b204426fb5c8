using System.Diagnostics;

namespace FastPoints.Cli;

public sealed class CliRun(TextWriter output, TextWriter error, RunSettings settings, CancellationToken cancellation)
{
    readonly Stopwatch m_watch = Stopwatch.StartNew();
    readonly HashSet<string> m_warned = [];
    public TextWriter StandardOutput { get; } = output;
    public TextWriter Out { get; } = settings.Json == "-" ? TextWriter.Null : output;
    public RunSettings Settings => settings;
    public StageProgress Progress { get; } = new();
    public CancellationToken Cancellation { get; } = cancellation;
    public CancellationToken Discard { get; init; }

    public bool IsDiscarding
    {
        get => field || Discard.IsCancellationRequested;
        set;
    }

    public string Line { get; init; } = "";
    public List<string> Inputs { get; } = [];
    public List<string> Warnings { get; } = [];
    public PointCounts Points { get; } = new();
    internal List<Loss> Losses { get; } = [];
    public bool HasSourceWarnings { get; private set; }

    /// <summary>No points were requested, or none lie in the requested region.</summary>
    public bool IsEmpty { get; private set; }
    public Failure? FirstFailure { get; private set; }
    public double Seconds => m_watch.Elapsed.TotalSeconds;

    /// <summary>Writes the verb's own keys; set as soon as they are known, so that a failed run says what it found.</summary>
    public Action<Utf8JsonWriter>? WriteKeys { get; set; }

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

    public void Warn(SourceInfo info, bool isShown = false)
    {
        // Points that the file itself marks as invalid do not count.
        HasSourceWarnings |= info.Warnings.Count > (info.PointsMarkedInvalid > 0 ? 1 : 0);
        foreach (var warning in info.Warnings)
            Warn(warning.ToString(), isShown);
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
        json.WriteStartArray("losses");
        foreach (var loss in Losses)
        {
            json.WriteStartObject();
            json.WriteString("what", loss.What);
            json.WriteString("where", loss.Where);
            json.WriteString("why", loss.Why);
            json.WriteEndObject();
        }
        json.WriteEndArray();
    }

    /// <summary>Says that nothing came out, which --strict takes for a failure.</summary>
    public void WarnEmpty(string line)
    {
        IsEmpty = true;
        Warn(line);
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
