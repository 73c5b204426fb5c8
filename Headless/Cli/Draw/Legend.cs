using FastPoints.Drawing;

namespace FastPoints.Cli.Draw;

public sealed class Legend(ColorMode mode, DisplayRanges ranges, Camera camera, PictureOptions options)
{
    const int MinWidthPx = 320, MinHeightPx = 180, MaxRows = 8;
    const string Letters = "0123456789abcdefghijklmnopqrstuvwxyz.,-+%/:()";
    const string Dots = "3E5149453E00427F40004261514946214145 4B311814127F1027454545393C4A494930017109050336494949360649"
        + "49291E20545454787F4844443838444444203844 44487F3854545418087E0901020C5252523E7F0804047800447D4000"
        + "2040443D007F1028440000417F40007C041804787C080404783844444438 7C141414080814 14187C7C080404084854545420"
        + "043F4440203C4040207C1C2040201C3C4030403C44281028440C5050503C4464544C44"
        + "006060000000503000000808080808 08083E080823130864622010080402003636000000 1C2241000041221C00";

    static readonly byte[] s_dots = System.Convert.FromHexString(Dots.Replace(" ", ""));

    internal static Legend Of(PicturePlan plan, PictureOptions options) =>
        new(plan.Mode, plan.Ranges, plan.Camera, options);

    public RgbaImage DrawOn(RgbaImage image)
    {
        var copy = new RgbaImage(image.Width, image.Height);
        image.Rgba.CopyTo(copy.Rgba, 0);
        if (image.Width < MinWidthPx || image.Height < MinHeightPx || ranges.Full.IsEmpty)
            return copy;
        int dot = Math.Max(1, image.Height / 360), row = 10 * dot, left = row, bottom = image.Height - row;
        Colors(copy, dot, row, left, bottom);
        Scale(copy, dot, row, image.Width - row, bottom);
        return copy;
    }

    void Colors(RgbaImage image, int dot, int row, int left, int bottom)
    {
        if (mode is ColorMode.Elevation or ColorMode.Intensity)
        {
            bool isHeight = mode == ColorMode.Elevation;
            var (low, high) = isHeight ? (ranges.ElevationLow, ranges.ElevationHigh)
                : (ranges.IntensityLow, ranges.IntensityHigh);
            if (!(high > low))
                return;
            using var palette = Palettes.Create(mode, Allocator.Persistent, options.Gradient);
            int width = 128 * dot;
            for (int x = 0; x < width; x++)
                Fill(image, left + x, bottom - row, 1, 8 * dot, palette[x * (Palettes.Length - 1) / (width - 1)]);
            int text = bottom - 2 * row - dot;
            string highest = Human.FourDigits(high) + (isHeight && ranges.UpAxis == UpAxis.Z
                ? " " + Human.Unit(ranges.Units.Vertical > 0 ? ranges.Units.Vertical : ranges.Units.Horizontal) : "");
            Write(image, dot, left, text - row, isHeight ? ranges.UpAxis == UpAxis.Z ? "elevation" : "height"
                : ranges.ValueAttribute.ToLowerInvariant());
            Write(image, dot, left, text, Human.FourDigits(low));
            Write(image, dot, left + width - WidthOf(highest, dot), text, highest);
            return;
        }
        if (mode is not (ColorMode.Classification or ColorMode.ReturnNumber))
            return;
        using var colors = Palettes.Create(mode, Allocator.Persistent);
        var names = mode == ColorMode.ReturnNumber ? Enumerable.Range(1, 5).Select(n => (n, "return " + n)).ToList()
            : ranges.Classes.Select(c => (Number: c, ClassNames.Of(c) ?? "class " + c)).Take(MaxRows).ToList();
        for (int i = 0; i < names.Count; i++)
        {
            int top = bottom - (names.Count - i) * row;
            Fill(image, left, top, 7 * dot, 7 * dot, colors[names[i].Item1 % Palettes.Length]);
            Write(image, dot, left + row, top, names[i].Item2);
        }
    }

    /// <summary>The longest of 1, 2, 5, 10 and so on that fits in a fifth of the picture; in perspective, at the distance of the
    /// middle.</summary>
    void Scale(RgbaImage image, int dot, int row, int right, int bottom)
    {
        double length = math.length(camera.Forward / ranges.LengthsPerUnit);
        double depth = math.dot((ranges.Robust.Center - camera.EyeGeo) * ranges.LengthsPerUnit,
            camera.Forward / ranges.LengthsPerUnit) / length;
        double pxPerUnit = camera.IsOrthographic ? image.Height / camera.HeightGeo
            : image.Height / (2 * Math.Tan(camera.FovRadians / 2) * depth);
        double max = image.Width / 5.0 / pxPerUnit;
        if (!(max > 0) || !double.IsFinite(max))
            return;
        double ten = Math.Pow(10, Math.Floor(Math.Log10(max)));
        double units = max >= 5 * ten ? 5 * ten : max >= 2 * ten ? 2 * ten : ten;
        int width = (int)Math.Round(units * pxPerUnit), top = bottom - 2 * dot;
        Fill(image, right - width, top, width, 2 * dot, Ink);
        Fill(image, right - width, top - 4 * dot, 2 * dot, 4 * dot, Ink);
        Fill(image, right - 2 * dot, top - 4 * dot, 2 * dot, 4 * dot, Ink);
        string text = Human.FourDigits(units) + " " + Human.Unit(ranges.Units.Horizontal)
            + (camera.IsOrthographic ? "" : " in the middle");
        Write(image, dot, right - Math.Max(width, WidthOf(text, dot)), top - 4 * dot - row, text);
    }

    bool IsDark => (options.Background & 255) + (options.Background >> 8 & 255) + (options.Background >> 16 & 255) < 3 * 128;
    uint Ink => IsDark ? Palettes.Pack(235, 235, 235) : Palettes.Pack(20, 20, 20);
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

    static void Fill(RgbaImage image, int left, int top, int width, int height, uint color)
    {
        for (int y = Math.Max(0, top); y < Math.Min(image.Height, top + height); y++)
            for (int x = Math.Max(0, left); x < Math.Min(image.Width, left + width); x++)
                image[x, y] = color;
    }
}
