namespace FastPoints.HostTests.Gpu;

/// <summary>A post of 4 m, 40 cm wide, on flat ground of white points, and light from the east at 45 degrees.</summary>
public sealed class ShadowTests : GraphicsFixture
{
    const int EdgePx = 640;
    const double HeightGeo = 6.4;
    const float Post = 10, HalfPost = 0.2f, PostHeight = 4;

    ScratchFolder m_scratch;
    string m_cloud;

    [OneTimeSetUp]
    public void MakeCloud()
    {
        m_scratch = new ScratchFolder();
        var points = new List<double3>();
        for (int i = 0; i < 201 * 201; i++)
            points.Add(new double3(i % 201 * 0.1, i / 201 * 0.1, 0));
        // As dense as the map's texels.
        for (int i = 0; i < 301 * 301; i++)
            points.Add(new double3(14 + i % 301 * 0.01, 3.5 + i / 301 * 0.01, 0));
        for (int row = 0; row <= 400; row++)
            for (int i = 0; i <= 40; i++)
            {
                double along = Post - HalfPost + i * 0.01;
                points.Add(new double3(Post - HalfPost, along, row * 0.01));
                points.Add(new double3(Post + HalfPost, along, row * 0.01));
                if (row <= 40)
                    points.Add(new double3(Post - HalfPost + row * 0.01, along, PostHeight));
            }
        var text = new StringBuilder("ply\nformat ascii 1.0\nelement vertex " + points.Count + "\nproperty double x\n" +
            "property double y\nproperty double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n");
        foreach (var p in points)
            text.Append(string.Create(CultureInfo.InvariantCulture, $"{p.x:0.###} {p.y:0.###} {p.z:0.###} 200 200 200\n"));
        File.WriteAllText(m_scratch["post.ply"], text.ToString());
        m_cloud = m_scratch["post.fastpoints"];
        var call = CliCall.Of("convert", m_scratch["post.ply"], "-o", m_cloud, "--quiet");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
    }

    [OneTimeTearDown]
    public void DeleteCloud() => m_scratch?.Dispose();

    TwinStreams Streams(double3 offset, string light = "90,45,1", bool hasShadows = true)
    {
        var options = new PictureOptions
        {
            WidthPx = EdgePx,
            HeightPx = EdgePx,
            PointSizePx = 14,
            Color = ColorMode.Rgb,
            EdlStrength = 0,
            Shadows = hasShadows,
        };
        Assert.That(options.SetStyle("light", light), Is.Null);
        return new TwinStreams(m_cloud, options, 1_000_000, placement =>
        {
            placement.OriginWorld += offset;
            return placement;
        });
    }

    static PictureCamera Above(double3 place) =>
        PictureCamera.Orthographic(place + new double3(0, 0, 50), place, new double3(0, 1, 0), HeightGeo);

    static bool[] Shaded(RgbaImage image) =>
        Enumerable.Range(0, EdgePx * EdgePx).Select(i => (image[i % EdgePx, i / EdgePx] & 255) < 130).ToArray();

    /// <summary>In metres, the part of a row or column of pixels that is shaded.</summary>
    static (double From, double To) Part(IEnumerable<bool> shaded, double first)
    {
        var at = shaded.Select((isShaded, i) => (isShaded, Place: first + i * HeightGeo / EdgePx)).Where(p => p.isShaded);
        return (at.First().Place, at.Last().Place);
    }

