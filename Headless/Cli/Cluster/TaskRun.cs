namespace FastPoints.Cli.Cluster;

/// <summary>A task of a plan: makes something in its scratch folder, puts it into the store, and its marker last.</summary>
sealed class TaskRun : IDisposable
{
    const string PartFolder = "part";
    const long HashedBytes = 64 << 20;

    readonly ConvertSettings m_settings;
    readonly string? m_scratchRoot;
    TaskScratch? m_scratch;

    public TaskRun(BuildPlan plan, string name, string? memory, string? scratch, CliRun run)
    {
        (Plan, Name, Run, m_scratchRoot) = (plan, name, run, scratch);
        (Cloud, Parsed) = CloudSettings.Parse(plan.Settings, plan.Path);
        m_settings = Cloud.Read(Parsed);
        Memory.Limit(m_settings, memory ?? plan.Estimate.MemoryBytes.ToString(CultureInfo.InvariantCulture));
        // RunToEnd waits for jobs, so none are scheduled ahead to fill the time between ticks.
        m_settings.InFlightMs = 0;
        Store = ObjectStore.Open(plan.Store);
    }

    public BuildPlan Plan { get; }
    public string Name { get; }
    public ObjectStore Store { get; }
    public CloudSettings Cloud { get; }
    public ParseResult Parsed { get; }
    public CliRun Run { get; }

    public List<string> Missing { get; } = [];

    public TaskScratch Scratch => m_scratch ??= TaskScratch.Take(m_scratchRoot, PlanFile.ToHex(Plan.Whole.CloudId) + "-" + Name);

    public void Dispose()
    {
        m_scratch?.Dispose();
        Store.Dispose();
    }

    public TaskMarker? CompleteIfDone()
    {
        var marker = TaskMarker.Read(Store, Plan, Name);
        // A run that was killed behind its marker left its folder.
        if (marker != null)
            Scratch.IsDone = true;
        return marker;
    }

    /// <returns>The cloud that the store has; null without one.</returns>
    /// <exception cref="PointCloudException">It is another one.</exception>
    public CloudManifest? FindCommitted()
    {
        if (Store.ReadText(StoreFormat.ManifestName) is not { } text)
            return null;
        var there = CloudManifest.FromJson(text, Store.Name);
        return there.CloudId == Plan.Whole.CloudId ? there
            : throw new PointCloudException(FailureCode.WriteFailed, Store.Name, -1, "has another cloud: plan for another store");
    }

    public static BuildPart PartOf(BuildPlan plan, GridCube cube, GridCube[] cells)
    {
        var part = plan.Whole.Of(cube);
        part.BaseCells = cells;
        return part;
    }

    /// <summary>Makes a part in the scratch folder, unless an earlier run of the task has made it.</summary>
    /// <returns>Null if it was there.</returns>
    public PartResult? Make(string folder, Func<PartOutput, IEnumerator<JobStep>> work)
    {
        if (File.Exists(Path.Combine(Scratch[folder], PartFile.NodesName)))
            return null;
        PartResult? result = null;
        using var stop = new CancellationTokenSource();
        // Set before cancelling: the build keeps its files if it was stopped, not if it failed.
        using var stopping = Run.Cancellation.Register(() =>
        {
            m_settings.KeepUnfinished = true;
            stop.Cancel();
        });
        JobCoroutine.RunToEnd(work(new PartOutput
        {
            Folder = Scratch[folder],
            Settings = m_settings,
            Take = r => result = r,
            Progress = Run.Progress,
        }), stop.Token);
        return result;
    }

    public PartResult Make(Func<PartOutput, IEnumerator<JobStep>> work)
    {
        Make(PartFolder, work);
        return PartFile.ReadResult(Path.Combine(Scratch[PartFolder], PartFile.NodesName), Plan.Whole.CloudId);
    }

    public string PartPath(string name) => Path.Combine(Scratch[PartFolder], name);

    public IEnumerable<(string Name, string Path)> FilesOf(string folder, string name)
    {
        foreach (string files in new[] { StoreFormat.ChunkFolderName, StoreFormat.UpperFolderName })
            if (Directory.Exists(Path.Combine(Scratch[folder], files)))
                foreach (string path in Directory.GetFiles(Path.Combine(Scratch[folder], files)))
                    yield return (files + "/" + Path.GetFileName(path), path);
        foreach (string path in Directory.GetFiles(Scratch[folder], PartNames))
            yield return (ObjectStore.WorkFolder + name + Path.GetExtension(path), path);
    }

    const string PartNames = "part.*";

    public IEnumerable<(string Name, string Path)> Files => FilesOf(PartFolder, Name);

    public TaskMarker Put(IEnumerable<(string Name, string Path)> files, PartResult result, long points,
        IReadOnlyList<TaskMarker.Range>? ranges = null)
    {
        Run.Progress.Begin("put");
        var all = files.OrderBy(f => f.Name, StringComparer.Ordinal).ToArray();
        var objects = new TaskMarker.StoredObject[all.Length];
        Store.ForEach(Enumerable.Range(0, all.Length), i =>
        {
            Run.Cancellation.ThrowIfCancellationRequested();
            objects[i] = new TaskMarker.StoredObject(all[i].Name, StoreFile.SizeOf(all[i].Path),
                HashOf(all[i].Path, 0, long.MaxValue));
            Store.Put(all[i].Name, all[i].Path);
        });
        var marker = new TaskMarker
        {
            Task = Name,
            Points = points,
            Checksum = ranges != null ? result.Statistics.Checksum : result.Checksum,
            OutsidePoints = result.OutsidePoints,
            Ranges = ranges ?? [],
            Objects = objects,
        };
        Store.PutText(TaskMarker.NameOf(Name), marker.ToText(Plan), Scratch.Folder);
        Scratch.IsDone = true;
        Run.Progress.End();
        return marker;
    }

    /// <summary>Of some bytes of a file; beyond 64 MiB the hash of the hashes of such pieces.</summary>
    public static ulong HashOf(string path, long offset, long count)
    {
        using var file = FileChanges.OpenToRead(path, 1);
        file.Position = offset;
        count = Math.Min(count, file.Length - offset);
        var hashes = new List<ulong>();
        var buffer = new byte[Math.Min(count, HashedBytes)];
        for (int got; count > 0; count -= got)
        {
            got = (int)Math.Min(count, buffer.Length);
            file.ReadExactly(buffer, 0, got);
            hashes.Add(ContentHash.Of(buffer.AsSpan(0, got)));
        }
        return hashes.Count == 1 ? hashes[0]
            : ContentHash.Of(System.Runtime.InteropServices.MemoryMarshal.AsBytes<ulong>(hashes.ToArray()));
    }

    public PartInput Fetch(string task) => new()
    {
        TopsPath = Store.EnsureLocal(ObjectStore.WorkFolder + task + ".tops", Scratch.Folder),
        NodesPath = FetchNodes(task),
    };

    public string FetchNodes(string task) => Store.EnsureLocal(ObjectStore.WorkFolder + task + ".nodes", Scratch.Folder);
}
