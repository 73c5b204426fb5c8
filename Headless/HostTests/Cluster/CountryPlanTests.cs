namespace FastPoints.HostTests.Cluster;

/// <summary>A plan of 10^12 points in 1.4 M tiles, by their headers alone: tasks, merges, and what a task reads of the
/// plan.</summary>
[Category("Long")]
public sealed class CountryPlanTests
{
    const int Tiles = 1_400_000;
    const double Points = 1e12;
    const double TileMetres = 600, ProjectTiles = 60;
    const long PointsPerBaseCell = 16_000_000, PointsPerTask = 50_000_000;
    static readonly GridCube s_whole = new(default, 30); // Steps of 1 mm: 1,074 km.

    readonly record struct Tile(Grid3 Min, Grid3 Max, double Points);

    /// <summary>Projects of 36 by 36 km in a country of 1,000 by 1,000 km, some missing; points a square metre as 3DEP's quality
    /// levels 3, 2 and 1 ask for (0.5, 2, 8) and deliver, and hills of 2 km.</summary>
    static List<Tile> MakeTiles()
    {
        var random = new Unity.Mathematics.Random(7);
        int perSide = (int)(1_000_000 / TileMetres), projects = (int)math.ceil(perSide / ProjectTiles);
        var densities = new double[projects * projects];
        for (int p = 0; p < densities.Length; p++)
            densities[p] = random.NextDouble() < 0.5 ? 0 : (random.NextDouble() switch { < 0.2 => 0.7, < 0.9 => 2.5, _ => 10 })
                * math.exp(0.3 * random.NextDouble(-1, 1));
        var tiles = new List<Tile>();
        for (int y = 0; y < perSide; y++)
            for (int x = 0; x < perSide; x++)
            {
                double density = densities[(int)(y / ProjectTiles) * projects + (int)(x / ProjectTiles)];
                if (density == 0)
                    continue;
                double height = 1000 + 600 * math.sin(x / 90.0) * math.cos(y / 70.0) + 200 * math.sin(x / 11.0 + y / 17.0);
                double span = 40 + 160 * random.NextDouble();
                long Mm(double metres) => (long)(metres * 1000);
                tiles.Add(new Tile(new Grid3(Mm(x * TileMetres), Mm(y * TileMetres), Mm(height)),
                    new Grid3(Mm((x + 1) * TileMetres) - 1, Mm((y + 1) * TileMetres) - 1, Mm(height + span)), density));
            }
        double sum = tiles.Sum(t => t.Points);
        return tiles.ConvertAll(t => t with { Points = t.Points * Points / sum });
    }

    static DensityTree Count(List<Tile> tiles)
    {
        using var codes = new NativeArray<uint>(tiles.Count, Allocator.Persistent);
        using var ranges = new NativeArray<SampleRange>(tiles.Count, Allocator.Persistent);
        var (codeOf, rangeOf) = (codes, ranges);
        for (int t = 0; t < tiles.Count; t++)
        {
            uint Cell(long min, long max) => (uint)((min + max) / 2 >> s_whole.SideLog2 - DensityNumbers.Levels);
            var (min, max) = (tiles[t].Min, tiles[t].Max);
            codeOf[t] = (uint)Morton.Encode(Cell(min.X, max.X), Cell(min.Y, max.Y), Cell(min.Z, max.Z));
            rangeOf[t] = new SampleRange { First = t, Count = 1, Weight = tiles[t].Points };
        }
        DensityTree tree = null;
        JobCoroutine.RunToEnd(DensityTree.Count(codes, ranges, tiles.Count / Points, 500_000, default, found => tree = found));
        return tree;
    }

