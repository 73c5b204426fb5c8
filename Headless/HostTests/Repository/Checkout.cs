namespace FastPoints.HostTests;

/// <summary>The checkout that the tests were built in.</summary>
internal static class Checkout
{
    internal static readonly RepoTools.Repository Repository = RepoTools.Repository.Find();

    /// <summary>Paths of the files that are committed or would be, with '/'.</summary>
    internal static IReadOnlyList<string> Files() => Repository.Files();

    /// <summary>The builds of one generation; what to run where they are absent.</summary>
    internal static GenerationBuilds Builds(string generation) => new GenerationBuilds(Repository, generation);
}
