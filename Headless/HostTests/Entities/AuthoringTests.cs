namespace FastPoints.HostTests.Entities;

public sealed class AuthoringTests : ScratchTests
{
    World m_world;
    PointCloudSystemGroup m_group;
    string m_cloud;

    [OneTimeSetUp]
    public void MakeCloud() => m_cloud = Scratch.Converted(points: 5000);

    [SetUp]
    public void MakeWorld()
    {
        m_world = CloudWorld.Make();
        m_group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
    }

    [TearDown]
    public void EndWorld()
    {
        if (m_world.IsCreated)
            m_world.Dispose();
    }

    void Frames(Func<bool> isDone) => CloudWorld.Frames(m_world, isDone);

    bool IsStreamed(Entity entity) => m_world.EntityManager.HasComponent<StreamedPointCloud>(entity);

    [Test]
    public void PointCloud_OnAGameObject_HasAnEntityThatFollowsIt()
    {
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<FastPoints.Entities.PointCloud>();
        Assert.That(cloud.Entity, Is.EqualTo(Entity.Null), "there is no path yet");
        cloud.Path = m_cloud;
        var entity = cloud.Entity;
        Frames(() => IsStreamed(entity));
        var before = m_group.Stream.Clouds[0].Placement.OriginWorld;
        var moved = Matrix4x4.identity;
        moved.m03 = 50;
        SceneLoop.Place(scene.transform, moved);
        Frames(() => m_group.Stream.Clouds[0].Placement.OriginWorld.x == before.x + 50);

        cloud.Path = m_cloud + "-other";
        Assert.That(cloud.Entity, Is.Not.EqualTo(entity));
        Frames(() => !m_world.EntityManager.Exists(entity));
        UnityEngine.Object.DestroyImmediate(scene);
        Assert.That(cloud.Entity, Is.EqualTo(Entity.Null));
    }

    sealed class MoveLate : MonoBehaviour
    {
        public float X;

        void Update()
        {
            var moved = Matrix4x4.identity;
            moved.m03 = X;
            SceneLoop.Place(transform, moved);
        }
    }

    [Test]
    public void PointCloudAndClipBox_MovedAfterTheirUpdate_MoveInTheSameFrame()
    {
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = m_cloud;
        scene.AddComponent<PointCloudClipBox>();
        var mover = scene.AddComponent<MoveLate>();
        SceneLoop.IsPlaying = true;
        SceneLoop.Refresh(mover);
        SceneLoop.IsPlaying = false;
        for (mover.X = 1; mover.X < 4; mover.X++)
        {
            SceneLoop.Update();
            using var placed = m_world.EntityManager.CreateEntityQuery(typeof(LocalToWorld))
                .ToComponentDataArray<LocalToWorld>(Allocator.Temp);
            Assert.That(placed.ToArray().Select(p => p.Value.c3.x), Is.EqualTo(new[] { mover.X, mover.X }));
        }
        UnityEngine.Object.DestroyImmediate(scene);
    }

