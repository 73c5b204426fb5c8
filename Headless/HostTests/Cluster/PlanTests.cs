using Random = System.Random;

namespace FastPoints.HostTests.Cluster;

public sealed class PlanTests
{
    static readonly GridCube s_whole = new(new Grid3(-500, 100, -7), 10);

    // Of random sizes, in Morton order.
    static GridCube[] Cubes(GridCube cube, Random random) => cube.SideLog2 < 3 || cube.SideLog2 < 10 && random.Next(4) > 0
        ? [cube] : Enumerable.Range(0, 8).SelectMany(octant => Cubes(cube.Child(octant), random)).ToArray();

    [Test]
    public void Find_OfBoxes_GivesTheCubesThatTouch()
    {
        var random = new Random(1);
        for (int i = 0; i < 200; i++)
        {
            // As where some tasks have nothing to read.
            var cubes = Cubes(s_whole, random).Where(_ => random.Next(5) > 0).ToArray();
            long Number() => random.Next(-700, 1300);
            var (a, b) = (new Grid3(Number(), Number(), Number()), new Grid3(Number(), Number(), Number()));
            var (min, max) = i % 10 == 0 ? (Grid3.MinValue, Grid3.MaxValue) : (Grid3.Min(a, b), Grid3.Max(a, b));
            var found = new List<int>();
            new CubeFinder(s_whole, cubes).Find(min, max, found);
            Assert.That(found, Is.EqualTo(Enumerable.Range(0, cubes.Length).Where(c =>
                Grid3.Max(cubes[c].Corner, min) == Grid3.Min(Grid3.Max(cubes[c].Corner, min), max)
                && cubes[c].Contains(Grid3.Min(Grid3.Max(cubes[c].Corner, min), max)))));
        }
    }

    [Test]
    public void Tree_OfAnyCubes_MergesEachOnceInACubeThatHoldsIt()
    {
        var random = new Random(2);
        for (int i = 0; i < 100; i++)
        {
            var cubeOf = Cubes(s_whole, random).Select((cube, n) => (Name: "build-" + n, Cube: cube))
                .ToDictionary(t => t.Name, t => t.Cube);
            var rounds = MergeTree.Of(s_whole, cubeOf.Select(t => (t.Key, t.Value)));
            foreach (var merge in rounds.SelectMany(r => r))
            {
                Assert.That(merge.Inputs.All(input => merge.Cube.ContainsAligned(cubeOf[input])), merge.Name);
                Assert.That(merge.Inputs.Count, Is.InRange(merge.Cube.SideLog2 == s_whole.SideLog2 ? 1 : 2, 512));
                cubeOf.Add(merge.Name, merge.Cube);
            }
            var inputs = rounds.SelectMany(r => r).SelectMany(m => m.Inputs).ToArray();
            string last = rounds[^1].Single().Name;
            Assert.That(inputs, Is.EquivalentTo(cubeOf.Keys.Where(name => name != last)));
        }
    }

    [Test]
    public void Tasks_OfBuildsOfAnySize_HaveEachOnceAndAreNoLarger()
    {
        var random = new Random(3);
        var points = Enumerable.Range(0, 500).Select(_ => Math.Pow(random.NextDouble(), 5) * 100).ToArray();
        var tasks = BuildAssignment.Of(points, 70);
        var builds = Enumerable.Range(0, tasks.BuildTasks).Select(task => tasks.Of(task).ToArray()).ToArray();
        Assert.That(builds.SelectMany(b => b), Is.EqualTo(Enumerable.Range(0, points.Length)));
        Assert.That(builds.Where(b => b.Length > 1).Max(b => b.Sum(build => points[build])), Is.InRange(60, 70));
        Assert.That(builds.SelectMany((b, task) => b.Select((_, part) => TaskNames.Build(task, part))), Is.EqualTo(tasks.Names));
        Assert.That(tasks.Names, Is.Unique);
    }

