using PointCloud = FastPoints.Entities.PointCloud;

namespace FastPoints.HostTests.SceneTools;

public sealed class MeasureTests : SceneToolFixture
{
    [Test]
    public void ScenePicker_RotatedAndScaledCloud_ReportsCoordinatesOfTheFile()
    {
        using var picker = new ScenePicker();
        var ray = Down();
        var pick = Find(picker, ray);
        Assert.That(pick.Failure, Is.Null);
        Assert.That(m_folder.Manifest.BoundsGeo.Contains(pick.Point.PositionGeo), Is.True);
        Assert.That(math.distance(WorldOf(pick.Point.PositionGeo), pick.Point.PositionWorld), Is.LessThan(1e-6));
        Assert.That(math.distance(ray.OriginWorld + pick.Point.Distance * ray.DirectionWorld, pick.Point.PositionWorld),
            Is.LessThan(ray.RadiusAt(pick.Point.Distance)));
        Assert.That(picker.EntityOf(pick.Cloud), Is.EqualTo(m_cloud.Entity));
        Assert.That(pick.Path, Is.EqualTo(m_path));
        Assert.That(pick.IsPreview, Is.False);
    }

    [Test]
    public void ScenePicker_OverriddenUnitAndUpAxis_ApplyToTheDistance()
    {
        using var picker = new ScenePicker();
        StreamPick from = Find(picker, Down()), to = Find(picker, Down(5));
        var asIs = new Measurement(from, to);
        Assert.That((from.Up, from.Units), Is.EqualTo((UpAxis.Z, m_folder.Manifest.Crs.Units)));
        Assert.That(asIs.HorizontalGeo, Is.EqualTo(math.length(asIs.DeltaGeo.xy)));
        var file = m_world.EntityManager.GetComponentData<PointCloudFile>(m_cloud.Entity);
        (file.Up, file.MetresPerUnitOverride) = (UpAxis.X, 0.25);
        m_world.EntityManager.SetComponentData(m_cloud.Entity, file);

        bool IsShown() => m_world.EntityManager.HasComponent<StreamedPointCloud>(m_cloud.Entity);
        m_world.Update();
        Assert.That(IsShown(), Is.False, "it is opened again");
        Frames(IsShown);
        var bounds = m_folder.Manifest.BoundsGeo;
        from = Find(picker, PointQuery.FromEye(WorldOf(new double3(bounds.Max.x + 10, bounds.Center.y, bounds.Center.z)),
            new double3(0, -1, 0), 100, 100));

        var set = new Measurement(from, to);
        Assert.That((from.Up, from.Units), Is.EqualTo((UpAxis.X, new CloudUnits(0.25))));
        Assert.That(set.HorizontalGeo, Is.EqualTo(math.length(set.DeltaGeo.yz)).And.GreaterThan(0));
        Assert.That(set.LengthMetres, Is.EqualTo(set.LengthGeo * 0.25));
    }

    [Test]
    public void ScenePicker_ClippedAndHiddenPoints_AreNotHit()
    {
        using var picker = new ScenePicker();
        var first = Find(picker, Down()).Point;
        var stream = m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream;
        stream.ClipBoxes.Add(new ClipBox(first.PositionWorld - 0.5, first.PositionWorld + 0.5, true));
        var second = Find(picker, Down()).Point;
        Assert.That(second.Position, Is.Not.EqualTo(first.Position));
        Assert.That(second.Distance, Is.GreaterThan(first.Distance));
        stream.ClipBoxes.Clear();
        Assert.That(Find(picker, Down()).Point.Position, Is.EqualTo(first.Position));

        var ray = Down();
        m_cloud.HiddenClasses = Enumerable.Range(0, 256).ToArray();
        Frames(() => m_world.EntityManager.HasComponent<StreamedPointCloud>(m_cloud.Entity));
        Assert.That(Find(picker, ray).Point, Is.Null);
    }

    [Test]
    public void ScenePicker_CloudMaskedForTheCamera_IsNotFound()
    {
        using var picker = new ScenePicker();
        Assert.That(Find(picker, Down()).Point, Is.Not.Null);
        var ray = Down();
        ray.Mask.HiddenLayers = 1u << m_cloud.gameObject.layer;
        Assert.That(Find(picker, ray).Point, Is.Null);
    }

