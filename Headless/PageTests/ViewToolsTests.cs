using FastPoints.HostTests.Shaders;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Sources;
using FastPoints.Tests;

namespace FastPoints.PageTests;

public sealed class ViewToolsTests : BrowserTests
{
    string m_corners, m_demo;

    protected override void MakePages()
    {
        // Corners of a rectangle 30 by 40, where surveyors' coordinates lie.
        string corners = m_scratch["corners.xyz"];
        File.WriteAllText(corners, string.Concat(Enumerable.Range(0, 64).Select(i => (i % 4) switch
        {
            0 => "500000.25 5400000 100\n",
            1 => "500030.25 5400000 100\n",
            2 => "500000.25 5400040 100\n",
            _ => "500030.25 5400040 112\n",
        })));
        m_corners = Report(corners, "corners");
        m_demo = Report(m_scratch.Demo(points: 20_000), "demo");
    }

    /// <summary>By corners' numbers, from above: all of the depth, 40, is seen, with 2 % to spare on either side.</summary>
    async Task ClickCorners(params int[] corners)
    {
        await Click("#view-top");
        var box = await Canvas();
        double perUnit = box!.Height / (1.04 * 40);
        foreach (int corner in corners)
        {
            int frames = await Frames();
            double x = (corner % 2 - 0.5) * 30 * perUnit, y = (0.5 - corner / 2) * 40 * perUnit;
            await m_page.Mouse.ClickAsync((float)(box.X + box.Width / 2 + x), (float)(box.Y + box.Height / 2 + y));
            await NewFrame(frames);
        }
    }

    /// <summary>At the middle's height, so far from the left, or where the nearest points are.</summary>
    async Task ClickPointNear(double share)
    {
        byte[] pixels = await Pixels();
        double x = share * GridWidth, y = GridHeight / 2.0;
        int nearest = Enumerable.Range(0, GridWidth * GridHeight).Where(p => IsCovered(pixels, p))
            .MinBy(p => Math.Pow(p % GridWidth - x, 2) + Math.Pow(p / GridWidth - y, 2));
        var box = await Canvas();
        int frames = await Frames();
        await m_page.Mouse.ClickAsync((float)(box.X + (nearest % GridWidth + 0.5) * box.Width / GridWidth),
            (float)(box.Y + (nearest / GridWidth + 0.5) * box.Height / GridHeight));
        await NewFrame(frames);
    }

    /// <summary>In pixels of the window, all of it.</summary>
    async Task<LocatorBoundingBoxResult> Canvas()
    {
        await m_page.EvaluateAsync("() => document.getElementById('view').scrollIntoView({ block: 'end' })");
        return await m_page.Locator("#view").BoundingBoxAsync();
    }

    async Task<Dictionary<string, string>> Measured()
    {
        string[] texts = await m_page.EvaluateAsync<string[]>(
            "() => [...document.querySelectorAll('#view-measured > *')].map(e => e.textContent)");
        return texts.Chunk(2).ToDictionary(pair => pair[0], pair => pair[1]);
    }

    [Test]
    public async Task Distance_AlongThreePoints_IsTheSumAndHasTheFilesCoordinates()
    {
        await Open(m_corners);
        await Click("#view-distance");
        await ClickCorners(0, 3);
        var measured = await Measured();
        Assert.That(measured["A"], Is.EqualTo("x 500,000.25  y 5,400,000  z 100"));
        Assert.That(measured["B"], Is.EqualTo("x 500,030.25  y 5,400,040  z 112"));
        // The square root of 30^2 + 40^2 + 12^2, and of the first two.
        Assert.That((measured["distance"], measured["level"], measured["rise"]),
            Is.EqualTo(("51.42 units", "50.00 units", "12.00 units")));
        Assert.That(await Text("#view-status"), Does.Contain("distance 51.42"));
        await ClickCorners(1);
        // And of 40^2 + 12^2.
        Assert.That((await Measured())["distance"], Is.EqualTo("93.18 units"));
        await m_page.Keyboard.PressAsync("Backspace");
        Assert.That((await Measured())["distance"], Is.EqualTo("51.42 units"));
        await m_page.Keyboard.PressAsync("Escape");
        Assert.That(await Measured(), Is.Empty);
    }

