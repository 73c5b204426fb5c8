namespace FastPoints.Cli.Settings;

public sealed class PictureSettings
{
    readonly ValueOption<string> m_size = new("--size", "WxH", "Pixels (default: 1280x720).", "1280x720");
    readonly ValueOption<string?> m_eye = new("--eye", "x,y,z",
        "Where the camera is, in the cloud's own coordinates; with --target and, if need be, --fov.");
    readonly ValueOption<string?> m_target = new("--target", "x,y,z", "Where the camera looks.");
    readonly ValueOption<double> m_fov = new("--fov", "DEG",
        "Vertical field of view in degrees (default: 45).", PictureOptions.DefaultFovDegrees);
    readonly ValueOption<string?> m_view = new("--view", "VIEW",
        "top, bottom, front, back, left (or side), right or iso in place of a camera (default: what shows most).");
    readonly ValueOption<string[]> m_clip = new("--clip", "x,y,z,X,Y,Z",
        "Draw only what is in the box between two corners, or in any of several (of converted clouds and octrees).");
    readonly ValueOption<string[]> m_cut = new("--cut", "x,y,z,X,Y,Z", "Leave out what is in the box.");

    readonly bool m_canFilter;
    readonly LookSettings m_look;

    public PictureSettings(Command command, bool canFilter)
    {
        m_canFilter = canFilter;
        if (canFilter)
            command.Add(m_clip, m_cut);
        command.Add(m_size, m_eye, m_target, m_fov, m_view);
        m_look = new LookSettings(command);
    }

    public bool IsPlain(ParseResult parsed) => m_look.IsPlain(parsed);

    public PictureOptions Read(ParseResult parsed)
    {
        var options = m_look.Read(parsed);
        (options.WidthPx, options.HeightPx) = ParseSize(parsed.GetRequiredValue(m_size));
        options.FovDegrees = parsed.GetValue(m_fov);
        if (!(options.FovDegrees > 0 && options.FovDegrees < 180))
            throw new UsageException("--fov: wanted more than 0 and less than 180 degrees");
        if (!m_canFilter && options.IsFiltered)
            throw new UsageException("--style: classes can be chosen by the verbs picture and fly, of converted clouds");
        foreach (string box in m_canFilter ? parsed.GetValue(m_clip) ?? [] : [])
            options.ClipBoxes.Add(Box("--clip", box, false));
        foreach (string box in m_canFilter ? parsed.GetValue(m_cut) ?? [] : [])
            options.ClipBoxes.Add(Box("--cut", box, true));

        string? eye = parsed.GetValue(m_eye), target = parsed.GetValue(m_target), view = parsed.GetValue(m_view);
        if ((eye == null) != (target == null))
            throw new UsageException("--eye and --target belong together");
        if (eye != null && view != null)
            throw new UsageException("--view and --eye exclude each other");
        if (eye != null)
        {
            options.UpAxis.Directions(out _, out _, out var up);
            options.Camera = Camera.Perspective(ParsePosition("--eye", eye), ParsePosition("--target", target!), up,
                options.FovDegrees);
        }
        options.View = view switch
        {
            null => ViewDirection.Auto,
            "side" => ViewDirection.Left,
            _ => System.Enum.TryParse<ViewDirection>(view, true, out var named) && char.IsLetter(view[0]) ? named
                : throw new UsageException("--view: wanted top, bottom, front, back, left, right or iso, got " + view),
        };
        return options;
    }

    static (int, int) ParseSize(string text)
    {
        var parts = text.Split('x');
        if (parts.Length == 2
            && int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out int width)
            && int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out int height)
            && width is >= 1 and <= PictureCanvas.MaxEdgePx && height is >= 1 and <= PictureCanvas.MaxEdgePx)
            return (width, height);
        throw new UsageException($"--size: wanted WxH, each 1 to {PictureCanvas.MaxEdgePx}, got {text}");
    }

    static double3 ParsePosition(string option, string text)
    {
        var numbers = ParseNumbers(text);
        return numbers.Length == 3 ? new double3(numbers[0], numbers[1], numbers[2])
            : throw new UsageException(option + ": wanted x,y,z, got " + text);
    }

    internal static ClipBox Box(string option, string text, bool cuts)
    {
        var numbers = ParseNumbers(text);
        return numbers.Length == 6 ? new ClipBox(new double3(numbers[0], numbers[1], numbers[2]),
            new double3(numbers[3], numbers[4], numbers[5]), cuts)
            : throw new UsageException(option + ": wanted x,y,z,X,Y,Z, got " + text);
    }

    internal static double[] ParseNumbers(string text)
    {
        var parts = text.Split(',');
        var numbers = new double[parts.Length];
        for (int i = 0; i < parts.Length; i++)
            if (!double.TryParse(parts[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i])
                || !double.IsFinite(numbers[i]))
                return [];
        return numbers;
    }
}
