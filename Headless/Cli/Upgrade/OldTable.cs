namespace FastPoints.Cli.Upgrade;

/// <summary>The nodes of a file of version 2, breadth first, and where their planes are: the table that pages are made of today.
/// Owns its memory.</summary>
sealed unsafe class OldTable : IDisposable
{
    public const int RangeBytes = 24;

    readonly int m_planeCount;
    NativeArray<byte> m_bytes;

    /// <summary>Takes over the bytes.</summary>
    public OldTable(NativeArray<byte> bytes, int nodeCount, int planeCount) =>
        (m_bytes, NodeCount, m_planeCount) = (bytes, nodeCount, planeCount);

    public int NodeCount { get; }

    public NodeRecord* Nodes => (NodeRecord*)m_bytes.GetUnsafePtr();

    PlaneRange* Ranges => (PlaneRange*)(Nodes + NodeCount);

    public PlaneRange* RangesOf(int node) => Ranges + (long)node * m_planeCount;

    public void Dispose()
    {
        if (m_bytes.IsCreated)
            m_bytes.Dispose();
    }

    /// <returns>Its bytes, which the caller disposes.</returns>
    public NativeArray<byte> Release()
    {
        var bytes = m_bytes;
        m_bytes = default;
        return bytes;
    }

    /// <returns>The first node that is not as the layout wants it, or -1: what is made of the table relies on it.</returns>
    public int FindFault(GridCube root, long planesEnd)
    {
        int nextChild = 0;
        while (nextChild < NodeCount && Nodes[nextChild].Parent == -1)
            nextChild++;
        for (int i = 0; i < NodeCount; i++)
        {
            var node = Nodes[i];
            bool isRight = node.Parent >= -1 && node.Parent < i && root.ContainsAligned(node.Cube) && node.ChildCount >= 0
                && node.ChildCount <= NodeCount - nextChild && (node.ChildCount == 0 || node.FirstChild == nextChild)
                && (node.PlaneNode == i || node.PlaneNode == node.Parent && node.PlaneNode >= 0 && node.ChildCount == 0);
            for (int p = 0; p < m_planeCount; p++)
            {
                var range = RangesOf(i)[p];
                isRight &= node.PlaneNode != i ? range.LengthBytes == 0
                    : range.LengthBytes > 0 && range.LengthBytes < 1 << 28 && (range.OffsetBytes | range.LengthBytes) % 16 == 0
                    && range.OffsetBytes >= OldHeader.SizeBytes && range.OffsetBytes <= planesEnd - range.LengthBytes;
            }
            for (int end = nextChild + (isRight ? node.ChildCount : 0); nextChild < end; nextChild++)
                isRight &= Nodes[nextChild].Parent == i;
            if (!isRight)
                return i;
        }
        return nextChild == NodeCount ? -1 : nextChild;
    }

    /// <summary>Lays the planes out as files have them today: position and colour of all nodes, then the others by node. The
    /// table says so from then on.</summary>
    /// <param name="moves">Receives what is to be copied, by its place in the new file; null if that is known.</param>
    /// <returns>The container's size and hash.</returns>
    public ContainerRecord LayOut(ContainerRecord container, int colorPlane, List<(PlaneRange From, long To)>? moves)
    {
        long at = FileHeader.SizeBytes;
        // Planes that are the same are stored once.
        var places = new Dictionary<(long Offset, long Length), long>();
        for (int pass = 0; pass < 2; pass++)
            for (int i = 0; i < NodeCount; i++)
                for (int p = 0; p < m_planeCount; p++)
                {
                    ref var range = ref RangesOf(i)[p];
                    bool isInFront = p == StoreLayout.PositionPlane || p == colorPlane;
                    if (range.LengthBytes == 0 || isInFront != (pass == 0))
                        continue;
                    var stored = (range.OffsetBytes, range.LengthBytes);
                    if (!places.TryGetValue(stored, out long place))
                    {
                        places.Add(stored, place = at);
                        moves?.Add((range, at));
                        at += range.LengthBytes;
                    }
                    range.OffsetBytes = place;
                }
        container.FileBytes = at;
        container.Hash = ContentHash.Of(Ranges, (long)NodeCount * m_planeCount * RangeBytes);
        return container;
    }
}