    [Test]
    public async Task Height_OfTwoPoints_IsTheRiseAndTheSlope()
    {
        await Open(m_corners);
        await Click("#view-height");
        await ClickCorners(1, 3);
        var measured = await Measured();
        Assert.That((measured["rise"], measured["level"], measured["slope"]),
            Is.EqualTo(("12.00 units", "40.00 units", "16.70°")));
    }

    [Test]
    public async Task Angle_OfThreePoints_IsAtTheSecond()
    {
        await Open(m_corners);
        await Click("#view-angle");
        await ClickCorners(1, 0, 2);
        Assert.That((await Measured())["angle"], Is.EqualTo("90.00°"));
        await ClickCorners(0, 1, 2);
        // atan(40 / 30)
        Assert.That((await Measured())["angle"], Is.EqualTo("53.13°"));
    }

    [Test]
    public async Task Area_OfCorners_IsTheirPolygons()
    {
        await Open(m_corners);
        await Click("#view-area");
        await ClickCorners(0, 1, 2);
        var measured = await Measured();
        Assert.That((measured["area"], measured["edge"]), Is.EqualTo(("600.00 units²", "120.00 units")));
        await ClickCorners(3);
        // Half the length of (30, 0, 0) x (0, 40, 0) + (0, 40, 0) x (30, 40, 12), and what of it points up.
        measured = await Measured();
        Assert.That((measured["area"], measured["seen from above"]), Is.EqualTo(("240.00 units²", "0.00 units²")));
    }

    [Test]
    public async Task Point_Picked_HasAllAttributes()
    {
        string[] attributes = CliCall.Of("info", m_scratch["demo.las"], "--json", "-", "--quiet").Json.GetProperty("attributes")
            .EnumerateArray().Select(a => a.GetProperty("name").GetString()).Except(["X", "Y", "Z"]).ToArray();
        await Open(m_demo);
        await Click("#view-top");
        await Click("#view-point");
        await ClickPointNear(0.5);
        var measured = await Measured();
        Assert.That(measured.Keys, Is.EqualTo(attributes.Prepend("A")));
        Assert.That(measured["Classification"], Does.Match("^[0-9]+ [a-z ]+$"));
    }

    [Test]
    public async Task Pointer_OverAPoint_ShowsItsCoordinates()
    {
        await Open(m_corners);
        await Click("#view-top");
        var box = await Canvas();
        double perUnit = box.Height / (1.04 * 40);
        await m_page.Mouse.MoveAsync((float)(box.X + box.Width / 2 + 15 * perUnit),
            (float)(box.Y + box.Height / 2 - 20 * perUnit));
        await m_page.WaitForFunctionAsync("() => document.getElementById('view-under').textContent !== ''");
        Assert.That(await Text("#view-under"), Is.EqualTo("x 500,030.25  y 5,400,040  z 112"));
        await m_page.Mouse.MoveAsync(1, 1);
        await m_page.WaitForFunctionAsync("() => document.getElementById('view-under').textContent === ''");
    }

