namespace FastPoints.Cli;

public sealed class UsageException(string message) : Exception(message);
