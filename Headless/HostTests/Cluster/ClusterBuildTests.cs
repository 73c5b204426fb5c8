namespace FastPoints.HostTests.Cluster;

/// <summary>A cloud by many tasks is that of one convert, byte for byte.</summary>
public sealed class ClusterBuildTests
{
    ClusterCloud m_cloud;

    [OneTimeSetUp]
    public void Begin() => m_cloud = new ClusterCloud();

    [OneTimeTearDown]
    public void End() => m_cloud.Dispose();

    [TearDown]
    public void LeavesNoScratch() => Assert.That(m_cloud.Scratches, Is.Empty);

    static IEnumerable<string> Missing(CliCall call) =>
        call.Json.GetProperty("missing").EnumerateArray().Select(m => m.GetString());

    void CommitAndCompare(string kind, params string[] options)
    {
        var commit = m_cloud.Commit();
        Assert.That(commit.Status, Is.EqualTo(ExitStatus.Done), commit.Error);
        Assert.That(commit.Json.GetProperty("missing").GetArrayLength(), Is.Zero);
        ClusterCloud.AssertSame(m_cloud.Whole(kind, options), m_cloud.Store);
    }

    [TestCase("tiles", 500_000, "poisson", "", "cells", 1)]
    [TestCase("tiles", 15_000, "poisson", "--cells", "cells", 8)]
    [TestCase("tiles", 15_000, "random", "--cells", "cells", 8)]
    [TestCase("tiles", 15_000, "poisson", "", "buckets", 8)]
    [TestCase("tiles", 1, "random", "--cells", "cells", 30)]
    [TestCase("tiles-laz", 15_000, "average", "--cells", "cells", 8)]
    [TestCase("las", 500_000, "random", "", "cells", 1)]
    [TestCase("las", 30_000, "random", "--cells", "cells", 4)]
    [TestCase("las", 15_000, "random", "", "buckets", 8)]
    [TestCase("las", 1, "poisson", "", "buckets", 30)]
    [TestCase("laz", 15_000, "poisson", "", "buckets", 8)]
    [TestCase("copc.laz", 15_000, "poisson", "--cells", "cells", 8)]
    [TestCase("copc.laz", 1, "random", "", "buckets", 30)]
    public void Tasks_OfAnyKindOfSource_MakeTheCloudOfOneConvert(string kind, int taskPoints, string sampler, string option,
        string mode, int tasks)
    {
        m_cloud.MakePlan(kind, taskPoints, ["--sampler", sampler, .. option.Split(' ', StringSplitOptions.RemoveEmptyEntries)]);
        Assert.That(m_cloud.Planned.GetProperty("mode").GetString(), Is.EqualTo(mode), m_cloud.Planned.GetRawText());
        Assert.That(m_cloud.Count("tasks"), tasks == 1 ? Is.EqualTo(1) : Is.GreaterThanOrEqualTo(tasks));
        m_cloud.RunTasks();
        CommitAndCompare(kind, "--sampler", sampler);
    }

    [TestCase("tiles", "--cells")]
    [TestCase("las", "--buckets")]
    public void Tasks_WithAFilterAndSomeAttributes_MakeTheCloudOfOneConvert(string kind, string mode)
    {
        string[] options = ["--attributes", "Intensity,Classification", "--where", "Z > 121", "--unit", "ft"];
        m_cloud.MakePlan(kind, 60_000, [mode, .. options]);
        m_cloud.RunTasks();
        CommitAndCompare(kind, options);
    }

    [TestCase("tiles", "--cells")]
    [TestCase("las", "--buckets")]
    public void Tasks_InAnyOrderTwiceWithOtherMemoryAndThreads_MakeTheSame(string kind, string mode)
    {
        m_cloud.MakePlan(kind, 60_000, mode);
        m_cloud.RunTasks(tasks => tasks.Reverse(), "--memory", "170MiB", "--threads", "1");
        // Once more, as if the first one had not been heard of.
        foreach (string marker in Directory.GetFiles(Path.Combine(m_cloud.Store, "work"), "*-00000[02].json"))
            File.Delete(marker);
        m_cloud.RunTasks(null, "--threads", "2");
        CommitAndCompare(kind);
        var again = m_cloud.Commit();
        Assert.That(again.Status, Is.EqualTo(ExitStatus.Done), again.Error);
        Assert.That(m_cloud.Run("build", m_cloud.Plan, "--task", "0").Output, Does.Contain("committed already"));
    }

