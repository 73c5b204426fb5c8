namespace FastPoints.Cli;

/// <summary>Options that parse, but cannot be meant together or are out of range.</summary>
public sealed class UsageException(string message) : Exception(message);
