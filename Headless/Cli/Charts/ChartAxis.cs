namespace FastPoints.Cli.Charts;

/// <summary>From values to pixels.</summary>
public sealed class ChartAxis
{
    const double FewDecades = 3; // Fewer decades than this get ticks at 2 and 5 as well.

    readonly bool m_isLog;
    readonly double m_low, m_high, m_lowPx, m_highPx;

    ChartAxis(bool isLog, double low, double high, double lowPx, double highPx)
    {
        (m_isLog, m_low, m_high, m_lowPx, m_highPx) = (isLog, low, high, lowPx, highPx);
        Ticks = (isLog ? LogTicks(low, high) : LinearTicks(low, high)).ToList();
        // Round numbers of a logarithm are far apart: an axis without a number would be useless.
        if (isLog && Ticks.Count < 2)
            Ticks = LinearTicks(Math.Pow(10, low), Math.Pow(10, high)).ToList();
    }

    public List<double> Ticks { get; }

    public static ChartAxis Of(IEnumerable<double> values, bool isLog, double lowPx, double highPx)
    {
        var shown = values.Where(v => !isLog || v > 0).Select(v => isLog ? Math.Log10(v) : v).ToList();
        double low = shown.Count > 0 ? shown.Min() : 0, high = shown.Count > 0 ? shown.Max() : 1;
        if (!isLog && low >= 0 && low < high / 2)
            low = 0;
        double margin = high > low ? 0.04 * (high - low) : isLog ? 0.5 : Math.Max(0.5, Math.Abs(high) / 2);
        return new ChartAxis(isLog, !isLog && low == 0 && high > low ? 0 : low - margin, high + margin, lowPx, highPx);
    }

    public bool CanShow(double value) => !m_isLog || value > 0;

    public double At(double value)
    {
        double position = m_isLog ? value > 0 ? Math.Log10(value) : m_low : value;
        return m_lowPx + (position - m_low) / (m_high - m_low) * (m_highPx - m_lowPx);
    }

    static IEnumerable<double> LogTicks(double low, double high)
    {
        double[] steps = high - low < FewDecades ? [1, 2, 5] : [1];
        int every = Math.Max(1, (int)((high - low) / 10) + (high - low > 10 ? 1 : 0));
        for (int decade = (int)Math.Floor(low); decade <= Math.Ceiling(high); decade += every)
            foreach (double step in steps)
            {
                double position = decade + Math.Log10(step);
                if (position >= low && position <= high)
                    yield return step * Math.Pow(10, decade);
            }
    }

    static IEnumerable<double> LinearTicks(double low, double high)
    {
        double rough = (high - low) / 6, decade = Math.Pow(10, Math.Floor(Math.Log10(rough)));
        double step = decade * (rough / decade) switch { < 1.5 => 1, < 3.5 => 2, < 7.5 => 5, _ => 10 };
        for (double tick = Math.Ceiling(low / step); tick * step <= high; tick++)
            // Not -0.
            yield return tick * step + 0.0;
    }
}
