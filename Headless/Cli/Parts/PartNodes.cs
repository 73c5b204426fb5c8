namespace FastPoints.Cli.Parts;

/// <summary>Where something hangs: on a node of a region of the same part, or, as long as nothing is above it, it is one of
/// the part's open tops or belongs to one.</summary>
struct PartAttachPoint
{
    public const int Open = -1;
    public const int Root = -2;
    public int Region; // Number of the region, or one of the above.
    public int Node; // Number of the node, or of the open top.

    public void Write(BinaryWriter to)
    {
        to.Write(Region);
        to.Write(Node);
    }

    public static PartAttachPoint Read(BinaryReader from) =>
        new PartAttachPoint { Region = from.ReadInt32(), Node = from.ReadInt32() };
}

sealed class PartNodes
{
    public struct Entry
    {
        public ContainerRecord Container;
        public int NodeCount;
        public long TableOffset;
        public ulong TableHash;
        public PartAttachPoint AttachPoint;

        public void Write(BinaryWriter to)
        {
            PartBytes.Write(to, Container.Cube);
            to.Write(Container.Part);
            to.Write((ushort)Container.Kind);
            to.Write(Container.FileBytes);
            to.Write(Container.Hash);
            to.Write(NodeCount);
            to.Write(TableOffset);
            to.Write(TableHash);
            AttachPoint.Write(to);
        }

        public static Entry Read(BinaryReader from) => new Entry
        {
            Container = new ContainerRecord
            {
                Cube = PartBytes.ReadCube(from),
                Part = from.ReadInt32(),
                Kind = (ContainerKind)from.ReadUInt16(),
                FileBytes = from.ReadInt64(),
                Hash = from.ReadUInt64(),
            },
            NodeCount = from.ReadInt32(),
            TableOffset = from.ReadInt64(),
            TableHash = from.ReadUInt64(),
            AttachPoint = PartAttachPoint.Read(from),
        };
    }

    public sealed class Input
    {
        public ulong NodesHash;
        public readonly List<PartAttachPoint> AttachPoints = new List<PartAttachPoint>();
    }

    public GridCube Cube; // The part's cube; if it has the root's region, the root.

    public PartResult Result = null!;
    public int OpenTops; // Tops that nothing is above of; 0 when the root's region is merged.
    public ulong Hash; // Tells it from all other parts.

    public readonly List<Entry> Chunks = new List<Entry>();
    public readonly List<Entry> Regions = new List<Entry>();
    public readonly List<Input> Inputs = new List<Input>();

    public byte[] FactsToBytes() => PartBytes.Of(to =>
    {
        PartBytes.Write(to, Cube);
        to.Write(OpenTops);
        Result.Write(to);
    });

    public static PartNodes OfFacts(string path, byte[] facts)
    {
        var nodes = new PartNodes();
        PartBytes.Read(path, PartHeader.SizeBytes, facts, from =>
        {
            nodes.Cube = PartBytes.ReadCube(from);
            nodes.OpenTops = from.ReadInt32();
            nodes.Result = PartResult.Read(from);
        });
        return nodes;
    }

    public byte[] EntriesToBytes() => PartBytes.Of(to =>
    {
        foreach (var entries in new[] { Chunks, Regions })
        {
            to.Write(entries.Count);
            foreach (var entry in entries)
                entry.Write(to);
        }
        to.Write(Inputs.Count);
        foreach (var input in Inputs)
        {
            to.Write(input.NodesHash);
            to.Write(input.AttachPoints.Count);
            foreach (var attachPoint in input.AttachPoints)
                attachPoint.Write(to);
        }
    });

    public void ReadEntries(string path, in PartHeader header) =>
        PartBytes.Read(path, header.EntriesOffset, header.ReadEntries(path), from =>
        {
            foreach (var entries in new[] { Chunks, Regions })
                for (int left = PartBytes.ReadCount(from); left > 0; left--)
                    entries.Add(Entry.Read(from));
            for (int inputs = PartBytes.ReadCount(from); inputs > 0; inputs--)
            {
                var input = new Input { NodesHash = from.ReadUInt64() };
                Inputs.Add(input);
                for (int left = PartBytes.ReadCount(from); left > 0; left--)
                    input.AttachPoints.Add(PartAttachPoint.Read(from));
            }
        });
}

