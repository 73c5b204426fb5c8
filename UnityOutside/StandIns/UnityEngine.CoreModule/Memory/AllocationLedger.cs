namespace StandIns.Memory;

static unsafe class AllocationLedger
{
    internal const int TempJobFrames = 4; // Frames that TempJob memory may live.

    static readonly object s_lock = new object();
    static readonly Dictionary<IntPtr, Entry> s_entries = new Dictionary<IntPtr, Entry>();
    static NativeLeakDetectionMode s_mode = NativeLeakDetectionMode.Enabled;
    static long s_frame;

    struct Entry
    {
        public Allocator Allocator;
        public bool Tracked;
        public bool Forgiven;
        public long Size;
        public long Frame;
        public string Site;
    }

    static AllocationLedger() => AppDomain.CurrentDomain.ProcessExit += (sender, args) => ReportAtExit();

    internal static NativeLeakDetectionMode Mode
    {
        get => s_mode;
        set
        {
            if (value < NativeLeakDetectionMode.Disabled || value > NativeLeakDetectionMode.EnabledWithStackTrace)
                throw new ArgumentException("NativeLeakDetectionMode out of range", nameof(value));
            s_mode = value;
        }
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    internal static void Add(void* memory, long size, Allocator allocator, bool tracked)
    {
        string site = s_mode == NativeLeakDetectionMode.EnabledWithStackTrace ? new StackTrace(2, true).ToString() : null;
        lock (s_lock)
        {
            s_entries[(IntPtr)memory] = new Entry
            {
                Allocator = allocator,
                Tracked = tracked && s_mode != NativeLeakDetectionMode.Disabled,
                Size = size,
                Frame = s_frame,
                Site = site,
            };
        }
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    internal static void Remove(void* memory, Allocator allocator)
    {
        lock (s_lock)
        {
            if (!s_entries.TryGetValue((IntPtr)memory, out Entry entry))
                throw new InvalidOperationException("The memory is not allocated, or was freed already.");
            if (entry.Allocator != allocator)
                throw new InvalidOperationException(
                    $"The memory was allocated with Allocator.{entry.Allocator} but freed with Allocator.{allocator}.");
            s_entries.Remove((IntPtr)memory);
        }
    }

    internal static int Live(Allocator allocator = Allocator.Invalid)
    {
        lock (s_lock)
        {
            int count = 0;
            foreach (Entry entry in s_entries.Values)
                if (allocator == Allocator.Invalid || entry.Allocator == allocator)
                    count++;
            return count;
        }
    }

    /// <summary>Ends a frame on the main thread; the host's stand-in for the player loop.</summary>
    internal static void AdvanceFrame()
    {
        TempMemory.FreeSince(default);
        string problem = null;
        lock (s_lock)
        {
            s_frame++;
            foreach (Entry entry in s_entries.Values)
            {
                if (entry.Allocator == Allocator.TempJob && !entry.Forgiven && s_frame - entry.Frame > TempJobFrames)
                {
                    problem = "Internal: JobTempAlloc has allocations that are more than the maximum lifespan of "
                        + $"{TempJobFrames} frames old - this is not allowed and likely a leak: {Describe(entry)}";
                    break;
                }
            }
        }
        if (problem != null)
            throw new InvalidOperationException(problem);
    }

    internal static int CheckForLeaks()
    {
        var text = new StringBuilder();
        int count = 0;
        lock (s_lock)
        {
            foreach (Entry entry in s_entries.Values)
            {
                if (!entry.Tracked || entry.Forgiven)
                    continue;
                count++;
                text.AppendLine(Describe(entry));
            }
        }
        if (count > 0)
            UnityEngine.Debug.LogError($"Found {count} leak(s) of native memory:{Environment.NewLine}{text}");
        return count;
    }

    internal static int ForgiveLeaks()
    {
        lock (s_lock)
        {
            int count = 0;
            foreach (IntPtr key in new List<IntPtr>(s_entries.Keys))
            {
                Entry entry = s_entries[key];
                if (!entry.Tracked || entry.Forgiven)
                    continue;
                entry.Forgiven = true;
                s_entries[key] = entry;
                count++;
            }
            return count;
        }
    }

    static string Describe(Entry entry) =>
        $"{entry.Size} bytes of Allocator.{entry.Allocator}"
        + (entry.Site == null ? "" : $", allocated from:{Environment.NewLine}{entry.Site}");

    static void ReportAtExit()
    {
        // Enabled as a default only counts for tests that ask; a report belongs to those who want allocation sites.
        if (s_mode == NativeLeakDetectionMode.EnabledWithStackTrace)
            CheckForLeaks();
    }
}
