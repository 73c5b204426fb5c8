namespace UnityEngine.Rendering;

/// <summary>Tells whether the device has come to a certain command.</summary>
public struct GraphicsFence
{
    // The submission of each of the last fences; before it is executed a fence has none.
    const int Kept = 1024;
    static readonly ulong[] s_submissionOf = new ulong[Kept];
    static int s_last;

    int m_id;
    GraphicsFenceType m_type;

    /// <summary>Also true for a fence so old that a thousand came after it.</summary>
    /// <exception cref="InvalidOperationException">Nothing made it.</exception>
    /// <exception cref="NotSupportedException">There are no fences, or it is one for the queue of async compute, which there is
    /// none of here.</exception>
    public bool passed
    {
        get
        {
            if (m_id == 0)
                throw new InvalidOperationException("This GraphicsFence was not made by CreateGraphicsFence");
            if (!SystemInfo.supportsGraphicsFence)
                throw new NotSupportedException("this platform has not implemented GraphicsFences");
            if (m_type != GraphicsFenceType.CPUSynchronisation)
                throw new NotSupportedException("a fence of AsyncQueueSynchronisation, without async compute");
            ulong number = s_submissionOf[m_id % Kept];
            return m_id <= s_last - Kept || (number > 0 && GpuDevice.Current.Queue.HasPassed(number));
        }
    }

    internal readonly int Id => m_id;

    internal static GraphicsFence Create(GraphicsFenceType type)
    {
        s_last++;
        s_submissionOf[s_last % Kept] = 0;
        return new GraphicsFence { m_id = s_last, m_type = type };
    }

    internal static void Execute(int id, ulong submission) => s_submissionOf[id % Kept] = submission;
}
