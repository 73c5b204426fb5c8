namespace FastPoints.Cli.Output;

/// <summary>Progress on standard error: a line redrawn in place on a terminal, elsewhere plain lines, at most one a second. Short
/// stages say nothing.</summary>
public sealed class ProgressDisplay : IDisposable
{
    const int BarCells = 24;
    const double RedrawSeconds = 0.1, LineSeconds = 1;

    readonly StageProgress m_progress;
    readonly TextWriter m_error;
    readonly bool m_isTerminal;
    readonly Stopwatch m_sinceReport = Stopwatch.StartNew();
    bool m_isDrawn;

    public ProgressDisplay(StageProgress progress, TextWriter error, bool isTerminal)
    {
        m_progress = progress;
        m_error = error;
        m_isTerminal = isTerminal;
        progress.Changed += Show;
    }

    void Show(StageProgress progress)
    {
        if (progress.Current == null || m_sinceReport.Elapsed.TotalSeconds < (m_isTerminal ? RedrawSeconds : LineSeconds))
            return;
        m_sinceReport.Restart();
        // Some work counts no points.
        string speed = progress.Points > 0 ? NumberFormat.Short(progress.PointsPerSecond) + " points/s  " : "";
        string line = string.Format(CultureInfo.InvariantCulture, "{0,3:0}%  {1}{2} left", 100 * progress.Fraction, speed,
            NumberFormat.Duration(progress.SecondsLeft));
        if (!m_isTerminal)
        {
            m_error.WriteLine(progress.Current + ": " + line.TrimStart());
            return;
        }
        int cells = (int)(progress.Fraction * BarCells);
        // Back to the start, and what is left of a longer line cleared.
        m_error.Write("\r" + progress.Current.PadRight(10) + " [" + new string('=', cells)
            + new string(' ', BarCells - cells) + "] "
            + line + "\u001b[K");
        m_isDrawn = true;
    }

    public void Clear()
    {
        if (m_isDrawn)
            m_error.Write("\r\u001b[K");
        m_isDrawn = false;
    }

    public void Dispose()
    {
        m_progress.Changed -= Show;
        Clear();
    }
}
