namespace FastPoints.RepoTools;

public sealed class ToolException(string message) : Exception(message) { }