    [Test]
    public async Task ClipBox_FaceDragged_HidesPointsAndNamesTheBoxForExport()
    {
        await Open(m_demo);
        await Click("#view-top");
        byte[] all = await Pixels();
        await Click("#view-clip");
        await Canvas();
        // From above: least x, greatest x, least y, greatest y, and two in the middle.
        var handle = await m_page.Locator("#view-marks [data-face='1']").BoundingBoxAsync();
        float x = handle!.X + handle.Width / 2, y = handle.Y + handle.Height / 2;
        double[] before = await Corners();
        await m_page.Mouse.MoveAsync(x, y);
        await m_page.Mouse.DownAsync();
        int frames = await Frames();
        await m_page.Mouse.MoveAsync(x - 300, y);
        await m_page.Mouse.UpAsync();
        await NewFrame(frames);
        double[] after = await Corners();
        Assert.That(after[3], Is.LessThan(before[3] - 1));
        Assert.That(after.Where((_, i) => i != 3), Is.EqualTo(before.Where((_, i) => i != 3)));
        await Click("#view-top");
        Assert.That(Difference(await Pixels(), all), Is.GreaterThan(0.01));
        // The line that the page gives exports the points that it shows.
        string[] line = (await Text("#view-box-line")).Split(' ');
        string cut = m_scratch["cut.las"];
        Assert.That(line[..2], Is.EqualTo(new[] { "fastpoints", "export" }));
        Run("export", line[2], line[3], line[4], "-o", cut, "--quiet");
        using var info = JsonDocument.Parse(Run("info", cut, "--json", "-", "--quiet"));
        long exported = info.RootElement.GetProperty("points").GetInt64();
        long shown = await m_page.EvaluateAsync<long>("""
            async box => {
              const data = JSON.parse(document.getElementById("view-data").textContent);
              const set = await unpackSet(data, data.sets.at(-1));
              let inside = 0;
              for (let i = 0; i < set.count; i++)
                inside += pointOf(data, set, i).geo.every((v, k) => v >= box[k] && v <= box[3 + k]) ? 1 : 0;
              return inside;
            }
            """, after);
        Assert.That(exported, Is.EqualTo(shown).And.InRange(1000, 19_900));

        // By itself: what has been awaited goes on in another thread, which the command line refuses.
        static string Run(params string[] arguments)
        {
            var (isGood, said) = Tool.Run("dotnet", [typeof(CliRun).Assembly.Location, .. arguments]);
            Assert.That(isGood, said);
            return said;
        }

        async Task<double[]> Corners() => await m_page.EvaluateAsync<double[]>(
            "() => [...document.querySelectorAll('#view-box input')].map(i => i.valueAsNumber)");
    }

    [Test]
    public async Task Profile_AlongALine_IsDrawnAndWrittenAsCsv()
    {
        await Open(m_demo);
        await Click("#view-profile");
        await Click("#view-top");
        Assert.That(await m_page.Locator("#view-strip").IsVisibleAsync(), Is.False);
        await ClickPointNear(0.4);
        await ClickPointNear(0.6);
        Assert.That(await m_page.Locator("#view-strip").IsVisibleAsync(), Is.True);
        await m_page.FillAsync("#view-strip-width", "5");
        await m_page.Keyboard.PressAsync("Enter");
        var download = await m_page.RunAndWaitForDownloadAsync(() => m_page.ClickAsync("#view-strip-csv"));
        string[] lines = File.ReadAllLines(await download.PathAsync());
        Assert.That(download.SuggestedFilename, Does.EndWith("-profile.csv"));
        Assert.That(lines[0], Does.StartWith("distance,height,X,Y,Z,Intensity,"));
        Assert.That(await Text("#view-strip-text"), Is.EqualTo((lines.Length - 1) + " of the points here"));
        Assert.That(lines, Has.Length.InRange(20, 5000));
        var measured = await Measured();
        double[] a = Place(measured["A"]), b = Place(measured["B"]);
        double length = Math.Sqrt(Math.Pow(b[0] - a[0], 2) + Math.Pow(b[1] - a[1], 2));
        foreach (double[] row in lines.Skip(1).Select(l => l.Split(',').Take(5).Select(double.Parse).ToArray()))
        {
            double along = ((row[2] - a[0]) * (b[0] - a[0]) + (row[3] - a[1]) * (b[1] - a[1])) / length;
            double aside = ((row[2] - a[0]) * (b[1] - a[1]) - (row[3] - a[1]) * (b[0] - a[0])) / length;
            Assert.That(row[0], Is.EqualTo(along).Within(1e-3).And.InRange(-1e-3, length + 1e-3));
            Assert.That(Math.Abs(aside), Is.LessThan(2.501));
            Assert.That(row[1], Is.EqualTo(row[4]).Within(1e-3), "height");
        }
        int drawn = await m_page.EvaluateAsync<int>("""
            () => {
              const canvas = document.getElementById("view-strip-canvas");
              const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data, colors = new Set();
              for (let i = 0; i < pixels.length; i += 4) colors.add(pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2]);
              return colors.size;
            }
            """);
        Assert.That(drawn, Is.GreaterThan(10), "colours");

        static double[] Place(string text) => text.Split("  ").Select(t => double.Parse(t[2..])).ToArray();
    }