/// <summary>What part.tops says: the tops that nothing is above of yet.</summary>
sealed class PartTops
{
    public ulong NodesHash;
    public PartResult Result = null!; // Where it was read.
    public readonly List<MergeInput> Items = new List<MergeInput>();

    public byte[] ToBytes() => PartBytes.Of(to =>
    {
        to.Write(Items.Count);
        foreach (var item in Items)
        {
            PartBytes.Write(to, item.Cube);
            to.Write(item.Top.SideLog2);
            to.Write(item.Top.CellLog2);
            to.Write(item.Top.IsLeaf);
            to.Write(item.Top.HasNodes);
            to.Write(item.TopPoints);
            to.Write(item.RecordsOffset);
            to.Write(item.RecordsHash);
        }
    });

    public void ReadEntries(string path, in PartHeader header, int strideBytes)
    {
        long end = header.EntriesOffset;
        PartBytes.Read(path, end, header.ReadEntries(path), from =>
        {
            for (int left = PartBytes.ReadCount(from); left > 0; left--)
            {
                var item = new MergeInput
                {
                    Path = path,
                    Cube = PartBytes.ReadCube(from),
                    Top = new TopNode
                    {
                        SideLog2 = from.ReadByte(),
                        CellLog2 = from.ReadByte(),
                        IsLeaf = from.ReadBoolean(),
                        HasNodes = from.ReadBoolean(),
                        AttachNode = -1,
                    },
                    TopPoints = from.ReadInt32(),
                    RecordsOffset = from.ReadInt64(),
                    RecordsHash = from.ReadUInt64(),
                };
                if (item.TopPoints < 0 || item.TopPoints > (end - item.RecordsOffset) / strideBytes)
                    throw PointCloudException.Wanted(FailureCode.BadInput, path, item.RecordsOffset, "points of a top",
                        "at most " + (end - item.RecordsOffset) / strideBytes, item.TopPoints);
                Items.Add(item);
            }
        });
    }
}

/// <summary>Finds what the items and regions of a merge hang on.</summary>
sealed class PartAttachPoints
{
    readonly Dictionary<UpperAttachPoint, int> m_open = new Dictionary<UpperAttachPoint, int>();
    readonly Dictionary<UpperAttachPoint, int> m_numbers = new Dictionary<UpperAttachPoint, int>();

    public PartAttachPoints(UpperMerge merge)
    {
        foreach (var item in merge.Unmerged)
            m_open.Add(item.AttachPoint, m_open.Count);
        foreach (var region in merge.Regions)
        {
            if (region.Subtree.NodeCount == 0)
                continue;
            m_numbers.Add(region, Regions.Count);
            Regions.Add(region);
        }
    }

    public readonly List<UpperRegion> Regions = new List<UpperRegion>(); // Those with nodes.

    public PartAttachPoint Of(UpperAttachPoint attachPoint)
    {
        attachPoint = attachPoint.OfNode();
        if (attachPoint.Above != null)
            return new PartAttachPoint { Region = m_numbers[attachPoint.Above], Node = attachPoint.Node };
        return m_open.TryGetValue(attachPoint, out int open) ? new PartAttachPoint { Region = PartAttachPoint.Open, Node = open }
            : new PartAttachPoint { Region = PartAttachPoint.Root };
    }

    public void AddInputs(UpperMerge merge, IReadOnlyList<PartTops> from, List<PartNodes.Input> to)
    {
        var items = new Queue<MergeInput>();
        foreach (var item in merge.Added)
            if (item.Chunk == null)
                items.Enqueue(item);
        foreach (var tops in from)
        {
            var input = new PartNodes.Input { NodesHash = tops.NodesHash };
            to.Add(input);
            foreach (var _ in tops.Items)
                input.AttachPoints.Add(Of(items.Dequeue().AttachPoint));
        }
    }
}
