namespace FastPoints.Cli.Settings;

public static class Memory
{
    /// <summary>What the process takes for any cloud: code, the runtime, readers, stacks. Measured with a thousand
    /// points: 45 MB; with LAZ and two workers 70.</summary>
    const long ProcessBytes = 96L << 20;
    const long MinBytes = ProcessBytes + (64L << 20);

    public static void Limit(ConvertSettings settings, string text)
    {
        settings.ProcessBytes = ProcessBytes;
        settings.MemoryBytes = ForBuild(text);
    }

    public static long ForBuild(string text)
    {
        long bytes = Parse(text);
        if (bytes < MinBytes)
            throw new UsageException("--memory: wanted at least " + (MinBytes >> 20) + "MiB, got " + text);
        return bytes - ProcessBytes;
    }

    public static long Parse(string text)
    {
        string digits = text.TrimEnd('B', 'i', 'K', 'k', 'M', 'G', 'T');
        double unit = text[digits.Length..] switch
        {
            "" or "B" => 1,
            "KiB" => 1L << 10,
            "MiB" => 1L << 20,
            "GiB" => 1L << 30,
            "TiB" => 1L << 40,
            "kB" or "KB" => 1e3,
            "MB" => 1e6,
            "GB" => 1e9,
            "TB" => 1e12,
            _ => 0,
        };
        if (unit == 0 || !double.TryParse(digits, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture,
            out double count)
            || count * unit >= long.MaxValue)
            throw new UsageException("--memory: wanted a size such as 300MiB, 1.5GiB or 2GB, got " + text);
        return (long)(count * unit);
    }
}
