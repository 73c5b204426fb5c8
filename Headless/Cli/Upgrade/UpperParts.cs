namespace FastPoints.Cli.Upgrade;

/// <summary>The upper nodes of a cloud of version 2, which were one table, as the parts that they were made in: nodes of a part
/// were sampled together.</summary>
sealed unsafe class UpperParts : IDisposable
{
    readonly OldTable m_table;
    readonly GridCube m_root;
    readonly int[] m_partOf, m_indexIn; // By node.
    readonly List<(Subtree Part, int Above, List<int> Nodes)> m_parts = [];

    /// <param name="table">Its planes are where <paramref name="container"/> has them.</param>
    public UpperParts(OldTable table, int planeCount, in ContainerRecord container, GridCube root)
    {
        m_table = table;
        m_root = root;
        m_partOf = new int[table.NodeCount];
        m_indexIn = new int[table.NodeCount];
        Divide();
        foreach (var (subtree, _, nodes) in m_parts)
        {
            subtree.Container = container;
            Fill(subtree, nodes, planeCount);
        }
    }

    public Subtree Root => m_parts.Count > 0 ? m_parts[0].Part : new Subtree();

    public void Dispose()
    {
        foreach (var (subtree, _, _) in m_parts)
            subtree.DisposeTable();
    }

    public void Attach(int node, Subtree subtree) => m_parts[m_partOf[node]].Part.Children.Add((m_indexIn[node], subtree));

    /// <summary>Hangs the parts on one another, when all chunks hang on them: their cubes hold what is below.</summary>
    public void Join()
    {
        for (int p = m_parts.Count - 1; p >= 0; p--)
        {
            var (subtree, above, nodes) = m_parts[p];
            subtree.Cube = above < 0 ? m_root : m_table.Nodes[nodes[0]].Cube;
            foreach (int node in nodes)
                subtree.Cube = Around(subtree.Cube, m_table.Nodes[node].Cube);
            foreach (var (_, below) in subtree.Children)
                subtree.Cube = Around(subtree.Cube, below.Cube);
            subtree.SortChildren(m_root.Corner);
            if (above >= 0)
                Attach(above, subtree);
        }
    }

    void Divide()
    {
        var nodes = m_table.Nodes;
        var known = new Dictionary<(int Above, int SamplingGroup), int>();
        for (int i = 0; i < m_table.NodeCount; i++)
        {
            int parent = nodes[i].Parent, part;
            bool isInlined = nodes[i].PlaneNode != i;
            if (parent >= 0 && (isInlined || nodes[parent].SamplingGroup == nodes[i].SamplingGroup))
            {
                part = m_partOf[parent];
            }
            else if (!known.TryGetValue((parent, nodes[i].SamplingGroup), out part))
            {
                known.Add((parent, nodes[i].SamplingGroup), part = m_parts.Count);
                m_parts.Add((new Subtree { SamplingGroup = nodes[i].SamplingGroup }, parent, []));
            }
            m_partOf[i] = part;
            m_indexIn[i] = m_parts[part].Nodes.Count;
            m_parts[part].Nodes.Add(i);
        }
    }

    void Fill(Subtree subtree, List<int> nodes, int planeCount)
    {
        subtree.NodeCount = nodes.Count;
        subtree.Table = new NativeArray<byte>(nodes.Count * ChunkResult.BytesPerNode(planeCount), Allocator.Persistent);
        var records = (NodeRecord*)subtree.Table.GetUnsafePtr();
        var ranges = (PlaneRange*)(records + nodes.Count);
        for (int i = 0; i < nodes.Count; i++)
        {
            var record = m_table.Nodes[nodes[i]];
            bool isRoot = record.Parent < 0 || m_partOf[record.Parent] != m_partOf[nodes[i]];
            record.Parent = isRoot ? -1 : m_indexIn[record.Parent];
            record.PlaneNode = record.PlaneNode == nodes[i] ? i : record.Parent;
            record.FirstChild = record.ChildCount = 0;
            records[i] = record;
            if (!isRoot && records[record.Parent].ChildCount++ == 0)
                records[record.Parent].FirstChild = i;
            for (int p = 0; p < planeCount; p++)
                ranges[(long)i * planeCount + p] = m_table.RangesOf(nodes[i])[p];
        }
    }

    GridCube Around(GridCube a, GridCube b)
    {
        while (!a.ContainsAligned(b))
        {
            var from = a.Corner - m_root.Corner;
            int side = a.SideLog2 + 1;
            a = new GridCube(m_root.Corner + new Grid3(from.X >> side << side, from.Y >> side << side, from.Z >> side << side),
                side);
        }
        return a;
    }
}