    [Test]
    public void ScenePicker_NoWorldOrNoCloud_FindsNothing()
    {
        using var picker = new ScenePicker();
        var ray = Down();
        m_cloud.enabled = false;
        var stream = m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream;
        Frames(() => stream.Clouds.All(c => c == null || c.IsRemoving));
        Assert.That(Find(picker, ray).Point, Is.Null);
        m_world.Dispose();
        Assert.That(picker.Begin(ray), Is.False);
    }

    /// <summary>Looks straight down on a point of the cloud, 20 units above it, through the middle of 100 x 100 pixels.</summary>
    UnityEngine.Camera CameraAbove(double east = 0)
    {
        float3 point;
        using (var picker = new ScenePicker())
            point = (float3)Find(picker, Down(east)).Point.PositionWorld;
        var camera = new GameObject("camera").AddComponent<UnityEngine.Camera>();
        camera.cameraType = CameraType.SceneView;
        camera.targetTexture = new RenderTexture(new RenderTextureDescriptor(100, 100));
        camera.projectionMatrix = Matrix4x4.Perspective(60, 1, 0.1f, 1000);
        camera.transform.position = new Vector3(point.x, point.y + 20, point.z);
        var view = Matrix4x4.zero;
        view.SetRow(0, new Vector4(1, 0, 0, -point.x));
        view.SetRow(1, new Vector4(0, 0, -1, point.z));
        view.SetRow(2, new Vector4(0, 1, 0, -point.y - 20));
        view.SetRow(3, new Vector4(0, 0, 0, 1));
        camera.worldToCameraMatrix = view;
        return camera;
    }

    [Test]
    public void Click_InTheSceneView_SelectsTheCloudThatCanBePicked()
    {
        ScenePicking.MaxMs = double.PositiveInfinity;
        var camera = CameraAbove();
        var middle = new Vector2(50, 50);
        var cloud = m_cloud.gameObject;
        bool Hits() => HandleUtility.Click(camera, middle).Contains(cloud);
        try
        {
            Assert.That(HandleUtility.Click(camera, middle), Is.EqualTo(new[] { cloud }));
            var view = camera.worldToCameraMatrix;
            view.m03 += 5000;
            var there = camera.worldToCameraMatrix;
            camera.worldToCameraMatrix = view;
            camera.transform.position -= new Vector3(5000, 0, 0);
            Assert.That(Hits(), Is.False, "beside all points");
            camera.worldToCameraMatrix = there;
            camera.transform.position += new Vector3(5000, 0, 0);

            SceneVisibilityManager.instance.Unpickable.Add(cloud);
            Assert.That(Hits(), Is.False, "the pick icon");
            SceneVisibilityManager.instance.Unpickable.Clear();
            Tools.lockedLayers = 1 << cloud.layer;
            Assert.That(Hits(), Is.False, "a locked layer");
            Tools.lockedLayers = 0;
            camera.cullingMask = ~(1 << cloud.layer);
            Assert.That(Hits(), Is.False, "a layer that is not drawn");
            camera.cullingMask = -1;
            StageUtility.Focused = new UnityEngine.SceneManagement.Scene { Number = 7 };
            Assert.That(Hits(), Is.False, "another prefab is open");
            StageUtility.Focused = default;
            ScenePicking.MaxMs = 0;
            Assert.That(() => Hits(), Throws.Nothing, "no time at all");
            ScenePicking.MaxMs = double.PositiveInfinity;
            Assert.That(Hits(), Is.True);
            EditorApplication.CallDelayed();
            m_cloud.HiddenClasses = Enumerable.Range(0, 256).ToArray();
            Frames(() => m_world.EntityManager.HasComponent<StreamedPointCloud>(m_cloud.Entity));
            Assert.That(Hits(), Is.False, "points that are not shown");
        }
        finally
        {
            ScenePicking.MaxMs = 100;
            EditorApplication.CallDelayed();
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
        }
    }

