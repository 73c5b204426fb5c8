namespace FastPoints.HostTests.Cluster;

/// <summary>Upper levels and hierarchy that were made in parts are those of one build.</summary>
class PartMergeTests : FolderTests
{
    static readonly PositionTransform s_centimetres = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01) };

    ConvertSettings m_settings;
    ConvertResult m_made;
    RecordLayout m_records;
    string[] m_chunks; // The finished chunks of one build, as they are before the merge.
    GridCube[] m_cubes;

    string Target => Folder.File("whole" + StoreFormat.FolderExtension);

    /// <summary>A filled cube with a dense corner, and many points at one place.</summary>
    static int3[] Filled()
    {
        const int count = 40000;
        var random = new Unity.Mathematics.Random(5);
        var positions = new int3[count];
        for (int i = 0; i < count; i++)
            positions[i] = i % 3 == 0 ? new int3(70000, 60000, 50000) + random.NextInt3(3000)
                : i % 10 == 1 ? new int3(31, 32, 33) : random.NextInt3(100000);
        return positions;
    }

    void Convert(Sampler sampler, int3[] positions)
    {
        m_settings = new ConvertSettings
        {
            Sampler = sampler,
            CellsLog2 = 4,
            TargetPointsPerLeaf = 100,
            PointsPerChunk = 600,
            PointsPerRegion = 2500,
            MemoryBytes = 1 << 19,
            SecondsPerGeneration = 1e9,
            SecondsToFirstGeneration = 1e9,
        };
        var reader = MemoryReader.Of(positions, s_centimetres, 2000);
        var progress = new StageProgress();
        string tops = Folder.File("chunks");
        var work = new CoroutineStack(
            ConvertCloud.Run(new[] { reader }, Target, m_settings, r => m_made = r, progress));
        while (work.MoveNext())
        {
            work.Current.Complete();
            if (progress.Current != BuildStages.Merge || Directory.Exists(tops))
                continue;
            Directory.CreateDirectory(tops);
            foreach (string file in Directory.GetFiles(
                Path.Combine(Target + StoreFormat.UnfinishedSuffix, BuildFiles.TopFolderName)))
                File.Copy(file, Path.Combine(tops, Path.GetFileName(file)));
        }
        m_chunks = Directory.GetFiles(tops).OrderBy(f => f, StringComparer.Ordinal).ToArray();
        Assert.That(m_chunks, Is.Not.Empty);
        m_records = GridChoice.Choose(new[] { reader.Info }, new SampleStatistics[1],
            m_made.Manifest.Attributes.BytesPerPoint).RecordLayout;
        m_cubes = m_chunks.Select((_, i) => ChunkOf(i, false).Chunk.Container.Cube).ToArray();
    }

    BuildPart PartOf(GridCube whole, GridCube cube) => new BuildPart
    {
        CloudId = m_made.Manifest.CloudId,
        Points = m_made.Manifest.Points,
        PointsPerChunk = m_settings.PointsPerChunk,
        Grid = m_made.Manifest.Grid,
        RecordLayout = m_records,
        Attributes = m_made.Manifest.Attributes,
        Divisors = m_made.Manifest.Divisors,
        CloudCube = whole,
        Cube = cube,
    };

    (ChunkResult Chunk, NativeArray<byte> Records) ChunkOf(int number, bool isLoaded)
    {
        int stride = m_records.ForTops(m_made.Manifest.HasAverages).StrideBytes;
        using var bytes = new NativeArray<byte>(File.ReadAllBytes(m_chunks[number]), Allocator.Persistent);
        var chunk = ChunkResult.FromBytes(bytes, number, m_made.Manifest.CloudId, m_made.BytesOfPlane.Length, stride);
        if (!isLoaded)
            return (chunk, default);
        chunk.Table = new NativeArray<byte>(bytes.GetSubArray(chunk.TableOffset, chunk.TableBytes), Allocator.Persistent);
        int records = chunk.TopPoints * stride;
        return (chunk, new NativeArray<byte>(bytes.GetSubArray(bytes.Length - records, records), Allocator.Persistent));
    }

    /// <summary>What a build of a part does when its chunks are finished.</summary>
    /// <param name="collects">Whether the chunks are in a cube whose upper levels are wanted.</param>
    PartInput Build(BuildPart part, IEnumerable<int> chunks, string name, bool collects = true)
    {
        string folder = Folder.File(name);
        var owned = new List<IDisposable>();
        using (var build = new BuildContext(part, new PointReader[0], 0, folder, m_settings, null))
        using (var store = new NativeStoreLayout(part.ToManifest(m_settings.Sampler).CreateLayout()))
        using (var merge = new UpperMerge(build, store, part.ToManifest(m_settings.Sampler)))
        {
            var result = new PartResult(part.Attributes.Count, store.Layout.Planes.Count);
            foreach (int number in chunks)
            {
                // In memory, or in files.
                var (chunk, records) = ChunkOf(number, number % 2 == 0);
                if (records.IsCreated)
                    owned.Add(records);
                else
                    File.Copy(m_chunks[number], build.Folder.PathOf(BuildFiles.TopPath(number)));
                owned.Add(chunk);
                merge.Add(chunk, records);
                result.Checksum += chunk.Checksum;
                result.Include(chunk.MinSideLog2, chunk.BytesOfPlane);
                result.Statistics.Include(new PointStatistics
                {
                    Count = chunk.TopPoints + chunk.FilePointCount,
                    Min = m_made.Manifest.BoundsMin,
                    Max = m_made.Manifest.BoundsMax,
                });
            }
            if (collects)
                JobCoroutine.RunToEnd(merge.Collect(part.Cube, null));
            result.Include(merge.MinSideLog2, merge.BytesOfPlane);
            JobCoroutine.RunToEnd(PartFile.Write(build.Folder, part.Cube, part.CloudId, merge, result));
            JobCoroutine.RunToEnd(build.Folder.Complete());
        }
        foreach (var one in owned)
            one.Dispose();
        return InputOf(name);
    }

    PartInput Merge(BuildPart part, IReadOnlyList<PartInput> inputs, string name, Action<PartResult> take)
    {
        JobCoroutine.RunToEnd(PartMerge.Run(part, inputs, new PartResult[0],
            new PartOutput { Folder = Folder.File(name), Settings = m_settings, Take = take }));
        return InputOf(name);
    }

    PartInput InputOf(string name) => new PartInput
    {
        TopsPath = Path.Combine(Folder.File(name), PartFile.TopsName),
        NodesPath = Path.Combine(Folder.File(name), PartFile.NodesName),
    };

    CloudManifest Commit(IEnumerable<string> nodesPaths)
    {
        var manifest = m_made.Manifest.Clone();
        (manifest.Root, manifest.NodeCount, manifest.ChunkCount, manifest.HierarchyFileBytes) = (default, 0, 0, 0);
        JobCoroutine.RunToEnd(PartMerge.Commit(nodesPaths.ToArray(), manifest, Folder.File("commit"), null));
        return manifest;
    }

    /// <summary>Cuts a cube into at least this many that hold chunks, and some that hold none.</summary>
    /// <param name="merges">Receives the cubes that were cut: each holds several of the others.</param>
    List<GridCube> Cut(GridCube whole, int parts, uint seed, List<GridCube> merges)
    {
        var random = new Unity.Mathematics.Random(seed);
        var cubes = new List<GridCube> { whole };
        while (cubes.Count(c => m_cubes.Any(c.ContainsAligned)) < parts)
        {
            var large = cubes.Where(c => m_cubes.Count(c.ContainsAligned) > 1 && c.SideLog2 > 0 && !m_cubes.Contains(c)).ToList();
            var cut = merges.Count % 2 == 0 ? large.OrderByDescending(c => m_cubes.Count(c.ContainsAligned)).First()
                : large[random.NextInt(large.Count)];
            cubes.Remove(cut);
            merges.Add(cut);
            for (int octant = 0; octant < 8; octant++)
                cubes.Add(cut.Child(octant));
        }
        return cubes;
    }

    IEnumerable<int> In(GridCube cube) => Enumerable.Range(0, m_cubes.Length).Where(i => cube.ContainsAligned(m_cubes[i]));

    void AssertSame(CloudManifest manifest, PartResult result)
    {
        var wanted = m_made.Manifest;
        Assert.That(manifest.Root, Is.EqualTo(wanted.Root));
        var upper = Directory.GetFiles(Path.GetDirectoryName(Target), "*.bin", SearchOption.AllDirectories)
            .Where(f => Path.GetFileName(Path.GetDirectoryName(f)) == StoreFormat.UpperFolderName).ToLookup(Path.GetFileName);
        var names = Directory.GetFiles(Path.Combine(Target, StoreFormat.UpperFolderName)).Select(Path.GetFileName).ToArray();
        Assert.That(upper.Select(f => f.Key), Is.EquivalentTo(names));
        foreach (var files in upper)
        {
            Assert.That(files.Count(), Is.EqualTo(2), files.Key + " is of one part, and of one build");
            Assert.That(File.ReadAllBytes(files.First()), Is.EqualTo(File.ReadAllBytes(files.Last())), files.Key);
        }
        string committed = Folder.File("commit");
        Assert.That(File.ReadAllBytes(Path.Combine(committed, StoreFormat.HierarchyName)),
            Is.EqualTo(File.ReadAllBytes(Path.Combine(Target, StoreFormat.HierarchyName))));
        Assert.That(manifest.ToJson(), Is.EqualTo(wanted.ToJson()));
        Assert.That(result.Checksum, Is.EqualTo(wanted.Checksum));
        Assert.That(result.Statistics.Count, Is.EqualTo(wanted.Points));
        Assert.That(result.BytesOfPlane, Is.EqualTo(m_made.BytesOfPlane));
        Assert.That(wanted.Root.SideLog2 - result.MinSideLog2 + 1, Is.EqualTo(m_made.LevelCount));
    }

    /// <param name="levels">Of merges; of more than one, one for each cube that was cut.</param>
    [Test]
    public void Parts_AnyCut_MakeTheBytesOfOneBuild([Values(2, 5, 17, 40)] int parts, [Values] bool mergesOften,
        [Values(Sampler.Average, Sampler.Random)] Sampler sampler)
    {
        Convert(sampler, Filled());
        var root = m_made.Manifest.Root;
        // The plan's cube is larger.
        var whole = new GridCube(root.Corner - new Grid3(root.Side, 0, root.Side), root.SideLog2 + 1);
        var merges = new List<GridCube>();
        var random = new Unity.Mathematics.Random(9);
        var inputs = Cut(whole, parts, (uint)parts, merges)
            .Select((cube, i) => (cube, Build(PartOf(whole, cube), In(cube), "build" + i))).ToList();
        if (!mergesOften)
            merges = new List<GridCube> { whole };
        var nodes = inputs.Select(i => i.Item2.NodesPath).ToList();
        PartResult result = null;
        foreach (var cube in merges.OrderBy(c => c.SideLog2).ToList())
        {
            var below = inputs.Where(i => cube.ContainsAligned(i.cube)).OrderBy(_ => random.NextUInt()).ToList();
            var merged = Merge(PartOf(whole, cube), below.Select(b => b.Item2).ToList(), "merge" + nodes.Count,
                r => result = r);
            inputs.RemoveAll(below.Contains);
            inputs.Add((cube, merged));
            nodes.Add(merged.NodesPath);
        }
        nodes.Reverse();
        AssertSame(Commit(nodes), result);
        Assert.That(Directory.GetFiles(Path.Combine(Target, StoreFormat.UpperFolderName)), Has.Length.GreaterThan(8),
            "there are regions of regions");
    }

    [Test]
    public void Parts_AllPointsAtOnePlace_MakeTheBytesOfOneBuild()
    {
        Convert(Sampler.Poisson, Enumerable.Repeat(new int3(-5, 600, 7), 40000).ToArray());
        var root = m_made.Manifest.Root;
        Assert.That(root.SideLog2, Is.Zero);
        var cube = new GridCube(root.Corner - new Grid3(1, 3, 0), 2);
        var part = PartOf(new GridCube(cube.Corner, 3), cube);
        var built = Build(part, In(cube), "build");
        PartResult result = null;
        var merged = Merge(PartOf(part.CloudCube, part.CloudCube), new[] { built }, "merge", r => result = r);
        AssertSame(Commit(new[] { built.NodesPath, merged.NodesPath }), result);
    }

    [Test]
    public void Parts_PointsOutsideThePlansCube_MakeTheBytesOfOneBuild([Values(0, 7)] int octant)
    {
        Convert(Sampler.Poisson, Filled());
        var whole = m_made.Manifest.Root.Child(octant);
        var part = PartOf(whole, whole);
        var inputs = new List<PartInput>();
        for (int child = 0; child < 8; child++)
            inputs.Add(Build(PartOf(whole, whole.Child(child)), In(whole.Child(child)), "build" + child));
        inputs.Add(Build(part, Enumerable.Range(0, m_cubes.Length).Except(In(whole)), "outside", false));
        PartResult result = null;
        var merged = Merge(part, inputs, "merge", r => result = r);
        AssertSame(Commit(inputs.Append(merged).Select(i => i.NodesPath)), result);
    }

    /// <summary>Two parts and their merge.</summary>
    PartInput[] SmallParts(out BuildPart whole)
    {
        Convert(Sampler.Average, Filled());
        var root = m_made.Manifest.Root;
        whole = PartOf(root, root);
        return Enumerable.Range(0, 8).Select(root.Child).Select((cube, i) => Build(PartOf(root, cube), In(cube), "build" + i))
            .ToArray();
    }

    [Test]
    public void PartFiles_Damaged_FailWithThePathAndLeaveNothing([Values] bool isTops)
    {
        var inputs = SmallParts(out var whole);
        string path = isTops ? inputs[3].TopsPath : inputs[3].NodesPath;
        byte[] sound = File.ReadAllBytes(path);
        var merged = Merge(whole, inputs, "sound", _ => { });
        string[] nodes = inputs.Append(merged).Select(i => i.NodesPath).ToArray();
        var random = new System.Random(3);
        for (int i = 0; i < 300; i++)
        {
            byte[] damaged = (byte[])sound.Clone();
            // The header and the entries are few of the bytes.
            int at = i < 64 ? i : i % 3 == 0 ? sound.Length - 1 - random.Next(100) : random.Next(sound.Length);
            if (i % 5 == 4)
                Array.Resize(ref damaged, at);
            else
                damaged[at] ^= (byte)(1 << random.Next(8));
            File.WriteAllBytes(path, damaged);
            var failure = Assert.Throws<PointCloudException>(() =>
            {
                if (isTops)
                    Merge(whole, inputs, "damaged", _ => { });
                else
                    Commit(nodes);
            }, "byte " + at);
            Assert.That(failure.Code, Is.EqualTo(FailureCode.BadInput).Or.EqualTo(FailureCode.Truncated), failure.Message);
            Assert.That(failure.Message, Does.StartWith(path + ": at byte ").And.Contain("wanted").And.Contain("got"));
        }
        foreach (string name in new[] { "damaged", "commit" })
            Assert.That(Directory.Exists(Folder.File(name)), Is.False);
        File.WriteAllBytes(path, sound);
        Commit(nodes);
    }

    [Test]
    public void Commit_PartsThatDoNotBelongTogether_SaysWhich()
    {
        var inputs = SmallParts(out var whole);
        var merged = Merge(whole, inputs, "merge", _ => { });
        var nodes = inputs.Append(merged).Select(i => i.NodesPath).ToList();
        void AssertFails(IEnumerable<string> paths, string what)
        {
            var failure = Assert.Throws<PointCloudException>(() => Commit(paths));
            Assert.That(failure.Message, Does.Contain(what));
        }
        AssertFails(nodes.Skip(1), "part.nodes of its input 0: wanted one with hash");
        AssertFails(nodes.Take(8), "no merge took it in");
        AssertFails(nodes.Take(1), "tops that are not merged: wanted 0, got");
        AssertFails(nodes.Append(nodes[2]), "is the same as " + nodes[2]);
        AssertFails(nodes.Append(
            Merge(PartOf(whole.CloudCube, whole.CloudCube.Child(1)), inputs.Skip(1).Take(1).ToArray(), "again",
            _ => { }).NodesPath), "two merges took it in");
        AssertFails(new string[0], "wanted parts to commit, got none");
        (inputs[1].NodesPath, inputs[2].NodesPath) = (inputs[2].NodesPath, inputs[1].NodesPath);
        var mixed = Assert.Throws<PointCloudException>(() => Merge(whole, inputs, "mixed", _ => { }));
        Assert.That(mixed.Message, Does.StartWith(inputs[1].TopsPath + ": at byte 32: hash of " + inputs[1].NodesPath));
        m_made.Manifest.CloudId++;
        Assert.That(Assert.Throws<PointCloudException>(() => Commit(nodes)).Message, Does.Contain("cloud: wanted"));
    }
}