    [Test]
    public void Build_ThatIsDone_EndsAtOnce()
    {
        m_cloud.MakePlan("tiles", 60_000, "--cells");
        string[] line = ["build", m_cloud.Plan, "--task", "0", "--json", "-"];
        var first = m_cloud.Run(line).Json;
        var second = m_cloud.Run(line).Json;
        Assert.That(second.GetProperty("points").GetInt64(), Is.EqualTo(first.GetProperty("points").GetInt64()).And.Positive);
        Assert.That(second.GetProperty("checksum").GetString(), Is.EqualTo(first.GetProperty("checksum").GetString()));
        Assert.That(first.GetProperty("stages").GetArrayLength(), Is.Positive);
        Assert.That(second.GetProperty("stages").GetArrayLength(), Is.Zero);
    }

    [Test]
    public void MergeAndCommit_WithoutSomeTasks_NameThemAndFail()
    {
        m_cloud.MakePlan("tiles", 60_000, "--cells");
        foreach (var line in m_cloud.Stage("build").Skip(1))
            m_cloud.Run(line);
        var merge = CliCall.Of([.. m_cloud.Stage("merge").First(), "--json", "-", "--scratch", m_cloud.Scratch["scratch"]]);
        var commit = m_cloud.Commit();
        foreach (var call in new[] { merge, commit })
        {
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Failed), call.Error);
            Assert.That(Missing(call), Does.Contain("build-000000"));
            Assert.That(call.Error, Does.Contain("build-000000"));
        }
        Assert.That(File.Exists(Path.Combine(m_cloud.Store, "cloud.json")), Is.False);
        m_cloud.RunTasks();
        CommitAndCompare("tiles");
    }

    // Damaged, another plan's, of another task, and one whose object has gone.
    [TestCase("damaged")]
    [TestCase("foreign")]
    [TestCase("renamed")]
    [TestCase("lost")]
    [TestCase("short")]
    public void Commit_WithAWrongMarker_NamesItsTask(string how)
    {
        m_cloud.MakePlan("tiles", 60_000, "--cells");
        m_cloud.RunTasks();
        string work = Path.Combine(m_cloud.Store, "work");
        string marker = Path.Combine(work, "build-000001.json"), text = File.ReadAllText(marker);
        string tops = Path.Combine(work, "build-000001.tops");
        byte[] bytes = File.ReadAllBytes(tops);
        switch (how)
        {
            case "damaged":
                File.WriteAllText(marker, text.Replace("\"points\":", "\"points\":1", StringComparison.Ordinal));
                break;
            case "foreign":
                var plan = BuildPlan.Read(m_cloud.Plan);
                plan.ToTextAndSetHash();
                File.WriteAllText(marker, PlanFile.ToText(json =>
                {
                    json.WriteString("plan", "0123456789abcdef");
                    json.WriteString("task", "build-000001");
                    foreach (string key in new[] { "points", "outsidePoints" })
                        json.WriteNumber(key, 0);
                    json.WriteString("checksum", "0");
                    foreach (string key in new[] { "ranges", "objects" })
                    {
                        json.WriteStartArray(key);
                        json.WriteEndArray();
                    }
                }));
                break;
            case "renamed": File.Copy(Path.Combine(work, "build-000000.json"), marker, true); break;
            case "lost": File.Delete(tops); break;
            default: File.WriteAllBytes(tops, bytes[..^1]); break;
        }
        var commit = m_cloud.Commit();
        Assert.That(commit.Status, Is.EqualTo(ExitStatus.Failed), commit.Error);
        Assert.That(Missing(commit), Is.EqualTo(new[] { "build-000001" }));
        // Another run of the task mends it.
        File.Delete(marker);
        m_cloud.Run("build", m_cloud.Plan, "--task", "1");
        CommitAndCompare("tiles");
    }

    [TestCase(0)]
    [TestCase(2)]
    public void Build_ByTheIndexOfAnArray_IsThatTask(int variable)
    {
        m_cloud.MakePlan("tiles", 60_000, "--cells");
        string name = new[] { "SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX", "AWS_BATCH_JOB_ARRAY_INDEX" }[variable];
        Environment.SetEnvironmentVariable(name, "1");
        try
        {
            Assert.That(m_cloud.Run("build", m_cloud.Plan, "--offset", "1").Output, Does.StartWith("build-000002: "));
        }
        finally
        {
            Environment.SetEnvironmentVariable(name, null);
        }
        var call = CliCall.Of("build", m_cloud.Plan);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(call.Error, Does.Contain("SLURM_ARRAY_TASK_ID"));
        Assert.That(CliCall.Of("build", m_cloud.Plan, "--task", "1000").Status, Is.EqualTo(ExitStatus.Usage));
    }

    [Test]
    public void Build_OfAChangedSourceOrADamagedPlan_IsBadInput()
    {
        using var cloud = new ClusterCloud();
        cloud.MakePlan("tiles", 60_000, "--cells");
        string tile = Directory.GetFiles(cloud.Sources("tiles"))[0];
        using (var file = File.OpenWrite(tile))
            file.SetLength(file.Length + 36);
        var calls = cloud.Stage("build").Select(line => CliCall.Of([.. line, "--scratch", cloud.Scratch["scratch"]])).ToArray();
        Assert.That(calls.Select(c => c.Status).Max(), Is.EqualTo(ExitStatus.BadInput));
        Assert.That(calls.First(c => c.Status == ExitStatus.BadInput).Error, Does.Contain("changed after it was planned"));
        string part = Path.Combine(cloud.Scratch["plan.parts"], "build-000000.json");
        File.WriteAllText(part, File.ReadAllText(part).Replace("\"points\":", "\"points\":1", StringComparison.Ordinal));
        Directory.Delete(cloud.Store, true);
        var damaged = CliCall.Of("build", cloud.Plan, "--task", "0");
        Assert.That(damaged.Status, Is.EqualTo(ExitStatus.BadInput));
        Assert.That(damaged.Error, Does.Contain("hash"));
    }

    // Headers may say less than there is: what lies elsewhere is missed, unless sources are read once.
    [Test]
    public void Tiles_WhoseHeadersLie_AreRefusedByCommitAndBuiltByBuckets()
    {
        using var cloud = new ClusterCloud();
        foreach (string tile in Directory.GetFiles(cloud.Sources("tiles"), "*-*.las"))
        {
            // The largest x is the smallest.
            byte[] bytes = File.ReadAllBytes(tile);
            bytes.AsSpan(187, 8).CopyTo(bytes.AsSpan(179));
            File.WriteAllBytes(tile, bytes);
        }
        cloud.MakePlan("tiles", 60_000, "--cells");
        cloud.RunTasks();
        var commit = cloud.Commit();
        Assert.That(commit.Status, Is.EqualTo(ExitStatus.Failed));
        Assert.That(commit.Error, Does.Contain("plan again with --buckets"));
        cloud.MakePlan("tiles", 60_000, "--buckets");
        cloud.RunTasks();
        commit = cloud.Commit();
        Assert.That(commit.Status, Is.EqualTo(ExitStatus.Done), commit.Error);
        ClusterCloud.AssertSame(cloud.Whole("tiles"), cloud.Store);
    }

    // Outliers that no header names lie outside of the plan's cube.
    [TestCase("--cells")]
    [TestCase("--buckets")]
    public void Tasks_WithPointsOutsideOfThePlansCube_MakeTheCloudOfOneConvert(string option)
    {
        using var cloud = new ClusterCloud();
        string tile = Directory.GetFiles(cloud.Sources("tiles")).MaxBy(f => new FileInfo(f).Length);
        byte[] bytes = File.ReadAllBytes(tile);
        int records = BitConverter.ToInt32(bytes, 96), stride = BitConverter.ToUInt16(bytes, 105);
        // Points that no sample has: behind the first of a block.
        for (int point = 901; point < 904; point++)
            BitConverter.TryWriteBytes(bytes.AsSpan(records + point * stride), 1_900_000_000 - point);
        File.WriteAllBytes(tile, bytes);
        cloud.MakePlan("tiles", 60_000, option);
        cloud.RunTasks();
        Assert.That(File.Exists(Path.Combine(cloud.Store, "work/outside.nodes")));
        var commit = cloud.Commit();
        Assert.That(commit.Status, Is.EqualTo(ExitStatus.Done), commit.Error);
        ClusterCloud.AssertSame(cloud.Whole("tiles"), cloud.Store);
    }
}