    [TestCase(EventType.DragUpdated)]
    [TestCase(EventType.DragPerform)]
    public void Drag_OverTheSceneView_PicksNoPoints(EventType type)
    {
        ScenePicking.MaxMs = double.PositiveInfinity;
        var camera = CameraAbove();
        try
        {
            Event.current = new Event { type = type };
            Assert.That(HandleUtility.Click(camera, new Vector2(50, 50)), Is.Empty);
            Event.current = new Event { type = EventType.MouseDown };
            Assert.That(HandleUtility.Click(camera, new Vector2(50, 50)), Is.Not.Empty);
        }
        finally
        {
            (ScenePicking.MaxMs, Event.current) = (100, null);
            EditorApplication.CallDelayed();
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
        }
    }

    [Test]
    public void Click_ShownWorldIsNotTheDefaultOne_SelectsItsCloud()
    {
        ScenePicking.MaxMs = double.PositiveInfinity;
        var camera = CameraAbove();
        using var other = new World("other");
        try
        {
            (World.DefaultGameObjectInjectionWorld, PointCloudSystemGroup.ObjectWorld) = (other, m_world);
            Assert.That(HandleUtility.Click(camera, new Vector2(50, 50)), Is.EqualTo(new[] { m_scene }));
        }
        finally
        {
            (World.DefaultGameObjectInjectionWorld, PointCloudSystemGroup.ObjectWorld) = (m_world, null);
            ScenePicking.MaxMs = 100;
            EditorApplication.CallDelayed();
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
        }
    }

    [Test]
    public void Click_OnTwoClouds_GoesThroughBoth()
    {
        ScenePicking.MaxMs = double.PositiveInfinity;
        var above = new GameObject("above");
        var camera = CameraAbove();
        try
        {
            var other = above.AddComponent<PointCloud>();
            var position = m_scene.transform.localToWorldMatrix;
            position.m13 += 10;
            SceneLoop.Place(above.transform, position);
            other.Path = m_path;
            Frames(() => m_world.EntityManager.HasComponent<StreamedPointCloud>(other.Entity));
            Frames(() => true);
            Assert.That(HandleUtility.Click(camera, new Vector2(50, 50)), Is.EqualTo(new[] { above, m_scene }));
        }
        finally
        {
            ScenePicking.MaxMs = 100;
            EditorApplication.CallDelayed();
            UnityEngine.Object.DestroyImmediate(above);
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
        }
    }

    [Test]
    public void MeasureTool_TwoClicks_ReportBothPointsAndTheDistance()
    {
        var view = NewView();
        var tool = ScriptableObject.CreateInstance<MeasureTool>();
        tool.Activate();
        void Send(Event sent) => SceneToolFixture.Send(tool, view, sent);
        void Click(double east)
        {
            float3 eye;
            using (var picker = new ScenePicker())
                eye = (float3)Find(picker, Down(east)).Point.PositionWorld + new float3(0, 1, 0);
            view.camera.transform.position = new Vector3(eye.x, eye.y, eye.z);
            var down = new Vector3(0, -1, 0);
            HandleUtility.PointedAlong = new Ray(view.camera.transform.position + down * 0.1f, down);
            var press = new Event { type = EventType.MouseDown };
            Send(press);
            Assert.That(press.type, Is.EqualTo(EventType.Used));
            int count = tool.Session.Picks.Count;
            Frames(() => tool.Session.Picks.Count > count);
            Send(new Event { type = EventType.Repaint });
        }
        try
        {
            Click(0);
            Assert.That(tool.Session.Lines[0], Is.EqualTo("From"));
            Assert.That(tool.Session.Text, Does.Contain("Intensity"));
            Click(60);
            var measured = new FastPoints.Queries.Measurement(tool.Session.Picks[0], tool.Session.Picks[1]);
            Assert.That(measured.DeltaGeo.x, Is.EqualTo(60).Within(40));
            Assert.That(measured.WorldLength, Is.EqualTo(2 * measured.LengthGeo).Within(1e-5), "the scene is twice as large");
            Assert.That(tool.Session.Lines[0], Does.StartWith("Distance  "));
            Assert.That(tool.Session.Lines, Has.Some.StartsWith("dx, dy, dz  "));
            AssertMarksGoWithTheCloud(tool.Session);

            var right = new Event { type = EventType.MouseDown, button = 1 };
            Send(right);
            Assert.That(right.type, Is.EqualTo(EventType.MouseDown), "the camera's own");
            Send(new Event { type = EventType.KeyDown, keyCode = KeyCode.Escape });
            Assert.That(tool.Session.Lines, Is.Empty);
        }
        finally
        {
            tool.Deactivate();
            UnityEngine.Object.DestroyImmediate(view.camera.gameObject);
        }
        var updated = EditorApplication.update?.GetInvocationList().Select(d => d.Target) ?? new object[0];
        Assert.That(updated, Has.None.SameAs(tool));
    }

