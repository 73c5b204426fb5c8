namespace FastPoints.Cli.Parts;

abstract class PartStages : IDisposable
{
    readonly PartFilter? m_selection;
    BuildGenerations? m_generations;

    protected PartStages(BuildContext build, PartFilter? selection)
    {
        Build = build;
        m_selection = selection;
        if (selection != null)
            build.TakeOwnBlockPoints = selection.TakeOwnBlockPoints;
        // A part of a cloud is none.
        build.Settings.SecondsPerGeneration = build.Settings.SecondsToFirstGeneration = double.PositiveInfinity;
    }

    protected BuildContext Build { get; }
    // Of these, what Resume has made.
    protected ScatterPoints Scatter { get; private set; } = null!;
    protected ChunkSet Chunks { get; private set; } = null!;
    protected BuildCheckpoints Checkpoints { get; private set; } = null!;
    protected BuildGenerations Generations => m_generations!;

    /// <summary>Coroutine, once there is a map: goes on from where a stopped one was.</summary>
    protected IEnumerator<JobStep> Resume()
    {
        // The coroutine checks its budget.
        yield return default;
        Scatter = new ScatterPoints(Build);
        Chunks = new ChunkSet(Build);
        Checkpoints = BuildCheckpoints.Resume(Build, Scatter, Chunks);
        yield return JobStep.Of(Checkpoints.Prepare());
        m_generations = new BuildGenerations(Build);
    }

    protected IEnumerator<JobStep> ReadSources() => new ReadSources(Build, Scatter, Checkpoints, Generations).Run();

    public virtual void Dispose()
    {
        m_generations?.Dispose();
        Chunks?.Dispose();
        Scatter?.Dispose();
        Checkpoints?.Dispose();
        Build.Dispose();
        m_selection?.Dispose();
    }
}

/// <summary>One of several builds that make a cloud: the chunks of its cube, and the upper levels as far as its points decide
/// them. The bytes are those that one build of everything would write.</summary>
sealed class PartBuild : PartStages
{
    FileWork? m_fetch;
    OctreeBuild? m_octree;

    PartBuild(BuildContext build, PartFilter? selection) : base(build, selection) { }

    /// <summary>Coroutine: from sources. When it has ended, the folder has containers and the part's files.</summary>
    /// <param name="blocks">Those that may have points of the part, ascending. The reader's blocks are known.</param>
    /// <param name="isOwn">By entry of these: see <see cref="PartFilter"/>.</param>
    /// <exception cref="PointCloudException">A source or the folder is at fault, or a value contradicts the plan.</exception>
    public static IEnumerator<JobStep> Run(BuildPart part, PointReader reader, IReadOnlyList<int> blocks,
        IReadOnlyList<bool> isOwn, PartOutput output) => Run(() =>
        {
            var selection = new PartFilter(part, GridChoice.OnGrid(reader.Info, part.Grid), isOwn);
            var selected = new FilteredReader(reader, selection, blocks);
            return new PartBuild(new BuildContext(part, new[] { selected }, 0, output.Folder, output.Settings,
                output.Progress), selection);
        }, output.Take);

    /// <summary>Coroutine: from packed records in a file.</summary>
    /// <param name="records">Number of records.</param>
    /// <param name="fetch">Writes the file, on the thread that writes; it may be called again.</param>
    public static IEnumerator<JobStep> RunRecords(BuildPart part, long records, FileWork fetch, PartOutput output) =>
        Run(() => new PartBuild(new BuildContext(part, Array.Empty<PointReader>(), records, output.Folder, output.Settings,
            output.Progress), null)
        { m_fetch = fetch }, output.Take);

    // A coroutine that is disposed before its first step has opened nothing.
    static IEnumerator<JobStep> Run(Func<PartBuild> open, Action<PartResult> take)
    {
        using var part = open();
        var build = part.Build;
        build.Progress?.Begin(BuildStages.Sample);
        yield return JobStep.Of(part.PlanPartition());
        yield return JobStep.Of(part.Resume());
        build.Progress?.Begin(BuildStages.Read);
        if (part.Checkpoints.Journal.CurrentStage == BuildJournal.Stage.Read)
            yield return JobStep.Of(part.Read());
        build.Progress?.Begin(BuildStages.Split);
        yield return JobStep.Of(new RebalanceChunks(build, part.Scatter, part.Chunks, part.Checkpoints).Run());
        build.Part.RequireDivisors(part.Scatter.Attributes, build.Target);
        yield return JobStep.Of(part.WriteNodes(take));
        build.Progress?.End();
    }

    public override void Dispose()
    {
        m_octree?.Dispose();
        base.Dispose();
    }

    IEnumerator<JobStep> PlanPartition()
    {
        var part = Build.Part;
        var samples = new List<SourceSample>();
        try
        {
            foreach (var reader in Build.Readers)
                yield return JobStep.Of(SourceSample.Read(reader, Build.InFlightMs, Build.Settings.Workers,
                    MemoryPlan.ReadBytesOf(Build.Settings), (_, loaded) => loaded, samples.Add));
            if (samples.Count == 0)
                Build.Map = PlannedParts.MapOf(part.Cube, new[] { part.Cube });
            else
                yield return JobStep.Of(PartitionPlan.Of(part.Cube, samples, Build.Grid, Build.Plan, Build.SliceTimes,
                    map => Build.Map = map));
            Build.Map.BaseCells = part.BaseCells;
            // What the sample does not count.
            Build.TakeOwnBlockPoints?.Invoke();
        }
        finally
        {
            foreach (var sample in samples)
                sample.Dispose();
        }
    }

