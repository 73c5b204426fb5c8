namespace FastPoints.Cli.Parts;

/// <summary>Makes one of several parts: a merge makes the upper levels of a larger cube, the last one those of the cloud;
/// then the commit writes the hierarchy. All bytes are those that one build of everything would write.</summary>
static class PartMerge
{
    /// <summary>Coroutine: merges what is left open of parts. The folder then has upper/*.bin, and <see cref="PartFile"/>'s
    /// two.</summary>
    /// <param name="part">Its cube holds those of the inputs. If that is the plan's, it is the last merge.</param>
    /// <param name="buckets">For the last merge: those whose points the parts have.</param>
    /// <param name="output">Receives what is known of the points, with those of the inputs.</param>
    public static IEnumerator<JobStep> Run(BuildPart part, IReadOnlyList<PartInput> inputs,
        IReadOnlyList<PartResult> buckets, PartOutput output)
    {
        var progress = output.Progress;
        using var build = new BuildContext(part, new PointReader[0], 0, output.Folder, output.Settings, progress);
        if (build.Folder.HasLeftovers)
            yield return JobStep.Of(build.Folder.Clear());
        progress?.Begin(BuildStages.Merge);
        var manifest = part.ToManifest(output.Settings.Sampler);
        using var store = new NativeStoreLayout(manifest.CreateLayout());
        using var merge = new UpperMerge(build, store, manifest);
        var all = new List<PartTops>();
        var result = new PartResult(part.Attributes.Count, merge.BytesOfPlane.Length);
        foreach (var bucket in buckets)
            result.Include(bucket);
        foreach (var input in inputs)
        {
            yield return JobStep.Of(PoolTask.Run(input.TopsPath,
                () => PartFile.ReadTops(input, part.CloudId, merge.TopStride), all.Add));
            foreach (var item in all[all.Count - 1].Items)
                merge.Add(item);
            result.Include(all[all.Count - 1].Result);
        }
        manifest.Root = part.IsWhole ? RootOf(part.CloudCube, result.Statistics) : part.Cube;
        yield return JobStep.Of(merge.Collect(manifest.Root, progress));
        if (part.IsWhole)
            yield return JobStep.Of(merge.MergeRoot());
        result.Include(merge.MinSideLog2, merge.BytesOfPlane);
        yield return JobStep.Of(PartFile.Write(build.Folder, manifest.Root, part.CloudId, merge, result, all.ToArray()));
        yield return JobStep.Of(build.Folder.Complete());
        progress?.End();
        output.Take(result);
    }

    /// <summary>Coroutine: writes hierarchy.bin of all parts into a folder, and adds it to the manifest.</summary>
    /// <param name="nodesPaths">The files of all parts and of all merges, in any order.</param>
    /// <param name="manifest">Complete but for the root, the counts of chunks and nodes, and the hierarchy.</param>
    public static IEnumerator<JobStep> Commit(IReadOnlyList<string> nodesPaths, CloudManifest manifest, string folder,
        StageProgress progress)
    {
        using var writer = new CloudFolderWriter(folder);
        if (writer.HasLeftovers)
            yield return JobStep.Of(writer.Clear());
        progress?.Begin(BuildStages.Finish);
        var graph = new PartGraph();
        foreach (string path in nodesPaths)
            yield return JobStep.Of(PoolTask.Run(path, () => PartFile.ReadNodes(path, manifest.CloudId),
                nodes => graph.Add(path, nodes)));
        var root = graph.Join(folder, manifest);
        try
        {
            if (root.NodeCount > 0)
                yield return JobStep.Of(root.Load(manifest.CreateLayout().Planes.Count));
            yield return JobStep.Of(HierarchyFile.Write(writer, manifest, root));
        }
        finally
        {
            root.DisposeTable();
        }
        yield return JobStep.Of(writer.Complete());
        progress?.End();
    }

    static GridCube RootOf(GridCube whole, in PointStatistics found)
    {
        if (found.Count == 0)
            return whole;
        var grown = RootCube.Grow(whole, found.Min, found.Max);
        return RootCube.Shrink(grown.Length > 0 ? grown[grown.Length - 1] : whole, found.Min, found.Max);
    }
}

/// <summary>The chunks and regions of all parts, and what they hang on.</summary>
sealed class PartGraph
{
    sealed class File
    {
        public required string Path;
        public required PartNodes Nodes;
        public required Subtree[] Regions;
        public File? Above; // The merge that took it in, and as which input.
        public int Input;
    }