    /// <summary>Unity tells the active tool before scripts are reloaded: a search of pool threads must not outlive
    /// them.</summary>
    [Test]
    public void MeasureTool_ScriptReload_ReportsOnceAndStartsOver()
    {
        var tool = ScriptableObject.CreateInstance<MeasureTool>();
        tool.Activate();
        var session = tool.Session;
        session.Begin(Down());

        AssemblyReloadEvents.Reload();

        Assert.That(tool.Session, Is.Null);
        Assert.That(tool.IsActive, Is.False);
        tool.Activate();
        Assert.That(tool.Session, Is.Not.Null.And.Not.SameAs(session));
        tool.Deactivate();
        Assert.That(AssemblyReloadEvents.IsHeardBy(tool), Is.False);
    }

    void AssertMarksGoWithTheCloud(MeasureSession session)
    {
        var picked = session.Picks[1].Point.PositionWorld;
        Assert.That(math.distance(session.PositionOf(1), picked), Is.LessThan(1e-6));
        var moved = m_scene.transform.localToWorldMatrix;
        moved.m13 += 7;
        SceneLoop.Place(m_scene.transform, moved);
        Frames(() => true);
        Assert.That(math.distance(session.PositionOf(1), picked + new double3(0, 7, 0)), Is.LessThan(1e-6));

        m_cloud.Reopen();
        Frames(() => m_world.EntityManager.HasComponent<StreamedPointCloud>(m_cloud.Entity));
        Frames(() => true);
        Assert.That(math.distance(session.PositionOf(1), picked + new double3(0, 7, 0)), Is.LessThan(1e-6), "opened anew");
        m_cloud.enabled = false;
        var stream = m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream;
        Frames(() => stream.Clouds.All(c => c == null || c.IsRemoving));
        Assert.That(session.PositionOf(1), Is.EqualTo(picked), "nobody knows any more");
        m_cloud.enabled = true;
        Frames(() => m_world.EntityManager.HasComponent<StreamedPointCloud>(m_cloud.Entity));
    }

    [TestCase(0.001, "690052.801, 5330006.106, 528.000")]
    [TestCase(0.01, "690052.80, 5330006.11, 528.00")]
    [TestCase(1, "690053, 5330006, 528")]
    [TestCase(0.0078125, "690052.8010000, 5330006.1060000, 528.0000000")]
    public void Coordinates_OfAGrid_HaveTheDecimalsOfItsSteps(double step, string wanted) => Assert.That(
        PickText.Coordinates(new double3(690052.801, 5330006.106, 528), new double3(step, step, step)), Is.EqualTo(wanted));

    [Test]
    public void PickQueryOf_Cameras_HaveTheWidthOfPixels()
    {
        var camera = new GameObject("camera").AddComponent<UnityEngine.Camera>();
        camera.targetTexture = new RenderTexture(new RenderTextureDescriptor(200, 100));
        camera.projectionMatrix = Matrix4x4.Perspective(90, 2, 0.5f, 1000);
        var ray = CameraViews.PickQueryOf(camera, new Ray(new Vector3(0, 0, 0.5f), new Vector3(0, 0, 1)), 5);
        Assert.That(ray.RadiusAt(10), Is.EqualTo(5.0 / 50 * 10).Within(1e-6), "50 pixels are 10 units there");
        Assert.That(ray.From, Is.EqualTo(0.5).Within(1e-6));
        camera.projectionMatrix = Matrix4x4.Ortho(-20, 20, -10, 10, 0.5f, 1000);
        var parallel = CameraViews.PickQueryOf(camera, new Ray(new Vector3(3, 4, 0.5f), new Vector3(0, 0, 1)), 5);
        Assert.That(parallel.RadiusAt(10), Is.EqualTo(1).Within(1e-6));
        Assert.That(parallel.OriginWorld, Is.EqualTo(new double3(3, 4, 0.5)));
        UnityEngine.Object.DestroyImmediate(camera.gameObject);
    }
}
