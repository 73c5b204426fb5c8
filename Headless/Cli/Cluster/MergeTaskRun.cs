namespace FastPoints.Cli.Cluster;

/// <summary>A merge: the upper levels of a cube, from what its inputs left open; the last one those of the cloud, with what lies
/// outside of the plan's cube.</summary>
static class MergeTaskRun
{
    const string OutsideFolder = "outside";
    public const string OutsideName = "outside"; // The name of the part of points outside of the plan's cube.

    public static TaskMarker Run(TaskRun task)
    {
        var json = task.Plan.ReadTask(task.Name);
        var names = json.Texts("inputs");
        TaskMarker.ReadAll(task.Store, task.Plan, names, task.Missing);
        var inputs = new PartInput[names.Count];
        task.Store.ForEach(Enumerable.Range(0, names.Count), i => inputs[i] = task.Fetch(names[i]));
        bool isLast = task.Name == task.Plan.LastMerge;
        (PartResult[] Results, TaskMarker[] Markers) buckets = isLast ? Buckets(task) : ([], []);
        var outside = isLast ? Outside(task, inputs, buckets.Results, buckets.Markers) : null;
        PartInput[] all = outside is { } last ? [.. inputs, last] : inputs;
        var part = TaskRun.PartOf(task.Plan, PlanFile.ReadCube(json, "cube"), []);
        var result = task.Make(output => PartMerge.Run(part, all, buckets.Results, output));
        var files = outside == null ? task.Files : task.Files.Concat(task.FilesOf(OutsideFolder, OutsideName));
        return task.Put(files, result, result.Statistics.Count);
    }

    static (PartResult[] Results, TaskMarker[] Markers) Buckets(TaskRun task)
    {
        var names = Enumerable.Range(0, task.Plan.BucketTasks).Select(TaskNames.Bucket).ToArray();
        var markers = TaskMarker.ReadAll(task.Store, task.Plan, names, task.Missing);
        var results = new PartResult[names.Length];
        task.Store.ForEach(Enumerable.Range(0, names.Length), b =>
            results[b] = PartFile.ReadResult(task.FetchNodes(names[b]), task.Plan.Whole.CloudId));
        return (results, markers);
    }

    /// <returns>The part of what lies outside; null if nothing does.</returns>
    static PartInput? Outside(TaskRun task, PartInput[] inputs, PartResult[] buckets, TaskMarker[] bucketMarkers)
    {
        var plan = task.Plan;
        var found = PointStatistics.None;
        long outside = 0;
        foreach (var result in inputs.Select(i => PartFile.ReadResult(i.NodesPath, plan.Whole.CloudId)).Concat(buckets))
        {
            found.Include(result.Statistics);
            outside += result.OutsidePoints;
        }
        if (outside == 0)
            return null;
        // Behind the last build's cube.
        int number = plan.BucketTasks > 0 ? plan.ReadCubes().Length : 0;
        var records = new BucketRecords(task.Store, bucketMarkers, number);
        if (plan.BucketTasks == 0)
            records.AddOutside(TaskMarker.ReadAll(task.Store, plan, [.. plan.Builds.Names], task.Missing));
        task.Make(OutsideFolder, output => PartBuild.RunRecords(plan.Whole.OfOutside(found), records.Count,
            records.FetchInto, output));
        return new PartInput
        {
            TopsPath = Path.Combine(task.Scratch[OutsideFolder], PartFile.TopsName),
            NodesPath = Path.Combine(task.Scratch[OutsideFolder], PartFile.NodesName),
        };
    }
}
