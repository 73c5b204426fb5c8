namespace StandIns.Memory;

/// <summary>Allocator.Temp: memory of one thread that nobody has to give back. What a job leaves is freed when it ends, what the
/// main thread leaves when the frame ends; containers in it are disposed then.</summary>
static unsafe class TempMemory
{
    [ThreadStatic] static List<IntPtr> t_blocks;
    [ThreadStatic] static List<(IntPtr Node, int Version)> t_containers;

    /// <summary>What is alive on this thread now, to free what comes after it.</summary>
    internal struct Mark
    {
        internal int Blocks;
        internal int Containers;
    }

    internal static Mark Now => new Mark { Blocks = t_blocks?.Count ?? 0, Containers = t_containers?.Count ?? 0 };

    internal static void* Allocate(long size, int alignment)
    {
        CheckThread();
        void* memory = NativeHeap.Allocate(size, alignment);
        (t_blocks ??= new List<IntPtr>()).Add((IntPtr)memory);
        return memory;
    }

    internal static void NoteContainer(SafetyNode* node) =>
        (t_containers ??= new List<(IntPtr, int)>()).Add(((IntPtr)node, node->Version));

    internal static void Free(void* memory)
    {
        int at = t_blocks == null ? -1 : t_blocks.LastIndexOf((IntPtr)memory);
        // Not found: freed already with its job or frame, which Unity lets pass too.
        if (at < 0)
            return;
        t_blocks.RemoveAt(at);
        NativeHeap.Free(memory);
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    static void CheckThread()
    {
        if (!JobThread.IsExecuting && !MainThread.IsCurrent)
            throw new ArgumentException("Could not allocate native memory. If this allocation was made from a managed thread "
                + "outside of a job, you must use Allocator.Persistent or Allocator.TempJob.");
    }

    internal static void FreeSince(Mark mark)
    {
        if (t_containers != null)
        {
            for (int i = t_containers.Count - 1; i >= mark.Containers; i--)
            {
                var node = (SafetyNode*)t_containers[i].Node;
                if (node->Version == t_containers[i].Version)
                    SafetyNode.Release(node, recycle: true);
                t_containers.RemoveAt(i);
            }
        }
        if (t_blocks == null)
            return;
        for (int i = t_blocks.Count - 1; i >= mark.Blocks; i--)
        {
            NativeHeap.Free((void*)t_blocks[i]);
            t_blocks.RemoveAt(i);
        }
    }
}
