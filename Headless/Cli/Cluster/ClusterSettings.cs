namespace FastPoints.Cli.Cluster;

/// <summary>What the user says of a cluster.</summary>
/// <param name="Volume">Where plan and store lie, if they have no address: what the scheduler calls it, and where tasks see
/// it.</param>
sealed record ClusterSettings(string Program, int Cores, int Attempts, int MaxArray, int? AtOnce, string? Queue, string? Image,
    string? Scratch, (string Name, string Path)? Volume);
