namespace FastPoints.Cli.Draw;

sealed partial class FlightOutput : IDisposable
{
    readonly List<Animation> m_animations = [];
    readonly string m_framePattern = "";
    int m_count;

    /// <summary>Frames from one picture to the next.</summary>
    public int Every { get; init; } = 1;

    /// <param name="output">A folder, NAME.webp, NAME.png, or NAME%04d.png for single pictures.</param>
    public FlightOutput(string output, PictureOptions options, int pictures, int delayMs, bool canWebp)
    {
        canWebp &= Math.Max(options.WidthPx, options.HeightPx) <= AnimatedWebp.MaxEdgePx;
        bool isFile = IsFile(output), isWebp = Path.GetExtension(output).Equals(".webp", StringComparison.OrdinalIgnoreCase);
        if (isWebp && !canWebp)
            throw new UsageException("--output: WebP takes libwebp, which is not here, and edges up to "
                + AnimatedWebp.MaxEdgePx + " pixels; NAME.png takes neither");
        string name = isFile ? output : Path.Combine(output, "flight.png");
        if (isFile && Numbers().IsMatch(output))
            m_framePattern = output;
        else if (!isWebp)
            m_animations.Add(new AnimatedPng(name, options.WidthPx, options.HeightPx, pictures, delayMs));
        if (canWebp && m_framePattern.Length == 0 && (isWebp || !isFile))
            m_animations.Add(new AnimatedWebp(Path.ChangeExtension(name, ".webp"), options.WidthPx, options.HeightPx, pictures,
                delayMs));
    }

    /// <summary>What was written: the animation's name, or the pattern of single pictures; null if it is not
    /// complete.</summary>
    public string? CommittedPath { get; private set; }

    public long Bytes { get; private set; }

    public static bool IsFile(string output) => Path.GetExtension(output).ToLowerInvariant() is ".png" or ".webp";

    public static string NameOf(string output, int number) => Numbers().Replace(output, match =>
        number.ToString("D" + match.Groups[1].Value, CultureInfo.InvariantCulture), 1);

    public void Add(RgbaImage image)
    {
        foreach (var animation in m_animations)
            animation.Add(image);
        if (m_framePattern.Length == 0)
            return;
        byte[] png = Png.Encode(image);
        OutputFile.Write(NameOf(m_framePattern, m_count++), png);
        (CommittedPath, Bytes) = (m_framePattern, Bytes + png.Length);
    }

    public void Commit()
    {
        foreach (var animation in m_animations.OrderBy(a => a.Bytes))
            if (CommittedPath == null)
                (CommittedPath, Bytes) = (animation.Path, animation.Bytes);
            else
                File.Delete(animation.Path);
    }

    public void Dispose()
    {
        foreach (var animation in m_animations)
            animation.Dispose();
    }

    [GeneratedRegex("%0?([0-9]?)d")]
    private static partial Regex Numbers();
}
