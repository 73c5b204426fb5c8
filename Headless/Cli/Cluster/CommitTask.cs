namespace FastPoints.Cli.Cluster;

/// <summary>Makes a cloud of what all tasks have put into the store: the hierarchy, and cloud.json last.</summary>
sealed class CommitTask
{
    const string HierarchyFolder = "hierarchy";
    const int PartBytes = 1 << 20;

    readonly TaskRun m_task;
    readonly BuildPlan m_plan;
    readonly ObjectStore m_store;

    CommitTask(TaskRun task) => (m_task, m_plan, m_store) = (task, task.Plan, task.Store);

    public static CloudManifest Run(TaskRun task)
    {
        var commit = new CommitTask(task);
        var markers = commit.CheckAndDeleteUnknown();
        var nodes = commit.FetchNodes(markers);
        var total = PartFile.ReadResult(nodes[task.Plan.LastMerge], task.Plan.Whole.CloudId);
        commit.CheckSums(markers, total);
        var manifest = commit.Describe(total);
        // Of a commit that was stopped.
        string folder = task.Scratch[HierarchyFolder];
        if (Directory.Exists(folder))
            FileChanges.DeleteFolder(folder);
        task.Run.RunSteps(PartMerge.Commit([.. nodes.Values], manifest, folder, task.Run.Progress));
        commit.Put(manifest);
        task.Scratch.IsDone = true;
        return manifest;
    }

    /// <summary>Tasks whose marker or whose objects are not there are missing.</summary>
    TaskMarker[] CheckAndDeleteUnknown()
    {
        m_task.Run.Progress.Begin("check");
        var markers = TaskMarker.ReadAll(m_store, m_plan, [.. m_plan.AllTasks], m_task.Missing);
        var there = Folders().SelectMany(m_store.List).ToDictionary(found => found.Name, found => found.Bytes);
        m_task.Missing.AddRange(markers.Where(m => m.Objects.Any(o => !there.TryGetValue(o.Name, out long bytes)
            || bytes != o.Bytes)).Select(m => m.Task));
        TaskMarker.RefuseMissing(m_store, m_task.Missing);
        // Those of an earlier plan, or of a task that was killed.
        var known = markers.SelectMany(m => m.Objects).Select(o => o.Name).ToHashSet();
        m_store.Delete(there.Keys.Where(name => !known.Contains(name)
            && !name.StartsWith(ObjectStore.WorkFolder, StringComparison.Ordinal)).ToList());
        return markers;
    }

    static IEnumerable<string> Folders() =>
        [StoreFormat.ChunkFolderName + "/", StoreFormat.UpperFolderName + "/", ObjectStore.WorkFolder];

    /// <returns>Files with tables of nodes by task, that of points outside besides.</returns>
    Dictionary<string, string> FetchNodes(TaskMarker[] markers)
    {
        var names = m_plan.Builds.Names.Concat(m_plan.Merges).ToList();
        string outside = ObjectStore.WorkFolder + MergeTaskRun.OutsideName + Path.GetExtension(PartFile.NodesName);
        if (markers[^1].Objects.Any(o => o.Name == outside))
            names.Add(MergeTaskRun.OutsideName);
        var paths = new string[names.Count];
        m_store.ForEach(Enumerable.Range(0, names.Count), i => paths[i] = m_task.FetchNodes(names[i]));
        return Enumerable.Range(0, names.Count).ToDictionary(i => names[i], i => paths[i]);
    }

    void CheckSums(TaskMarker[] markers, PartResult total)
    {
        var builds = markers.Where(m => m.Task.StartsWith("build-", StringComparison.Ordinal)).ToArray();
        Require("points of all builds", total.Statistics.Count, builds.Sum(b => b.Points) + total.OutsidePoints, "");
        Require("points of the sources", total.OwnBlockPoints, total.Statistics.Count + total.Statistics.LeftOut,
            ": some lie outside of what their files' headers say, plan again with --buckets");
        if (total.Checksum != total.Statistics.Checksum)
            throw PointCloudException.Wanted(FailureCode.WriteFailed, m_store.Name, -1, "checksum of the points on their way "
                + "into the octree", PlanFile.ToHex(total.Statistics.Checksum), PlanFile.ToHex(total.Checksum));
    }

    void Require(string what, long wanted, long got, string why)
    {
        if (wanted != got)
            throw new PointCloudException(FailureCode.WriteFailed, m_store.Name, -1, what + ": wanted "
                + NumberFormat.Count(wanted) + ", got " + NumberFormat.Count(got) + why);
    }

    CloudManifest Describe(PartResult total)
    {
        var manifest = m_plan.Cloud;
        int[] divisors = manifest.Divisors;
        CloudDescription.Describe(total.Statistics, manifest);
        AttributeSummary.Describe(manifest.Attributes, total.Attributes, manifest);
        manifest.Divisors = divisors;
        return manifest;
    }

    void Put(CloudManifest manifest)
    {
        m_task.Run.Progress.Begin(BuildStages.Finish);
        m_store.MakeFolders(StoreFormat.ChunkFolderName, StoreFormat.UpperFolderName);
        m_store.Put(StoreFormat.HierarchyName, Path.Combine(m_task.Scratch[HierarchyFolder], StoreFormat.HierarchyName));
        if (manifest.Points > 0)
            m_task.Run.RunSteps(ConvertCloud.MeasureDisplayRanges(m_store.CloudPath, manifest));
        PutFact(StoreFormat.RecordsName);
        PutFact(StoreFormat.FactsName);
        PutSources(manifest);
        m_store.PutText(StoreFormat.ManifestName, manifest.ToJson(), m_task.Scratch.Folder);
        Clean(m_store);
        m_task.Run.Progress.End();
    }

    public static void Clean(ObjectStore store) =>
        store.Delete(store.List(ObjectStore.WorkFolder).Select(found => found.Name).ToList());

    /// <summary>What the plan knows of the sources; not all kinds have all of it.</summary>
    void PutFact(string name)
    {
        string from = m_plan.PathOf(name), to = m_task.Scratch[name];
        if (!SourcePath.IsRemote(from) && !File.Exists(from))
            return;
        OutputFile.Write(to, PartsOf(from));
        m_store.Put(name, to);
    }

    static IEnumerable<byte[]> PartsOf(string path)
    {
        long size = StoreFile.SizeOf(path);
        for (long at = 0; at < size; at += PartBytes)
        {
            using var bytes = StoreFile.Read(path, at, Math.Min(PartBytes, size - at), Allocator.Persistent);
            yield return bytes.ToArray();
        }
    }

    void PutSources(CloudManifest manifest)
    {
        // Those of tiles stay as the plan has them: they are claimed, and may be a million.
        if (m_plan.Tiles != null)
        {
            PutFact(StoreFormat.SourcesName);
            return;
        }
        var source = StoredSources.FromJson(StoreFile.ReadText(m_plan.PathOf(StoreFormat.SourcesName)), m_plan.Path)[0];
        source.Points = manifest.Points + manifest.PointsLeftOut;
        m_store.PutText(StoreFormat.SourcesName, StoredSources.ToJson([source]), m_task.Scratch.Folder);
    }
}
