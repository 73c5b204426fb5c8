using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Surface;
using Random = Unity.Mathematics.Random;

namespace FastPoints.HostTests.Surface;

public sealed class SurfaceCacheTests : ScratchTests
{
    const ulong CloudId = 0x1234_5678_9abc_def0;

    static readonly int3 s_cell = new int3(-3, 70000, 2);

    string m_cloud;
    string Folder => m_cloud + SurfaceCache.Extension;

    [SetUp]
    public void MakeCloud() => m_cloud = Scratch[TestContext.CurrentContext.Test.ID + ".fastpoints"];

    SurfaceCache Open(long maxBytes = 16 << 20, ulong cloudId = CloudId) =>
        Begin(new SurfaceCache(m_cloud, cloudId, true, maxBytes), new SurfaceGrid(0.1, 80, 3));

    static SurfaceCache Begin(SurfaceCache cache, SurfaceGrid grid, int hidden = -1, double z = 1, UpAxis up = UpAxis.Z)
    {
        cache.Begin(grid, ClassMask.Of(hidden), new double3(1, 1, z), up);
        return cache;
    }

    static PackedSurface Surface(int vertices, int triangles, uint seed = 1)
    {
        var random = new Random(seed);
        var surface = new PackedSurface(vertices, triangles);
        var (places, corners) = (surface.Vertices, surface.Triangles);
        for (int i = 0; i < vertices; i++)
            places[i] = (float3)random.NextDouble3(-1, 9);
        for (int i = 0; i < triangles; i++)
            corners[i] = new int3(random.NextInt(0, vertices), random.NextInt(0, vertices), i % vertices);
        return surface;
    }

    void Write(int3 cell, uint seed = 1, ulong edits = 0)
    {
        using var surface = Surface(4, 3, seed);
        Open().Write(cell, edits, surface);
    }

    static bool Finds(SurfaceCache cache, int3 cell, uint seed = 1, ulong edits = 0)
    {
        using var read = cache.Read(cell, edits);
        using var wanted = Surface(4, 3, seed);
        return read.Ints.IsCreated && read.Ints.ToArray().SequenceEqual(wanted.Ints.ToArray());
    }

    string File => Directory.GetFiles(Folder).Single();

    [Test]
    public void Read_WhatWasWritten_IsTheSameInLaterRuns()
    {
        Write(s_cell);
        using (var empty = new PackedSurface(0, 0))
            Open().Write(new int3(1), 0, empty);
        Assert.That(Finds(Open(), s_cell), Is.True);
        using var read = Open().Read(new int3(1), 0);
        Assert.That((read.Ints.IsCreated, read.Vertices.Length, read.Triangles.Length), Is.EqualTo((true, 0, 0)));
        Assert.That(Finds(Open(), s_cell + new int3(0, 0, 1)), Is.False);
    }

    [Test]
    public void Read_DamagedAtAnyByte_FindsNothingAndIsWrittenAnew()
    {
        Write(s_cell);
        byte[] whole = System.IO.File.ReadAllBytes(File);
        for (int at = 0; at < whole.Length; at++)
        {
            var damaged = (byte[])whole.Clone();
            damaged[at] ^= (byte)(1 << at % 8);
            System.IO.File.WriteAllBytes(File, damaged);
            Assert.That(Finds(Open(), s_cell), Is.False, "byte " + at);
        }
        Write(s_cell);
        Assert.That(Finds(Open(), s_cell), Is.True);
    }

    [Test]
    public void Read_CutOffAtAnyByte_FindsWhatIsWholeAndGoesOn()
    {
        using (var cache = Open())
        using (PackedSurface first = Surface(4, 3), second = Surface(4, 3, 2))
        {
            cache.Write(0, 0, first);
            cache.Write(1, 0, second);
        }
        byte[] whole = System.IO.File.ReadAllBytes(File);
        for (int length = 0; length < whole.Length; length++)
        {
            System.IO.File.WriteAllBytes(File, whole.AsSpan(0, length).ToArray());
            var cache = Open();
            Assert.That((Finds(cache, 0), Finds(cache, 1, 2)), Is.EqualTo((length >= whole.Length / 2, false)),
                length + " bytes");
        }
        Write(new int3(1), 2);
        Assert.That((Finds(Open(), 0), Finds(Open(), 1, 2)),
            Is.EqualTo((true, true)));
    }

