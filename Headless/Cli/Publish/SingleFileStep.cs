namespace FastPoints.Cli.Publish;

/// <summary>Puts the planes and pages of a cloud into one file: the planes of each container as they lie, then all pages, in
/// which only places and hashes change. One page is in memory at a time, and some megabytes of planes.</summary>
sealed unsafe class SingleFileStep : IDisposable
{
    readonly CloudFolder m_cloud;
    readonly StageProgress m_progress;
    readonly CloudFolderWriter m_to;
    readonly PieceFileWriter m_file;
    readonly Dictionary<string, long> m_shiftOfFile = [];
    readonly List<(string Path, ContainerRecord Container)> m_containers = [];
    long m_planesEnd = FileHeader.SizeBytes;

    SingleFileStep(CloudFolder cloud, string target, StageProgress progress)
    {
        m_cloud = cloud;
        m_progress = progress;
        m_to = new CloudFolderWriter(target);
        m_file = new PieceFileWriter(m_to, StoreFormat.SingleFileName);
    }

    public static IEnumerator<JobStep> Run(string folder, string target, StageProgress progress)
    {
        using (var cloud = CloudFolder.Open(folder))
        {
            if (cloud.IsUnfinished || cloud.Manifest.IsSingleFile || SourcePath.IsRemote(folder))
                throw new PointCloudException(FailureCode.Unsupported, folder, -1, "wanted a finished cloud of several files on "
                    + "this machine, got " + (cloud.IsUnfinished ? "one that is being built"
                    : cloud.Manifest.IsSingleFile ? "one of a single file" : "an address"));
            using var step = new SingleFileStep(cloud, target, progress);
            yield return JobStep.Of(DerivedCloud.Begin(step.m_to));
            progress.Begin("check");
            yield return JobStep.Of(step.CheckPlanes());
            progress.Begin("planes");
            yield return JobStep.Of(step.CopyPlanes());
            progress.Begin("pages");
            yield return JobStep.Of(step.WritePages());
            yield return JobStep.Of(DerivedCloud.End(step.m_to, cloud.Manifest, folder, StoreFormat.SourcesName,
                StoreFormat.RecordsName, StoreFormat.FactsName));
        }
        // The writer's.
        Directory.Delete(Path.Combine(target, StoreFormat.ChunkFolderName));
        Directory.Delete(Path.Combine(target, StoreFormat.UpperFolderName));
        progress.End();
    }

    public void Dispose()
    {
        m_to.Dispose();
        m_file.Dispose();
    }

    /// <summary>Hashes all planes, and gives each container its place.</summary>
    IEnumerator<JobStep> CheckPlanes()
    {
        long points = 0;
        byte[] buffer = [];
        int page = 0;
        foreach (var table in m_cloud.EachTable())
        {
            if (table.Nodes.Length > 0)
            {
                string path = m_cloud.PlanesPathOf(page), ofComputed = m_cloud.PathOfComputed(page);
                Place(path, m_cloud.PlanesContainerOf(page));
                Place(ofComputed, m_cloud.ContainerOfComputed(page));
                using var built = OpenHandle(path);
                using var computed = OpenHandle(ofComputed);
                for (int i = 0; i < table.PlaneRanges.Length; i++)
                {
                    var range = table.PlaneRanges[i];
                    var file = IsComputed(i % table.PlaneCount) ? computed : built;
                    if (buffer.Length < range.LengthBytes)
                        buffer = new byte[range.LengthBytes];
                    var bytes = buffer.AsSpan(0, (int)range.LengthBytes);
                    PieceFileWriter.Read(file, path, range.OffsetBytes, bytes);
                    if (range.LengthBytes > 0 && ContentHash.Of(bytes) is var hash && hash != range.Hash)
                        throw new PointCloudException(FailureCode.BadInput, file == built ? path : ofComputed,
                            range.OffsetBytes, "a plane is damaged: " + StoreFile.HashProblem(range.Hash, hash));
                }
                points += table.View.Header.PointCount;
            }
            page++;
            m_progress.Report(points / Math.Max(1.0, m_cloud.Manifest.Points), points, 0);
            yield return default;
        }
    }

