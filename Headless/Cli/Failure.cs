namespace FastPoints.Cli;

public sealed class Failure
{
    public required string Code { get; init; }
    public required string Message { get; init; }
    public required int Status { get; init; }
    public string? File { get; init; }

    /// <summary>Byte in the file, or -1.</summary>
    public long Offset { get; init; } = -1;

    public static Failure? OfStrict(CliRun run)
    {
        string lost = run.Points.Lost > 0 ? NumberFormat.Count(run.Points.Lost) + " points that are claimed are not there" : "";
        string odd = run.HasSourceWarnings ? "a source is odd (see the warnings)" : "";
        string empty = run.IsEmpty ? "no point came out (see the warnings)" : "";
        return lost.Length + odd.Length + empty.Length == 0 ? null : new Failure
        {
            Code = "Incomplete",
            Message = "--strict: " + string.Join("; ", new[] { lost, odd, empty }.Where(s => s.Length > 0)),
            Status = ExitStatus.Incomplete,
        };
    }

    public static Failure Of(Exception e, IReadOnlyCollection<string> inputs)
    {
        if (e is AggregateException { InnerExceptions.Count: 1 } one)
            e = one.InnerExceptions[0];
        switch (e)
        {
            case OperationCanceledException:
                string message = e is StoppedException ? e.Message : "cancelled";
                return new Failure { Code = "Cancelled", Message = message, Status = ExitStatus.Cancelled };
            case PointCloudException p:
                bool isAbsent = p.Code is FailureCode.NotFound or FailureCode.AccessDenied;
                bool isMissingPart = p.Code == FailureCode.NotFound && inputs.Any(i => FolderOf(i) is { } folder
                    && p.Path.StartsWith(Path.TrimEndingDirectorySeparator(folder)
                        + (SourcePath.IsRemote(folder) ? '/' : Path.DirectorySeparatorChar), StringComparison.Ordinal));
                bool isInput = p.IsInputAtFault || isMissingPart || (isAbsent && inputs.Contains(p.Path));
                return new Failure
                {
                    Code = p.Code.ToString(),
                    Message = p.Message + (isInput ? Hints.For(p) : ""),
                    File = p.Path,
                    Offset = p.ByteOffset,
                    Status = isInput ? ExitStatus.BadInput : ExitStatus.Failed,
                };
            // File errors were converted before.
            case IOException:
                return new Failure
                {
                    Code = FailureCode.WriteFailed.ToString(),
                    Message = "standard output: " + e.Message,
                    Status = ExitStatus.Failed,
                };
            case OutOfMemoryException:
                return new Failure { Code = "OutOfMemory", Message = "out of memory", Status = ExitStatus.Failed };
            default:
                // A defect: where it happened is all that helps.
                return new Failure { Code = "Internal", Message = "internal error: " + e, Status = ExitStatus.Failed };
        }
    }

    static string? FolderOf(string input) => Directory.Exists(input) ? input
        : SourcePath.NameOf(input) is "ept.json" or "metadata.json" or "cloud.js" ? SourcePath.FolderOf(input) : null;
}
