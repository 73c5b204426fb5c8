namespace UnityEditor.Build.Reporting;

public enum BuildResult { Unknown = 0, Succeeded = 1, Failed = 2, Cancelled = 3 }

public struct BuildSummary
{
    public BuildResult result { get; internal set; }
}

public sealed class BuildReport : UnityEngine.Object
{
    public BuildSummary summary { get; internal set; }
}
