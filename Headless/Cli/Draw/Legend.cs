namespace FastPoints.Cli.Draw;

/// <summary>Colours, a scale bar and, of projected systems, where north is: drawn on a picture.</summary>
public sealed class Legend(ColorMode mode, DisplayRanges ranges, Camera camera, PictureOptions options, CloudCrs crs)
{
    const int MinWidthPx = 320, MinHeightPx = 180, MaxRows = 8;
    const int PanelOpacity = 190; // Of 256: what is behind a panel shines through, and never as bright as letters.
    const double MinNorth = 0.1; // Seen at a flatter angle than this sine, an arrow is a dot.

    const string Letters = "0123456789abcdefghijklmnopqrstuvwxyz.,-+%/:()";
    const string Dots = "3E5149453E00427F40004261514946214145 4B311814127F1027454545393C4A494930017109050336494949360649"
        + "49291E20545454787F4844443838444444203844 44487F3854545418087E0901020C5252523E7F0804047800447D4000"
        + "2040443D007F1028440000417F40007C041804787C080404783844444438 7C141414080814 14187C7C080404084854545420"
        + "043F4440203C4040207C1C2040201C3C4030403C44281028440C5050503C4464544C44"
        + "006060000000503000000808080808 08083E080823130864622010080402003636000000 1C2241000041221C00";

    static readonly byte[] s_dots = System.Convert.FromHexString(Dots.Replace(" ", ""));

    internal static Legend Of(PicturePlan plan, PictureOptions options, CloudCrs crs) =>
        new(plan.Mode, plan.Ranges, plan.Camera, options, crs);

    public RgbaImage CopyWithLegend(RgbaImage image)
    {
        var copy = new RgbaImage(image.Width, image.Height);
        image.Rgba.CopyTo(copy.Rgba, 0);
        if (image.Width < MinWidthPx || image.Height < MinHeightPx || ranges.Full.IsEmpty)
            return copy;
        int dot = Math.Max(1, image.Height / 360), row = 10 * dot;
        Colors(copy, dot, row, row, image.Height - row);
        int top = Scale(copy, dot, row, image.Width - row, image.Height - row);
        North(copy, dot, row, image.Width - row, top);
        return copy;
    }

    void Colors(RgbaImage image, int dot, int row, int left, int bottom)
    {
        if (mode is ColorMode.Elevation or ColorMode.Intensity)
        {
            Ramp(image, dot, row, left, bottom);
            return;
        }
        if (mode is not (ColorMode.Classification or ColorMode.ReturnNumber))
            return;
        using var colors = Palettes.Create(mode, Allocator.Persistent);
        var names = mode == ColorMode.ReturnNumber ? Enumerable.Range(1, 5).Select(n => (n, "return " + n)).ToList()
            : ranges.Classes.Select(c => (Number: c, ClassNames.Of(c) ?? "class " + c)).Take(MaxRows).ToList();
        if (names.Count == 0)
            return;
        Panel(image, dot, left, bottom - names.Count * row, row + names.Max(n => WidthOf(n.Item2, dot)), names.Count * row);
        for (int i = 0; i < names.Count; i++)
        {
            int top = bottom - (names.Count - i) * row;
            Fill(image, left, top, 7 * dot, 7 * dot, colors[names[i].Item1 % Palettes.Length]);
            Write(image, dot, left + row, top, names[i].Item2);
        }
    }

    /// <summary>The ends are exact where they are whole, else rounded to a step of the colours.</summary>
    void Ramp(RgbaImage image, int dot, int row, int left, int bottom)
    {
        bool isHeight = mode == ColorMode.Elevation;
        var (low, high) = isHeight ? (ranges.ElevationLow, ranges.ElevationHigh) : (ranges.IntensityLow, ranges.IntensityHigh);
        if (!(high > low))
            return;
        using var palette = Palettes.Create(mode, Allocator.Persistent, options.ColorRamp);
        double step = low % 1 == 0 && high % 1 == 0 ? 0.9 : (high - low) / Palettes.Length;
        string lowest = NumberFormat.Coordinate(low, step), highest = NumberFormat.Coordinate(high, step)
            + (isHeight && ranges.UpAxis == UpAxis.Z
                ? " " + NumberFormat.Unit(ranges.Units.Vertical > 0 ? ranges.Units.Vertical : ranges.Units.Horizontal) : "");
        int width = Math.Max(128 * dot, WidthOf(lowest + "   " + highest, dot)), text = bottom - 2 * row - dot;
        Panel(image, dot, left, text - row, width, bottom - text + row);
        for (int x = 0; x < width; x++)
            Fill(image, left + x, bottom - row, 1, 8 * dot, palette[x * (Palettes.Length - 1) / (width - 1)]);
        Write(image, dot, left, text - row, isHeight ? ranges.UpAxis == UpAxis.Z ? "elevation" : "height"
            : ranges.ValueAttribute.ToLowerInvariant());
        Write(image, dot, left, text, lowest);
        Write(image, dot, left + width - WidthOf(highest, dot), text, highest);
    }

