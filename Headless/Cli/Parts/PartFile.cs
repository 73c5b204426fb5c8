namespace FastPoints.Cli.Parts;

/// <summary>The two files of a part: the tops that are merged with those of other parts, which the merge reads, and the
/// tables of its nodes, which are for the hierarchy.</summary>
static class PartFile
{
    public const string TopsName = "part.tops";
    public const string NodesName = "part.nodes";

    /// <summary>Coroutine: writes both, when the part's upper levels are collected.</summary>
    /// <param name="folder">The part's.</param>
    /// <param name="cube">The part's; the root, if the root's region is merged.</param>
    /// <param name="inputs">The parts whose tops were added to the merge, in the same order; chunks may come in
    /// between.</param>
    public static IEnumerator<JobStep> Write(CloudFolderWriter folder, GridCube cube, ulong cloudId, UpperMerge merge,
        PartResult result, params PartTops[] inputs)
    {
        var nodes = new PartNodes { Cube = cube, Result = result, OpenTops = merge.Unmerged.Count };
        var header = new PartHeader { Magic = PartHeader.NodesMagic, CloudId = cloudId };
        using (var file = new PartFileWriter(folder, NodesName, header, nodes.FactsToBytes()))
        {
            int planeCount = result.BytesOfPlane.Length;
            var attachPoints = new PartAttachPoints(merge);
            foreach (var item in merge.Added)
                if (item.Chunk != null && item.Top.HasNodes)
                    yield return JobStep.Of(AddTable(file, item.ToSubtree(), planeCount,
                        attachPoints.Of(item.AttachPoint), nodes.Chunks));
            foreach (var region in attachPoints.Regions)
                yield return JobStep.Of(AddTable(file, region.Subtree, planeCount, attachPoints.Of(region), nodes.Regions));
            attachPoints.AddInputs(merge, inputs, nodes.Inputs);
            yield return JobStep.Of(file.Finish(nodes.EntriesToBytes()));
            header.NodesHash = file.HeaderHash;
        }
        header.Magic = PartHeader.TopsMagic;
        using (var file = new PartFileWriter(folder, TopsName, header, new byte[0]))
        {
            var tops = new PartTops();
            foreach (var item in merge.Unmerged)
                yield return JobStep.Of(AddTop(file, item, merge.TopStride, tops.Items));
            yield return JobStep.Of(file.Finish(tops.ToBytes()));
        }
    }

    /// <summary>What is known of a part's points. Any thread.</summary>
    /// <exception cref="PointCloudException">It is damaged, or another cloud's.</exception>
    public static PartResult ReadResult(string nodesPath, ulong cloudId)
    {
        PartHeader.Read(nodesPath, PartHeader.NodesMagic, cloudId, out byte[] facts);
        return PartNodes.OfFacts(nodesPath, facts).Result;
    }

    /// <summary>All of part.nodes but the tables, which stay in the file. Any thread.</summary>
    /// <exception cref="PointCloudException">It is damaged, or another cloud's.</exception>
    public static PartNodes ReadNodes(string path, ulong cloudId)
    {
        var header = PartHeader.Read(path, PartHeader.NodesMagic, cloudId, out byte[] facts);
        var nodes = PartNodes.OfFacts(path, facts);
        nodes.Hash = header.HeaderHash;
        nodes.ReadEntries(path, header);
        return nodes;
    }

    /// <summary>The tops of a part; their records stay in the file. Any thread.</summary>
    /// <exception cref="PointCloudException">One is damaged, or another cloud's.</exception>
    public static PartTops ReadTops(PartInput input, ulong cloudId, int strideBytes)
    {
        var nodes = PartHeader.Read(input.NodesPath, PartHeader.NodesMagic, cloudId, out byte[] facts);
        var header = PartHeader.Read(input.TopsPath, PartHeader.TopsMagic, cloudId, out _);
        PartHeader.Check(input.TopsPath, 32, "hash of " + input.NodesPath, nodes.HeaderHash, header.NodesHash);
        var tops = new PartTops { NodesHash = nodes.HeaderHash, Result = PartNodes.OfFacts(input.NodesPath, facts).Result };
        tops.ReadEntries(input.TopsPath, header, strideBytes);
        return tops;
    }

    static IEnumerator<JobStep> AddTable(PartFileWriter file, Subtree subtree, int planeCount, PartAttachPoint attachPoint,
        List<PartNodes.Entry> entries)
    {
        bool isLoaded = subtree.Table.IsCreated;
        try
        {
            if (!isLoaded)
                yield return JobStep.Of(subtree.Load(planeCount));
            entries.Add(new PartNodes.Entry
            {
                Container = subtree.Container,
                NodeCount = subtree.NodeCount,
                TableOffset = file.Offset,
                TableHash = HashOf(subtree.Table),
                AttachPoint = attachPoint,
            });
            yield return JobStep.Of(file.Add(subtree.Table));
        }
        finally
        {
            if (!isLoaded)
                subtree.DisposeTable();
        }
    }

    static IEnumerator<JobStep> AddTop(PartFileWriter file, MergeInput item, int strideBytes, List<MergeInput> entries)
    {
        using var read = new StoreRead();
        var records = item.Records;
        if (!records.IsCreated)
        {
            read.Begin(item.Path, item.RecordsOffset, item.TopPoints * (long)strideBytes);
            yield return read.Done;
            read.Complete();
            records = read.Bytes;
            StoreFile.CheckHash(item.Path, item.RecordsOffset, records, item.RecordsHash);
        }
        entries.Add(new MergeInput
        {
            Cube = item.Cube,
            Top = item.Top,
            TopPoints = item.TopPoints,
            RecordsOffset = file.Offset,
            RecordsHash = HashOf(records),
        });
        yield return JobStep.Of(file.Add(records));
    }

    static unsafe ulong HashOf(NativeArray<byte> bytes) => ContentHash.Of(bytes.GetUnsafeReadOnlyPtr(), bytes.Length);
}

struct PartInput
{
    public string TopsPath;
    public string NodesPath;
}
