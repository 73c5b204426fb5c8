namespace StandIns.Safety;

/// <summary>What all handles of one container's memory point at. Releasing it bumps the version, so that every copy of the
/// container knows; jobs in flight are kept as flags, so that an access costs two loads.</summary>
unsafe struct SafetyNode
{
    internal const int WriterInFlight = 1;
    internal const int ReaderInFlight = 2;

    public int Version;
    public int SecondaryVersion;
    public int InFlight;
    public int Index;
    public int BumpOnScheduledWrite;

    const int SlabNodes = 256;
    static readonly object s_lock = new object();
    static readonly Stack<IntPtr> s_free = new Stack<IntPtr>();
    static int s_count;

    internal static SafetyNode* Create()
    {
        lock (s_lock)
        {
            if (s_free.Count == 0)
                AddSlab();
            var node = (SafetyNode*)s_free.Pop();
            node->InFlight = 0;
            node->BumpOnScheduledWrite = 0;
            return node;
        }
    }

    internal static void Release(SafetyNode* node, bool recycle)
    {
        lock (s_lock)
        {
            node->Version++;
            node->SecondaryVersion++;
            if (recycle)
                s_free.Push((IntPtr)node);
        }
    }

    // Slabs are never given back: a stale copy of a container may look at its node at any time.
    static void AddSlab()
    {
        var nodes = (SafetyNode*)NativeHeap.Allocate(SlabNodes * sizeof(SafetyNode), 16);
        for (int i = SlabNodes - 1; i >= 0; i--)
        {
            nodes[i] = new SafetyNode { Version = 1, SecondaryVersion = 1, Index = s_count + i };
            s_free.Push((IntPtr)(nodes + i));
        }
        s_count += SlabNodes;
    }
}
