namespace FastPoints.Cli.Draw;

public readonly record struct FlightFrame
{
    public required FrameStats Stats { get; init; }
    public required double MainThreadMs { get; init; }
    public required double FrameMs { get; init; }
    public required long GarbageBytes { get; init; }
    public required double AtSeconds { get; init; }
    public required bool IsCut { get; init; }

    public required double Popping { get; init; }
}

public sealed class FlightLog
{
    const double FullFraction = 0.95;
    const double HitchMs = 1000.0 / 30; // A frame that takes longer than two of 60 a second.

    const int FramesToWarmUp = 60;

    readonly List<FlightFrame> m_frames;

    // The list itself makes no garbage between frames.
    public FlightLog(int frames) => m_frames = new List<FlightFrame>(Frames = frames);

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

    /// <summary>Without the frames where it was not measured.</summary>
    public IEnumerable<(double Frame, double Flip)> PoppingByFrame =>
        m_frames.Select((f, i) => ((double)i, f.Popping)).Where(p => !double.IsNaN(p.Popping));

    public PoppingSummary? Popping => PoppingSummary.Of(PoppingByFrame);

    /// <summary>But for the frames until, at first and after a cut, nearly all that was selected is drawn.</summary>
    public PoppingSummary? PoppingWhenLoaded
    {
        get
        {
            var loading = Cuts().Select(c => (c.Frame, End: c.FramesToFull < 0 ? Count : c.Frame + c.FramesToFull)).ToList();
            return PoppingSummary.Of(PoppingByFrame.Where(p => !loading.Exists(l => p.Frame >= l.Frame && p.Frame <= l.End)));
        }
    }

    public void Add(in FlightFrame frame) => m_frames.Add(frame);

    /// <summary>Seconds until nearly all that was selected was drawn; NaN if never.</summary>
    public double SecondsToFull =>
        FirstFull(0) is var full and >= 0 ? m_frames[full].AtSeconds - m_frames[0].AtSeconds : double.NaN;

    /// <summary>From the command's start, with the time to open the clouds.</summary>
    public double SecondsTo95 => BeginSeconds + (FirstFull(0) is var full and >= 0 ? m_frames[full].AtSeconds : double.NaN);

    public double BeginSeconds { get; set; }

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

    double[] Percentiles(Func<FlightFrame, double> of)
    {
        var sorted = m_frames.Select(of).Order().ToArray();
        return [sorted[sorted.Length / 2], sorted[Math.Min(sorted.Length - 1, sorted.Length * 99 / 100)], sorted[^1]];
    }

    public string ToCsv()
    {
        var text = new StringBuilder("frame,cut,selectedNodes,selectedPoints,requestedNodes,requestedBytes,readBytes,"
            + "uploadedNodes,uploadedBytes,evictedNodes,drawnNodes,drawnPoints,cachedNodes,poolBytes,hierarchyBytes,"
            + "readsUnderWay,receiveMs,selectMs,uploadMs,requestMs,listMs,mainThreadMs,frameMs,garbageBytes,popping\n");
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
                .Append(string.Create(CultureInfo.InvariantCulture, $"{f.GarbageBytes},"))
                .Append(double.IsNaN(f.Popping) ? "\n"
                    : string.Create(CultureInfo.InvariantCulture, $"{f.Popping:0.000000}\n"));
        }
        return text.ToString();
    }
}

/// <summary>See <see cref="FlightRenderer.MeasurePopping"/>.</summary>
public sealed record PoppingSummary(double Mean, double Max, int FrameOfMax)
{
    public static PoppingSummary? Of(IEnumerable<(double Frame, double Flip)> frames)
    {
        var all = frames.ToList();
        if (all.Count == 0)
            return null;
        var max = all.MaxBy(f => f.Flip);
        return new PoppingSummary(all.Average(f => f.Flip), max.Flip, (int)max.Frame);
    }

    public override string ToString() =>
        $"FLIP {NumberFormat.Value(Mean)} on average, at most {NumberFormat.Value(Max)}, in frame {FrameOfMax}";

    public void WriteKey(Utf8JsonWriter json, string name)
    {
        json.WriteStartObject(name);
        json.WriteReal("mean", Mean);
        json.WriteReal("max", Max);
        json.WriteInteger("frameOfMax", FrameOfMax);
        json.WriteEndObject();
    }
}