    [Test]
    public void PointCloud_LayerSceneAndVisibility_FollowItsGameObject()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(FastPoints.Editor.SceneVisibility).TypeHandle);
        var scene = new GameObject("scan") { layer = 5 };
        var cloud = scene.AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = m_cloud;
        Frames(() => IsStreamed(cloud.Entity));
        var camera = new GameObject("camera").AddComponent<Camera>();
        var target = new RenderTexture(new RenderTextureDescriptor(100, 100));
        camera.targetTexture = target;
        camera.projectionMatrix = Matrix4x4.Perspective(60, 1, 0.1f, 1000);
        bool Sees()
        {
            SceneLoop.Update();
            m_world.Update();
            return CameraViews.StreamViewOf(camera).Mask.Shows(m_group.Stream.Clouds[0].Placement.Visibility);
        }
        Assert.That(Sees(), Is.True);
        camera.cullingMask = ~(1 << 5);
        Assert.That(Sees(), Is.False, "culling mask");
        scene.layer = 6;
        Assert.That(Sees(), Is.True, "another layer");

        SceneVisibilityManager.instance.Set(scene, true);
        Assert.That(Sees(), Is.True, "a game's camera");
        camera.cameraType = CameraType.SceneView;
        Assert.That(Sees(), Is.False, "the eye is closed");
        SceneVisibilityManager.instance.Set(scene, false);
        Assert.That(Sees(), Is.True, "the eye is open");

        camera.scene = new UnityEngine.SceneManagement.Scene { Mask = 4 };
        Assert.That(Sees(), Is.False, "a prefab stage");
        scene.SceneMask = 4;
        Assert.That(Sees(), Is.True, "in the stage");
        camera.overrideSceneCullingMask = 8;
        Assert.That(Sees(), Is.False, "an override");
        foreach (var made in new[] { scene, camera.gameObject })
            UnityEngine.Object.DestroyImmediate(made);
        target.Release();
    }

    [Test]
    public void PointCloud_ColourAndClasses_SelectTheStreamedPlanes()
    {
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = m_cloud;
        PointCloudLook Look() => m_world.EntityManager.GetComponentData<PointCloudLook>(cloud.Entity);
        string[] Planes()
        {
            Frames(() => IsStreamed(cloud.Entity));
            int number = m_world.EntityManager.GetComponentData<StreamedPointCloud>(cloud.Entity).Number;
            var source = m_group.Stream.Clouds[number].Source;
            return source.Planes.ToArray().Select(p => source.Layout.Planes[p].Name).ToArray();
        }
        Assert.That(Planes(), Is.EqualTo(new[] { StoreLayout.PositionName, StoreLayout.ColorName }));
        Assert.That(Look().Value.Source, Is.EqualTo(ColorSource.Channels));

        cloud.Color = ColorMode.Elevation;
        Assert.That(Planes(), Is.EqualTo(new[] { StoreLayout.PositionName }));
        Assert.That(Look().Value.Source, Is.EqualTo(ColorSource.Position));

        cloud.HiddenClasses = new[] { 2, 6 };
        Assert.That(Planes(), Is.EqualTo(new[] { StoreLayout.PositionName, AttributeNames.Classification }));
        Assert.That(Look().Value.HiddenClasses.Has(6), Is.True);
        Assert.That(Look().Value.ClassPlane, Is.EqualTo(1));
        UnityEngine.Object.DestroyImmediate(scene);
    }

    [Test]
    public void PointCloudClipBox_OnAGameObject_ClipsByItsTransformUntilDestroyed()
    {
        var clips = m_group.Stream.ClipBoxes;
        var scene = new GameObject("box");
        var box = scene.AddComponent<PointCloudClipBox>();
        var matrix = Matrix4x4.identity;
        matrix.m00 = 4;
        matrix.m03 = 50;
        SceneLoop.Place(scene.transform, matrix);
        Frames(() => clips.Length == 1 && clips[0].CenterWorld.x == 50);
        Assert.That(clips[0].EdgesWorld, Is.EqualTo(new double3x3(4, 0, 0, 0, 1, 0, 0, 0, 1)));
        Assert.That(clips[0].Cuts, Is.False);
        box.Cuts = true;
        Frames(() => clips[0].Cuts);
        UnityEngine.Object.DestroyImmediate(scene);
        Frames(() => clips.Length == 0);

        // What a script gave the stream stays.
        clips.Add(new ClipBox(0, 1));
        Frames(() => true);
        m_world.Update();
        Assert.That(clips.Length, Is.EqualTo(1));
    }

#if !REAL_ENTITIES
    /// <summary>A write completes other people's jobs, and those who look for changes look again. Unity's own counts no
    /// writes.</summary>
    [Test]
    public void Components_Unchanged_WriteNothing()
    {
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = m_cloud;
        var box = scene.AddComponent<PointCloudClipBox>();
        Frames(() => IsStreamed(cloud.Entity));
        int Written(Action change)
        {
            SceneLoop.Update();
            m_world.Update();
            int Count() => ComponentWrites<Unity.Transforms.LocalToWorld>.Count + ComponentWrites<PointCloudLayer>.Count +
                ComponentWrites<PointCloudPlacement>.Count + ComponentWrites<PointCloudClip>.Count;
            int before = Count();
            change();
            SceneLoop.Update();
            m_world.Update();
            return Count() - before;
        }
        Assert.That(Written(() => { }), Is.Zero);
        var matrix = Matrix4x4.identity;
        matrix.m03 = 50;
        Assert.That(Written(() => SceneLoop.Place(scene.transform, matrix)), Is.EqualTo(3), "cloud, placement and box");
        Assert.That(Written(() => scene.layer = 6), Is.EqualTo(1));
        Assert.That(Written(() => box.Cuts = true), Is.EqualTo(1));
        UnityEngine.Object.DestroyImmediate(scene);
    }
