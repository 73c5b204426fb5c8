using System.Runtime.InteropServices;
using FastPoints.HostTests.Samples;
using FastPoints.Surface;
using UnityEngine.AI;
using PointCloud = FastPoints.Entities.PointCloud;
using Random = Unity.Mathematics.Random;

namespace FastPoints.HostTests.Surface;

/// <summary>A ground of 64 by 32 m in cells of 16 m, whose middle lies at the cloud's GameObject, and a table of class 6 on it,
/// a metre high, around (-24, 1, 0).</summary>
public sealed class PointCloudColliderTests : ScratchTests
{
    const float Voxel = 0.2f;

    SampleWorld m_world;
    List<string> m_logged;
    Transform m_player;
    string m_cloud;

    [OneTimeSetUp]
    public void MakeCloud() => m_cloud = Convert(Scratch["ground.fastpoints"]);

    internal static string Convert(string path, bool isInMillimetres = false)
    {
        var random = new Random(5);
        var points = new List<(double3 Place, byte Class)>();
        var middle = new double3(500_000, 5_000_000, 100); // Far from zero, as coordinates are.
        for (double y = -16; y < 16; y += 0.9 * Voxel)
            for (double x = -32; x < 32; x += 0.9 * Voxel)
            {
                double3 place = new double3(x, y, 0) + new double3(0.1 * random.NextDouble2(0, 1), 0.02 * random.NextDouble());
                points.Add((place, 2));
                if (math.all(math.abs(place.xy - new double2(-24, 0)) < 2))
                    points.Add((place + new double3(0, 0, 1), 6));
            }
        var batch = TestBatches.New(points.Count, isInMillimetres ? AttributeType.Int32 : AttributeType.Float64,
            new PointAttribute(AttributeNames.Classification, AttributeType.UInt8));
        for (int i = 0; i < points.Count; i++)
        {
            var place = isInMillimetres ? points[i].Place * 1000 : points[i].Place + middle;
            for (int axis = 0; axis < 3; axis++)
                TestBatches.Set(batch, axis, i, place[axis]);
            TestBatches.Put(batch, 3, i, points[i].Class);
        }
        using var reader = new MemoryPointReader(batch, 10_000);
        if (isInMillimetres)
            reader.Info.Transform = new PositionTransform { Scale = 0.001, Offset = middle };
        JobCoroutine.RunToEnd(ConvertCloud.Run([reader], path, new ConvertSettings { PointsPerChunk = 20_000 }, _ => { }, null));
        batch.Dispose();
        return path;
    }

    [SetUp]
    public void MakeWorld()
    {
        SceneLoop.Clear();
        UnsafeUtility.ForgiveLeaks();
        m_world = new SampleWorld();
        m_logged = [];
        Debug.s_sink = (type, text) => m_logged.Add(type + ": " + text);
        MeshCollider.BakedWhereSet = 0;
        m_player = new GameObject("player").transform;
    }

    [TearDown]
    public void EndWorld()
    {
        Object.DestroyImmediate(m_player.gameObject);
        m_world.Dispose();
        Debug.s_sink = null;
        Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        Assert.That(Mesh.Count, Is.Zero, "meshes are left");
        Assert.That(MeshCollider.BakedWhereSet, Is.Zero, "baked on the main thread");
    }

    PointCloudCollider Collider(Action<PointCloudCollider> set = null, string path = null) =>
        m_world.Add<PointCloudCollider>(added =>
        {
            added.GetComponent<PointCloud>().Path = path ?? m_cloud;
            added.Followed.Add(m_player);
            (added.Radius, added.VoxelSize, added.HoleSize, added.FrameMs) = (4, Voxel, 0.6f, 4);
            added.CacheMegabytes = 0; // Tests that use the cache say so.
            set?.Invoke(added);
        });

    void Put(float x, float y = 1, float z = 0) => m_player.position = new Vector3(x, y, z);

    static MeshCollider[] Shown(PointCloudCollider of) => of.GetComponentsInChildren<MeshCollider>(false);

    static IEnumerable<Vector3> Places(PointCloudCollider of) => Shown(of).SelectMany(c =>
        c.sharedMesh.Vertices.Select(v => c.transform.localPosition + v));

    void Await(PointCloudCollider of, Vector3 place) => m_world.Frames(() => of.IsReady(place, 1) || of.Error != null);

    static bool IsAtRest(PointCloudCollider of) => of.Surface != null && !of.Surface.IsMaking &&
        of.Surface.Cells.Next(double.MaxValue) == null;

