namespace FastPoints.Cli.Stability;

public sealed record StabilityCase(string Name, Func<string, int, StabilityInput> Make)
{
    /// <summary>Whether a build must end in a cloud; otherwise in an error that says why.</summary>
    public bool MustSucceed { get; init; } = true;

    public Func<string, string>? Target { get; init; }
    public bool IsBuiltTwice { get; init; }

    public override string ToString() => Name;
}

public sealed record StabilityInput(string[] Files, long Points, long LeftOut = 0);