    /// <summary>The longest of 1, 2, 5, 10 and so on that fits in a fifth of the picture; in perspective, at the distance of the
    /// middle.</summary>
    /// <returns>Its upper edge.</returns>
    int Scale(RgbaImage image, int dot, int row, int right, int bottom)
    {
        double length = math.length(camera.Forward / ranges.LengthsPerUnit);
        double depth = math.dot((ranges.Robust.Center - camera.EyeGeo) * ranges.LengthsPerUnit,
            camera.Forward / ranges.LengthsPerUnit) / length;
        double pxPerUnit = camera.IsOrthographic ? image.Height / camera.HeightGeo
            : image.Height / (2 * Math.Tan(camera.FovRadians / 2) * depth);
        double max = image.Width / 5.0 / pxPerUnit;
        if (!(max > 0) || !double.IsFinite(max))
            return bottom;
        double ten = Math.Pow(10, Math.Floor(Math.Log10(max)));
        double units = max >= 5 * ten ? 5 * ten : max >= 2 * ten ? 2 * ten : ten;
        int width = (int)Math.Round(units * pxPerUnit), top = bottom - 2 * dot, text = top - 4 * dot - row;
        string label = NumberFormat.FourDigits(units) + " " + NumberFormat.Unit(ranges.Units.Horizontal)
            + (camera.IsOrthographic ? "" : " in the middle");
        int wide = Math.Max(width, WidthOf(label, dot));
        Panel(image, dot, right - wide, text, wide, bottom - text);
        Fill(image, right - width, top, width, 2 * dot, Ink);
        Fill(image, right - width, top - 4 * dot, 2 * dot, 4 * dot, Ink);
        Fill(image, right - 2 * dot, top - 4 * dot, 2 * dot, 4 * dot, Ink);
        Write(image, dot, right - WidthOf(label, dot), text, label);
        return text - 8 * dot;
    }

    /// <summary>Grid north, as long as it is seen.</summary>
    void North(RgbaImage image, int dot, int row, int right, int bottom)
    {
        if (ranges.UpAxis != UpAxis.Z || !SourceFacts.IsNorthAlongY(crs))
            return;
        double3 forward = math.normalize(camera.Forward / ranges.LengthsPerUnit);
        double3 up = math.normalize(camera.Up / ranges.LengthsPerUnit);
        var north = new double3(math.cross(forward, up).y, -up.y, 0);
        double seen = math.length(north), half = 11 * dot;
        if (seen < MinNorth)
            return;
        int edge = 3 * row;
        var middle = new double3(right - edge / 2.0, bottom - row - edge / 2.0, 0);
        Panel(image, dot, right - edge, bottom - row - edge, edge, edge + row);
        north *= half / Math.Max(seen, 0.4);
        var across = new double3(-north.y, north.x, 0) / math.length(north) * (5 * dot);
        double3 tip = middle + north, tail = middle - north;
        for (int y = 0; y < edge; y++)
            for (int x = 0; x < edge; x++)
            {
                var at = new double3(right - edge + x + 0.5, bottom - row - edge + y + 0.5, 0) - tail;
                double along = math.dot(at, tip - tail) / math.lengthsq(tip - tail);
                double aside = math.dot(at, across) / math.lengthsq(across);
                // A kite: two sides that meet in the tip, and a notch in the tail.
                if (Math.Abs(aside) <= 1 - along && along >= 0.3 * (1 - Math.Abs(aside)))
                    Fill(image, right - edge + x, bottom - row - edge + y, 1, 1, aside < 0 ? Ink : Grey);
            }
        Write(image, dot, (int)middle.x - 5 * dot / 2, bottom - row + dot, "n");
    }

    bool IsDark => (options.Background & 255) + (options.Background >> 8 & 255) + (options.Background >> 16 & 255) < 3 * 128;
    uint Ink => IsDark ? Palettes.Pack(235, 235, 235) : Palettes.Pack(20, 20, 20);
    uint Grey => IsDark ? Palettes.Pack(150, 150, 150) : Palettes.Pack(110, 110, 110);
    uint Shadow => IsDark ? Palettes.Pack(0, 0, 0) : Palettes.Pack(255, 255, 255);

    static int WidthOf(string text, int dot) => (6 * text.Length - 1) * dot;

    void Write(RgbaImage image, int dot, int left, int top, string text)
    {
        foreach (var (color, shift) in new[] { (Shadow, dot), (Ink, 0) })
            for (int i = 0; i < text.Length; i++)
            {
                int letter = Letters.IndexOf(char.ToLowerInvariant(text[i]));
                for (int bit = 0; letter >= 0 && bit < 35; bit++)
                    if ((s_dots[letter * 5 + bit / 7] >> bit % 7 & 1) != 0)
                        Fill(image, left + (6 * i + bit / 7) * dot + shift, top + bit % 7 * dot + shift, dot, dot, color);
            }
    }

    /// <summary>Behind letters, and two dots around them: without it they cannot be read on points.</summary>
    void Panel(RgbaImage image, int dot, int left, int top, int width, int height)
    {
        uint behind = IsDark ? Palettes.Pack(10, 11, 13) : Palettes.Pack(250, 250, 250);
        for (int y = Math.Max(0, top - 3 * dot); y < Math.Min(image.Height, top + height + 3 * dot); y++)
            for (int x = Math.Max(0, left - 4 * dot); x < Math.Min(image.Width, left + width + 4 * dot); x++)
                image[x, y] = Mixed(image[x, y], behind);
    }

    static uint Mixed(uint below, uint above)
    {
        uint mixed = 0;
        for (int shift = 0; shift < 32; shift += 8)
            mixed |= ((below >> shift & 255) * (256 - PanelOpacity) + (above >> shift & 255) * PanelOpacity) / 256 << shift;
        return mixed;
    }

    static void Fill(RgbaImage image, int left, int top, int width, int height, uint color)
    {
        for (int y = Math.Max(0, top); y < Math.Min(image.Height, top + height); y++)
            for (int x = Math.Max(0, left); x < Math.Min(image.Width, left + width); x++)
                image[x, y] = color;
    }
}
