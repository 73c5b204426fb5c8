using FastPoints.Store;
using FastPoints.Surface;
using Unity.Physics;
using Unity.Physics.Systems;
using Collider = Unity.Physics.Collider;

namespace FastPoints.HostTests.Surface;

/// <summary>The cloud of <see cref="PointCloudColliderTests"/>, in a world of entities.</summary>
public sealed class PointCloudGroundTests : ScratchTests
{
    const float Voxel = 0.2f;

    string m_path;
    World m_world;
    PhysicsSystemGroup m_physics;
    EntityManager m_entities;
    Entity m_cloud, m_player;

    [OneTimeSetUp]
    public void MakeCloud() => m_path = PointCloudColliderTests.Convert(Scratch["ground.fastpoints"]);

    [SetUp]
    public void MakeWorld()
    {
        UnsafeUtility.ForgiveLeaks();
        m_world = new World("physics");
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(FixedStepSimulationSystemGroup),
            typeof(PhysicsSystemGroup), typeof(BeforePhysicsSystemGroup), typeof(MakeGroundSystem));
        m_physics = m_world.GetExistingSystemManaged<PhysicsSystemGroup>();
        m_entities = m_world.EntityManager;
        m_cloud = m_entities.CreateEntity(typeof(LocalToWorld), typeof(PointCloudFile));
        Place(m_cloud, float4x4.Translate(default));
        new PointCloudPaths { Path = m_path }.WriteTo(m_entities.AddBuffer<PointCloudPathByte>(m_cloud));
        var ground = PointCloudGround.Default;
        (ground.Radius, ground.VoxelSize, ground.HoleSize, ground.StepMs, ground.CacheMegabytes) = (4, Voxel, 0.6f, 4, 0);
        m_entities.AddComponentData(m_cloud, ground);
        m_player = m_entities.CreateEntity(typeof(LocalToWorld), typeof(PointCloudGround.Followed));
    }

    [TearDown]
    public void EndWorld()
    {
        m_world.Dispose();
        Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero, "colliders are left");
    }

    void Place(Entity entity, float4x4 at) => m_entities.SetComponentData(entity, new LocalToWorld { Value = at });

    void Put(float x)
    {
        var place = new float3(x, 1, 0);
        Place(m_player, float4x4.Translate(place));
        var watch = System.Diagnostics.Stopwatch.StartNew();
        do
        {
            m_physics.Update();
            Thread.Yield();
        }
        while (!PointCloudGround.IsReady(m_world, m_cloud, place, 1) && watch.ElapsedMilliseconds < 10_000);
        Assert.That(PointCloudGround.IsReady(m_world, m_cloud, place, 1), Is.True);
    }

    void Steps(int count)
    {
        for (int step = 0; step < count; step++)
            m_physics.Update();
    }

    Entity[] Bodies()
    {
        using var query = m_entities.CreateEntityQuery(typeof(PhysicsCollider), typeof(PhysicsWorldIndex),
            typeof(LocalToWorld));
        using var bodies = query.ToEntityArray(Allocator.Temp);
        return bodies.ToArray();
    }

    unsafe CollisionFilter[] Filters() => Bodies()
        .Select(body => ((Collider*)m_entities.GetComponentData<PhysicsCollider>(body).Value.GetUnsafePtr())->Filter).ToArray();

    [Test]
    public void Filter_ThatIsChanged_IsThatOfEachBodyMadeAnew()
    {
        Put(0);
        Assert.That(Filters(), Is.Not.Empty.And.All.EqualTo(CollisionFilter.Default));
        var ground = m_entities.GetComponentData<PointCloudGround>(m_cloud);
        foreach (var filter in new[] { new() { BelongsTo = 4, CollidesWith = 3, GroupIndex = -7 }, default(CollisionFilter) })
        {
            ground.Filter = filter;
            m_entities.SetComponentData(m_cloud, ground);
            Steps(1);
            Put(0);
            Assert.That(Filters(), Is.Not.Empty.And.All.EqualTo(filter.Equals(default) ? CollisionFilter.Default : filter));
        }
    }

    unsafe List<(float3 A, float3 B, float3 C)> Triangles()
    {
        var all = new List<(float3 A, float3 B, float3 C)>();
        foreach (var body in Bodies())
        {
            var collider = (Collider*)m_entities.GetComponentData<PhysicsCollider>(body).Value.GetUnsafePtr();
            var at = m_entities.GetComponentData<LocalToWorld>(body).Value.c3.xyz;
            var vertices = (float3*)(collider + 1);
            foreach (int3 t in new ReadOnlySpan<int3>(vertices + collider->Vertices, collider->Triangles))
                all.Add((at + vertices[t.x], at + vertices[t.y], at + vertices[t.z]));
        }
        return all;
    }

    [Test]
    public void OnUpdate_SomethingFollowed_HasBodiesNearItOfTheCloudsGround()
    {
        Put(-12);
        var triangles = Triangles();
        Assert.That(triangles.Select(t => (double)t.A.y), Is.All.EqualTo(0).Within(0.75 * Voxel)
            .Or.EqualTo(1).Within(0.75 * Voxel));
        Assert.That(triangles.Any(t => math.lengthsq(t.A - new float3(-12, t.A.y, 0)) < 4 * Voxel * Voxel), Is.True, "underfoot");
        Assert.That(triangles.Max(t => t.A.x), Is.LessThan(16));
        // Fronts of the tops are clockwise from above, as PhysX's.
        float middle = triangles.Average(t => t.A.y);
        Assert.That(triangles.Sum(t => math.min(math.min(t.A.y, t.B.y), t.C.y) > middle
            ? math.cross(t.B - t.A, t.C - t.A).y : 0), Is.Positive);
        Assert.That(PointCloudGround.IsReady(m_world, m_cloud, new float3(28, 1, 0)), Is.False);
    }

    [Test]
    public void OnUpdate_WhatIsFollowedMovesOn_DropsBodiesAndFreesTheirCollidersLater()
    {
        var ground = m_entities.GetComponentData<PointCloudGround>(m_cloud);
        ground.MaxCells = 8;
        m_entities.SetComponentData(m_cloud, ground);
        for (float x = -28; x <= 28; x += 4)
            Put(x);
        Assert.That(Bodies(), Is.Not.Empty.And.Length.LessThanOrEqualTo(8));
        Assert.That(Triangles().Min(t => t.A.x), Is.GreaterThan(-17));
        Steps(20);
        int bodies = Bodies().Length;
        m_entities.DestroyEntity(m_cloud);
        Steps(1);
        Assert.That(Bodies(), Is.Empty);
        // Queries may read the physics world, which is not built again yet.
        int live = UnsafeUtility.CheckForLeaks();
        Steps(1);
        Assert.That(UnsafeUtility.CheckForLeaks(), Is.EqualTo(live));
        Steps(20);
        Assert.That(UnsafeUtility.CheckForLeaks(), Is.EqualTo(live - bodies));
    }

    [Test]
    public void OnUpdate_CloudMovedThenTurnedAndStretched_HasItsGroundThere()
    {
        Put(-12);
        Place(m_cloud, float4x4.Translate(new float3(0, 5, 0)));
        m_physics.Update();
        Assert.That(Triangles().Select(t => (double)t.A.y), Is.All.GreaterThan(4.5));
        // East becomes up, twice as long.
        Place(m_cloud, new float4x4(new float4(0, 2, 0, 0), new float4(-1, 0, 0, 0), new float4(0, 0, 1, 0),
            new float4(0, 24, 0, 1)));
        m_physics.Update();
        Put(0);
        Assert.That(Triangles().Any(t => math.abs(t.A.x) < 2 * Voxel && math.abs(t.A.y - 1) < 2 * Voxel), Is.True);
        Assert.That(Triangles().Select(t => (double)t.A.x), Is.All.InRange(-1.5, 0.5));
    }

    /// <summary>Nothing falls through while a body is made anew.</summary>
    [Test]
    public void OnUpdate_CloudEdited_BodiesStandUntilTheNextReplaceThem()
    {
        Put(-12);
        var before = Triangles();
        int bodies = Bodies().Length;
        var hole = new EditOperation { Action = EditAction.Delete };
        using (var folder = CloudFolder.Open(m_path))
        {
            var middle = new double3(500_000, 5_000_000, 100);
            var (min, max) = (middle + new double3(-13, -1, -9), middle + new double3(-11, 1, 9));
            hole.Boxes.Add(EditShape.Box(folder.Manifest.Grid, min, max));
            EditJournal.Read(m_path, folder.Manifest.CloudId).Add(hole);
        }
        bool IsGone() => !Triangles().Any(t => math.max(math.abs(t.A.x + 12), math.abs(t.A.z)) < 0.5f);
        try
        {
            Assert.That(IsGone(), Is.False);
            Assert.That(() =>
            {
                m_physics.Update();
                Assert.That(Bodies(), Has.Length.EqualTo(bodies));
                return IsGone();
            }, Is.True.After(10_000, 1));
            Assert.That(Triangles(), Has.Count.LessThan(before.Count));
        }
        finally
        {
            File.Delete(EditJournal.PathOf(m_path));
        }
    }

    [Test]
    public void OnUpdate_NoCloudAtThePath_SaysSoOnce()
    {
        new PointCloudPaths { Path = Scratch["absent.fastpoints"] }.WriteTo(m_entities.GetBuffer<PointCloudPathByte>(m_cloud));
        Assert.That(LoggedOnce(), Does.Contain("absent.fastpoints"));
    }

    /// <summary>com.unity.physics would leave out most of their triangles.</summary>
    [Test]
    public void OnUpdate_VoxelsTooSmallForPhysics_SaysSoOnceAndMakesThemWhereTheyAreLarger()
    {
        Place(m_cloud, Scaled(0.19f));
        Assert.That(LoggedOnce(), Does.Contain("voxels of 0.038 m").And.Contain("ground.fastpoints"));
        Assert.That(Bodies(), Is.Empty);
        Place(m_cloud, Scaled(0.21f));
        var ground = m_entities.GetComponentData<PointCloudGround>(m_cloud);
        m_entities.RemoveComponent<PointCloudGround>(m_cloud); // It would be tried again five seconds later.
        m_physics.Update();
        m_entities.AddComponentData(m_cloud, ground);
        Put(-12 * 0.21f);
        Assert.That(Bodies(), Is.Not.Empty);
    }

    static float4x4 Scaled(float by) => new float4x4(new float4(by, 0, 0, 0), new float4(0, by, 0, 0), new float4(0, 0, by, 0),
        new float4(0, 0, 0, 1));

    string LoggedOnce()
    {
        var logged = new List<string>();
        UnityEngine.Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        try
        {
            Assert.That(() =>
            {
                m_physics.Update();
                return logged.Count;
            }, Is.EqualTo(1).After(10_000, 1));
            return logged[0];
        }
        finally
        {
            UnityEngine.Debug.s_sink = null;
        }
    }
}
