namespace FastPoints.Cli.Cluster;

/// <summary>A task of the merges: what is left open of its inputs, in a cube that holds theirs.</summary>
/// <param name="Inputs">Names of tasks.</param>
sealed record MergeTask(string Name, GridCube Cube, List<string> Inputs);

/// <summary>Which tops are merged with which: two levels of the octree a round, and all that are left in the last one.</summary>
static class MergeTree
{
    const int LevelsAtOnce = 2;

    /// <returns>The tasks of each round; the last one has one.</returns>
    /// <param name="tasks">Names and cubes of the builds, in Morton order.</param>
    public static List<List<MergeTask>> Of(GridCube whole, IEnumerable<(string Name, GridCube Cube)> tasks)
    {
        var open = tasks.ToList();
        var rounds = new List<List<MergeTask>>();
        for (int side = open.Min(t => t.Cube.SideLog2) + LevelsAtOnce; side < whole.SideLog2; side += LevelsAtOnce)
        {
            var round = new List<MergeTask>();
            var left = new List<(string, GridCube)>();
            foreach (var group in open.GroupBy(t => CubeAbove(whole, t.Cube, side)))
            {
                var inputs = group.ToList();
                if (inputs.Count == 1)
                {
                    left.Add(inputs[0]);
                    continue;
                }
                string name = TaskNames.Merge(rounds.Count + 1, round.Count);
                round.Add(new MergeTask(name, group.Key, inputs.ConvertAll(i => i.Name)));
                left.Add((name, group.Key));
            }
            open = left;
            if (round.Count > 0)
                rounds.Add(round);
        }
        rounds.Add([new MergeTask(TaskNames.Merge(rounds.Count + 1, 0), whole, open.ConvertAll(t => t.Name))]);
        return rounds;
    }

    /// <summary>The cube of a size that holds another one; that one if it is as large.</summary>
    static GridCube CubeAbove(GridCube whole, GridCube cube, int sideLog2)
    {
        if (cube.SideLog2 >= sideLog2)
            return cube;
        var offset = cube.Corner - whole.Corner;
        return new GridCube(whole.Corner + new Grid3(offset.X >> sideLog2 << sideLog2, offset.Y >> sideLog2 << sideLog2,
            offset.Z >> sideLog2 << sideLog2), sideLog2);
    }
}

/// <summary>Which task builds what: each some cubes, one after the other, in Morton order.</summary>
/// <param name="First">By task, its first build.</param>
sealed record BuildAssignment(long[] First, int BuildCount)
{
    public int BuildTasks => First.Length;
    public IEnumerable<string> Names => Enumerable.Range(0, BuildCount).Select(NameOf);

    /// <param name="points">Of each build.</param>
    /// <param name="most">Points of a task of several.</param>
    public static BuildAssignment Of(IReadOnlyList<double> points, double most)
    {
        var first = new List<long>();
        double sum = 0;
        for (int build = 0; build < points.Count; build++)
        {
            if (build == 0 || sum + points[build] > most)
            {
                first.Add(build);
                sum = 0;
            }
            sum += points[build];
        }
        return new BuildAssignment([.. first], points.Count);
    }

    public IEnumerable<int> Of(int task) =>
        Enumerable.Range((int)First[task], (int)((task + 1 < BuildTasks ? First[task + 1] : BuildCount) - First[task]));

    public string NameOf(int build)
    {
        int found = Array.BinarySearch(First, build);
        int task = found < 0 ? ~found - 1 : found;
        return TaskNames.Build(task, build - (int)First[task]);
    }
}

static class TaskNames
{
    public static string Build(int task, int part) =>
        Of("build", task) + (part == 0 ? "" : "-" + part.ToString(CultureInfo.InvariantCulture));
    public static string Bucket(int number) => Of("bucket", number);
    public static string Merge(int round, int number) => Of("merge-" + round.ToString(CultureInfo.InvariantCulture), number);

    static string Of(string what, int number) => what + "-" + number.ToString("d6", CultureInfo.InvariantCulture);
}