    [Test]
    public void LateUpdate_SomethingFollowed_HasGroundNearItAndNowhereElse()
    {
        Put(-12);
        var collider = Collider();
        Assert.That(collider.IsReady(m_player.position), Is.False);
        Await(collider, m_player.position);
        m_world.Frames(() => IsAtRest(collider));

        var places = Places(collider).ToArray();
        Assert.That(places.Select(p => p.y), Is.All.EqualTo(0).Within(0.75 * Voxel).Or.EqualTo(1).Within(0.75 * Voxel));
        Assert.That(places.Any(p => new Vector3(p.x + 12, 0, p.z).magnitude < 2 * Voxel), Is.True, "underfoot");
        Assert.That(collider.IsReady(new Vector3(28, 1, 0)), Is.False);
        Assert.That(places.Max(p => p.x), Is.LessThan(16));
        Assert.That(Shown(collider).Select(c => c.gameObject.hideFlags), Is.All.EqualTo(HideFlags.DontSave));
        Assert.That(collider.TriangleCount, Is.EqualTo(Shown(collider).Sum(c => c.sharedMesh.Indices.Length / 3)));
    }

    /// <summary>Unity's fronts are clockwise: there this product points to who sees them so.</summary>
    [Test]
    public void LateUpdate_TopsOfSheets_FaceUp()
    {
        Put(0);
        var collider = Collider();
        Await(collider, m_player.position);
        var mesh = Shown(collider)[0].sharedMesh;
        double up = 0, down = 0, middle = mesh.Vertices.Average(v => v.y);
        for (int i = 0; i < mesh.Indices.Length; i += 3)
        {
            var corners = Enumerable.Range(i, 3).Select(n => mesh.Vertices[mesh.Indices[n]]).ToArray();
            Vector3 a = corners[1] - corners[0], b = corners[2] - corners[0];
            double y = a.z * b.x - a.x * b.z;
            if (corners.All(c => c.y > middle))
                (up, down) = (up + Math.Max(0, y), down + Math.Max(0, -y));
        }
        Assert.That(up, Is.GreaterThan(100 * down));
        Assert.That(up, Is.Positive);
    }

    [Test]
    public void LateUpdate_BeyondTheBudgetOfCells_DropsWhatWasWantedLongestAgo()
    {
        Put(-28);
        var collider = Collider(c => c.MaxCells = 8);
        m_world.Frames(() => IsAtRest(collider) && collider.CellCount > 0);
        for (float x = -28; x <= 28; x += 4)
        {
            Put(x);
            m_world.Frame();
            m_world.Frames(() => IsAtRest(collider));
            Assert.That(collider.CellCount, Is.LessThanOrEqualTo(8));
            Assert.That(collider.IsReady(m_player.position, 1), Is.True);
        }
        Assert.That(collider.IsReady(new Vector3(-28, 1, 0), 1), Is.False);
        Assert.That(Places(collider).Min(p => p.x), Is.GreaterThan(-17));
        int meshes = Mesh.Count;
        Put(-28);
        m_world.Frame();
        m_world.Frames(() => IsAtRest(collider));
        Assert.That(Mesh.Count, Is.LessThanOrEqualTo(Math.Max(meshes, 8)), "they are taken from the pool");
        Assert.That(collider.IsReady(m_player.position, 1), Is.True);
    }

    [Test]
    public void LateUpdate_BeyondTheBudgetOfTriangles_KeepsTheNearestAndRests()
    {
        Put(0.5f, 1, 0.5f);
        var collider = Collider(c => c.Radius = 30);
        m_world.Frames(() => IsAtRest(collider) && collider.CellCount > 0);
        long all = collider.TriangleCount;
        collider.MaxTriangles = (int)(all / 2);
        Put(-3.5f, 1, 0.5f);
        m_world.Frame();
        m_world.Frames(() => IsAtRest(collider));
        Assert.That(collider.TriangleCount, Is.Positive.And.LessThanOrEqualTo(all / 2));
        Assert.That(collider.IsReady(m_player.position, 1), Is.True);
        var before = Shown(collider).Select(c => c.transform.localPosition).ToArray();
        for (int i = 0; i < 50; i++)
            m_world.Frame();
        Assert.That(Shown(collider).Select(c => c.transform.localPosition), Is.EqualTo(before), "nothing comes and goes");
    }

    [Test]
    public void OnDisable_WhileACellIsMade_LeavesNothing()
    {
        Put(0);
        var collider = Collider();
        // At each step that a cell takes.
        for (int frames = 0; frames < 40; frames++)
        {
            m_world.Frames(() => collider.Surface?.IsMaking == true);
            for (int i = 0; i < frames; i++)
                m_world.Frame();
            collider.enabled = false;
            m_world.Frame();
            Assert.That(Shown(collider), Is.Empty);
            Assert.That(Mesh.Count, Is.Zero);
            collider.enabled = true;
        }
        Assert.That(m_logged, Is.Empty);
    }

