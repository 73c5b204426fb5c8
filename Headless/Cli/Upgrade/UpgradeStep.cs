namespace FastPoints.Cli.Upgrade;

/// <summary>Makes a cloud of today's version of one of version 2, without its sources: the planes' bytes stay. One chunk's nodes
/// and some megabytes of planes are in memory at a time, besides the upper nodes.</summary>
sealed unsafe class UpgradeStep : IDisposable
{
    readonly OldCloud m_old;
    readonly StageProgress m_progress;
    readonly CloudFolderWriter m_to;
    readonly StoreLayout m_layout;
    readonly int m_colorPlane;
    readonly List<(PlaneRange From, long To)> m_moves = [];
    readonly Dictionary<Subtree, OldChunk> m_chunkOfPart = [];
    readonly Dictionary<(Grid3, int), int> m_partsOfCube = [];
    UpperParts? m_upper;
    long m_points;

    UpgradeStep(OldCloud old, string target, StageProgress progress)
    {
        m_old = old;
        m_progress = progress;
        m_layout = old.Manifest.CreateLayout();
        m_colorPlane = m_layout.PlaneOf(StoreLayout.ColorName);
        m_to = new CloudFolderWriter(target);
    }

    /// <summary>Coroutine.</summary>
    /// <param name="target">May be the folder itself: it is replaced when the new one is whole.</param>
    /// <param name="done">Receives the number of points and the new folder's bytes.</param>
    public static IEnumerator<JobStep> Run(string folder, string target, StageProgress progress, Action<long, long> done)
    {
        using var old = OldCloud.Open(folder);
        using var upgrade = new UpgradeStep(old, target, progress);
        yield return JobStep.Of(DerivedCloud.Begin(upgrade.m_to));
        progress.Begin("upgrade");
        yield return JobStep.Of(upgrade.CopyUpper());
        yield return JobStep.Of(upgrade.CopyChunks());
        progress.Begin("hierarchy");
        yield return JobStep.Of(upgrade.WriteHierarchy());
        yield return JobStep.Of(upgrade.WriteTexts(folder));
        progress.End();
        done(old.Manifest.Points, upgrade.m_to.BytesOnDisk);
    }

    public void Dispose()
    {
        m_to.Dispose();
        m_upper?.Dispose();
    }

    IEnumerator<JobStep> CopyUpper()
    {
        var container = new ContainerRecord { Cube = m_old.Manifest.Root, Kind = ContainerKind.Upper };
        var table = m_old.Upper;
        if (table.NodeCount > 0)
        {
            m_moves.Clear();
            container = table.LayOut(container, m_colorPlane, m_moves);
            yield return JobStep.Of(Copy(m_old.UpperPath, container, PointsOf(table)));
        }
        m_upper = new UpperParts(table, m_layout.Planes.Count, container, m_old.Manifest.Root);
    }

    IEnumerator<JobStep> CopyChunks()
    {
        foreach (var chunk in m_old.Chunks)
        {
            var container = new ContainerRecord { Cube = chunk.Cube, Kind = ContainerKind.Chunk };
            container.Part = CollectionsMarshal.GetValueRefOrAddDefault(m_partsOfCube, (chunk.Corner, chunk.SideLog2), out _)++;
            using var table = m_old.TableOf(chunk);
            m_moves.Clear();
            container = table.LayOut(container, m_colorPlane, m_moves);
            yield return JobStep.Of(Copy(m_old.PathOf(chunk), container, PointsOf(table)));
            var subtree = new Subtree { Cube = chunk.Cube, Container = container, NodeCount = chunk.NodeCount };
            m_chunkOfPart.Add(subtree, chunk);
            m_upper!.Attach(chunk.AttachNode, subtree);
        }
        m_upper!.Join();
    }

    IEnumerator<JobStep> Copy(string from, ContainerRecord container, long points)
    {
        string name = StoreFormat.PathOf(container);
        using var pieces = new PieceFileWriter(m_to, name);
        using (var file = File.OpenHandle(from))
            foreach (var (range, _) in m_moves)
            {
                ulong hash = ContentHash.Of(pieces.Append(file, from, range.OffsetBytes, (int)range.LengthBytes));
                OldCloud.RequireHash(from, range.OffsetBytes, range.Hash, hash);
                if (pieces.IsFull)
                    yield return JobStep.Of(pieces.Flush());
            }
        yield return JobStep.Of(pieces.Seal(new FileHeader
        {
            Magic = StoreFormat.PlanesMagic,
            PlaneCount = m_layout.Planes.Count,
            Container = container,
            CloudId = m_old.Manifest.CloudId,
            PointCount = points,
        }));
        m_points += points;
        m_progress.Report(m_points / Math.Max(1.0, m_old.Manifest.Points), m_points, 0);
    }

    IEnumerator<JobStep> WriteHierarchy()
    {
        var manifest = m_old.Manifest;
        string name = StoreFormat.HierarchyName;
        using var pages = new HierarchyWriter(m_layout.Planes.Count, manifest.CloudId, FileHeader.SizeBytes, LoadTable,
            (bytes, offset) => CloudFolderWriter.Await(m_to.WritePiece(name, bytes, offset)));
        PageLink root = default;
        yield return JobStep.Of(pages.Write(m_upper!.Root, link => root = link));
        if (root.SubtreePointCount != manifest.Points || root.SubtreeNodeCount != manifest.NodeCount)
            throw new PointCloudException(FailureCode.BadInput, m_old.UpperPath, -1, "wanted " + manifest.Points + " points in "
                + manifest.NodeCount + " nodes, got " + root.SubtreePointCount + " in " + root.SubtreeNodeCount);
        manifest.RootOffset = root.OffsetBytes;
        manifest.RootBytes = root.LengthBytes;
        manifest.RootHash = root.Hash;
        manifest.HierarchyFileBytes = pages.Offset;
        using var none = new PieceFileWriter(m_to, name);
        yield return JobStep.Of(none.Seal(new FileHeader
        {
            Magic = StoreFormat.HierarchyMagic,
            PlaneCount = m_layout.Planes.Count,
            Container = new ContainerRecord
            {
                Cube = manifest.Root,
                Kind = ContainerKind.Hierarchy,
                FileBytes = manifest.HierarchyFileBytes,
                Hash = manifest.RootHash,
            },
            CloudId = manifest.CloudId,
            PointCount = manifest.Points,
        }));
    }

    IEnumerator<JobStep> LoadTable(Subtree subtree)
    {
        using var table = m_old.TableOf(m_chunkOfPart[subtree]);
        table.LayOut(subtree.Container, m_colorPlane, null);
        subtree.Table = table.Release();
        yield return default;
    }

    IEnumerator<JobStep> WriteTexts(string folder)
    {
        yield return JobStep.Of(m_to.WriteText(StoreFormat.SourcesName, StoredSources.ToJson(m_old.Sources)));
        yield return JobStep.Of(DerivedCloud.End(m_to, m_old.Manifest, folder, StoreFormat.RecordsName,
            StoreFormat.FactsName));
    }

    static long PointsOf(OldTable table)
    {
        long points = 0;
        for (int i = 0; i < table.NodeCount; i++)
            points += table.Nodes[i].PointCount;
        return points;
    }
}