    [Test]
    public async Task Range_SliderMoved_ColoursAndHides()
    {
        await Open(m_demo);
        Assert.That(await m_page.Locator("#view-range").IsVisibleAsync(), Is.False, "colours have no range");
        await m_page.SelectOptionAsync("#view-color", "Elevation");
        await Click("#view-top");
        byte[] all = await Pixels();
        string low = await Text("#view-range-low-text");
        int frames = await Frames();
        await m_page.FillAsync("#view-range-low", "500");
        await NewFrame(frames);
        Assert.That(await Text("#view-range-low-text"), Is.Not.EqualTo(low));
        Assert.That(await Text("#view-legend"), Does.Contain(await Text("#view-range-low-text")));
        byte[] ranged = await Pixels();
        Assert.That(Difference(ranged, all), Is.GreaterThan(0.01), "colours");
        frames = await Frames();
        await m_page.CheckAsync("#view-rest");
        await NewFrame(frames);
        int Covered(byte[] pixels) => Enumerable.Range(0, GridWidth * GridHeight).Count(p => IsCovered(pixels, p));
        Assert.That(Covered(await Pixels()), Is.LessThan(0.8 * Covered(ranged)));
    }

    [Test]
    public async Task Link_OfWhatIsShown_ShowsTheSame()
    {
        await Open(m_demo);
        await m_page.SelectOptionAsync("#view-color", "Classification");
        await Click("#view-legend button >> nth=0");
        await Click("#view-clip");
        await m_page.FocusAsync("#view");
        foreach (string key in new[] { "ArrowLeft", "+", "m" })
            await m_page.Keyboard.PressAsync(key);
        double[] ends = await m_page.EvaluateAsync<double[]>(
            "() => [...document.querySelectorAll('#view-box input')].map(i => i.valueAsNumber)");
        string middle = ((ends[0] + 2 * ends[3]) / 3).ToString("0.00", CultureInfo.InvariantCulture);
        await m_page.FillAsync("#view-box input >> nth=3", middle);
        await m_page.FocusAsync("#view");
        await m_page.Keyboard.PressAsync("Enter");
        await m_page.WaitForFunctionAsync("() => /camera=.*box=.*tool=distance/.test(location.hash)");
        await m_page.WaitForTimeoutAsync(400);
        string fragment = await m_page.EvaluateAsync<string>("() => location.hash");
        byte[] shown = await Pixels();
        Assert.That(Enumerable.Range(0, GridWidth * GridHeight).Count(p => IsCovered(shown, p)), Is.GreaterThan(500));
        var measured = await Measured();
        await IsSilent();
        await Open(m_demo, fragment: fragment);
        Assert.That(Difference(await Pixels(), shown), Is.LessThan(0.001));
        Assert.That(await Measured(), Is.EqualTo(measured));
        Assert.That(await m_page.GetAttributeAsync("#view-legend button >> nth=0", "aria-pressed"), Is.EqualTo("false"));
        Assert.That(await m_page.GetAttributeAsync("#view-distance", "aria-pressed"), Is.EqualTo("true"));
        await IsSilent();
        await Open(m_demo, fragment: "#camera=1,2&color=%00&box=1,2,x&tool=saw&points=1;2&range=9,1&size=nine");
        Assert.That(await m_page.Locator("#view").IsVisibleAsync(), "a broken link");
    }

    static IEnumerable<FormatFixture> Formats => FormatFixture.All.Where(f => !f.IsSample);