    [Test]
    public void LateUpdate_NoCloudAtThePath_SaysSoOnceAndTriesAgain()
    {
        Put(0);
        string path = Scratch["later.fastpoints"];
        var collider = Collider(path: path);
        m_world.Frames(() => collider.Error != null);
        collider.Reopen();
        for (int i = 0; i < 20; i++)
            m_world.Frame();
        Assert.That(collider.Error, Does.StartWith(path).And.Contains("wanted a folder with cloud.json"));
        Assert.That(m_logged.Count(l => l.Contains("lacks colliders")), Is.EqualTo(1));
        FileChanges.MoveFolder(Convert(Scratch["made.fastpoints"]), path);
        collider.Reopen();
        m_world.Frames(() => collider.IsReady(m_player.position));
        Assert.That(collider.Error, Is.Null);
        Assert.That(collider.TriangleCount, Is.Positive);
    }

    [Test]
    public void LateUpdate_DamagedCloud_SaysWhichFileAndKeepsWhatThereIs()
    {
        Put(-28);
        string path = Convert(Scratch["damaged.fastpoints"]);
        var collider = Collider(path: path);
        m_world.Frames(() => IsAtRest(collider) && collider.CellCount > 0);
        int shown = Shown(collider).Length;
        foreach (string file in Directory.GetFiles(path, "*", SearchOption.AllDirectories))
            if (new FileInfo(file).Length > 100_000)
                File.WriteAllBytes(file, new byte[new FileInfo(file).Length]);
        Put(28);
        m_world.Frames(() => collider.Error != null);
        for (int i = 0; i < 20; i++)
            m_world.Frame();
        Assert.That(collider.Error, Does.StartWith(path));
        Assert.That(m_logged.Count(l => l.Contains("lacks colliders")), Is.EqualTo(1));
        Assert.That(Shown(collider).Length, Is.EqualTo(shown));
        Assert.That(collider.IsReady(m_player.position), Is.False);
    }

    [Test]
    public void LateUpdate_ClassesLeftOut_HaveNoSurface()
    {
        Put(-24);
        var collider = Collider();
        Await(collider, m_player.position);
        Assert.That(Places(collider).Any(p => p.y > 0.8), Is.True, "the table");
        collider.HiddenClasses = [6];
        m_world.Frame();
        Assert.That(collider.CellCount, Is.Zero, "made anew");
        Await(collider, m_player.position);
        Assert.That(Places(collider).Select(p => p.y), Is.All.LessThan(0.5));
    }

    [Test]
    public void LateUpdate_OriginMoved_MovesCollidersInDouble()
    {
        Put(0);
        var origin = m_world.Add<PointCloudOrigin>();
        var collider = Collider(c => c.transform.SetParent(origin.transform, false));
        Await(collider, m_player.position);
        m_world.Frames(() => origin.HasPosition && IsAtRest(collider));
        var before = Shown(collider).Select(c => c.transform.localPosition).ToArray();
        origin.Shift(new double3(20, 0, 0));
        m_world.Frames(() => Shown(collider)[0].transform.localPosition.x < before[0].x - 19);
        Assert.That(Shown(collider).Select((c, i) => (c.transform.localPosition - before[i] + new Vector3(20, 0, 0)).magnitude),
            Is.All.LessThan(1e-5));
        Assert.That(collider.IsReady(new Vector3(-20, 1, 0), 1), Is.True);
        // What is followed is at another place of the cloud now.
        m_world.Frames(() => collider.IsReady(m_player.position, 1));
    }

    [Test]
    public void LateUpdate_TurnedAndScaledCloud_HasGroundNearWhatMovesInIt()
    {
        var collider = Collider(c => CloudWorld.Turn(c.transform));
        // Of the cloud's (10, 0, 0).
        var place = collider.transform.localToWorldMatrix.MultiplyPoint3x4(new Vector3(10, 0, 0));
        Put(place.x, place.y, place.z);
        Await(collider, place);
        Assert.That(Places(collider).Any(p => (p - new Vector3(10, 0, 0)).magnitude < 2 * Voxel), Is.True);
        Assert.That(collider.IsReady(new Vector3(10, 0, 0)), Is.False);
    }

    [Test]
    public void AddNavMeshSources_OfTheCollidersOfNow_HasTheirMeshesAndPlaces()
    {
        Put(0);
        var collider = Collider();
        Await(collider, m_player.position);
        m_world.Frames(() => IsAtRest(collider));
        var sources = new List<NavMeshBuildSource>();
        collider.AddNavMeshSources(sources);
        Assert.That(sources.Select(s => s.sourceObject), Is.EquivalentTo(Shown(collider).Select(c => c.sharedMesh)));
        Assert.That(sources.Select(s => s.component), Is.EquivalentTo(Shown(collider)));
        Assert.That(sources.Select(s => s.transform), Is.EquivalentTo(Shown(collider).Select(
            c => c.transform.localToWorldMatrix)));
        Assert.That(sources.Select(s => s.shape), Is.All.EqualTo(NavMeshBuildSourceShape.Mesh));
    }