    [Test]
    public void Plan_OfACountry_HasTasksThatReadLittleOfIt()
    {
        var watch = System.Diagnostics.Stopwatch.StartNew();
        var tiles = MakeTiles();
        TestContext.Out.WriteLine($"{tiles.Count:n0} tiles in {watch.Elapsed.TotalSeconds:f1} s");
        Assert.That(tiles, Has.Count.EqualTo(Tiles).Within(10).Percent);
        using var density = Count(tiles);
        var cells = PartitionMap.BaseCellsOf(s_whole, density, PointsPerBaseCell, out double[] pointsOfCell);
        int next = 0;
        var groups = CubeGroups.Of(s_whole, cells, c => c, _ => (long)math.ceil(pointsOfCell[next++]), PointsPerTask);
        var cubes = groups.ConvertAll(g => g.Count == 1 ? cells[g.First] : g.Cube).ToArray();
        var index = new CubeFinder(s_whole, cubes);
        var (tilesOf, pointsRead, found) = (new int[cubes.Length], new double[cubes.Length], new List<int>());
        foreach (var tile in tiles)
        {
            found.Clear();
            index.Find(tile.Min, tile.Max, found);
            foreach (int task in found)
            {
                tilesOf[task]++;
                pointsRead[task] += tile.Points;
            }
        }
        int[] kept = Enumerable.Range(0, cubes.Length).Where(t => tilesOf[t] > 0).ToArray();
        double[] built = groups.ConvertAll(g => pointsOfCell.AsSpan(g.First, g.Count).ToArray().Sum()).ToArray();
        var builds = BuildAssignment.Of(Array.ConvertAll(kept, t => built[t]), PointsPerTask);
        var merges = MergeTree.Of(s_whole, kept.Select((t, number) => (builds.NameOf(number), cubes[t])));
        watch.Stop();
        long[] bytes = kept.Select(t => BytesOf(groups[t], cells, tilesOf[t])).ToArray();
        string sizes = string.Join(", ", kept.GroupBy(t => cubes[t].SideLog2).OrderBy(g => g.Key)
            .Select(g => $"2^{g.Key}: {g.Count():n0}"));
        TestContext.Out.WriteLine($"""
            {cells.Length:n0} base cells, {pointsOfCell.Count(p => p > 0):n0} with points,
            of {pointsOfCell.Max() / 1e6:f1} M at most
            {cubes.Length:n0} cubes, {kept.Length:n0} builds, of {built.Max() / 1e6:f1} M points at most,
            {Points / kept.Length / 1e6:f1} M on average; {builds.BuildTasks:n0} tasks of {Points / builds.BuildTasks / 1e6:f1} M
            builds below 1 M points: {kept.Count(t => built[t] < 1e6):n0},
            with {kept.Where(t => built[t] < 1e6).Sum(t => built[t]) / Points:p2} of the points
            each point is read {pointsRead.Sum() / Points:f2} times;
            a build reads {tilesOf.Max():n0} tiles at most, {pointsRead.Max() / 1e6:f0} M points
            merges: {string.Join(", ", merges.Select(r => $"{r.Count:n0} of {r.Max(m => m.Inputs.Count):n0} inputs at most"))}
            tasks' files: {bytes.Max():n0} bytes at most, {bytes.Sum() / 1e6:f0} MB together
            cubes by size: {sizes}
            {watch.Elapsed.TotalSeconds:f1} s, {System.Diagnostics.Process.GetCurrentProcess().PeakWorkingSet64 / 1e6:f0} MB
            """);
        Assert.That(bytes.Max(), Is.LessThan(1_000_000));
        Assert.That(merges.Max(r => r.Max(m => m.Inputs.Count)), Is.LessThan(1000));
        Assert.That(merges[^1], Has.Count.EqualTo(1));
    }

    static long BytesOf(CubeGroups.Group group, GridCube[] cells, int tiles) => PlanFile.ToText(json =>
    {
        PlanFile.WriteCubes(json, "cells", cells.AsSpan(group.First, group.Count).ToArray());
        json.WriteStartArray("sources");
        for (int t = 0; t < tiles; t++)
        {
            json.WriteStartObject();
            json.WriteString("path", "s3://usgs-lidar/Projects/STATE_County_QL2_2021_D21/LAZ/tile_123456_123456.laz");
            json.WriteNumber("bytes", 123456789);
            json.WriteStartArray("blocks");
            json.WriteNumbers(0, 15, 1);
            json.WriteEndArray();
            json.WriteEndObject();
        }
        json.WriteEndArray();
    }).Length;
}