    IEnumerator<JobStep> Read()
    {
        if (m_fetch == null)
        {
            Build.RequireRoom(Build.Points - Scatter.Statistics.Count);
            yield return JobStep.Of(ReadSources());
            yield break;
        }
        // In memory they are in a file, too, until they are loaded.
        Build.RequireRoom(Build.Points);
        string path = Build.Folder.PathOf(BuildFiles.RecordPath(0));
        RecordBlocks? blocks = null;
        yield return JobStep.Of(Build.Folder.Run(BuildFiles.RecordPath(0), file =>
        {
            m_fetch(file);
            blocks = RecordBlocks.Read(file, Build.RecordLayout.StrideBytes);
        }));
        if (blocks!.Records != Build.Points)
            throw PointCloudException.Wanted(FailureCode.ReadFailed, path, -1, "points of the part", Build.Points,
                blocks.Records);
        if (Build.Files != null)
            Build.Files.Adopt(0, blocks);
        else
            yield return JobStep.Of(Load(blocks));
        var cube = Build.Part.Cube;
        Checkpoints.Journal.Statistics.Add(new PointStatistics
        {
            Count = Build.Points,
            Min = cube.Corner,
            Max = cube.Corner + new Grid3(cube.Side - 1, cube.Side - 1, cube.Side - 1),
        });
        Scatter.RestoreStatistics(Checkpoints.Journal);
    }

    IEnumerator<JobStep> Load(RecordBlocks blocks)
    {
        using var load = new RecordLoad(Build, Build.SliceTimes);
        using var outside = new NativeReference<int>(Allocator.Persistent);
        var ranges = new[] { new RecordRange { Count = Build.Points } };
        var chunks = Scatter.Chunks;
        for (long first = 0, count; first < Build.Points; first += count)
        {
            count = Math.Min(ChunkSet.PagesPerBatch * RecordPages.RecordsPerPage, Build.Points - first);
            load.Begin(ranges, first, count, blocks);
            yield return load.Done;
            var pages = load.Complete();
            yield return JobStep.Of(JobStep.Await(CheckRecordsJob.Schedule(new CheckRecordsJob
            {
                SliceTimes = Build.SliceTimes,
                Pages = pages,
                Layout = Build.RecordLayout,
                Cube = Build.Part.Cube,
                Outside = outside,
            }, default)));
            var all = chunks[0];
            all.Join(ref pages);
            chunks[0] = all;
        }
        if (outside.Value > 0)
            throw PointCloudException.Wanted(FailureCode.ReadFailed, blocks.Path, -1, "points outside of the part", 0,
                outside.Value);
        Build.Folder.Delete(BuildFiles.RecordPath(0));
    }

    IEnumerator<JobStep> WriteNodes(Action<PartResult> take)
    {
        var part = Build.Part;
        var manifest = part.ToManifest(Build.Settings.Sampler);
        m_octree = new OctreeBuild(Build, Chunks, manifest, Generations);
        yield return JobStep.Of(m_octree.Index());
        Build.Progress?.Begin(BuildStages.Merge);
        using var store = new NativeStoreLayout(manifest.CreateLayout());
        using var merge = new UpperMerge(Build, store, manifest);
        for (int c = 0; c < m_octree.Results.Count; c++)
            merge.Add(m_octree.Results[c], m_octree.TopRecords[c]);
        // Tops of points outside of the whole cube meet all others in the last merge.
        if (part.CloudCube.ContainsAligned(part.Cube))
            yield return JobStep.Of(merge.Collect(part.Cube, Build.Progress));
        var result = new PartResult(part.Attributes.Count, m_octree.BytesOfPlane.Length)
        {
            // Of records the bucket has them.
            Statistics = m_fetch == null ? Scatter.Statistics : PointStatistics.None,
            Attributes = Scatter.Attributes,
            OwnBlockPoints = Checkpoints.Journal.OwnBlockPoints,
            Checksum = m_octree.Checksum,
        };
        result.Include(m_octree.MinSideLog2, m_octree.BytesOfPlane);
        result.Include(merge.MinSideLog2, merge.BytesOfPlane);
        string outside = Build.Folder.PathOf(BuildFiles.OutsideName);
        if (System.IO.File.Exists(outside))
            result.OutsidePoints = RecordBlocks.Read(outside, Build.RecordLayout.StrideBytes).Records;
        yield return JobStep.Of(PartFile.Write(Build.Folder, part.Cube, part.CloudId, merge, result));
        yield return JobStep.Of(Build.Folder.Complete());
        take(result);
    }
}

struct PartOutput
{
    public string Folder; // A folder of its own, which exists when the work has ended.
    public ConvertSettings Settings;
    public Action<PartResult> Take;
    public StageProgress Progress;
}