    [Test]
    public void Read_OtherCloudEditsOrSettings_FindsNothing()
    {
        Write(s_cell);
        var grid = new SurfaceGrid(0.1, 80, 3);
        Assert.That(Finds(Open(), s_cell), Is.True);
        Assert.That(Finds(Open(cloudId: CloudId + 1), s_cell), Is.False, "another cloud");
        Assert.That(Finds(Open(), s_cell, edits: 1), Is.False, "edits");
        Assert.That(Finds(Begin(Open(), new SurfaceGrid(0.1000001, 80, 3)), s_cell), Is.False, "voxel size");
        Assert.That(Finds(Begin(Open(), new SurfaceGrid(0.1, 81, 3)), s_cell), Is.False, "cell size");
        Assert.That(Finds(Begin(Open(), new SurfaceGrid(0.1, 80, 2)), s_cell), Is.False, "hole size");
        Assert.That(Finds(Begin(Open(), grid, 6), s_cell), Is.False, "classes");
        Assert.That(Finds(Begin(Open(), grid, 200), s_cell), Is.False, "high classes");
        Assert.That(Finds(Begin(Open(), grid, z: 1.5), s_cell), Is.False, "metres");
        Assert.That(Finds(Begin(Open(), grid, up: UpAxis.Y), s_cell), Is.False, "up");
    }

    [Test]
    public void Write_BeyondTheLimit_DropsWhatWasUsedLongestAgo()
    {
        const long max = 64 << 10;
        using var surface = Surface(200, 100);
        for (int run = 0; run < 40; run++)
        {
            var cache = Open(max);
            for (int n = 0; n < 5; n++)
                cache.Write(new int3(run, n, 0), 0, surface);
            Assert.That(cache.Bytes, Is.LessThanOrEqualTo(max));
            using var read = cache.Read(new int3(run, 4, 0), 0);
            Assert.That(read.Ints.IsCreated, Is.True);
        }
        using var oldest = Open(max).Read(0, 0);
        Assert.That(oldest.Ints.IsCreated, Is.False);
        Assert.That(Directory.GetFiles(Folder), Has.Length.LessThanOrEqualTo(17));
        Assert.That(Directory.GetFiles(Folder).Sum(f => new FileInfo(f).Length), Is.LessThanOrEqualTo(max));
    }

    [Test]
    public void Open_WhereNobodyCanWrite_IsInTheFolderOfTheUser()
    {
        Assert.That(Open().Folder, Is.EqualTo(Folder));
        Directory.Delete(Folder);
        System.IO.File.WriteAllText(Folder, "in the way");
        Assert.That(Open().Folder, Is.EqualTo(RangeCache.FolderOfUser("surfaces")));
        Assert.That(new SurfaceCache("https://a.example/b.fastpoints", 1, false, 1).Folder,
            Is.EqualTo(RangeCache.FolderOfUser("surfaces")));
    }

    /// <summary>What is on disk must not outlive a change of how surfaces are made: raise the version, then these.</summary>
    [Test]
    public void Version_OfWhatSurfacesAreMadeBy_IsThatOfTheCache()
    {
        var random = new Random(3);
        using var batch = TestBatches.New(20_000, AttributeType.Float64);
        for (int i = 0; i < batch.Count; i++)
        {
            var at = random.NextDouble2(0, 8);
            var place = new double3(at, 2 + math.sin(at.x) + 0.02 * random.NextDouble());
            for (int axis = 0; axis < 3; axis++)
                TestBatches.Put(batch, axis, i, place[axis]);
        }
        using var builder = new SurfaceBuilder(new SurfaceGrid(0.1, 80, 3), new float3(0, 0, 1));
        JobCoroutine.RunToEnd(builder.Run(0, (b, at) => b.Add(at, batch, 1)));
        Assert.That((SurfaceCache.Version, builder.Vertices.Length, builder.Triangles.Length), Is.EqualTo((1, 21468, 41898)));
    }
}
