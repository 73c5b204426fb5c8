namespace FastPoints.HostTests.Cli;

public sealed class LegendTests
{
    const int Width = 1280, Height = 720, Dot = 2, Row = 20, LetterPx = 6 * Dot;

    static readonly uint s_ink = Palettes.Pack(235, 235, 235), s_white = Palettes.Pack(255, 255, 255);

    static readonly CloudCrs s_projected = new() { Epsg = 32632 };

    static RgbaImage Draw(double low, double high, ViewDirection view = ViewDirection.Top, CloudCrs crs = null,
        uint background = 0)
    {
        var options = new PictureOptions { WidthPx = Width, HeightPx = Height, View = view };
        var box = new BoundsGeo(new double3(0, 0, low), new double3(100, 100, high));
        var ranges = new DisplayRanges { Full = box, Robust = box, ElevationLow = low, ElevationHigh = high };
        var camera = CameraFraming.Frame(options, box, [box.Min, box.Max], [box.Min, box.Max], new double3(1, 1, 1));
        var image = new RgbaImage(Width, Height);
        for (int i = 0; i < Width * Height; i++)
            image[i % Width, i / Width] = background;
        return new Legend(ColorMode.Elevation, ranges, camera, options, crs ?? new CloudCrs()).CopyWithLegend(image);
    }

    [TestCase(-0.05636, 0.05686), TestCase(0, 1), TestCase(-123456.789, 123456.789), TestCase(1e-7, 2e-7)]
    public void Ramp_Ends_StandApart(double low, double high)
    {
        var image = Draw(low, high);
        int top = Height - Row - 2 * Row - Dot;
        bool[] inked = [.. Enumerable.Range(Row, Width / 2).Select(x =>
            Enumerable.Range(top, 7 * Dot).Any(y => image[x, y] == s_ink))];
        int first = Array.IndexOf(inked, true), last = Array.LastIndexOf(inked, true), gap = 0, widest = 0;
        for (int x = first; x <= last; x++)
        {
            gap = inked[x] ? 0 : gap + 1;
            widest = Math.Max(widest, gap);
        }
        Assert.That(widest, Is.GreaterThan(2 * LetterPx));
    }

    [Test]
    public void Letters_OnWhitePoints_StandOnADarkPanel()
    {
        var image = Draw(0, 100, background: s_white);
        int white = 0, dark = 0;
        for (int y = Height - 3 * Row; y < Height - 2 * Row; y++)
            for (int x = Row; x < Row + 128 * Dot; x++)
                _ = image[x, y] == s_white ? white++ : (image[x, y] & 255) < 100 ? dark++ : 0;
        Assert.That((white, dark > 2000), Is.EqualTo((0, true)));
    }

    [TestCase(ViewDirection.Top, true, true), TestCase(ViewDirection.Iso, true, true)]
    [TestCase(ViewDirection.Front, true, false), TestCase(ViewDirection.Top, false, false)]
    public void North_OfProjectedSystems_IsShownWhereItIsSeen(ViewDirection view, bool isProjected, bool isShown)
    {
        var image = Draw(0, 100, view, isProjected ? s_projected : null);
        int inked = 0;
        for (int y = Height - 8 * Row; y < Height - 3 * Row; y++)
            for (int x = Width - 5 * Row; x < Width; x++)
                inked += image[x, y] == s_ink ? 1 : 0;
        Assert.That(inked > 50, Is.EqualTo(isShown));
    }

    [Test]
    public void North_FromAbove_PointsUp()
    {
        var image = Draw(0, 100, ViewDirection.Top, s_projected);
        // The arrow is a kite: narrow at its tip.
        int[] widths = [.. Enumerable.Range(Height - 8 * Row, 5 * Row).Select(y =>
            Enumerable.Range(Width - 4 * Row, 3 * Row).Count(x => (image[x, y] & 255) > 140)).Where(w => w > 0)];
        Assert.That(widths[0], Is.LessThan(widths[widths.Length / 3]));
    }
}
