namespace FastPoints.Cli.Stability;

/// <summary>An extreme of input, made from a seed, and what must come of it.</summary>
public sealed record StabilityCase(string Name, Func<string, int, StabilityInput> Make)
{
    /// <summary>Whether a build must end in a cloud; otherwise in an error that says why.</summary>
    public bool IsCloud { get; init; } = true;

    /// <summary>Where the cloud goes, given the folder; null for a place of its own.</summary>
    public Func<string, string>? Target { get; init; }

    public bool IsBuiltTwice { get; init; }

    public override string ToString() => Name;
}

public sealed record StabilityInput(string[] Files, long Points, long LeftOut = 0);
