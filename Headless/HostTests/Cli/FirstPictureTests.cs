namespace FastPoints.HostTests.Cli;

public class FirstPictureTests : ScratchPerTest
{
    static void ExpectEmptyEdges(string path)
    {
        var image = Png.Read(path);
        uint background = new PictureOptions().Background;
        int drawn = 0;
        for (int y = 0; y < image.Height; y++)
            for (int x = 0; x < image.Width; x++)
            {
                bool isEdge = x == 0 || y == 0 || x == image.Width - 1 || y == image.Height - 1;
                if (isEdge)
                    Assert.That(image[x, y], Is.EqualTo(background), $"{Path.GetFileName(path)} at {x}, {y}");
                drawn += image[x, y] != background ? 1 : 0;
            }
        Assert.That(drawn, Is.GreaterThan(image.Width * image.Height / 50), path);
    }

    [Test]
    public void MainJob_Street_FramesAllPoints()
    {
        string folder = Scratch["report"];
        var call = CliCall.Of(Scratch.Demo(points: 60_000), "-o", folder, "--plain", "--quiet");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        foreach (string name in new[] { "preview.png", "picture.png", "gpu.png" })
            if (File.Exists(Path.Combine(folder, name)))
                ExpectEmptyEdges(Path.Combine(folder, name));
    }

    [TestCase("top"), TestCase("front"), TestCase("iso")]
    public void Preview_StreetFromAnySide_FramesAllPoints(string view)
    {
        string picture = Scratch["p.png"];
        CliCall.Of("preview", Scratch.Demo(points: 60_000), "-o", picture, "--view", view, "--plain", "--quiet");
        ExpectEmptyEdges(picture);
    }

    [Test]
    public void Preview_LargePoints_FitWithTheirSize()
    {
        string picture = Scratch["p.png"];
        CliCall.Of("preview", Scratch.Demo(points: 60_000), "-o", picture, "--style", "size=60", "--plain", "--quiet");
        ExpectEmptyEdges(picture);
    }

    [Test]
    public void Preview_Legend_IsLeftOutOfPlainPictures()
    {
        string scan = Scratch.Demo(points: 20_000), plain = Scratch["plain.png"], with = Scratch["with.png"];
        CliCall.Of("preview", scan, "-o", plain, "--plain", "--style", "color=elevation");
        CliCall.Of("preview", scan, "-o", with, "--style", "color=elevation");
        var (a, b) = (Png.Read(plain), Png.Read(with));
        int left = 0, right = 0, elsewhere = 0;
        for (int y = 0; y < a.Height; y++)
            for (int x = 0; x < a.Width; x++)
                if (a[x, y] != b[x, y] && y < 560)
                    elsewhere++;
                else if (a[x, y] != b[x, y])
                    (left, right) = x < 640 ? (left + 1, right) : (left, right + 1);
        Assert.That(elsewhere, Is.Zero);
        Assert.That(left, Is.GreaterThan(2000), "a ramp and its ends");
        Assert.That(right, Is.GreaterThan(300), "a length");
    }

    /// <summary>Seen from above, a metre of the picture is as long as its bar says.</summary>
    [Test]
    public void Picture_ScaleBarFromAbove_HasItsLength()
    {
        string file = Scratch["square.xyz"], picture = Scratch["p.png"];
        File.WriteAllLines(file, Enumerable.Range(0, 10_201).Select(i => $"{i % 101} {i / 101} {i % 7 / 10.0}"));
        CliCall.Of("preview", file, "-o", picture, "--view", "top", "--style", "size=1", "--quiet");
        var image = Png.Read(picture);
        uint background = new PictureOptions().Background, ink = Palettes.Pack(235, 235, 235);
        int bar = Enumerable.Range(0, image.Width).Count(x => image[x, image.Height - 21] == ink);
        var columns = Enumerable.Range(0, image.Width).Where(x => Enumerable.Range(40, 580).Any(y =>
            image[x, y] != background)).ToList();
        double pxPerUnit = (columns[^1] - columns[0]) / 100.0;
        Assert.That(bar / pxPerUnit, Is.EqualTo(20).Within(0.5));
    }

    [TestCase("", "Y is taken for up"), TestCase("z", "coloured by")]
    public void Picture_PlyWithYUp_IsGuessedUnlessGiven(string up, string expected)
    {
        string file = Scratch["y.ply"];
        var random = new Unity.Mathematics.Random(3);
        var lines = new List<string> { "ply", "format ascii 1.0", "element vertex 3000", "property float x", "property float y",
            "property float z", "end_header" };
        for (int i = 0; i < 3000; i++)
            lines.Add(string.Create(CultureInfo.InvariantCulture, $"{random.NextDouble(0, 9):0.###} {(i % 2 == 0 ? 0
                : random.NextDouble(0, 4)):0.###} {random.NextDouble(0, 8):0.###}"));
        File.WriteAllLines(file, lines);
        string[] line = ["picture", file, "-o", Scratch["p.png"]];
        var call = CliCall.Of(up == "" ? line : [.. line, "--up", up]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Output, Does.Contain(expected));
        Assert.That(call.Output.Contains("taken for up"), Is.EqualTo(up == ""));
    }

    [TestCase("x", -1, 1, -1), TestCase("y", 1, -1, -1), TestCase("z", 1, -1, -1)]
    public void Picture_NegativeUp_MatchesTheRotatedCloud(string axis, int x, int y, int z)
    {
        var random = new System.Random(5);
        string[] files = [Scratch["down.xyz"], Scratch["turned.xyz"]];
        string[] pictures = [Scratch["down.png"], Scratch["turned.png"]];
        var positions = Enumerable.Range(0, 4000)
            .Select(_ => (x: random.Next(900), y: random.Next(700), z: random.Next(200))).ToList();
        File.WriteAllLines(files[0], positions.Select(p => $"{p.x} {p.y} {p.z}"));
        File.WriteAllLines(files[1], positions.Select(p => $"{x * p.x} {y * p.y} {z * p.z}"));
        foreach (int i in new[] { 0, 1 })
        {
            var call = CliCall.Of("picture", files[i], "-o", pictures[i], "--up", (i == 0 ? "-" : "") + axis, "--size", "320x180",
                "--style", "color=elevation", "--plain");
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        }
        byte[] down = Png.Read(pictures[0]).Rgba, turned = Png.Read(pictures[1]).Rgba;
        Assert.That(down.Zip(turned).Count(p => Math.Abs(p.First - p.Second) > 2), Is.LessThan(down.Length / 100));
    }

    [Test]
    public void MainJob_UpOfNoAxis_IsWrongUsage() =>
        Assert.That(CliCall.Of(Scratch.Demo(), "--up", "w").Status, Is.EqualTo(ExitStatus.Usage));
}
