namespace FastPoints.Cli.Cluster;

static class ClusterPlan
{
    public static ClusterJob Read(string path)
    {
        using var json = JsonDocument.Parse(File.ReadAllText(path));
        var plan = json.RootElement;
        var stages = new List<ClusterStage>();
        if (plan.GetProperty("bucketTasks").GetInt32() is > 0 and int buckets)
            stages.Add(new ClusterStage("bucket", ["build", "--bucket"], buckets));
        stages.Add(new ClusterStage("build", ["build"], plan.GetProperty("tasks").GetInt32()));
        foreach (var level in plan.GetProperty("mergeLevels").EnumerateArray())
        {
            string number = level.GetProperty("level").GetRawText();
            stages.Add(new ClusterStage("merge-" + number, ["merge", "--level", number], level.GetProperty("tasks").GetInt32()));
        }
        stages.Add(new ClusterStage("commit", ["commit"], 1));
        var estimate = plan.GetProperty("estimate");
        return new ClusterJob(path, stages, estimate.GetProperty("memoryBytes").GetInt64(),
            estimate.GetProperty("seconds").GetDouble(), estimate.GetProperty("bytesOnDisk").GetInt64());
    }
}
