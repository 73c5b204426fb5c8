using PointCloud = FastPoints.Entities.PointCloud;

namespace FastPoints.HostTests.Editor;

public sealed class OriginTests : EditorFixture
{
    World m_world;

    [SetUp]
    public void MakeWorld()
    {
        m_world = World.DefaultGameObjectInjectionWorld = new World("default");
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(PointCloudSystemGroup),
            typeof(OpenCloudsSystem), typeof(PlaceCloudsSystem), typeof(AddCloudsSystem));
        m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Begin(new MemoryNodePool(1 << 24, 1 << 20));
    }

    [TearDown]
    public void ClearScene()
    {
        SceneLoop.Clear();
        m_world.Dispose();
    }

    void Update()
    {
        SceneLoop.Update();
        m_world.Update();
    }

    static PointCloudOrigin Origin() => new GameObject("origin").AddComponent<PointCloudOrigin>();

    PointCloud Shown(string name, PointCloudOrigin origin, string crs = null)
    {
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo(name + ".las", 3000), "Assets");
        m_project.UpdateToTheEnd();
        if (crs != null)
        {
            var other = ScriptableObject.CreateInstance<PointCloudAsset>();
            SerializedFields.Copy(asset, other);
            (asset, other.name, other.Crs) = (other, name, crs);
        }
        var cloud = PointCloudDrops.AddToScene(asset, null, origin?.transform);
        ImportProject.Updates(Update, () => m_world.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity));
        return cloud;
    }

    CloudPlacement PlacementOf(Entity cloud) => m_world.EntityManager.GetComponentData<PointCloudPlacement>(cloud).Value;

    double3 WorldOf(PointCloud cloud, double3 geo)
    {
        int number = m_world.EntityManager.GetComponentData<StreamedPointCloud>(cloud.Entity).Number;
        var source = m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream.Clouds[number].Source;
        var placement = PlacementOf(cloud.Entity);
        return placement.OriginWorld + math.mul(placement.Linear, geo - source.Grid.ToGeo(source.Root.Corner));
    }

    [Test]
    public void Clouds_UnderAnOrigin_AreGeoreferencedByItUntilTheyLeave()
    {
        var origin = Origin();
        var cloud = Shown("a", origin);
        var own = cloud.Cloud.Origin;
        Update();
        Assert.That(origin.HasPosition, Is.True, "the first beneath it decides");
        Assert.That(origin.PositionGeo, Is.EqualTo(own));
        Assert.That(origin.Crs, Is.EqualTo(cloud.Cloud.Crs));

        // Far away, in steps that float does not have.
        origin.PositionGeo = own + new double3(1_000_000.001, -2_000_000.002, 0.003);
        m_world.Update();
        var at = WorldOf(cloud, origin.PositionGeo);
        Assert.That(math.length(at), Is.LessThan(1e-8), "its place lies at the GameObject");
        Assert.That(WorldOf(cloud, own).x, Is.EqualTo(-1_000_000.001).Within(1e-8));

        origin.enabled = false;
        Update();
        ImportProject.Updates(Update, () => m_world.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity));
        Assert.That(math.length(WorldOf(cloud, own)), Is.LessThan(1e-8), "it lies at its own again");
    }

    [Test]
    public void Update_OriginTakenFromACloud_IsStoredOnceInEditMode()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(SceneVisibility).TypeHandle);
        var origin = Origin();
        int[] Kept()
        {
            Update();
            Update();
            var kept = new[] { EditorUtility.s_dirty, PrefabUtility.s_recorded };
            int[] counts = Array.ConvertAll(kept, k => k.Count(o => o == origin));
            Array.ForEach(kept, k => k.Clear());
            return counts;
        }
        var cloud = Shown("a", origin);
        Assert.That(Kept(), Is.EqualTo(new[] { 1, 1 }));
        Assert.That(origin.HasPosition, Is.True);
        Assert.That(Kept(), Is.EqualTo(new[] { 0, 0 }), "nothing is decided any more");

        Object.DestroyImmediate(origin.gameObject);
        origin = Origin();
        origin.PositionGeo = cloud.Cloud.Origin;
        Shown("b", origin, "EPSG:25832 ETRS89 / UTM zone 32N");
        Assert.That(Kept(), Is.EqualTo(new[] { 1, 1 }), "a coordinate system alone");
        Assert.That(origin.Crs, Does.StartWith("EPSG:25832"));

        EditorApplication.isPlaying = true;
        try
        {
            origin = Origin();
            Shown("c", origin);
            Assert.That(Kept(), Is.EqualTo(new[] { 0, 0 }), "play mode's end takes it back");
            Assert.That(origin.HasPosition, Is.True);
        }
        finally
        {
            EditorApplication.isPlaying = false;
        }
    }

    /// <summary>Each frame of a long flight: what lies at the camera stays there to 1e-6, though it is 1,000 km off.</summary>
    [Test]
    public void Shift_Repeated_NeitherJumpsNorDrifts()
    {
        var origin = Origin();
        var cloud = Shown("a", origin);
        Update();
        // Turned about the vertical by 3-4-5.
        var turned = Matrix4x4.identity;
        (turned.m00, turned.m02, turned.m20, turned.m22) = (0.6f, 0.8f, -0.8f, 0.6f);
        SceneLoop.Place(origin.transform, turned);
        SceneLoop.Place(cloud.transform, turned);
        Update();
        var seen = cloud.Cloud.Origin + new double3(3, 4, 5);
        var before = WorldOf(cloud, seen);
        var by = new double3(1234.567, 8.9, -4321.012);
        for (int i = 1; i <= 200; i++)
        {
            origin.Shift(by);
            // Before the components' own updates: who drew now would see it moved.
            m_world.Update();
            Assert.That(math.length(WorldOf(cloud, seen) - (before - by * i)), Is.LessThan(1e-6), i.ToString());
        }
    }

    [Test]
    public void Shift_EntityClouds_MovesOpenAndUnopenedOnes()
    {
        string folder = m_project.Scratch["far.fastpoints"];
        Assert.That(CliCall.Of("convert", m_project.Scratch.Demo(points: 3000), "-o", folder, "--quiet").Status, Is.Zero);
        var entities = m_world.EntityManager;
        Entity Add()
        {
            var made = entities.CreateEntity();
            entities.AddComponentData(made, new Unity.Transforms.LocalToWorld { Value = float4x4.identity });
            entities.AddComponentData(made, new PointCloudFile());
            new PointCloudPaths { Path = folder }.WriteTo(entities.AddBuffer<PointCloudPathByte>(made));
            return made;
        }
        var open = Add();
        var shown = Shown("a", null);
        ImportProject.Updates(Update, () => entities.HasComponent<StreamedPointCloud>(open));
        var (before, kept) = (PlacementOf(open).OriginWorld, PlacementOf(shown.Entity).OriginWorld);
        var late = Add();
        var by = new double3(100_000.25, 0, 3);

        PointCloudOrigin.ShiftEntities(by);
        ImportProject.Updates(Update, () => entities.HasComponent<StreamedPointCloud>(late));

        Assert.That(math.length(PlacementOf(open).OriginWorld - (before - by)), Is.LessThan(1e-8));
        Assert.That(math.length(PlacementOf(late).OriginWorld - (before - by)), Is.LessThan(1e-8));
        Assert.That(PlacementOf(shown.Entity).OriginWorld, Is.EqualTo(kept), "a GameObject's is moved by its origin");

        var copy = entities.Instantiate(shown.Entity);
        ImportProject.Updates(Update, () => entities.HasComponent<StreamedPointCloud>(copy));
        Assert.That(math.length(PlacementOf(copy).OriginWorld - (kept - by)), Is.LessThan(1e-8), "a copy is no GameObject's");

        var later = Add();
        ImportProject.Updates(Update, () => entities.HasComponent<StreamedPointCloud>(later));
        Assert.That(math.length(PlacementOf(later).OriginWorld - (before - by)), Is.LessThan(1e-8), "it lies among the others");
        PointCloudOrigin.ShiftEntities(by);
        m_world.Update();
        foreach (var each in new[] { open, late, later })
            Assert.That(math.length(PlacementOf(each).OriginWorld - (before - 2 * by)), Is.LessThan(1e-8));
    }

    [Test]
    public void Compare_CloudOfAnotherCrs_WarnsOnceWithBothNames()
    {
        var origin = Origin();
        Shown("a", origin, "EPSG:25832 ETRS89 / UTM zone 32N");
        Shown("b", origin, "EPSG:25832 ETRS89 / UTM zone 32N");
        Update();
        Assert.That(m_logged, Is.Empty);
        Shown("c", origin, "EPSG:2056 CH1903+ / LV95");
        Update();
        Assert.That(m_logged.Single(), Does.StartWith("Warning: FastPoints: c is in EPSG:2056 CH1903+ / LV95")
            .And.Contains("origin in EPSG:25832 ETRS89 / UTM zone 32N"));
    }

    [Test]
    public void Convert_CloudUnderAnOrigin_KeepsItsOwnOrigin()
    {
        var origin = Origin();
        origin.PositionGeo = new double3(1e6, 1e6, 0);
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 3000), "Assets");
        var cloud = PointCloudDrops.AddToScene(asset, null, origin.transform);
        ImportProject.Updates(Update, () => cloud.TryGetSpace(out var space) && space.OriginGeo.x == 1e6);
        m_project.UpdateToTheEnd();
        Assert.That(asset.Origin.x, Is.InRange(asset.BoundsMin.x, asset.BoundsMax.x));
    }

    [Test]
    public void Undo_OfAPosition_MovesTheCloudsBack()
    {
        var origin = Origin();
        var cloud = Shown("a", origin);
        Update();
        var (position, before) = (origin.PositionGeo, PlacementOf(cloud.Entity).OriginWorld);
        Undo.IncrementCurrentGroup();
        Undo.RecordObject(origin, "Set origin");
        origin.Shift(new double3(5, 0, 0));
        m_world.Update();
        Assert.That(PlacementOf(cloud.Entity).OriginWorld.x, Is.EqualTo(before.x - 5).Within(1e-9));
        Undo.PerformUndo();
        Assert.That(origin.PositionGeo, Is.EqualTo(position));
        Update();
        Assert.That(PlacementOf(cloud.Entity).OriginWorld, Is.EqualTo(before));
    }

    [Test]
    public void Inspector_Buttons_MoveTheOriginAndUndoMovesItBack()
    {
        var origin = Origin();
        var cloud = Shown("a", origin);
        Update();
        var position = origin.PositionGeo;
        var editor = UnityEditor.Editor.Of<PointCloudOriginEditor>(origin);
        editor.Draw();
        SceneView.lastActiveSceneView = new SceneView { pivot = new Vector3(7, 0, 0) };
        GUILayoutUtility.Send(new Event { type = EventType.Layout }, editor.OnInspectorGUI);
        GUILayout.Pressed = "Set origin here";
        GUILayoutUtility.Send(new Event { type = EventType.MouseUp }, editor.OnInspectorGUI);
        (GUILayout.Pressed, Event.current, SceneView.lastActiveSceneView) = (null, null, null);
        Assert.That(origin.PositionGeo.x, Is.EqualTo(position.x + 7).Within(1e-9), "east is Unity's X");
        m_world.Update();
        Assert.That(WorldOf(cloud, origin.PositionGeo).x, Is.Zero.Within(1e-8));
        Undo.PerformUndo();
        Assert.That(origin.PositionGeo, Is.EqualTo(position));
        Object.DestroyImmediate(editor);
    }

    [Test]
    public void Inspector_TypedPosition_IsSetAndTypedCrsAloneIsNot()
    {
        var origin = Origin();
        var editor = UnityEditor.Editor.Of<PointCloudOriginEditor>(origin);
        void Type(string field, object value)
        {
            SerializedObject.s_typed = o => SerializedFields.Of(o.GetType()).Single(f => f.Name == field).SetValue(o, value);
            editor.Draw();
            SerializedObject.s_typed = null;
        }
        Type("m_crs", "EPSG:25832");
        Assert.That(origin.HasPosition, Is.False);
        Type("m_place", new double3(7, 8, 9));
        Assert.That((origin.HasPosition, origin.PositionGeo), Is.EqualTo((true, new double3(7, 8, 9))));
        Undo.PerformUndo();
        Assert.That(origin.HasPosition, Is.False, "a prefab's instance keeps what Undo has recorded");
        Object.DestroyImmediate(editor);
    }

    [Test]
    public void AlignTo_CloudKnownByPathOnly_MovesToTheMiddleOfItsFloor()
    {
        var origin = Origin();
        origin.PositionGeo = new double3(1, 2, 3);
        var made = new GameObject("path");
        var cloud = made.AddComponent<PointCloud>();
        Assert.That(origin.AlignTo(cloud), Is.False, "nobody knows where it lies");
        var known = Shown("a", null);
        cloud.Path = m_project.Paths.Absolute(known.Cloud.ProjectPath);
        ImportProject.Updates(Update, () => cloud.TryGetSpace(out _) && cloud.TryGetLocalBounds(out _));
        Assert.That(origin.AlignTo(cloud), Is.True);
        Assert.That(math.length(origin.PositionGeo - known.Cloud.Origin), Is.LessThan(2));
    }
}
