namespace FastPoints.HostTests.Cluster;

/// <summary>Several builds make the chunks that one would.</summary>
class PartBuildTests : FolderTests
{
    const int Points = 60000;

    // With outliers around the planned cube, and some positions that are no numbers.
    static MemoryReader Reader() => MemoryReader.Of(SameBytesTests.Terrain(Points),
        new PositionTransform { Scale = new double3(0.01, 0.01, 0.01) }, 2000);

    System.Random m_stops; // With it, parts and buckets are stopped now and then, and begun again.

    // Whether they are stopped instead when the folder has its name, while the writing thread is still at it.
    bool m_isStoppedAtTheEnd;

    ulong m_cloudId;

    // A task asks whether its folder is there before it begins.
    bool IsMade(string name) => File.Exists(InputOf(name).NodesPath);

    void RunToEnd(string name, List<PartResult> results, Func<IEnumerator<JobStep>> begin)
    {
        int taken = results.Count;
        // Stopped before its first step.
        if (m_stops != null)
            begin().Dispose();
        for (int attempt = 1; m_stops != null && !IsMade(name); attempt++)
            RunUntilStopped(name, begin(), m_isStoppedAtTheEnd ? int.MaxValue : m_stops.Next(300 * attempt));
        if (!IsMade(name))
            JobCoroutine.RunToEnd(begin());
        if (results.Count == taken)
            results.Add(PartFile.ReadResult(InputOf(name).NodesPath, m_cloudId));
    }

    void RunUntilStopped(string name, IEnumerator<JobStep> begun, int steps)
    {
        var stopped = new System.Threading.ManualResetEventSlim(!m_isStoppedAtTheEnd);
        FileChanges.Intercept = (change, path, _) =>
        {
            if (change == FileChange.Delete && IsMade(name))
                stopped.Wait();
        };
        using var work = new CoroutineStack(begun);
        // When the last step is left, its jobs run.
        while (steps-- > 0 && (stopped.IsSet || !IsMade(name)) && work.MoveNext())
            if (steps > 0)
                work.Current.Complete();
        stopped.Set();
        FileChanges.Intercept = null;
    }

    static ConvertSettings Settings(int megabytes = 928) => new ConvertSettings
    {
        PointsPerCheckpoint = 10000,
        KeepUnfinished = true,
        PointsPerChunk = 1500,
        TargetPointsPerLeaf = 50,
        CellsLog2 = 4,
        MemoryBytes = (long)megabytes << 20,
    };

    CloudPlan Plan()
    {
        CloudPlan plan = null;
        using var reader = Reader();
        JobCoroutine.RunToEnd(ConvertCloud.Plan(new[] { reader }, Settings(),
            (build, values, records) => plan = CloudPlan.Of(build, values, records), null));
        m_cloudId = plan.Whole.CloudId;
        return plan;
    }

    PartOutput Output(string name, List<PartResult> results, int megabytes = 928) => new PartOutput
    {
        Folder = Folder.File(name),
        Settings = Settings(megabytes),
        Take = results.Add,
    };

    // Containers, and the hierarchy if there is one.
    Dictionary<string, byte[]> FilesOf(IEnumerable<string> folders) => folders.SelectMany(folder => Directory.GetFiles(
        Folder.File(folder), "*.bin", SearchOption.AllDirectories)).ToDictionary(Path.GetFileName, File.ReadAllBytes);

    PartInput InputOf(string name) => new PartInput
    {
        TopsPath = Path.Combine(Folder.File(name), PartFile.TopsName),
        NodesPath = Path.Combine(Folder.File(name), PartFile.NodesName),
    };

    // In two levels: pairs of parts of one cube first.
    void Merge(CloudPlan plan, GridCube[] cubes, PartResult[] buckets, List<string> folders)
    {
        var inputs = folders.ConvertAll(InputOf);
        int merges = 0;
        foreach (var octant in Enumerable.Range(0, 8).Select(plan.Whole.CloudCube.Child))
        {
            var inOctant = Enumerable.Range(0, cubes.Length).Where(i => octant.ContainsAligned(cubes[i])).ToArray();
            if (inOctant.Length < 2)
                continue;
            string name = "merge" + merges++;
            JobCoroutine.RunToEnd(PartMerge.Run(plan.Whole.Of(octant), Array.ConvertAll(inOctant, i => InputOf("part" + i)),
                new PartResult[0], Output(name, new List<PartResult>())));
            foreach (int i in inOctant)
                inputs.Remove(InputOf("part" + i));
            inputs.Add(InputOf(name));
            folders.Add(name);
        }
        PartResult all = null;
        var last = Output("last", new List<PartResult>());
        last.Take = result => all = result;
        JobCoroutine.RunToEnd(PartMerge.Run(plan.Whole, inputs, buckets, last));
        folders.Add("last");
        var manifest = plan.Whole.ToManifest(Settings().Sampler);
        manifest.Points = all.Statistics.Count;
        JobCoroutine.RunToEnd(PartMerge.Commit(folders.ConvertAll(f => InputOf(f).NodesPath), manifest,
            Folder.File("commit"), null));
        folders.Add("commit");
    }