    [TestCaseSource(nameof(Formats))]
    public async Task Points_OfEveryFormat_HaveTheFilesNumbers(FormatFixture fixture)
    {
        string folder = m_scratch[fixture.ToString()];
        Directory.CreateDirectory(folder);
        string cloud = fixture.Write(folder);
        string report = Report(cloud, fixture + "-report");
        var (columns, file, types, transform) = FileValues(cloud);
        await Open(report);
        using var shown = JsonDocument.Parse(await m_page.EvaluateAsync<string>("""
            async () => {
              const data = JSON.parse(document.getElementById("view-data").textContent);
              const set = await unpackSet(data, data.sets.at(-1));
              const stored = (c, k, i) => c.kind === "constant" ? Number(c.value.split(" ")[0]) : set.columns[k][i];
              return JSON.stringify({ columns: data.columns.map(c => c.name), points: [...Array(set.count).keys()].map(i => ({
                texts: pointOf(data, set, i).texts,
                values: [...set.positions.map(v => v[i]), ...data.columns.map((c, k) => stored(c, k, i))].map(String) })) });
            }
            """));
        var names = s_axes.Concat(shown.RootElement.GetProperty("columns").EnumerateArray()
            .Select(c => c.GetString())).ToList();
        Assert.That(names, Is.EquivalentTo(columns));
        var page = shown.RootElement.GetProperty("points").EnumerateArray().Select(p => (
            Values: columns.Select(c => Number(p.GetProperty("values")[names.IndexOf(c)].GetString())).ToArray(),
            Texts: p.GetProperty("texts").EnumerateArray().Select(t => t.GetString()).ToArray()))
            .OrderBy(p => p.Values, s_byValues).ToList();
        // A page leaves out what lies far away, as some points of LAZ do here.
        Assert.That(page, Has.Count.LessThanOrEqualTo(file.Count).And.Count.GreaterThan(file.Count / 2));
        int next = 0;
        foreach (var (values, texts) in page)
        {
            while (next < file.Count && s_byValues.Compare(file[next], values) < 0)
                next++;
            Assert.That(values, Is.EqualTo(next < file.Count ? file[next] : null), "point " + next);
            for (int axis = 0; axis < 3; axis++)
                AssertExact(texts[axis], types[axis], transform.Scale[axis], transform.Offset[axis], values[axis]);
            next++;
        }
    }

    static double Number(string text) => text == "Infinity" ? double.PositiveInfinity : text == "-Infinity"
        ? double.NegativeInfinity : double.Parse(text, CultureInfo.InvariantCulture);

    static readonly string[] s_axes = ["X", "Y", "Z"];

    static readonly IComparer<double[]> s_byValues = Comparer<double[]>.Create((a, b) =>
        a.Zip(b, (x, y) => x.CompareTo(y)).FirstOrDefault(c => c != 0));

    static (string[] Columns, List<double[]> Values, AttributeType[] Types, PositionTransform Transform) FileValues(string cloud)
    {
        using var reader = PointReaders.Open(cloud);
        string[] columns = [.. s_axes, .. reader.Info.Schema.Select(a => a.Name).Except(s_axes)];
        reader.Info.ExtraSampledAttributes = columns;
        if (!reader.BlocksAreKnown)
            JobCoroutine.RunToEnd(reader.IndexBlocks());
        using var sampler = new PreviewWaveSampler(reader, 100_000, 1);
        JobCoroutine.RunToEnd(sampler.Run(0, null));
        using var sample = sampler.TakeSample();
        var points = sample.Points;
        byte[] bytes = points.Bytes.ToArray();
        var values = Enumerable.Range(0, points.Count).Select(i => columns.Select(name => Stored(name, i)).ToArray())
            .Where(v => v.Take(3).All(double.IsFinite)).Order(s_byValues).ToList();
        return (columns, values, s_axes.Select(a => points.Schema[points.Schema.IndexOf(a)].Type).ToArray(),
            reader.Info.Transform);

        unsafe double Stored(string name, int point)
        {
            var column = points.Column(points.Schema.IndexOf(name));
            double value;
            fixed (byte* first = bytes)
                ColumnValues.ToDoubles(first + column.OffsetBytes, column.Type, point, 1, &value);
            return value;
        }
    }

    /// <summary>Integers in decimals, which are not rounded to doubles; floats as numbers that read back as the same.</summary>
    static void AssertExact(string text, AttributeType type, double scale, double offset, double stored)
    {
        if (type is AttributeType.Float32)
            Assert.That(float.Parse(text, CultureInfo.InvariantCulture), Is.EqualTo((float)stored));
        else if (type is AttributeType.Float64)
            Assert.That(Number(text), Is.EqualTo(stored * scale + offset));
        else
            Assert.That(decimal.Parse(text, CultureInfo.InvariantCulture),
                Is.EqualTo((decimal)stored * (decimal)scale + (decimal)offset));
    }
}