    readonly List<File> m_files = new List<File>();
    readonly Dictionary<ulong, File> m_byHash = new Dictionary<ulong, File>();

    public void Add(string path, PartNodes nodes)
    {
        var file = new File { Path = path, Nodes = nodes, Regions = new Subtree[nodes.Regions.Count] };
        for (int r = 0; r < file.Regions.Length; r++)
            file.Regions[r] = SubtreeOf(path, nodes.Regions[r]);
        m_files.Add(file);
        if (!m_byHash.TryAdd(nodes.Hash, file))
            throw new PointCloudException(FailureCode.BadInput, path, -1, "is the same as " + m_byHash[nodes.Hash].Path);
    }

    /// <summary>Hangs all on one another, and adds root and number of chunks to the manifest.</summary>
    /// <returns>The root's region; one without nodes if the cloud is empty.</returns>
    public Subtree Join(string folder, CloudManifest manifest)
    {
        File? last = null;
        foreach (var file in m_files)
            for (int i = 0; i < file.Nodes.Inputs.Count; i++)
                LinkInput(file, i);
        foreach (var file in m_files)
        {
            if (file.Above != null)
                continue;
            if (last != null)
                throw new PointCloudException(FailureCode.BadInput, file.Path, -1, "no merge took it in, nor " + last.Path +
                    ": wanted one such part, got two");
            last = file;
        }
        if (last == null)
            throw new PointCloudException(FailureCode.BadInput, folder, -1, "wanted parts to commit, got none");
        if (last.Nodes.OpenTops > 0)
            throw PointCloudException.Wanted(FailureCode.BadInput, last.Path, -1, "tops that are not merged", 0,
                last.Nodes.OpenTops);
        manifest.Root = last.Nodes.Cube;
        manifest.ChunkCount = 0;
        var root = new Subtree();
        foreach (var file in m_files)
        {
            manifest.ChunkCount += file.Nodes.Chunks.Count;
            foreach (var chunk in file.Nodes.Chunks)
                Attach(file, chunk.AttachPoint, SubtreeOf(file.Path, chunk));
            for (int r = 0; r < file.Regions.Length; r++)
                if (file.Nodes.Regions[r].AttachPoint.Region == PartAttachPoint.Root)
                    root = file.Regions[r];
                else
                    Attach(file, file.Nodes.Regions[r].AttachPoint, file.Regions[r]);
        }
        foreach (var file in m_files)
            foreach (var region in file.Regions)
                region.SortChildren(manifest.Root.Corner);
        return root;
    }

    void LinkInput(File file, int input)
    {
        ulong hash = file.Nodes.Inputs[input].NodesHash;
        if (!m_byHash.TryGetValue(hash, out var below))
            throw PointCloudException.Wanted(FailureCode.BadInput, file.Path, -1, "part.nodes of its input " + input,
                "one with hash " + hash.ToString("x16"), "none");
        if (below.Above != null)
            throw new PointCloudException(FailureCode.BadInput, below.Path, -1, "two merges took it in: " +
                below.Above.Path + " and " + file.Path);
        (below.Above, below.Input) = (file, input);
    }

    static void Attach(File file, PartAttachPoint attachPoint, Subtree subtree)
    {
        while (attachPoint.Region == PartAttachPoint.Open && file.Above != null &&
            attachPoint.Node < file.Above.Nodes.Inputs[file.Input].AttachPoints.Count)
            (attachPoint, file) = (file.Above.Nodes.Inputs[file.Input].AttachPoints[attachPoint.Node], file.Above);
        if (attachPoint.Region < 0 || attachPoint.Region >= file.Regions.Length || attachPoint.Node < 0 ||
            attachPoint.Node >= file.Regions[attachPoint.Region].NodeCount)
            throw PointCloudException.Wanted(FailureCode.BadInput, file.Path, -1, "what " + subtree.Cube + " hangs on",
                "a node of a region", attachPoint.Node + " of " + attachPoint.Region);
        file.Regions[attachPoint.Region].Children.Add((attachPoint.Node, subtree));
    }

    static Subtree SubtreeOf(string path, in PartNodes.Entry entry) => new Subtree
    {
        Cube = entry.Container.Cube,
        Container = entry.Container,
        NodeCount = entry.NodeCount,
        Path = path,
        TableOffset = entry.TableOffset,
        TableHash = entry.TableHash,
    };
}
