namespace FastPoints.Cli.Cluster;

/// <summary>A script of AWS' command line: one job definition, and an array job for each array.</summary>
static class BatchScript
{
    const int MaxDependencies = 20; // A job waits for no more jobs.

    public static string Of(ClusterJob job, ClusterSettings settings) => $$"""
        #!/usr/bin/env bash
        # {{job.Name}}: {{job.Contents}}. With AWS' command line: bash THIS_FILE
        # Submitted once more, it does what is missing: a task that is done ends at once.
        set -eu
        queue={{SlurmScript.Quoted(settings.Queue!)}}
        definition=$(aws batch register-job-definition --query jobDefinitionArn --output text \
          --cli-input-json '{{Definition(job, settings)}}')

        after='[]' jobs=
        submit() { # name, tasks, what a task does as JSON
          local id size=()
          if [ "$2" -gt 1 ]; then size=(--array-properties "size=$2"); fi
          id=$(aws batch submit-job --job-name "$1" --job-queue "$queue" --job-definition "$definition" ${size[@]+"${size[@]}"} \
            --depends-on "$after" --container-overrides "{\"command\": $3}" --query jobId --output text)
          jobs+=${jobs:+, }"{\"jobId\": \"$id\"}"
          echo "$1: job $id"
        }
        behind() { after="[$jobs]" jobs=; }
        {{Submissions(job, settings)}}
        """;

    static string Definition(ClusterJob job, ClusterSettings settings)
    {
        string volumes = "{\"name\": \"scratch\", \"host\": {\"sourcePath\": \"/tmp\"}}";
        string mounts = Mount("scratch", KubernetesManifest.ScratchOf(settings));
        if (settings.Volume is var (name, path))
        {
            volumes += ",\n      {\"name\": \"data\", \"efsVolumeConfiguration\": {\"fileSystemId\": " + Json(name) + "}}";
            mounts += ",\n      " + Mount("data", path);
        }
        return $$"""
            {
              "jobDefinitionName": "fastpoints-{{job.Name}}",
              "type": "container",
              "retryStrategy": {"attempts": {{settings.Attempts}}, "evaluateOnExit": [
                {"onExitCode": "2", "action": "EXIT"},
                {"onExitCode": "3", "action": "EXIT"},
                {"onReason": "*", "action": "RETRY"}]},
              "containerProperties": {
                "image": {{Json(settings.Image!)}},
                "command": ["true"],
                "resourceRequirements": [
                  {"type": "VCPU", "value": "{{settings.Cores}}"},
                  {"type": "MEMORY", "value": "{{job.NodeMebibytes}}"}],
                "volumes": [
                  {{volumes}}],
                "mountPoints": [
                  {{mounts}}]
              }
            }
            """.Replace("'", "'\\''", StringComparison.Ordinal);
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
