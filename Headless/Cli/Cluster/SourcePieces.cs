namespace FastPoints.Cli.Cluster;

/// <summary>Consecutive blocks of a file whose points lie in a box.</summary>
struct SourcePiece
{
    public int File;
    public int FirstBlock; // In the file's own count, and in that of the whole source.
    public int FirstOfAll;
    public int Blocks;
    public long Points;
    public Grid3 Min; // Both ends are included; all there is if nothing is known.
    public Grid3 Max;
}

/// <summary>What a plan knows of the places of points before they are read: tiles by their headers, nodes of an octree by their
/// cubes.</summary>
sealed class SourcePieces
{
    const int MarginSteps = 2; // Numbers in headers are rounded, points of nodes are, too.

    readonly CloudGrid m_grid;

    SourcePieces(CloudGrid grid) => m_grid = grid;

    public List<(string Path, long Bytes)> Files { get; } = [];
    public List<SourcePiece> Pieces { get; } = [];

    /// <param name="reader">Its blocks are known.</param>
    public static SourcePieces Of(PointReader reader, CloudGrid grid)
    {
        var pieces = new SourcePieces(grid);
        if (reader is TiledReader tiles)
            pieces.AddTiles(tiles);
        else if (reader.Tree != null)
            pieces.AddNodes(reader);
        else
            pieces.Add(reader, new SourcePiece { Blocks = reader.BlockCount }, reader.Info.BoundsIfFinite);
        if (pieces.Files.Count == 0)
            pieces.Files.Add((reader.Info.Path, reader.Info.FileBytes));
        return pieces;
    }

    void AddTiles(TiledReader tiles)
    {
        Files.Capacity = Pieces.Capacity = tiles.TileCount;
        for (int t = 0; t < tiles.TileCount; t++)
        {
            var tile = tiles.TileEntryOf(t);
            var (first, count) = tiles.BlocksOf(t);
            Files.Add((tile.Name, tile.FileBytes));
            Add(tiles, new SourcePiece { File = t, FirstOfAll = first, Blocks = count }, tiles.BoundsOf(t));
        }
    }

    void AddNodes(PointReader reader)
    {
        var tree = reader.Tree;
        for (int n = 0; n < tree.NodeCount; n++)
        {
            var node = tree[n];
            if (node.Block < 0)
                continue;
            var edge = tree.Cube.Size / math.pow(2.0, node.Level);
            var min = tree.Cube.Min + edge * new double3(node.Cell.x, node.Cell.y, node.Cell.z);
            Add(reader, new SourcePiece { FirstBlock = node.Block, FirstOfAll = node.Block, Blocks = 1 },
                new BoundsGeo(min, min + edge));
        }
    }

    void Add(PointReader reader, SourcePiece piece, BoundsGeo bounds)
    {
        int end = piece.FirstOfAll + piece.Blocks;
        if (piece.Blocks > 0)
            piece.Points = reader.FirstPointOfBlock(end - 1) + reader.PointsInBlock(end - 1)
                - reader.FirstPointOfBlock(piece.FirstOfAll);
        (piece.Min, piece.Max) = bounds.IsEmpty ? (Grid3.MinValue, Grid3.MaxValue)
            : (ToGrid(bounds.Min, -MarginSteps), ToGrid(bounds.Max, MarginSteps));
        if (piece.Points > 0)
            Pieces.Add(piece);
    }

    Grid3 ToGrid(double3 position, double margin)
    {
        const long limit = SourceToGrid.Limit;
        var steps = math.clamp(math.round((position - m_grid.Origin) / m_grid.Step) + margin, -limit, limit);
        return new Grid3((long)steps.x, (long)steps.y, (long)steps.z);
    }
}
