namespace FastPoints.RepoTools;

/// <summary>A tool cannot do its work; the message says what to do about it.</summary>
public sealed class ToolException(string message) : Exception(message) { }
