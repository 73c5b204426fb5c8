namespace FastPoints.HostTests.Cli;

public sealed class SurfaceTests : ScratchTests
{
    string m_cloud;

    [OneTimeSetUp]
    public void MakeCloud() => m_cloud = Scratch.Converted("street.fastpoints", 200_000);
    const string Box = "441048,5611993,110,441068,5612009,140"; // Around a station of the scanner.

    CliCall Make(string output, params string[] args) =>
        CliCall.Of(["surface", m_cloud, "-o", Scratch[output], "--json", "-", .. args]);

    static (List<double3> Vertices, List<int3> Triangles) ReadPly(string path)
    {
        byte[] bytes = File.ReadAllBytes(path);
        const string end = "end_header\n";
        string text = Encoding.Latin1.GetString(bytes, 0, Math.Min(bytes.Length, 1000));
        int CountOf(string element) => int.Parse(Regex.Match(text, "element " + element + " (\\d+)").Groups[1].Value);
        using var reader = new BinaryReader(new MemoryStream(bytes));
        reader.BaseStream.Position = text.IndexOf(end, StringComparison.Ordinal) + end.Length;
        var vertices = new List<double3>();
        for (int i = CountOf("vertex"); i > 0; i--)
            vertices.Add(new double3(reader.ReadDouble(), reader.ReadDouble(), reader.ReadDouble()));
        var triangles = new List<int3>();
        for (int i = CountOf("face"); i > 0; i--)
        {
            Assert.That(reader.ReadByte(), Is.EqualTo(3));
            triangles.Add(new int3(reader.ReadInt32(), reader.ReadInt32(), reader.ReadInt32()));
        }
        Assert.That(reader.BaseStream.Position, Is.EqualTo(bytes.Length));
        return (vertices, triangles);
    }

    [Test]
    public void Surface_OfAStreet_IsClosedAndWhereItsPointsAre()
    {
        // Crowns are full of points; of those a surface has the outermost.
        var call = Make("a.ply", "--voxel", "0.25", "--clip", Box, "--where", "Classification != 5");
        Assert.That(call.Status, Is.Zero, call.Error);
        var (vertices, triangles) = ReadPly(Scratch["a.ply"]);
        Assert.That(call.Json.GetProperty("vertices").GetInt64(), Is.EqualTo(vertices.Count));
        Assert.That(call.Json.GetProperty("triangles").GetInt64(), Is.EqualTo(triangles.Count).And.GreaterThan(5000));
        Assert.That(call.Json.GetProperty("points").GetInt64(), Is.InRange(1000, 199_999));
        var distance = call.Json.GetProperty("distance");
        Assert.That(distance.GetProperty("p50").GetDouble(), Is.LessThan(0.1));
        Assert.That(distance.GetProperty("p95").GetDouble(), Is.LessThan(0.25));
        Assert.That(distance.GetProperty("max").GetDouble(), Is.LessThan(0.5));
        foreach (var vertex in vertices)
            Assert.That(vertex.x > 441047 && vertex.x < 441069 && vertex.y > 5611992 && vertex.y < 5612010, vertex.ToString());
        var balance = new Dictionary<(int, int), int>();
        foreach (var t in triangles)
            foreach (var (a, b) in new[] { (t.x, t.y), (t.y, t.z), (t.z, t.x) })
                balance[(Math.Min(a, b), Math.Max(a, b))] = balance.GetValueOrDefault((Math.Min(a, b), Math.Max(a, b)))
                    + (a < b ? 1 : -1);
        Assert.That(balance.Values, Has.All.Zero);
    }

