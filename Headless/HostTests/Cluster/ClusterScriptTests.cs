namespace FastPoints.HostTests.Cluster;

public sealed class ClusterScriptTests
{
    static readonly ClusterSettings s_settings = new("/opt/fast points/it's", 4, 10, 1000, null, "spot", "registry/fastpoints:1",
        null, ("data", "/data"));

    /// <summary>2,500 builds behind 16 buckets, and merges of two levels.</summary>
    static ClusterJob Job => new("/data/Town 3.json",
    [
        new ClusterStage("bucket", ["build", "--bucket"], 16), new ClusterStage("build", ["build"], 2001),
        new ClusterStage("merge-1", ["merge", "--level", "1"], 157), new ClusterStage("merge-2", ["merge", "--level", "2"], 1),
        new ClusterStage("commit", ["commit"], 1),
    ], new PlanEstimate(90_000, 1000, 2L << 30, 1L << 40, 5L << 30));

    static string Run(string program, string input, params string[] args)
    {
        if (!(Environment.GetEnvironmentVariable("PATH") ?? "").Split(':').Any(f => File.Exists(Path.Combine(f, program))))
            Assert.Ignore("no " + program + " here");
        var start = new ProcessStartInfo(program, args)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        using var process = Process.Start(start);
        process.StandardInput.Write(input);
        process.StandardInput.Close();
        var error = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.That(process.ExitCode, Is.Zero, error.Result);
        return output;
    }

    /// <summary>The script with a function in place of a scheduler's command, which prints what it is told and answers.</summary>
    static string[] Submit(string script, string command, string answer) =>
        Run("bash", command + "() { printf '%s|' \"$@\" >&2; echo >&2; echo " + answer + "; }\nexec 2>&1\n" + script, "-s")
            .Split('\n', StringSplitOptions.RemoveEmptyEntries);

    [Test]
    public void Slurm_ArraysAreSplit_AndEachStageWaitsForTheOneBefore()
    {
        string[] calls = Submit(SlurmScript.Of(Job, s_settings), "sbatch", "7")
            .Where(l => l.StartsWith("--parsable", StringComparison.Ordinal)).ToArray();
        Assert.That(calls, Has.Length.EqualTo(7));
        Assert.That(calls[0], Does.Contain("|--array=0-15|").And.Contain("|build|/data/Town 3.json|--bucket|")
            .And.Not.Contain("--dependency"));
        Assert.That(calls[2], Does.Contain("|--array=0-999|").And.Contain("|build|/data/Town 3.json|--offset|1000|")
            .And.Contain("|--dependency=afterok:7|"));
        Assert.That(calls[3], Does.Contain("|--array=0-0|").And.Contain("|--offset|2000|"));
        Assert.That(calls[4], Does.Contain("|--dependency=afterok:7:7:7|").And.Contain("|--level|1|"));
        Assert.That(calls[6], Does.Contain("|commit|/data/Town 3.json|").And.Not.Contain("--array"));
    }

    /// <summary>What the script does when the task ends, by what Slurm says that it is.</summary>
    [TestCase(0, "RUNNING", 0, "", 0)]
    [TestCase(1, "RUNNING", 3, "requeue 7_12", 1)]
    [TestCase(130, "RUNNING", 0, "requeue 7_12", 130)]
    [TestCase(3, "RUNNING", 0, "", 3)]
    [TestCase(2, "RUNNING", 0, "", 2)]
    [TestCase(130, "COMPLETING", 0, "", 130)]
    [TestCase(1, "RUNNING", 10, "", 1)]
    [Platform(Exclude = "Win")]
    public void Slurm_TaskEnds_IsRequeuedWhereThatHelps(int status, string state, int restarts, string wanted, int ends)
    {
        using var scratch = new ScratchFolder();
        File.WriteAllText(scratch["task"], "#!/bin/sh\nexit " + status + "\n");
        Run("chmod", "", "+x", scratch["task"]);
        string script = SlurmScript.Of(Job, s_settings with { Program = scratch["task"] });
        string said = Run("bash", "scontrol() { echo \"$@\"; }\nsqueue() { echo " + state
            + "; }\nSLURM_CPUS_PER_TASK=4 SLURM_JOB_ID=9 SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=12 SLURM_RESTART_COUNT="
            + restarts + "\n(" + script + ")\necho $?\n",
            "-s", "build", "x");
        Assert.That(said, Is.EqualTo((wanted.Length > 0 ? wanted + "\n" : "") + ends + "\n"));
    }