    void ConvertWhole()
    {
        using var reader = Reader();
        JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, Folder.File("whole"), Settings(), _ => { }, null));
    }

    void BuildOutside(CloudPlan plan, List<PartResult> results, long count, FileWork fetch, List<string> folders)
    {
        var found = PointStatistics.None;
        foreach (var result in results)
            found.Include(result.Statistics);
        JobCoroutine.RunToEnd(PartBuild.RunRecords(plan.Whole.OfOutside(found), count, fetch, Output("outside", results)));
        folders.Add("outside");
    }

    void AssertWhole(CloudPlan plan, GridCube[] cubes, List<PartResult> results, List<string> folders,
        params PartResult[] buckets)
    {
        Merge(plan, cubes, buckets, folders);
        ConvertWhole();
        var (wanted, made) = (FilesOf(new[] { "whole" }), FilesOf(folders));
        Assert.That(wanted.Count, Is.GreaterThan(30));
        Assert.That(made.Keys, Is.EquivalentTo(wanted.Keys));
        foreach (var file in wanted)
            Assert.That(made[file.Key], Is.EqualTo(file.Value), file.Key);
        using var cloud = CloudFolder.Open(Folder.File("whole"));
        ulong built = 0, found = 0;
        long count = 0, pointsWanted = 0;
        foreach (var result in results)
        {
            built += result.Checksum;
            found += result.Statistics.Checksum;
            count += result.Statistics.Count;
            pointsWanted += result.OwnBlockPoints;
        }
        Assert.That(built, Is.EqualTo(cloud.Manifest.Checksum));
        Assert.That(found, Is.EqualTo(cloud.Manifest.Checksum));
        Assert.That(count, Is.EqualTo((long)Points));
        Assert.That(pointsWanted, Is.EqualTo((long)Points));
    }

    [TestCase(1L << 40, 928)]
    [TestCase(30000L, 928)]
    [TestCase(1L, 928)]
    [TestCase(20000L, 1)]
    public void Run_PartsOfAnySize_MakeTheChunksOfOneBuild(long pointsPerPart, int megabytes)
    {
        var plan = Plan();
        var cubes = plan.CubesOf(pointsPerPart);
        Assert.That(cubes.Length, pointsPerPart > Points ? Is.EqualTo(1) : Is.GreaterThan(1));
        var results = new List<PartResult>();
        var folders = new List<string>();
        using var outside = new MemoryStream();
        foreach (var cube in cubes)
        {
            using var reader = Reader();
            var blocks = Enumerable.Range(0, reader.BlockCount).ToArray();
            // Each block belongs to one part.
            var isOwn = Array.ConvertAll(blocks, b => b % cubes.Length == folders.Count);
            string name = "part" + folders.Count;
            RunToEnd(name, results, () => PartBuild.Run(plan.Whole.Of(cube), reader, blocks, isOwn,
                Output(name, results, megabytes)));
            folders.Add(name);
            string file = Path.Combine(Folder.File(name), BuildFiles.OutsideName);
            Assert.That(File.Exists(file), Is.EqualTo(results[results.Count - 1].OutsidePoints > 0));
            if (File.Exists(file))
                outside.Write(File.ReadAllBytes(file), 0, (int)new FileInfo(file).Length);
        }
        Assert.That(results.Sum(r => r.OutsidePoints), Is.EqualTo(2L));
        BuildOutside(plan, results, 2, path => File.WriteAllBytes(path, outside.ToArray()), folders);
        AssertWhole(plan, cubes, results, folders);
    }

    [TestCase(30000L, 928)]
    [TestCase(1L, 1)]
    public void RunRecords_OfBuckets_MakesTheChunksOfOneBuild(long pointsPerPart, int megabytes)
    {
        var plan = Plan();
        var cubes = plan.CubesOf(pointsPerPart);
        var results = new List<PartResult>();
        for (int b = 0; b < 2; b++)
        {
            string name = "bucket" + b;
            using var reader = Reader();
            var blocks = Enumerable.Range(0, reader.BlockCount).Where(n => n / (reader.BlockCount / 2) == b).ToArray();
            RunToEnd(name, results, () => BucketBuild.Run(plan.Whole, cubes, reader, blocks,
                Output(name, results, megabytes)));
        }
        var ranges = new[] { BucketBuild.ReadRanges(Folder.File("bucket0")), BucketBuild.ReadRanges(Folder.File("bucket1")) };
        var folders = new List<string>();
        void Fetch(int part, string path)
        {
            using var to = File.Create(path);
            for (int bucket = 0; bucket < 2; bucket++)
                foreach (var range in ranges[bucket].Where(r => r.Part == part))
                    to.Write(File.ReadAllBytes(Path.Combine(Folder.File("bucket" + bucket), BucketBuild.BucketName)),
                        (int)range.Offset, (int)range.Bytes);
        }
        long CountOf(int part) => ranges.Sum(r => r.Where(x => x.Part == part).Sum(x => x.Count));
        for (int p = 0; p < cubes.Length; p++)
        {
            int part = p;
            string name = "part" + p;
            RunToEnd(name, results, () => PartBuild.RunRecords(plan.Whole.Of(cubes[part]), CountOf(part),
                path => Fetch(part, path), Output(name, results, megabytes)));
            folders.Add(name);
        }
        Assert.That(CountOf(cubes.Length), Is.EqualTo(2L));
        BuildOutside(plan, results, 2, path => Fetch(cubes.Length, path), folders);
        AssertWhole(plan, cubes, results, folders, results.Take(2).ToArray());
    }

    [Test]
    public void Run_StoppedAnywhere_MakesTheChunksOfOneBuild([Values] bool ofBuckets, [Values] bool atTheEnd)
    {
        m_isStoppedAtTheEnd = atTheEnd;
        m_stops = new System.Random(8);
        if (ofBuckets)
            RunRecords_OfBuckets_MakesTheChunksOfOneBuild(30000, 1);
        else
            Run_PartsOfAnySize_MakeTheChunksOfOneBuild(30000, 1);
    }
}