    [Test]
    public void Surface_AsObj_HasTheSameTriangles()
    {
        Assert.That(Make("b.ply", "--voxel", "0.5", "--clip", Box).Status, Is.Zero);
        Assert.That(Make("b.obj", "--voxel", "0.5", "--clip", Box).Status, Is.Zero);
        var (vertices, triangles) = ReadPly(Scratch["b.ply"]);
        string[] lines = File.ReadAllLines(Scratch["b.obj"]);
        Assert.That(lines.Count(l => l.StartsWith("v ", StringComparison.Ordinal)), Is.EqualTo(vertices.Count));
        double[] first = [.. lines.First(l => l.StartsWith("v ", StringComparison.Ordinal))[2..].Split(' ')
            .Select(v => double.Parse(v, CultureInfo.InvariantCulture))];
        Assert.That(math.distance(new double3(first[0], first[1], first[2]), vertices[0]), Is.LessThan(1e-3));
        Assert.That(lines.Where(l => l.StartsWith("f ", StringComparison.Ordinal)),
            Is.EqualTo(triangles.Select(t => $"f {t.x + 1} {t.y + 1} {t.z + 1}")));
    }

    [Test]
    public void Surface_OfClasses_LeavesOutTheOthers()
    {
        var all = Make("all.ply", "--voxel", "0.5", "--clip", Box).Json;
        var ground = Make("ground.ply", "--voxel", "0.5", "--clip", Box, "--classes", "2").Json;
        Assert.That(ground.GetProperty("points").GetInt64(), Is.InRange(1, all.GetProperty("points").GetInt64() - 1));
        // The street and its pavements are flat.
        Assert.That(ReadPly(Scratch["ground.ply"]).Vertices.Max(v => v.z),
            Is.LessThan(ReadPly(Scratch["all.ply"]).Vertices.Max(v => v.z) - 1));
    }

    [Test]
    public void Surface_OnAnyNumberOfThreads_IsTheSameFile()
    {
        Assert.That(Make("one.ply", "--voxel", "0.5", "--threads", "1").Status, Is.Zero);
        Assert.That(Make("two.ply", "--voxel", "0.5", "--threads", "2").Status, Is.Zero);
        Assert.That(File.ReadAllBytes(Scratch["two.ply"]), Is.EqualTo(File.ReadAllBytes(Scratch["one.ply"])));
    }

    [Test]
    public void Surface_WithoutPoints_IsEmptyAndSaysSo()
    {
        var call = Make("none.ply", "--clip", "0,0,0,1,1,1");
        Assert.That(call.Status, Is.Zero);
        Assert.That(call.Json.GetProperty("triangles").GetInt64(), Is.Zero);
        Assert.That(call.Json.GetProperty("distance").GetProperty("max").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(call.Error, Does.Contain("no point is left"));
    }

    [TestCase("x.stl"), TestCase("x.ply", "--voxel", "0"), TestCase("x.ply", "--hole", "1"),
     TestCase("x.ply", "--every-nth", "2"), TestCase("x.ply", "--clip", "1,2")]
    public void Surface_OfWhatCannotBe_IsWrongUsage(string output, params string[] args)
    {
        Assert.That(Make(output, args).Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(File.Exists(Scratch[output]), Is.False);
    }

    [Test]
    public void Surface_OfASource_SaysWhatToDo()
    {
        var call = CliCall.Of("surface", Scratch.Demo(), "-o", Scratch["y.ply"]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
        Assert.That(call.Error, Does.Contain("./fastpoints convert"));
    }

    [Test]
    public void Surface_OverAForeignFile_IsRefusedWithoutForce()
    {
        File.WriteAllText(Scratch["mine.obj"], "v 0 0 0\n");
        Assert.That(Make("mine.obj", "--voxel", "1").Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(File.ReadAllText(Scratch["mine.obj"]), Is.EqualTo("v 0 0 0\n"));
        Assert.That(Make("mine.obj", "--voxel", "1", "--force").Status, Is.Zero);
    }

    [Test]
    public void Surface_Cancelled_LeavesNothing()
    {
        using var cancellation = new CancellationTokenSource();
        cancellation.Cancel();
        var call = CliCall.Of(cancellation.Token, "surface", m_cloud, "-o", Scratch["stopped.ply"]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Cancelled));
        Assert.That(Directory.GetFiles(Scratch.Root, "stopped*"), Is.Empty);
    }
}