    [Test]
    public void Kubernetes_EachArray_IsAJobThatNeverRetriesBadInput()
    {
        string json = Run("python3", KubernetesManifest.Of(Job, s_settings), "-c",
            "import json, sys, yaml; print(json.dumps(list(yaml.safe_load_all(sys.stdin))))");
        var jobs = JsonDocument.Parse(json).RootElement.EnumerateArray().ToArray();
        Assert.That(jobs.Select(j => j.GetProperty("metadata").GetProperty("name").GetString()), Is.EqualTo(new[]
        {
            "town-3-bucket", "town-3-build", "town-3-build-1000", "town-3-build-2000", "town-3-merge-1", "town-3-merge-2",
            "town-3-commit",
        }));
        var spec = jobs[2].GetProperty("spec");
        Assert.That(spec.GetProperty("completionMode").GetString(), Is.EqualTo("Indexed"));
        Assert.That(spec.GetProperty("completions").GetInt32(), Is.EqualTo(1000));
        Assert.That(spec.GetProperty("podFailurePolicy").GetProperty("rules")[0].GetRawText(),
            Does.Contain("\"FailIndex\"").And.Contain("[2, 3]"));
        var pod = spec.GetProperty("template").GetProperty("spec");
        Assert.That(pod.GetProperty("restartPolicy").GetString(), Is.EqualTo("Never"));
        var container = pod.GetProperty("containers")[0];
        Assert.That(container.GetProperty("command").EnumerateArray().Select(w => w.GetString()), Is.EqualTo(new[]
        {
            s_settings.Program, "build", "/data/Town 3.json", "--offset", "1000", "--threads", "4", "--scratch", "/scratch",
            "--quiet",
        }));
        var limits = container.GetProperty("resources").GetProperty("limits");
        Assert.That(limits.GetProperty("memory").GetString(), Is.EqualTo("2560Mi"));
        Assert.That(pod.GetProperty("volumes")[1].GetRawText(), Does.Contain("\"claimName\": \"data\""));
    }

    [Test]
    public void Batch_ArraysHaveTwoTasksAtLeast_AndBadInputEndsThem()
    {
        string[] lines = Submit(AwsBatchScript.Of(Job, s_settings), "aws", "id");
        int at = Array.FindIndex(lines, l => l.StartsWith("batch|submit-job", StringComparison.Ordinal));
        string registered = string.Join("\n", lines[..at]);
        var definition = JsonDocument.Parse(registered[registered.IndexOf('{')..(registered.LastIndexOf('}') + 1)]).RootElement;
        Assert.That(definition.GetProperty("retryStrategy").GetProperty("evaluateOnExit")[1].GetRawText(),
            Is.EqualTo("{\"onExitCode\": \"3\", \"action\": \"EXIT\"}"));
        var volumes = definition.GetProperty("containerProperties").GetProperty("volumes");
        Assert.That(volumes[1].GetRawText(), Does.Contain("\"data\""));
        string[] calls = lines.Where(l => l.StartsWith("batch|submit-job", StringComparison.Ordinal)).ToArray();
        Assert.That(calls, Has.Length.EqualTo(7));
        Assert.That(calls[1], Does.Contain("|size=1000|").And.Contain("|[{\"jobId\": \"id\"}]|"));
        Assert.That(calls[3], Does.Contain("\"--offset\", \"2000\"").And.Contain("\"--task\", \"0\"")
            .And.Not.Contain("size="));
        foreach (string call in calls)
        {
            var overrides = JsonDocument.Parse(call.Split('|').First(w => w.StartsWith('{'))).RootElement;
            Assert.That(overrides.GetProperty("command")[0].GetString(), Is.EqualTo(s_settings.Program));
        }
    }

    [TestCase("cluster lsf {0}", "wanted slurm, kubernetes or aws-batch, got lsf")]
    [TestCase("cluster kubernetes {0}", "needs --image")]
    [TestCase("cluster aws-batch {0} --image i", "needs --queue")]
    [TestCase("cluster kubernetes {0} --image i", "containers see no path of this machine")]
    [TestCase("cluster kubernetes {0} --image i --volume data", "wanted NAME:PATH")]
    public void Cluster_WithoutWhatItNeeds_SaysSo(string line, string wanted)
    {
        using var cloud = new ClusterCloud();
        cloud.MakePlan("las", 60_000);
        var call = CliCall.Of(string.Format(CultureInfo.InvariantCulture, line, cloud.Plan).Split(' '));
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(call.Error, Does.Contain(wanted));
    }

    [Test]
    public void Cluster_OfAPlan_HasItsTasks()
    {
        using var cloud = new ClusterCloud();
        cloud.MakePlan("las", 60_000);
        var call = CliCall.Of("cluster", "slurm", cloud.Plan);
        Assert.That(call.Status, Is.Zero, call.Error);
        Run("bash", call.Output, "-n");
        Assert.That(call.Output, Does.Contain("submit plan-bucket 0-" + (cloud.Count("bucketTasks") - 1) + " build"));
        Assert.That(call.Output, Does.Contain("submit plan-build 0-" + (cloud.Count("tasks") - 1) + " build"));
        Assert.That(call.Output, Does.Contain("submit plan-commit '' commit \"$plan\""));
    }
}
