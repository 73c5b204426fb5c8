namespace FastPoints.HostTests;

internal static class Checkout
{
    internal static readonly RepoTools.Repository Repository = RepoTools.Repository.Find();

    /// <summary>Paths of the files that are committed or would be, with '/'.</summary>
    internal static IReadOnlyList<string> Files() => Repository.Files();

    internal static GenerationBuilds Builds(string generation) => new GenerationBuilds(Repository, generation);
}
