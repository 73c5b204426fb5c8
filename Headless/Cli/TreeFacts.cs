using System.Collections.Generic;
using FastPoints.Files;

namespace FastPoints.Cli
{
    /// <summary>A source's own octree as far as it was read, for when the source itself is closed.</summary>
    public sealed class TreeFacts
    {
        public required int Nodes { get; init; }
        public required int NodesWithoutPoints { get; init; }

        /// <summary>Of the hierarchy; 0 where it has none.</summary>
        public required int Pages { get; init; }

        public required bool IsWhole { get; init; }
        public required IReadOnlyList<TreeLevel> Levels { get; init; }

        internal static TreeFacts Of(SourceTree tree) => new()
        {
            Nodes = tree.NodeCount,
            NodesWithoutPoints = tree.NodesWithoutPoints(),
            Pages = tree.PageCount,
            IsWhole = tree.IsWhole,
            Levels = TreeLevel.Of(tree),
        };
    }
}