    [TestCase(0), TestCase(1e9)]
    public void Draw_PostOnTheGround_ShadesWhereGeometrySays(double offset)
    {
        using var streams = Streams(offset);
        var camera = Above(new double3(7, Post, 0) + offset);
        var pictures = streams.Draw(camera);
        double texel = streams.ShadowMapProjection(camera).TexelWorld;
        Assert.That(texel, Is.InRange(0.005, 0.02));
        Assert.That(streams.ShareThatDiffers(pictures, out _, 1), Is.LessThan(0.003));
        foreach (var image in new[] { pictures.Cpu, pictures.Gpu })
        {
            var shaded = Shaded(image);
            double left = 7 - HeightGeo / 2, within = texel + HeightGeo / EdgePx;
            // Along the middle of the shadow, up to the post, and across it.
            var along = Part(shaded.Skip(EdgePx / 2 * EdgePx).Take(EdgePx).TakeWhile((_, i) =>
                left + i * HeightGeo / EdgePx < Post - HalfPost - 0.1), left);
            Assert.That(along.From, Is.EqualTo(Post - HalfPost - PostHeight).Within(within));
            Assert.That(along.To, Is.GreaterThan(Post - HalfPost - 0.1 - 0.02));
            int column = (int)((7.5 - left) * EdgePx / HeightGeo);
            var across = Part(Enumerable.Range(0, EdgePx).Select(row => shaded[row * EdgePx + column]), Post - HeightGeo / 2);
            Assert.That(across.From, Is.EqualTo(Post - HalfPost).Within(within));
            Assert.That(across.To, Is.EqualTo(Post + HalfPost).Within(within));
        }
    }

    /// <summary>The camera moves by whole pixels, the map by other steps.</summary>
    [Test]
    public void Draw_CameraMoves_ShadesTheSameGround()
    {
        using var streams = Streams(0);
        var first = Shaded(streams.Draw(Above(new double3(7, Post, 0))).Gpu);
        Assert.That(first.Count(isShaded => isShaded), Is.GreaterThan(10_000));
        foreach (int moved in new[] { 1, 7, 40, 130 })
        {
            var then = Shaded(streams.Draw(Above(new double3(7 + moved * HeightGeo / EdgePx, Post, 0))).Gpu);
            int differ = 0;
            for (int i = 0; i < EdgePx * EdgePx; i++)
                differ += i % EdgePx >= moved && first[i] != then[i - moved] ? 1 : 0;
            Assert.That(differ, Is.LessThan(0.0003 * EdgePx * EdgePx), moved + " pixels");
        }
    }

    /// <summary>Nothing shades ground beside the post, from wherever light comes.</summary>
    [TestCase("90,80,1"), TestCase("60,45,1"), TestCase("33,20,1"), TestCase("90,8,1")]
    public void Draw_FlatGround_DoesNotShadeItself(string light)
    {
        using var streams = Streams(0, light);
        using var without = Streams(0, light, false);
        var camera = Above(new double3(15.5, 5, 0));
        Assert.That(streams.Draw(camera).Gpu.Rgba, Is.EqualTo(without.Draw(camera).Gpu.Rgba));
    }

    /// <summary>Texels are those of one grid, halved or doubled, which rests in the world.</summary>
    [TestCase(0), TestCase(1e9)]
    public void Fit_AnyCamera_LiesOnOneGrid(double offset)
    {
        var place = new double3(5, 6, 0) + offset;
        for (int i = 0; i < 50; i++)
        {
            var eye = new double3(3 + i * 0.37, 10 - i * 0.2, 8) + offset;
            var camera = PictureCamera.Perspective(eye, eye + new double3(0.3, 1, -2), new double3(0, 0, 1), 60);
            var frame = new ShadowMapProjection(new float3(0.4f, 0.3f, 0.8f), 1);
            frame.Add(camera.ToStreamView(640, 360), new CloudPlacement(double3x3.identity, offset), 50,
                new double3(50, 50, 50));
            frame.Fit();
            Assert.That(Math.Log2(frame.TexelWorld) % 1, Is.Zero);
            double steps = math.dot(frame.MiddleWorld, frame.Right) / (64 * frame.TexelWorld);
            Assert.That(steps, Is.EqualTo(math.round(steps)).Within(1e-5));
            var shadow = frame.From(eye);
            Assert.That(math.dot(shadow.Column, (float3)(place - eye)) + shadow.Eye.x,
                Is.EqualTo(512 + math.dot(place - frame.MiddleWorld, frame.Right) / frame.TexelWorld).Within(1e-3));
        }
    }
}
