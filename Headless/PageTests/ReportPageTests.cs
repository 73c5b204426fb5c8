namespace FastPoints.PageTests;

public sealed class ReportPageTests : BrowserTests
{
    string m_report;

    protected override void MakePages() => m_report = Report(m_scratch.Demo(points: 60_000), "demo");

    static byte[] Small(RgbaImage image)
    {
        int step = image.Width / GridWidth;
        byte[] small = new byte[4 * GridWidth * GridHeight];
        for (int i = 0; i < small.Length; i++)
        {
            int x = i / 4 % GridWidth * step, y = i / 4 / GridWidth * step, sum = 0;
            for (int p = 0; p < step * step; p++)
                sum += image.Rgba[4 * ((y + p / step) * image.Width + x + p % step) + i % 4];
            small[i] = (byte)(sum / (step * step));
        }
        return small;
    }

    [Test]
    public async Task View_FirstPicture_IsTheCommandLines()
    {
        await Open(m_report);
        byte[] shown = await Pixels(), drawn = Small(Png.Read(Path.Combine(m_scratch["demo"], "preview.png")));
        int both = 0, either = 0;
        double difference = 0;
        for (int p = 0; p < GridWidth * GridHeight; p++)
        {
            bool isShown = IsCovered(shown, p), isDrawn = IsCovered(drawn, p);
            either += isShown || isDrawn ? 1 : 0;
            if (!isShown || !isDrawn)
                continue;
            both++;
            difference += Enumerable.Range(0, 3).Average(c => Math.Abs(shown[4 * p + c] - drawn[4 * p + c]));
        }
        TestContext.Out.WriteLine($"overlap {both / (double)either:0.000}, difference {difference / both:0.0} of 255");
        Assert.That(both / (double)either, Is.GreaterThan(0.88), "silhouettes");
        Assert.That(difference / both, Is.LessThan(20), "colours");
    }

    [Test]
    public async Task View_Buttons_ChangeWhatIsShown()
    {
        await Open(m_report);
        byte[] home = await Pixels();
        foreach (string view in new[] { "#view-top", "#view-front", "#view-side" })
        {
            await Click(view);
            Assert.That(Difference(await Pixels(), home), Is.GreaterThan(0.05), view);
        }
        await Click("#view-home");
        Assert.That(Difference(await Pixels(), home), Is.LessThan(0.001), "home again");
        bool wasShaded = await m_page.GetAttributeAsync("#view-shade", "aria-pressed") == "true";
        await Click("#view-shade");
        Assert.That(await m_page.GetAttributeAsync("#view-shade", "aria-pressed"), Is.EqualTo(wasShaded ? "false" : "true"));
        Assert.That(Difference(await Pixels(), home), Is.GreaterThan(0.01), "shading");
        foreach (string color in await m_page.Locator("#view-color option").AllInnerTextsAsync())
        {
            int frames = await Frames();
            await m_page.SelectOptionAsync("#view-color", color);
            await m_page.WaitForFunctionAsync("n => Number(document.getElementById('view').dataset.frames) >= n", frames);
            Assert.That(await m_page.Locator("#view-legend > *").CountAsync(), color == "Colour" ? Is.Zero : Is.Positive, color);
        }
        await m_page.SelectOptionAsync("#view-color", "Classification");
        byte[] all = await Pixels();
        await Click("#view-legend button >> nth=0");
        Assert.That(Difference(await Pixels(), all), Is.GreaterThan(0.001), "a class is hidden");
    }

    [Test]
    public async Task View_Keys_TurnMoveAndZoom()
    {
        await Open(m_report);
        await m_page.FocusAsync("#view");
        foreach (string key in new[] { "ArrowLeft", "ArrowUp", "Shift+ArrowLeft", "+", "t", "Home" })
        {
            byte[] before = await Pixels();
            int frames = await Frames();
            await m_page.Keyboard.PressAsync(key);
            await NewFrame(frames);
            Assert.That(Difference(await Pixels(), before), Is.GreaterThan(0.01), key);
        }
    }

    [Test]
    public async Task View_Play_ShowsTheWavesWithTheirErrors()
    {
        await Open(m_report);
        byte[] all = await Pixels();
        string last = await Text("#view-time-text");
        Assert.That(last, Does.Contain("points after").And.Contains("RMS error").And.Contains("FLIP 0."));
        await Click("#view-play");
        string first = await Text("#view-time-text");
        Assert.That(first, Is.Not.EqualTo(last));
        Assert.That(Difference(await Pixels(), all), Is.GreaterThan(0.01));
        foreach (string chart in new[] { "#error-chart", "#flip-chart" })
            Assert.That(await m_page.Locator(chart + " .mark.now").CountAsync(), Is.EqualTo(1), chart);
        await m_page.WaitForFunctionAsync("text => document.getElementById('view-time-text').textContent === text", last);
        Assert.That(Difference(await Pixels(), all), Is.LessThan(0.001));
    }

    [Test]
    public async Task View_OnePlace_IsSeen()
    {
        string file = m_scratch["place.xyz"];
        File.WriteAllText(file, string.Concat(Enumerable.Repeat("500000 5400000 100\n", 50)));
        await Open(Report(file, "place"));
        foreach (string view in new[] { "#view-top", "#view-side", "#view-home" })
        {
            await Click(view);
            byte[] pixels = await Pixels();
            // A dot of five pixels, of which these are a hundredth.
            Assert.That(pixels.Chunk(4).Count(p => p[1] > 27), Is.InRange(1, 100), view);
        }
    }