    bool IsComputed(int plane) => m_cloud.Layout.Planes[plane].IsComputed;

    void Place(string path, ContainerRecord container)
    {
        if (!m_shiftOfFile.TryAdd(path, m_planesEnd - FileHeader.SizeBytes))
            return;
        m_containers.Add((path, container));
        m_planesEnd += container.FileBytes - FileHeader.SizeBytes;
    }

    IEnumerator<JobStep> CopyPlanes()
    {
        long done = FileHeader.SizeBytes;
        foreach (var (path, container) in m_containers)
        {
            using var file = OpenHandle(path);
            for (long at = FileHeader.SizeBytes; at < container.FileBytes;)
            {
                int count = (int)Math.Min(PieceFileWriter.BytesPerPiece, container.FileBytes - at);
                m_file.Append(file, path, at, count);
                at += count;
                done += count;
                m_progress.Report(done / (double)m_planesEnd, 0, done);
                if (m_file.IsFull)
                    yield return JobStep.Of(m_file.Flush());
            }
        }
        yield return JobStep.Of(m_file.Flush());
    }

    IEnumerator<JobStep> WritePages()
    {
        var manifest = m_cloud.Manifest;
        long shift = m_planesEnd - FileHeader.SizeBytes;
        var whole = new ContainerRecord
        {
            Cube = manifest.Root,
            Kind = ContainerKind.SingleFile,
            FileBytes = manifest.HierarchyFileBytes + shift,
            Hash = ContentHash.Of(MemoryMarshal.AsBytes<ulong>(m_containers.Select(c => c.Container.Hash).ToArray())),
        };
        var hashes = new ulong[m_cloud.PageCount];
        for (int page = hashes.Length - 1; page >= 0; page--)
        {
            var piece = m_cloud.TableOf(page);
            using var bytes = StoreFile.Read(piece.Path, piece.OffsetBytes, piece.LengthBytes, Allocator.Persistent);
            Move(page, bytes, whole, shift, hashes);
            yield return JobStep.Of(CloudFolderWriter.Await(
                m_to.WritePiece(StoreFormat.SingleFileName, bytes, piece.OffsetBytes + shift)));
            m_progress.Report(1 - page / (double)hashes.Length, 0, 0);
        }
        manifest.IsSingleFile = true;
        manifest.HierarchyFileBytes = whole.FileBytes;
        manifest.RootOffset += shift;
        manifest.RootHash = hashes[0];
        yield return JobStep.Of(m_file.Seal(new FileHeader
        {
            Magic = StoreFormat.HierarchyMagic,
            PlaneCount = m_cloud.Layout.Planes.Count,
            Container = whole,
            CloudId = manifest.CloudId,
            PointCount = manifest.Points,
        }));
    }

    void Move(int page, NativeArray<byte> bytes, in ContainerRecord whole, long shift, ulong[] hashes)
    {
        var view = PageView.Of(bytes);
        var header = view.Header;
        for (int c = 0; c < header.ContainerCount; c++)
            view.Containers[c] = whole;
        for (int r = 0; r < header.NodeCount * header.PlaneCount; r++)
        {
            var range = view.Ranges[r].Range;
            if (range.LengthBytes == 0)
                continue;
            range.OffsetBytes += m_shiftOfFile[IsComputed(r % header.PlaneCount) ? m_cloud.PathOfComputed(page)
                : m_cloud.PlanesPathOf(page)];
            view.Ranges[r] = new PackedRange(range);
        }
        for (int l = 0; l < header.LinkCount; l++)
        {
            view.Links[l].OffsetBytes += shift;
            view.Links[l].Container = -1;
            view.Links[l].Hash = hashes[m_cloud.FirstBelow(page) + l];
        }
        hashes[page] = ContentHash.Of(bytes.AsReadOnlySpan());
    }

    static Microsoft.Win32.SafeHandles.SafeFileHandle OpenHandle(string path)
    {
        // Says what is missing, as other readers do.
        StoreFile.SizeOf(path);
        return File.OpenHandle(path);
    }
}
