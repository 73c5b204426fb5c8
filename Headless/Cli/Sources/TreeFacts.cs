namespace FastPoints.Cli.Sources;

public sealed class TreeFacts
{
    public required int Nodes { get; init; }
    public required int NodesWithoutPoints { get; init; }

    /// <summary>Pages of the hierarchy; 0 if it has none.</summary>
    public required int Pages { get; init; }

    public required bool IsHierarchyRead { get; init; }
    public required IReadOnlyList<TreeLevel> Levels { get; init; }

    internal static TreeFacts Of(SourceTree tree) => new()
    {
        Nodes = tree.NodeCount,
        NodesWithoutPoints = tree.AsArray().Count(n => n.Block < 0),
        Pages = tree.PageCount,
        IsHierarchyRead = tree.IsHierarchyRead,
        Levels = TreeLevel.Of(tree),
    };
}

public sealed class TreeLevel
{
    public required int Level { get; init; }
    public required double Spacing { get; init; }
    public int Nodes { get; private set; }
    public long Points { get; private set; }
    public int MaxPoints { get; private set; }

    internal static IReadOnlyList<TreeLevel> Of(SourceTree tree)
    {
        var levels = new List<TreeLevel>();
        for (int i = 0; i < tree.LevelCount; i++)
            levels.Add(new TreeLevel { Level = i, Spacing = tree.Spacing / Math.Pow(2, i) });
        for (int i = 0; i < tree.NodeCount; i++)
        {
            var level = levels[tree[i].Level];
            level.Nodes++;
            level.Points += tree[i].PointCount;
            level.MaxPoints = Math.Max(level.MaxPoints, tree[i].PointCount);
        }
        return levels;
    }
}