    [TestCase("flown.webp", "image/webp"), TestCase("flown.png", "image/png")]
    public async Task Flight_Animation_IsDecodedWhole(string name, string type)
    {
        if (type == "image/webp" && !AnimatedWebp.CanWrite)
            Assert.Ignore("no libwebp here, WebP is not tried; with root: apt-get install libwebp7");
        string output = m_scratch[name];
        var call = CliCall.Of("fly", m_scratch["demo.las"], "--frames", "35", "--every", "10", "--size", "161x91", "-o", output);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        await Open(m_report);
        string decoded = await m_page.EvaluateAsync<string>("""
            async ([base64, type]) => {
              const decoder = new ImageDecoder({ data: Uint8Array.from(atob(base64), c => c.charCodeAt(0)), type });
              await decoder.tracks.ready;
              const frames = [], count = decoder.tracks.selectedTrack.frameCount;
              for (let i = 0; i < count; i++) {
                const { image } = await decoder.decode({ frameIndex: i });
                frames.push([image.displayWidth, image.displayHeight, Math.round(image.duration / 1000)].join(" "));
              }
              return frames.join();
            }
            """, new[] { System.Convert.ToBase64String(File.ReadAllBytes(output)), type });
        Assert.That(decoded, Is.EqualTo(string.Join(",", Enumerable.Repeat("161 91 166", 3))));
    }

    [Test]
    public async Task Flight_Play_MovesTheCamera()
    {
        string folder = m_scratch["flight"];
        var call = CliCall.Of("fly", m_scratch["demo.las"], "--frames", "60", "--every", "30", "--size", "160x90",
            "-o", folder, "--quiet");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        await Open(Path.Combine(folder, "report.html"));
        byte[] first = await Pixels();
        Assert.That(await Text("#view-time-text"), Is.EqualTo("frame 0"));
        await Click("#view-play");
        await m_page.WaitForFunctionAsync("() => document.getElementById('view-time-text').textContent === 'frame 54'");
        Assert.That(Difference(await Pixels(), first), Is.GreaterThan(0.05));
        Assert.That(await m_page.Locator(".row svg.chart").CountAsync(), Is.EqualTo(4));
    }

    [Test]
    public async Task Page_WithoutWebGl_ShowsThePicture()
    {
        await Open(m_report, script: "HTMLCanvasElement.prototype.getContext = () => null");
        Assert.That(await m_page.Locator("#view").IsVisibleAsync(), Is.False);
        Assert.That(await m_page.Locator(".stage img").IsVisibleAsync(), Is.True);
        Assert.That(await m_page.EvaluateAsync<int>("() => document.querySelector('.stage img').naturalWidth"), Is.EqualTo(1280));
        Assert.That(await Text("#view-status"), Does.Contain("stands in"));
        Assert.That(await m_page.Locator("#view-home").IsDisabledAsync(), Is.True);
    }

    [Test]
    public async Task Page_AtAnyWidthAndScheme_FitsAndCanBeRead()
    {
        Assert.That(new FileInfo(m_report).Length, Is.LessThan(8_000_000));
        await Open(m_report, 400, 800);
        foreach (var (width, scheme) in new[] { (400, ColorScheme.Light), (400, ColorScheme.Dark), (1600, ColorScheme.Dark) })
        {
            await m_page.SetViewportSizeAsync(width, 800);
            await m_page.EmulateMediaAsync(new() { ColorScheme = scheme });
            int needed = await m_page.EvaluateAsync<int>("() => document.documentElement.scrollWidth");
            Assert.That(needed, Is.LessThanOrEqualTo(width));
            // Contrast of text by WCAG 2: at least 4.5 to 1.
            string worst = await m_page.EvaluateAsync<string>("""
                () => {
                  const light = c => {
                    const [r, g, b] = c.map(v => (v /= 255) <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4);
                    return .2126 * r + .7152 * g + .0722 * b; };
                  const rgb = text => text.match(/[\d.]+/g).map(Number);
                  let worst = ["", 99];
                  const all = "p, dt, dd, td, th, li, button, figcaption, h1, h2, code, svg text, .scale";
                  for (const e of document.querySelectorAll(all)) {
                    if (e.closest(".legend, :disabled, #view-marks") || !e.textContent.trim()) continue;
                    const style = getComputedStyle(e), ink = light(rgb(e instanceof SVGElement ? style.fill : style.color));
                    let behind = e, color = "rgb(255, 255, 255)";
                    while (behind && /rgba\(.*, 0\)/.test(color = getComputedStyle(behind).backgroundColor))
                      behind = behind.parentElement;
                    const page = light(rgb(color));
                    const contrast = (Math.max(ink, page) + .05) / (Math.min(ink, page) + .05);
                    if (contrast < worst[1]) worst = [e.outerHTML.slice(0, 80), contrast];
                  }
                  return worst[1] < 4.5 ? worst.join(" ") : "";
                }
                """);
            Assert.That(worst, Is.Empty, width + " " + scheme);
        }
        await m_page.SetViewportSizeAsync(400, 800);
        await m_page.EmulateMediaAsync(new() { Media = Media.Print });
        Assert.That(await m_page.EvaluateAsync<int>("() => Math.max(...[...document.querySelectorAll('.copy code')].map(e => "
            + "e.scrollWidth - e.clientWidth))"), Is.Zero, "commands are printed whole");
        string nameless = await m_page.EvaluateAsync<string>("""
            () => [...document.querySelectorAll("button, input, select, canvas, img, svg[role=img]")].filter(e =>
              !(e.getAttribute("aria-label") || e.alt || e.textContent.trim() || e.labels?.length)).map(e => e.outerHTML).join()
            """);
        Assert.That(nameless, Is.Empty, "names for screen readers");
    }
}
