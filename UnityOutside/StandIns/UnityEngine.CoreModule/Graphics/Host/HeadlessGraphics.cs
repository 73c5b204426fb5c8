namespace UnityOutside.Graphics;

public static class HeadlessGraphics
{
    /// <summary>Frames that the device may be behind: Unity's QualitySettings.maxQueuedFrames.</summary>
    public const int FramesInFlight = 2;

    static readonly Queue<ulong> s_endsOfFrames = new Queue<ulong>();
    static int s_framesBehind;
    public static bool IsAvailable => UnsupportedReason.Length == 0;

    /// <summary>What is missing, in one line; empty if nothing is.</summary>
    public static string UnsupportedReason
    {
        get
        {
            if (GpuDevice.TryGet(out string reason) == null)
                return reason;
            return ShaderCompiler.IsThere ? "" : "there is no glslangValidator (Debian, Ubuntu: apt-get install glslang-tools)";
        }
    }

    public static bool Validate
    {
        get => GpuDevice.Exists ? GpuDevice.Current.IsValidated : GpuDevice.Validate;
        set => GpuDevice.Validate = value;
    }

    public static long UsedBytes => GpuDevice.Exists ? (long)GpuDevice.Current.Memory.UsedBytes : 0;

    public static long MemoryLimitBytes
    {
        get => (long)System.Math.Min(long.MaxValue, GpuDevice.Current.Memory.LimitBytes);
        set => GpuDevice.Current.Memory.LimitBytes = (ulong)value;
    }

    /// <summary>0: work completes at once. Otherwise it is reported complete this many frames later, as a GPU does
    /// that has much to do, or whose frames nobody waits for.</summary>
    public static int FramesBehind
    {
        get => s_framesBehind;
        set
        {
            s_framesBehind = value;
            s_endsOfFrames.Clear();
            if (!GpuDevice.Exists)
                return;
            GpuQueue queue = GpuDevice.Current.Queue;
            queue.Await(queue.Flush());
            queue.NotBeyond = value == 0 ? ulong.MaxValue : queue.Known;
        }
    }

    /// <summary>A device without compute shaders, as WebGL 2: what takes them is refused.</summary>
    public static bool HasNoCompute { get; set; }

    public static bool HasNoFences { get; set; }

    /// <summary>A device that gives vertex shaders so many storage buffers; null: as it is.</summary>
    public static int? VertexBuffers { get; set; }

    /// <summary>What the validation layer has said since the last call: nothing, or there is a fault.</summary>
    public static string[] TakeValidationMessages() => ValidationLog.Take();

    public static void EndFrame()
    {
        if (!GpuDevice.Exists)
            return;
        GpuQueue queue = GpuDevice.Current.Queue;
        s_endsOfFrames.Enqueue(queue.Flush());
        if (s_endsOfFrames.Count > (s_framesBehind > 0 ? s_framesBehind : FramesInFlight))
        {
            ulong oldest = s_endsOfFrames.Dequeue();
            queue.Await(oldest);
            if (s_framesBehind > 0)
                queue.NotBeyond = oldest;
        }
        ReadbackTable.EndFrame();
    }

    public static void WaitForIdle()
    {
        if (!GpuDevice.Exists)
            return;
        GpuQueue queue = GpuDevice.Current.Queue;
        queue.Await(queue.Flush());
    }
}
