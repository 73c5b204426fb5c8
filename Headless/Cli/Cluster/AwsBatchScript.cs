namespace FastPoints.Cli.Cluster;

/// <summary>A script of AWS' command line: one job definition, and an array job for each array.</summary>
static class AwsBatchScript
{
    const int MaxDependencies = 20; // A job waits for no more jobs.

    public static string Of(ClusterJob job, ClusterSettings settings) => EmbeddedText.Of("batch.sh",
        ("name", job.Name), ("contents", job.Contents), ("queue", SlurmScript.Quoted(settings.Queue!)),
        ("definition", Definition(job, settings))) + Submissions(job, settings);

    static string Definition(ClusterJob job, ClusterSettings settings)
    {
        string volumes = "{\"name\": \"scratch\", \"host\": {\"sourcePath\": \"/tmp\"}}";
        string mounts = Mount("scratch", KubernetesManifest.ScratchOf(settings));
        if (settings.Volume is var (name, path))
        {
            volumes += ",\n      {\"name\": \"data\", \"efsVolumeConfiguration\": {\"fileSystemId\": " + Json(name) + "}}";
            mounts += ",\n      " + Mount("data", path);
        }
        return EmbeddedText.Of("batch.json", ("name", job.Name), ("attempts", settings.Attempts),
            ("image", Json(settings.Image!)), ("cores", settings.Cores), ("mebibytes", job.TaskMebibytes), ("volumes", volumes),
            ("mounts", mounts)).TrimEnd('\n').Replace("'", "'\\''", StringComparison.Ordinal);
    }

    static string Mount(string volume, string path) =>
        "{\"sourceVolume\": \"" + volume + "\", \"containerPath\": " + Json(path) + "}";

    static string Json(string text) => KubernetesManifest.JsonOf(text);

    static string Submissions(ClusterJob job, ClusterSettings settings)
    {
        var text = new StringBuilder();
        foreach (var stage in job.Stages)
        {
            if (stage != job.Stages[0])
                text.Append("behind\n");
            var arrays = stage.Arrays(settings.MaxArray).ToList();
            if (arrays.Count > MaxDependencies)
                throw new UsageException("--max-array: " + arrays.Count + " arrays are more than the " + MaxDependencies
                    + " that a job may wait for");
            foreach (var array in arrays)
            {
                // An array has two tasks at least: one is a job, which has no number.
                var words = KubernetesManifest.Command(job, array, settings);
                if (array.Tasks == 1 && stage.IsNumbered)
                    words = words.Concat(["--task", "0"]);
                text.Append("submit " + job.Name + "-" + array.Name + " " + array.Tasks + " "
                    + SlurmScript.Quoted("[" + string.Join(", ", words.Select(Json)) + "]") + "\n");
            }
        }
        return text.ToString();
    }
}
