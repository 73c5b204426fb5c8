namespace FastPoints.Cli.Parts;

/// <summary>For sources whose points are anywhere: writes the points of some blocks as packed records, those of each part
/// together, so that parts read these and no source.</summary>
sealed class BucketBuild : PartStages
{
    BucketBuild(BuildContext build, PartFilter selection) : base(build, selection) { }

    /// <summary>Coroutine. The folder then has the records, <see cref="BuildFiles.BucketName"/>, what is known of them, and
    /// their ranges, for <see cref="ReadRanges"/>.</summary>
    /// <param name="whole">All of the cloud.</param>
    /// <param name="cubes">Of the parts, which fill its cube, in Morton order.</param>
    /// <param name="blocks">Ascending. The reader's blocks are known.</param>
    /// <exception cref="PointCloudException">A source or the folder is at fault, or a value contradicts the plan.</exception>
    public static IEnumerator<JobStep> Run(BuildPart whole, GridCube[] cubes, PointReader reader, IReadOnlyList<int> blocks,
        PartOutput output)
    {
        var isOwn = new bool[blocks.Count];
        Array.Fill(isOwn, true);
        var selection = new PartFilter(whole, GridChoice.OnGrid(reader.Info, whole.Grid), isOwn);
        using var bucket = new BucketBuild(new BuildContext(whole, new[] { new FilteredReader(reader, selection, blocks) }, 0,
            output.Folder, output.Settings, output.Progress), selection);
        var build = bucket.Build;
        build.Progress?.Begin(BuildStages.Read);
        build.Map = PlannedParts.MapOf(whole.CloudCube, cubes);
        build.Map.BaseCells = whole.BaseCells;
        yield return JobStep.Of(bucket.Read());
        whole.RequireDivisors(bucket.Scatter.Attributes, reader.Info.Path);
        yield return JobStep.Of(bucket.Write(output.Take));
        build.Progress?.End();
    }

    /// <summary>Where the records of each part are, in the folder of a bucket that has ended; those outside of all have the
    /// number behind the last.</summary>
    public static BucketRange[] ReadRanges(string folder)
    {
        string path = Path.Combine(folder, BuildFiles.RangesName);
        using var bytes = StoreFile.Read(path, 0, StoreFile.SizeOf(path), Allocator.Persistent);
        return MemoryMarshal.Cast<byte, BucketRange>(bytes.ToArray()).ToArray();
    }

    IEnumerator<JobStep> Read()
    {
        yield return JobStep.Of(Resume());
        Build.RequireRoom(2 * Build.Points - Scatter.Statistics.Count);
        yield return JobStep.Of(ReadSources());
    }

    IEnumerator<JobStep> WriteRecords(List<BucketRange> ranges)
    {
        var chunks = Scatter.Chunks;
        long written = 0;
        Build.Folder.Truncate(BuildFiles.BucketName, 0);
        for (int i = 0; i < ranges.Count; i++)
        {
            var range = ranges[i];
            yield return JobStep.Of(Chunks.Write(BuildFiles.BucketName, chunks[range.Part], written,
                bytes => range.Bytes = bytes));
            range.Offset = written;
            written += range.Bytes;
            ranges[i] = range;
        }
        yield return JobStep.Of(CloudFolderWriter.Await(Build.Folder.SyncRecords(BuildFiles.BucketName)));
    }

    IEnumerator<JobStep> JoinFiles(List<BucketRange> ranges)
    {
        var files = Build.Files;
        string path = Build.Folder.PathOf(BuildFiles.BucketName);
        return Build.Folder.Run(BuildFiles.BucketName, _ =>
        {
            using var to = FileChanges.OpenToWrite(path, FileMode.Create);
            foreach (var range in ranges)
                using (var from = FileChanges.OpenToRead(files.PathOf(range.Part), 1 << 16))
                    from.CopyTo(to, 1 << 20);
            to.Flush(true);
        });
    }

    IEnumerator<JobStep> Write(Action<PartResult> take)
    {
        var ranges = new List<BucketRange>();
        long offset = 0;
        for (int part = 0; part <= Build.Map.OutsideChunk; part++)
        {
            long count = Build.Files?.RecordsOf(part) ?? Scatter.Chunks[part].RecordCount;
            long bytes = Build.Files?.BlocksOf(part).Bytes ?? 0;
            if (count > 0)
                ranges.Add(new BucketRange { Part = part, Count = count, Offset = offset, Bytes = bytes });
            offset += bytes;
        }
        yield return JobStep.Of(Build.Files == null ? WriteRecords(ranges) : JoinFiles(ranges));
        yield return JobStep.Of(Build.Folder.Write(BuildFiles.RangesName,
            MemoryMarshal.AsBytes<BucketRange>(ranges.ToArray()).ToArray()));
        var manifest = Build.Part.ToManifest(Build.Settings.Sampler);
        using var store = new NativeStoreLayout(manifest.CreateLayout());
        using var merge = new UpperMerge(Build, store, manifest);
        var result = new PartResult(Build.Attributes.Count, merge.BytesOfPlane.Length)
        {
            Statistics = Scatter.Statistics,
            Attributes = Scatter.Attributes,
            OwnBlockPoints = Checkpoints.Journal.OwnBlockPoints,
            OutsidePoints = ranges.Count > 0 && ranges[ranges.Count - 1].Part == Build.Map.OutsideChunk
                ? ranges[ranges.Count - 1].Count : 0,
        };
        yield return JobStep.Of(PartFile.Write(Build.Folder, Build.Part.Cube, Build.CloudId, merge, result));
        yield return JobStep.Of(Build.Folder.Complete());
        take(result);
    }
}

struct BucketRange
{
    public int Part;
    public long Count;
    public long Offset; // Of their blocks in the file.
    public long Bytes;
}
