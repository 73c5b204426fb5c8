using System.Diagnostics;

namespace FastPoints.Cli;

/// <summary>One call of a verb: where it speaks to, how far it is, and what its summary will say.</summary>
public sealed class CliRun(TextWriter output, TextWriter error, bool quiet, string? json, CancellationToken cancellation)
{
    readonly Stopwatch m_watch = Stopwatch.StartNew();
    readonly HashSet<string> m_warned = [];

    /// <summary>For people; swallows everything when the summary goes to standard output.</summary>
    public TextWriter Out { get; } = output;

    public StageProgress Progress { get; } = new();
    public CancellationToken Cancellation { get; } = cancellation;
    public List<string> Inputs { get; } = [];
    public List<string> Warnings { get; } = [];
    public double Seconds => m_watch.Elapsed.TotalSeconds;

    /// <summary>Writes the verb's own keys; set as soon as they are known, so that a failed run says what it found.</summary>
    public Action<Utf8JsonWriter>? WriteKeys { get; set; }

    /// <summary>Takes down what is read and what will be written, before either is done.</summary>
    /// <exception cref="UsageException">An output would be written over an input.</exception>
    public void Begin(IEnumerable<string> inputs, params IEnumerable<string> outputs)
    {
        Inputs.AddRange(inputs);
        foreach (string path in json is null or "-" ? outputs : outputs.Append(json))
            OutputNames.RefuseInputs(path, Inputs);
    }

    /// <summary>Runs work on this thread until it is done, or cancelled.</summary>
    public void Pump(IEnumerator<Work> work) => WorkPump.RunToEnd(work, Cancellation);

    /// <summary>Takes over what a source has to say against itself; each line once.</summary>
    /// <param name="isShown">Whether people have read it already, with the source's facts.</param>
    public void Warn(SourceInfo info, bool isShown = false)
    {
        foreach (var warning in info.Warnings)
            Warn(warning.ToString(), isShown);
    }

    void Warn(string line, bool isShown)
    {
        if (!m_warned.Add(line))
            return;
        Warnings.Add(line);
        if (!quiet && !isShown)
            error.WriteLine("fastpoints: warning: " + line);
    }
}
