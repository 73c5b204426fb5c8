namespace FastPoints.Cli.Cluster;

/// <summary>A build: the chunks of a cube. A bucket: records of some blocks, by the builds that they belong to.</summary>
static class BuildTask
{
    public static TaskMarker Run(TaskRun task, int number)
    {
        var json = task.Plan.ReadTask(task.Name);
        var part = TaskRun.PartOf(task.Plan, PlanFile.ReadCube(json, "cube"), PlanFile.ReadCubes(json, "cells"));
        return task.Plan.BucketTasks > 0 ? OfBuckets(task, part, number, json.Longs("buckets")) : OfSources(task, part, json);
    }

    static TaskMarker OfSources(TaskRun task, BuildPart part, JsonMembers json)
    {
        // Only the first task may have none, of a cloud without points.
        if (json.List("sources").Count == 0)
            return task.Put(task.Files, task.Make(output =>
                PartBuild.RunRecords(part, 0, path => File.WriteAllBytes(path, []), output)), 0);
        using var sources = TaskSources.Open(task, json);
        var result = task.Make(output => PartBuild.Run(part, sources.Reader, sources.Blocks, sources.IsOwn, output));
        task.Run.Warn(sources.Reader.Info);
        task.Run.Report(sources.Reader.Info.Losses);
        return task.Put(task.Files, result, result.Statistics.Count - result.OutsidePoints);
    }

    static TaskMarker OfBuckets(TaskRun task, BuildPart part, int number, long[] planned)
    {
        var names = planned.Select(b => TaskNames.Bucket((int)b)).Concat(StraysOf(task, number)).Distinct()
            .Order(StringComparer.Ordinal).ToArray();
        var records = new BucketRecords(task.Store, TaskMarker.ReadAll(task.Store, task.Plan, names, task.Missing), number);
        var result = task.Make(output => PartBuild.RunRecords(part, records.Count,
            records.FetchInto, output));
        return task.Put(task.Files, result, records.Count);
    }

    static string StrayFolder(int number) => ObjectStore.WorkFolder + "stray/" + number + "/";

    /// <summary>Buckets that turned out to have points of a build, against what headers say.</summary>
    static IEnumerable<string> StraysOf(TaskRun task, int number) =>
        task.Store.List(StrayFolder(number)).Select(found => found.Name.Split('/')[^1]);

    public static TaskMarker RunBucket(TaskRun task, int number)
    {
        var json = task.Plan.ReadTask(task.Name);
        var cubes = task.Plan.ReadCubes();
        using var sources = TaskSources.Open(task, json);
        var result = task.Make(output => BucketBuild.Run(task.Plan.Whole, cubes, sources.Reader, sources.Blocks, output));
        string records = task.PartPath(BucketBuild.BucketName);
        var hashed = Array.ConvertAll(BucketBuild.ReadRanges(Path.GetDirectoryName(records)!), r => new TaskMarker.Range(r.Part,
            r.Count, r.Offset, r.Bytes, TaskRun.HashOf(records, r.Offset, r.Bytes)));
        var planned = json.Longs("builds").ToHashSet();
        foreach (var stray in hashed.Where(r => r.Task < cubes.Length && !planned.Contains(r.Task)))
            task.Store.PutText(StrayFolder(stray.Task) + task.Name, "\n", task.Scratch.Folder);
        task.Run.Warn(sources.Reader.Info);
        return task.Put(task.Files, result, result.Statistics.Count, hashed);
    }
}

/// <summary>Records of one build in several buckets, or in what builds set aside.</summary>
sealed class BucketRecords
{
    readonly ObjectStore m_store;
    readonly List<(string Name, TaskMarker.Range Range)> m_ranges = [];

    /// <param name="task">Of a build; the number behind the last is that of points outside of all.</param>
    public BucketRecords(ObjectStore store, IEnumerable<TaskMarker> buckets, int task)
    {
        m_store = store;
        foreach (var bucket in buckets)
            foreach (var range in bucket.Ranges.Where(r => r.Task == task))
                m_ranges.Add((ObjectStore.WorkFolder + bucket.Task + Path.GetExtension(BucketBuild.BucketName), range));
    }

    /// <summary>Those that builds set aside, in whole files.</summary>
    public void AddOutside(IEnumerable<TaskMarker> builds)
    {
        foreach (var build in builds.Where(b => b.OutsidePoints > 0))
        {
            string name = ObjectStore.WorkFolder + build.Task + Path.GetExtension(BuildFiles.OutsideName);
            var stored = build.Objects.First(o => o.Name == name);
            m_ranges.Add((name, new TaskMarker.Range(0, build.OutsidePoints, 0, stored.Bytes, stored.Hash)));
        }
    }

    public long Count => m_ranges.Sum(r => r.Range.Count);

    /// <summary>Writes all into a file. Any thread.</summary>
    public void FetchInto(string path)
    {
        using (var to = FileChanges.OpenToWrite(path, FileMode.Create))
            foreach (var (name, range) in m_ranges)
                m_store.CopyRangeTo(name, range.Offset, range.Bytes, to);
        long at = 0;
        foreach (var (name, range) in m_ranges)
        {
            ulong got = TaskRun.HashOf(path, at, range.Bytes);
            if (got != range.Hash)
                throw new PointCloudException(FailureCode.ReadFailed, name, range.Offset, StoreFile.HashProblem(range.Hash, got));
            at += range.Bytes;
        }
    }
}
