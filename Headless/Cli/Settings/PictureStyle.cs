namespace FastPoints.Cli.Settings;

/// <summary>Options of a picture as text, as for <c>--style</c>.</summary>
static class PictureStyle
{
    public const string Help =
        "color=auto|rgb|elevation|intensity|classification|returnnumber|pointsource or an attribute's name, " +
        "gradient=auto|viridis|turbo|gray, size=auto|PIXELS|LENGTHu|adaptive[:GAPS], " +
        "points=square|round|paraboloid|splat (the last of converted clouds), " +
        "classes=N+N+... (shown; of converted clouds), edl=auto|on|off|STRENGTH, " +
        "light=auto|on|off|AZIMUTH,ELEVATION[,SHARE], shadows=on|off, holes=fill|keep, " +
        "background=RRGGBB[AA], up=x|y|z|-x|-y|-z";

    /// <returns>What was wanted; null if it is set.</returns>
    public static string? SetStyle(this PictureOptions options, string key, string value)
    {
        switch (key)
        {
            case "color":
                return SetColor(options, value);
            case "gradient":
                return TryName(value, out options.ColorRamp) ? null : Wanted<ColorRamp>(value);
            case "up":
                options.GuessesUpAxis = false;
                return TryName(value.StartsWith('-') ? "Negative" + value[1..] : value, out options.UpAxis) ? null
                    : "wanted x, y, z, -x, -y or -z, got " + value;
            case "size":
                return TrySize(options, value) ? null : "size: wanted auto, 1 to " + NumberText.Of(PointDrawing.MaxSizePx)
                    + " pixels, a length in units of the coordinates as in 0.05u, or adaptive, with distances between points "
                    + "as in adaptive:1.2; got " + value;
            case "points":
                options.RoundPoints = value is "round" or "splat";
                options.BlendedPoints = value == "splat";
                options.ParaboloidPoints = value == "paraboloid";
                return options.RoundPoints || options.ParaboloidPoints || value == "square" ? null
                    : "points: wanted square, round, paraboloid or splat, got " + value;
            case "classes":
                return TryClasses(options, value) ? null : "classes: wanted numbers from 0 to 255 as in 2+6, got " + value;
            case "edl":
                options.EdlStrength = value == "auto" ? -1 : value == "on" ? PictureOptions.DefaultEdlStrength : 0;
                return value is "auto" or "on" or "off" || TryNumber(value, 0, 100, out options.EdlStrength) ? null
                    : "edl: wanted auto, on, off or a strength, got " + value;
            case "light":
                return TryLight(options, value) ? null : "light: wanted auto, on, off, or degrees from north and above the "
                    + "horizon and perhaps a share, as in 315,45,0.7; got " + value;
            case "shadows":
                options.Shadows = value == "on";
                return value is "on" or "off" ? null : "shadows: wanted on or off, got " + value;
            case "holes":
                options.FillsHoles = value == "fill";
                return value is "fill" or "keep" ? null : "holes: wanted fill or keep, got " + value;
            case "background":
                return TryColor(value, out options.Background) ? null
                    : "background: wanted RRGGBB or RRGGBBAA in hexadecimal, got " + value;
            default:
                return "no such style: " + key + "; there are " + Help;
        }
    }

    static string? SetColor(PictureOptions options, string value)
    {
        options.ColorAttribute = null;
        if (TryName(value, out options.Color))
            return null;
        if (value.Length == 0 || !char.IsLetter(value[0]))
            return Wanted<ColorMode>(value);
        (options.Color, options.ColorAttribute) = (ColorMode.Intensity, value);
        if (options.ColorRamp == ColorRamp.Auto)
            options.ColorRamp = ColorRamp.Viridis;
        return null;
    }

    static bool TryName<T>(string text, out T value) where T : struct, System.Enum
    {
        value = default;
        return text.Length > 0 && char.IsLetter(text[0]) && System.Enum.TryParse(text, true, out value);
    }

    static string Wanted<T>(string got) where T : struct, System.Enum =>
        "wanted " + string.Join(", ", System.Enum.GetNames<T>()).ToLowerInvariant() + ", got " + got;

    static bool TryNumber(string text, float min, float max, out float value)
    {
        bool isNumber = NumberText.TryRead(text, out double number);
        value = (float)number;
        return isNumber && value >= min && value <= max;
    }

    static bool TrySize(PictureOptions options, string value)
    {
        const string adaptive = "adaptive", ofGaps = adaptive + ":";
        float number = 0;
        PointSize? inWorld = null;
        if (value == adaptive)
            inWorld = PointSize.Adaptive();
        else if (value.StartsWith(ofGaps, StringComparison.Ordinal) && TryNumber(value[ofGaps.Length..], 0.01f, 100, out number))
            inWorld = PointSize.Adaptive(number);
        else if (value.EndsWith('u') && TryNumber(value[..^1], float.Epsilon, float.MaxValue, out number))
            inWorld = PointSize.World(number);
        else if (value != "auto" && !TryNumber(value, 1, PointDrawing.MaxSizePx, out number))
            return false;
        options.SizeInWorld = inWorld;
        options.PointSizePx = inWorld.HasValue ? 0 : number;
        return true;
    }

    static bool TryLight(PictureOptions options, string value)
    {
        (options.LightAzimuth, options.LightElevation) = (double.NaN, 45);
        options.LitFraction = value == "auto" ? -1 : value == "off" ? 0 : PictureOptions.DefaultLitFraction;
        if (value is "auto" or "off" or "on")
            return true;
        var parts = value.Split(',');
        if (parts.Length is not (2 or 3) || !TryNumber(parts[0], -360, 360, out float azimuth)
            || !TryNumber(parts[1], -90, 90, out float elevation))
            return false;
        (options.LightAzimuth, options.LightElevation) = (azimuth, elevation);
        return parts.Length == 2 || TryNumber(parts[2], 0, 1, out options.LitFraction);
    }

    static bool TryClasses(PictureOptions options, string value)
    {
        var shown = new ClassMask();
        foreach (string part in value.Split('+'))
        {
            if (!byte.TryParse(part, NumberStyles.None, CultureInfo.InvariantCulture, out byte c))
                return false;
            shown.Add(c);
        }
        options.HiddenClasses = shown.Inverse;
        return true;
    }

    static bool TryColor(string text, out uint color)
    {
        string hex = text.TrimStart('#');
        hex += hex.Length == 6 ? "FF" : "";
        bool isColor = uint.TryParse(hex, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out uint rgba);
        color = BinaryPrimitives.ReverseEndianness(rgba);
        return isColor && hex.Length == 8;
    }
}