    [Test]
    public void Read_OfATextThatWasChanged_IsRefused()
    {
        string text = PlanFile.ToText(json => json.WriteNumber("a", 12));
        Assert.That(PlanFile.Parse(text, "x").Long("a"), Is.EqualTo(12));
        Assert.That(() => PlanFile.Parse(text.Replace("12", "13"), "x"),
            Throws.TypeOf<PointCloudException>().With.Message.Contains("hash"));
    }

    [Test]
    public void Plan_OfManyTiles_HasTasksOfTheirSizeAndSmallFiles()
    {
        using var cloud = new ClusterCloud();
        const int side = 40, points = 60, step = 100_000;
        byte[] tile = File.ReadAllBytes(cloud.Scratch.Demo("tile.las", points));
        int records = BitConverter.ToInt32(tile, 96), stride = BitConverter.ToUInt16(tile, 105);
        double scale = BitConverter.ToDouble(tile, 131);
        double x = BitConverter.ToDouble(tile, 155), y = BitConverter.ToDouble(tile, 163);
        var random = new Random(3);
        for (int i = 0; i < points; i++)
            for (int axis = 0; axis < 2; axis++)
                BitConverter.TryWriteBytes(tile.AsSpan(records + i * stride + 4 * axis), random.Next(step));
        Directory.CreateDirectory(cloud.Scratch["tiles"]);
        for (int t = 0; t < side * side; t++)
        {
            double left = x + t % side * step * scale, low = y + t / side * step * scale;
            foreach (var (at, value) in new[] { (155, left), (163, low), (179, left + (step - 1) * scale),
                (187, left), (195, low + (step - 1) * scale), (203, low) })
                BitConverter.TryWriteBytes(tile.AsSpan(at), value);
            File.WriteAllBytes(cloud.Scratch["tiles/" + t.ToString("d4") + ".las"], tile);
        }
        cloud.MakePlan("tiles", 20_000, "--cells");
        Assert.That(cloud.Count("tasks"), Is.InRange(6, 40));
        foreach (string file in Directory.GetFiles(cloud.Scratch["plan.parts"], "build-*.json"))
        {
            using var json = JsonDocument.Parse(File.ReadAllText(file));
            Assert.That(json.RootElement.GetProperty("sources").GetArrayLength() * points, Is.LessThan(2 * 20_000), file);
            Assert.That(new FileInfo(file).Length, Is.LessThan(1 << 20));
        }
        Assert.That(new FileInfo(cloud.Plan).Length, Is.LessThan(100_000));
    }

    [Test]
    public void Plan_OfPatternsAndLists_TakesTheFiles()
    {
        using var cloud = new ClusterCloud();
        string Sources() => File.ReadAllText(cloud.Scratch["plan.parts/sources.json"]);
        string folder = cloud.Sources("tiles");
        ClusterCloud.Done("plan", Path.Combine(folder, "1-*.las"), "-o", cloud.Plan, "--store", cloud.Store, "--quiet");
        Assert.That(Sources(), Does.Contain("1-3.las").And.Not.Contain("2-0.las"));
        File.WriteAllLines(cloud.Scratch["list.txt"], ["", Path.Combine(folder, "0-*.las"), Path.Combine(folder, "2-0.las")]);
        ClusterCloud.Done("plan", "@" + cloud.Scratch["list.txt"], "-o", cloud.Plan, "--store", cloud.Store, "--quiet",
            "--force");
        Assert.That(Sources(), Does.Contain("0-3.las").And.Contain("2-0.las"));
        Assert.That(CliCall.Of("plan", Path.Combine(folder, "*.e57"), "-o", cloud.Plan, "--store", cloud.Store).Status,
            Is.EqualTo(ExitStatus.BadInput));
        Assert.That(CliCall.Of("plan", folder, "-o", cloud.Plan, "--store", cloud.Store, "--every-nth", "2").Status,
            Is.EqualTo(ExitStatus.Usage));
    }
}