    /// <summary>With the cloud's points gone, the surfaces are those of the cache.</summary>
    [Test]
    public void LateUpdate_CellsOnDisk_AreTheSameBitForBitAndReadNoPoints()
    {
        Put(-24);
        string path = Convert(Scratch["cached.fastpoints"]);
        var collider = Collider(c => c.CacheMegabytes = 16, path);
        List<(Vector3 Place, Vector3[] Vertices, uint[] Indices)> MakeAll()
        {
            collider.enabled = false;
            collider.enabled = true;
            m_world.Frames(() => collider.Error != null ||
                IsAtRest(collider) && collider.CellCount > 0 && !collider.Surface.IsWriting);
            Assert.That(collider.Error, Is.Null);
            return Shown(collider).Select(c => (c.transform.localPosition, c.sharedMesh.Vertices.ToArray(),
                c.sharedMesh.Indices.ToArray())).OrderBy(c => (c.localPosition.x, c.localPosition.y, c.localPosition.z)).ToList();
        }
        var made = MakeAll();
        Assert.That(made, Is.Not.Empty);
        foreach (string file in Directory.GetFiles(path, "*", SearchOption.AllDirectories))
            if (new FileInfo(file).Length > 100_000)
                File.WriteAllBytes(file, new byte[new FileInfo(file).Length]);
        var read = MakeAll();
        Assert.That(read.Select(c => c.Place), Is.EqualTo(made.Select(c => c.Place)));
        for (int i = 0; i < made.Count; i++)
        {
            Assert.That(read[i].Indices, Is.EqualTo(made[i].Indices));
            Assert.That(MemoryMarshal.AsBytes<Vector3>(read[i].Vertices).SequenceEqual(
                MemoryMarshal.AsBytes<Vector3>(made[i].Vertices)), Is.True);
        }
        Assert.That(Directory.GetFiles(path + ".surfaces"), Has.Length.EqualTo(1), "what was read is not written again");
        collider.HoleSize = 0.4f;
        m_world.Frames(() => collider.Error != null);
        Assert.That(collider.CellCount, Is.Zero, "cells of other settings are not taken");
    }

    [Test]
    public void LateUpdate_AtRest_MakesNoGarbage()
    {
        Put(0);
        var collider = Collider();
        m_world.Frames(() => IsAtRest(collider) && collider.CellCount > 0);
        long GarbageOf(Action frame)
        {
            for (int i = 0; i < 20; i++)
                frame();
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < 100; i++)
                frame();
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }
        Assert.That(GarbageOf(collider.LateUpdate), Is.Zero);
        Assert.That(GarbageOf(() =>
        {
            Put(m_player.position.x == 0 ? 0.5f : 0);
            collider.LateUpdate();
        }), Is.Zero);
    }

    [StructLayout(LayoutKind.Sequential)]
    struct TimeSpec
    {
        public long Seconds;
        public long Nanoseconds;
    }

    [DllImport("libc")]
    static extern int clock_gettime(int clock, out TimeSpec time);

    /// <summary>Of this thread's own work, whatever else the machine does: Linux.</summary>
    static double ThreadMs() => clock_gettime(3, out var time) == 0 ? time.Seconds * 1e3 + time.Nanoseconds * 1e-6 : 0;

    /// <summary>What LateUpdate takes on the main thread while cells are made, PhysX apart, which is not here.</summary>
    [Test, Explicit("a measurement")]
    public void LateUpdate_WhileCellsAreMade_TakesItsShareOfTheMainThread()
    {
        var collider = Collider(c => (c.FrameMs, c.Radius) = (0.5f, 20));
        var times = new List<double>();
        for (float x = -30; x <= 30; x += 0.5f)
        {
            Put(x);
            do
            {
                m_world.Frame();
                double begin = ThreadMs();
                collider.LateUpdate();
                // By then all has been compiled.
                if (x > -15)
                    times.Add(ThreadMs() - begin);
                Thread.Yield();
            }
            while (!IsAtRest(collider) && collider.Error == null);
        }
        times.Sort();
        Console.WriteLine(times.Count + " frames, " + collider.CellCount + " cells, " + collider.TriangleCount + " triangles: "
            + times[times.Count / 2] + " ms in the middle, 99 % within " + times[times.Count * 99 / 100] + " ms, longest "
            + times[^1] + " ms");
    }
}
