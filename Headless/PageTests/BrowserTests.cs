[assembly: Parallelizable(ParallelScope.None)]

namespace FastPoints.PageTests;

public abstract class BrowserTests
{
    protected const int GridWidth = 160, GridHeight = 90;
    const int NearBackground = 12; // Largest difference of a channel from the background, of 255, that is still background.

    static readonly int[] s_background = [24, 26, 30];

    private protected ScratchFolder m_scratch;
    IPlaywright m_playwright;
    IBrowser m_browser;
    private protected IPage m_page;
    List<string> m_said;

    [OneTimeSetUp]
    public async Task OpenBrowser()
    {
        string chromium = new[] { "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome" }
            .FirstOrDefault(File.Exists);
        if (chromium == null)
            Assert.Ignore("no browser here, pages are not tried in one; with root: apt-get install chromium");
        m_scratch = new ScratchFolder();
        // Before anything is awaited: the command line wants the test's own thread.
        MakePages();
        m_playwright = await Playwright.CreateAsync();
        m_browser = await m_playwright.Chromium.LaunchAsync(new()
        {
            ExecutablePath = chromium,
            Args = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
        });
    }

    protected abstract void MakePages();

    [OneTimeTearDown]
    public async Task Close()
    {
        if (m_browser != null)
            await m_browser.CloseAsync();
        m_playwright?.Dispose();
        m_scratch?.Dispose();
    }

    protected string Report(string cloud, string name)
    {
        var call = CliCall.Of(cloud, "--out", m_scratch[name], "--quiet", "--plain");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        return Path.Combine(m_scratch[name], "report.html");
    }

    protected async Task Open(string path, int width = 1280, int height = 900, string script = null, string fragment = "")
    {
        m_said = [];
        m_page = await m_browser.NewPageAsync(new() { ViewportSize = new() { Width = width, Height = height } });
        m_page.Console += (_, message) => m_said.Add("console: " + message.Text);
        m_page.PageError += (_, error) => m_said.Add("error: " + error);
        m_page.Request += (_, request) =>
        {
            if (request.Url.Split('#')[0] != "file://" + path && !request.Url.StartsWith("data:", StringComparison.Ordinal))
                m_said.Add("request: " + request.Url);
        };
        if (script != null)
            await m_page.AddInitScriptAsync(script);
        await m_page.GotoAsync("file://" + path + fragment);
        await m_page.WaitForSelectorAsync(".still img, canvas[data-frames]", new() { State = WaitForSelectorState.Attached });
    }

    [TearDown]
    public async Task IsSilent()
    {
        if (m_page != null)
            await m_page.CloseAsync();
        m_page = null;
        Assert.That(m_said, Is.Empty);
    }

    protected Task<string> Text(string selector) => m_page.Locator(selector).InnerTextAsync();

    protected async Task Click(string id)
    {
        int frames = await Frames();
        await m_page.ClickAsync(id);
        await NewFrame(frames);
    }

    protected Task<int> Frames() => m_page.EvaluateAsync<int>("() => Number(document.getElementById('view').dataset.frames)");

    protected Task NewFrame(int after) =>
        m_page.WaitForFunctionAsync("n => Number(document.getElementById('view').dataset.frames) > n", after);

    protected async Task<byte[]> Pixels() => System.Convert.FromBase64String(await m_page.EvaluateAsync<string>($$"""
        () => {
          const small = document.createElement("canvas"), context = small.getContext("2d");
          [small.width, small.height] = [{{GridWidth}}, {{GridHeight}}];
          context.imageSmoothingQuality = "high";
          context.drawImage(document.getElementById("view"), 0, 0, small.width, small.height);
          let text = "";
          for (const byte of context.getImageData(0, 0, small.width, small.height).data) text += String.fromCharCode(byte);
          return btoa(text);
        }
        """));

    protected static bool IsCovered(byte[] pixels, int pixel) =>
        Enumerable.Range(0, 3).Any(c => Math.Abs(pixels[4 * pixel + c] - s_background[c]) > NearBackground);

    /// <summary>Share of the pixels.</summary>
    protected static double Difference(byte[] a, byte[] b) => Enumerable.Range(0, GridWidth * GridHeight).Average(p =>
        Enumerable.Range(0, 3).Any(c => Math.Abs(a[4 * p + c] - b[4 * p + c]) > 8) ? 1.0 : 0);
}
