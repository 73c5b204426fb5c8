namespace FastPoints.Cli;

public static class ExitStatus
{
    public const int Done = 0;
    public const int Failed = 1;
    public const int Usage = 2;
    public const int BadInput = 3;
    public const int Incomplete = 4;
    public const int Cancelled = 130;
}
