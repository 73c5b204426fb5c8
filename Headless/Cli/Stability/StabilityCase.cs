namespace FastPoints.Cli.Stability;

/// <summary>An extreme of input, made from a seed, and what must come of it.</summary>
/// <param name="Name">For tables and tests.</param>
/// <param name="Make">From a folder and a number of points about to make: the files.</param>
public sealed record StabilityCase(string Name, Func<string, int, StabilityInput> Make)
{
    /// <summary>Whether a build must end in a cloud; otherwise in an error that says why.</summary>
    public bool IsCloud { get; init; } = true;

    /// <summary>Where the cloud goes, given the folder; null for a place of its own.</summary>
    public Func<string, string>? Target { get; init; }

    /// <summary>Another build of the same target begins while this one is under way.</summary>
    public bool IsBuiltTwice { get; init; }

    public override string ToString() => Name;
}

/// <summary>What was made.</summary>
/// <param name="Points">Readable points in the files.</param>
/// <param name="LeftOut">Of these, without a finite position.</param>
public sealed record StabilityInput(string[] Files, long Points, long LeftOut = 0);
