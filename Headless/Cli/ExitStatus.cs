namespace FastPoints.Cli;

/// <summary>What the process ends with: see <c>--help</c>.</summary>
public static class ExitStatus
{
    public const int Done = 0;
    public const int Failed = 1;
    public const int Usage = 2;
    public const int BadInput = 3;

    /// <summary>With <c>--strict</c>: all was done, but a source lacks points or is odd.</summary>
    public const int Incomplete = 4;

    public const int Cancelled = 130;
}
