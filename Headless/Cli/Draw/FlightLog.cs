namespace FastPoints.Cli.Draw;

public sealed class FlightLog
{
    const double FullFraction = 0.95;

    /// <summary>A frame that takes longer than two of 60 a second.</summary>
    const double HitchMs = 1000.0 / 30;

    const int FramesToWarmUp = 60;

    readonly record struct Frame(FrameStats Stats, double MainThreadMs, double FrameMs, long GarbageBytes,
        double AtSeconds, bool IsCut);

    readonly List<Frame> m_frames;

    // The list itself makes no garbage between frames.
    public FlightLog(int frames) => m_frames = new List<Frame>(Frames = frames);

    /// <summary>Frames of the whole flight; <see cref="Count"/> of them are done.</summary>
    public int Frames { get; }

    public int Count => m_frames.Count;
    public long GarbageBytes => m_frames.Sum(f => f.GarbageBytes);
    public long GarbageBytesAfterWarmUp => m_frames.Skip(FramesToWarmUp).Sum(f => f.GarbageBytes);
    public double FirstMs => m_frames[0].MainThreadMs;
    public double MaxLaterMs => m_frames.Skip(1).Select(f => f.MainThreadMs).DefaultIfEmpty().Max();
    public long BytesRead => m_frames.Sum(f => f.Stats.ReadBytes);
    public int Hitches => m_frames.Count(f => f.MainThreadMs > HitchMs);
    public long PoolBytesPeak => m_frames.Max(f => f.Stats.PoolBytes);
    public FrameStats Last => m_frames[^1].Stats;
    public double[] MainThreadMs => Percentiles(f => f.MainThreadMs);
    public double[] FrameMs => Percentiles(f => f.FrameMs);
    public double[] SelectMs => Percentiles(f => f.Stats.SelectMs);
    public double[] RequestMs => Percentiles(f => f.Stats.RequestMs);

    public IEnumerable<(double, double)> Of(Func<FrameStats, double> value) =>
        m_frames.Select((f, i) => ((double)i, value(f.Stats)));

    public IEnumerable<(double, double)> MainThreadByFrame => m_frames.Select((f, i) => ((double)i, f.MainThreadMs));

    public void Add(in FrameStats stats, double mainThreadMs, double frameMs, long garbageBytes,
        double atSeconds, bool isCut) =>
        m_frames.Add(new Frame(stats, mainThreadMs, frameMs, garbageBytes, atSeconds, isCut));

    /// <summary>Seconds until nearly all that was selected was drawn; NaN if never.</summary>
    public double SecondsToFull =>
        FirstFull(0) is var full and >= 0 ? m_frames[full].AtSeconds - m_frames[0].AtSeconds : double.NaN;

    /// <summary>For each cut: frames until nearly all that was selected was drawn (-1 if never), and the bytes that
    /// were copied until then.</summary>
    public IEnumerable<(int Frame, int FramesToFull, long Bytes)> Cuts()
    {
        for (int cut = 0; cut < m_frames.Count; cut++)
        {
            if (!m_frames[cut].IsCut)
                continue;
            int full = FirstFull(cut);
            long bytes = full < 0 ? 0 : m_frames.Skip(cut).Take(full - cut + 1).Sum(f => f.Stats.UploadedBytes);
            yield return (cut, full < 0 ? -1 : full - cut, bytes);
        }
    }

    int FirstFull(int from) => m_frames.FindIndex(from, f => f.Stats.SelectedPoints > 0
        && f.Stats.DrawnPoints >= FullFraction * f.Stats.SelectedPoints && f.Stats.MissingPages == 0);

    double[] Percentiles(Func<Frame, double> of)
    {
        var sorted = m_frames.Select(of).Order().ToArray();
        return [sorted[sorted.Length / 2], sorted[Math.Min(sorted.Length - 1, sorted.Length * 99 / 100)], sorted[^1]];
    }

    public string ToCsv()
    {
        var text = new StringBuilder("frame,cut,selectedNodes,selectedPoints,requestedNodes,requestedBytes,readBytes,"
            + "uploadedNodes,uploadedBytes,evictedNodes,drawnNodes,drawnPoints,cachedNodes,poolBytes,hierarchyBytes,"
            + "readsUnderWay,receiveMs,selectMs,uploadMs,requestMs,listMs,mainThreadMs,frameMs,garbageBytes\n");
        for (int i = 0; i < m_frames.Count; i++)
        {
            var f = m_frames[i];
            var s = f.Stats;
            text.Append(string.Create(CultureInfo.InvariantCulture,
                $"{i},{(f.IsCut ? 1 : 0)},{s.SelectedNodes},{s.SelectedPoints},"))
                .Append(string.Create(CultureInfo.InvariantCulture, $"{s.RequestedNodes},{s.RequestedBytes},{s.ReadBytes},"))
                .Append(string.Create(CultureInfo.InvariantCulture, $"{s.UploadedNodes},{s.UploadedBytes},{s.EvictedNodes},"))
                .Append(string.Create(CultureInfo.InvariantCulture,
                    $"{s.DrawnNodes},{s.DrawnPoints},{s.CachedNodes},{s.PoolBytes},"))
                .Append(string.Create(CultureInfo.InvariantCulture,
                    $"{s.HierarchyBytes},{s.ReadsInFlight},{s.ReceiveMs:0.000},"))
                .Append(string.Create(CultureInfo.InvariantCulture,
                    $"{s.SelectMs:0.000},{s.UploadMs:0.000},{s.RequestMs:0.000},"))
                .Append(string.Create(CultureInfo.InvariantCulture,
                    $"{s.ListMs:0.000},{f.MainThreadMs:0.000},{f.FrameMs:0.000},"))
                .Append(string.Create(CultureInfo.InvariantCulture, $"{f.GarbageBytes}\n"));
        }
        return text.ToString();
    }
}