#endif

#if !REAL_ENTITIES
    [Test]
    public void PointCloud_ToggledDuringIteration_ChangesInTheNextFrames()
    {
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = m_cloud;
        Frames(() => IsStreamed(cloud.Entity));
        var entity = cloud.Entity;
        var store = m_world.EntityManager.Store;
        void WhileIterating(bool isActive)
        {
            store.Iterations++;
            Assert.That(() => m_world.EntityManager.CreateEntity(), Throws.InvalidOperationException);
            Assert.That(() => scene.SetActive(isActive), Throws.Nothing);
            store.Iterations--;
        }

        WhileIterating(false);
        Assert.That(cloud.Entity, Is.EqualTo(Entity.Null));
        Frames(() => !m_world.EntityManager.Exists(entity));
        WhileIterating(true);
        SceneLoop.Update();
        Frames(() => IsStreamed(cloud.Entity));
        UnityEngine.Object.DestroyImmediate(scene);
    }
#endif

    [Test]
    public void PointCloud_WorldDisposedFirst_IsDestroyedWithoutError()
    {
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = m_cloud;
        m_world.Dispose();
        SceneLoop.Update();
        Assert.That(() => UnityEngine.Object.DestroyImmediate(scene), Throws.Nothing);
    }

    [Test]
    public void Components_EntitiesOrWorldDestroyedByOthers_CreateThemAgain()
    {
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = m_cloud;
        scene.AddComponent<PointCloudSettings>().MillionPoints = 3;
        scene.AddComponent<PointCloudClipBox>();
        Frames(() => IsStreamed(cloud.Entity));
        Entity budget = Only<PointCloudBudget>(), clip = Only<PointCloudClip>();
        foreach (var entity in new[] { cloud.Entity, budget, clip })
            m_world.EntityManager.DestroyEntity(entity);
        // What is left of the cloud's until the next frame has no place and no layer.
        Assert.That(m_world.EntityManager.Exists(cloud.Entity), Is.True);
        SceneLoop.Place(scene.transform, Matrix4x4.Translate(new Vector3(50, 0, 0)));
        scene.layer = 6;
        Assert.That(() => cloud.Refresh(), Throws.Nothing);
        Assert.That(SceneLoop.Update, Throws.Nothing);
        Frames(() => IsStreamed(cloud.Entity));

        m_world.Dispose();
        SceneLoop.Update();
        MakeWorld();
        Frames(() => IsStreamed(cloud.Entity));
        budget = Only<PointCloudBudget>();
        Assert.That(m_world.EntityManager.GetComponentData<PointCloudBudget>(budget).Points, Is.EqualTo(3_000_000));
        Assert.That(Only<PointCloudClip>(), Is.Not.EqualTo(budget));
        UnityEngine.Object.DestroyImmediate(scene);
    }

    Entity Only<T>()
    {
        using var query = m_world.EntityManager.CreateEntityQuery(ComponentType.ReadOnly<T>());
        return query.ToEntityArray(Unity.Collections.Allocator.Temp).ToArray().Single();
    }

    [Test]
    public void Baker_AuthoringComponent_CreatesAStreamedCloud()
    {
        var scene = new GameObject("scan");
        var authoring = scene.AddComponent<PointCloudAuthoring>();
        authoring.Path = m_cloud;
        var entity = Baking.Bake(new PointCloudBaker(), authoring, m_world);
        // What the transform system adds for TransformUsageFlags.Dynamic.
        m_world.EntityManager.AddComponentData(entity, new LocalToWorld { Value = Unity.Mathematics.float4x4.identity });
        Frames(() => IsStreamed(entity));
        UnityEngine.Object.DestroyImmediate(scene);
    }

    [Test]
    public void Baker_ClipBoxAndSettings_MatchesTheScene()
    {
        var entities = m_world.EntityManager;
        var scene = new GameObject("all");
        var box = scene.AddComponent<PointCloudClipBox>();
        var settings = scene.AddComponent<PointCloudSettings>();
        (box.Cuts, settings.MillionPoints, settings.Size) = (true, 3, 7);
        var (clip, budget) = (Baking.Bake(new ClipBoxBaker(), box, m_world), Baking.Bake(new SettingsBaker(), settings, m_world));
        Assert.That(entities.GetComponentData<PointCloudClip>(clip).Cuts, Is.True);
        Assert.That(entities.GetComponentData<PointCloudBudget>(budget).Points, Is.EqualTo(3_000_000));
        Assert.That(entities.GetComponentData<PointCloudStyle>(budget).Value.Size.Value, Is.EqualTo(7));
        UnityEngine.Object.DestroyImmediate(scene);
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Baker_ForAPlayer_NamesNoFolderOfTheProject(bool isForPlayer)
    {
        var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
        (asset.PlayerPath, asset.ProjectPath, asset.ProjectSources) = ("in/player", "/home/me/in", new[] { "/home/me/a.las" });
        var scene = new GameObject("scan");
        var authoring = scene.AddComponent<PointCloudAuthoring>();
        authoring.Cloud = asset;
        var entity = Baking.Bake(new PointCloudBaker { IsForPlayer = isForPlayer }, authoring, m_world);
        var paths = PointCloudPaths.Of(
            PointCloudPaths.BytesOf(m_world.EntityManager.GetBuffer<PointCloudPathByte>(entity, true)));
        Assert.That(paths.Path, Is.EqualTo("in/player"));
        Assert.That(paths.ProjectPath + string.Concat(paths.ProjectSources), isForPlayer ? Is.Empty : Does.Contain("/home/me"));
        UnityEngine.Object.DestroyImmediate(scene);
    }

    /// <summary>Baked again in an open subscene: where a component or a buffer differs, its entity gets the new
    /// values.</summary>
    void BakeAgain(PointCloudAuthoring authoring, Entity entity)
    {
        var entities = m_world.EntityManager;
        var baked = Baking.Bake(new PointCloudBaker(), authoring, m_world);
        entities.SetComponentData(entity, entities.GetComponentData<PointCloudFile>(baked));
        PointCloudPaths.Of(PointCloudPaths.BytesOf(entities.GetBuffer<PointCloudPathByte>(baked, true)))
            .WriteTo(entities.GetBuffer<PointCloudPathByte>(entity));
        entities.DestroyEntity(baked);
    }

    Entity BakedAndStreamed(PointCloudAuthoring authoring)
    {
        var entity = Baking.Bake(new PointCloudBaker(), authoring, m_world);
        m_world.EntityManager.AddComponentData(entity, new LocalToWorld { Value = Unity.Mathematics.float4x4.identity });
        Frames(() => IsStreamed(entity));
        return entity;
    }

    [Test]
    public void Baker_RunAgainInAnOpenSubscene_ShowsTheChange()
    {
        var entities = m_world.EntityManager;
        var scene = new GameObject("scan");
        var authoring = scene.AddComponent<PointCloudAuthoring>();
        (authoring.Path, authoring.Color) = (m_cloud, ColorMode.Elevation);
        var entity = BakedAndStreamed(authoring);
        int Number() => entities.GetComponentData<StreamedPointCloud>(entity).Number;
        CloudLook Look() => entities.GetComponentData<PointCloudLook>(entity).Value;

        int first = Number();
        BakeAgain(authoring, entity);
        m_world.Update();
        Assert.That(Number(), Is.EqualTo(first), "nothing has changed");

        void Changed(string what, Func<bool> isShown)
        {
            BakeAgain(authoring, entity);
            m_world.Update();
            Assert.That(IsStreamed(entity), Is.False, what);
            Frames(() => IsStreamed(entity));
            Assert.That(isShown(), Is.True, what);
        }
        authoring.Color = ColorMode.Classification;
        Changed("colour", () => Look().Source == ColorSource.Attribute);
        authoring.HiddenClasses = new[] { 7 };
        Changed("classes", () => Look().HiddenClasses.Has(7));
        string other = Scratch.Converted("other.fastpoints", 4000);
        authoring.Path = other;
        Changed("path", () => m_group.Stream.Clouds[Number()].Source.Path == other);
        authoring.Path = "nowhere";
        BakeAgain(authoring, entity);
        Frames(() => m_group.ErrorOf(entity) != null);
        Assert.That(IsStreamed(entity), Is.False);
        authoring.Path = m_cloud;
        Changed("what could not be opened", () => m_group.Stream.Clouds[Number()].Source.Path == m_cloud);
        Assert.That(m_group.Stream.Clouds.Count(c => c != null && !c.IsRemoving), Is.EqualTo(1));
        UnityEngine.Object.DestroyImmediate(scene);
    }

    [Test]
    public void Baker_UnderAnOrigin_IsPlacedByItAndFollowsIt()
    {
        var entities = m_world.EntityManager;
        var root = new GameObject("origin");
        var origin = root.AddComponent<PointCloudOrigin>();
        var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
        (asset.BoundsMin, asset.BoundsMax, asset.HasOrigin, asset.Origin) = (0, 9, true, new double3(5, 6, 7));
        GameObject Beneath(string name)
        {
            var made = new GameObject(name);
            made.transform.SetParent(root.transform, false);
            return made;
        }
        var scan = Beneath("first").AddComponent<PointCloudAuthoring>();
        var first = Beneath("second").AddComponent<PointCloudAuthoring>();
        (scan.Path, first.Cloud) = (m_cloud, asset);
        var baker = new PointCloudBaker();
        var entity = Baking.Bake(baker, scan, m_world);
        double3 Geo() => entities.GetComponentData<PointCloudSpace>(entity).Value.OriginGeo;
        Assert.That(baker.Dependencies, Is.SupersetOf(new UnityEngine.Object[] { origin, first, asset }));
        entities.AddComponentData(entity, new LocalToWorld { Value = float4x4.identity });
        Frames(() => IsStreamed(entity));
        Assert.That(Geo(), Is.EqualTo(asset.Origin), "the first whose place is known decides");

        int number = entities.GetComponentData<StreamedPointCloud>(entity).Number;
        PointCloudOrigin.ShiftEntities(new double3(100, 0, 0));
        origin.PositionGeo = new double3(1e6, 2e6, 3);
        BakeAgain(scan, entity);
        m_world.Update();
        Assert.That(Geo(), Is.EqualTo(new double3(1e6 + 100, 2e6, 3)), "shifted once, east is Unity's X");
        Assert.That(entities.GetComponentData<StreamedPointCloud>(entity).Number, Is.EqualTo(number), "and not opened again");

        origin.enabled = false;
        BakeAgain(scan, entity);
        m_world.Update();
        Frames(() => IsStreamed(entity));
        Assert.That(Geo().x, Is.Not.EqualTo(1e6 + 100).And.Not.EqualTo(1e6));
        UnityEngine.Object.DestroyImmediate(root);
    }

    [Test]
    public void Worlds_BothDrawing_ShowCloudsInTheChosenOne()
    {
        var server = new World("server");
        World.DefaultGameObjectInjectionWorld = server;
        using var second = new World("second client");
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(second, typeof(PointCloudSystemGroup));
        Assert.That(PointCloudSystemGroup.ObjectGroup, Is.SameAs(m_group), "the default world draws nothing");
        PointCloudSystemGroup.ObjectWorld = second;
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<PointCloud>();
        cloud.Path = m_cloud;
        Assert.That(second.EntityManager.Exists(cloud.Entity), Is.True);
        Assert.That(second.EntityManager.HasComponent<PointCloudFile>(cloud.Entity), Is.True);
        Assert.That(second.GetExistingSystemManaged<PointCloudSystemGroup>().NeedsFrame, Is.True);
        PointCloudSystemGroup.ObjectWorld = server;
        Assert.That(second.GetExistingSystemManaged<PointCloudSystemGroup>().NeedsFrame, Is.False, "another is shown");
        server.Dispose();
        Assert.That(second.GetExistingSystemManaged<PointCloudSystemGroup>().NeedsFrame, Is.True, "which has ended");
        PointCloudSystemGroup.ObjectWorld = null;
        UnityEngine.Object.DestroyImmediate(scene);
    }
}
