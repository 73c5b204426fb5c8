namespace FastPoints.HostTests.Remote;

// A cloud flown over at 60 frames a second, from when its stream begins; then the camera rests.
sealed class TimedFlight
{
    const int RestFrames = 240;

    readonly double[] m_mainThreadMs;
    int m_full, m_firstFull;

    TimedFlight(int frames) => m_mainThreadMs = new double[frames];

    // Of frames, those that drew 95 % of what was selected, and knew all that was in view.
    public double FullShare => m_full / (double)m_mainThreadMs.Length;

    public long ReadBytes { get; private set; } // Of reads that ended while the camera moved.

    public long GarbageAtRest { get; private set; } // Of the main thread, in the last half of the rest.

    public static TimedFlight Over(string cloud, CameraPath path, int budget)
    {
        var flight = new TimedFlight(path.FrameCount);
        using var stream = new StreamContext(new MemoryNodePool(256 << 20, 16 << 20)) { FrameSeconds = 1 / 60f };
        stream.Settings.Selection.PointBudget = budget;
        var source = new FolderSource(CloudFolder.Open(cloud), StoreLayout.ColorName);
        stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
        using var views = new NativeArray<StreamView>(1, Allocator.Persistent);
        var view = views;
        var watch = Stopwatch.StartNew();
        for (int frame = 0; frame < path.FrameCount + RestFrames; frame++)
        {
            view[0] = path.CameraAt(Math.Min(frame, path.FrameCount - 1)).ToStreamView(1280, 720);
            long garbage = GC.GetAllocatedBytesForCurrentThread(), start = Stopwatch.GetTimestamp();
            FrameStats stats = FrameStep.Run(stream, views);
            if (frame < path.FrameCount)
                flight.Add(frame, stats, Stopwatch.GetElapsedTime(start).TotalMilliseconds);
            else if (frame >= path.FrameCount + RestFrames / 2)
                flight.GarbageAtRest += GC.GetAllocatedBytesForCurrentThread() - garbage;
            JobHandle.ScheduleBatchedJobs();
            if ((frame + 1) / 60.0 - watch.Elapsed.TotalSeconds is var rest && rest > 0)
                Thread.Sleep(TimeSpan.FromSeconds(rest));
        }
        return flight;
    }

    public override string ToString() => $"{FullShare:0.0%} of frames have 95 %, the first is {m_firstFull}; main thread p99 " +
        $"{m_mainThreadMs.Order().ElementAt(m_mainThreadMs.Length * 99 / 100):0.00} ms, {GarbageAtRest} bytes of garbage at rest";

    void Add(int frame, in FrameStats stats, double ms)
    {
        m_mainThreadMs[frame] = ms;
        ReadBytes += stats.ReadBytes;
        bool isFull = stats.SelectedPoints > 0 && stats.MissingPages == 0 && stats.DrawnPoints >= 0.95 * stats.SelectedPoints;
        m_full += isFull ? 1 : 0;
        m_firstFull = isFull && m_full == 1 ? frame : m_firstFull;
    }
}
