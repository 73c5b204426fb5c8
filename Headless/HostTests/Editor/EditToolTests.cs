using System.Diagnostics;

namespace FastPoints.HostTests.Editor;

public sealed class EditToolTests : SceneToolFixture
{
    [SetUp]
    public void Listen()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(CloudEdits).TypeHandle);
        // Other tests end what listens.
        if (EditorApplication.update?.GetInvocationList().Any(d => d.Method.DeclaringType == typeof(CloudEdits)) != true)
            CloudEdits.Listen();
    }

    [TearDown]
    public void EndEdits()
    {
        for (var watch = Stopwatch.StartNew(); CloudEdits.IsBusy && watch.Elapsed.TotalSeconds < 10; Thread.Yield())
            EditorApplication.update?.Invoke();
        File.Delete(EditJournal.PathOf(m_path));
        Undo.Clear();
    }

    EditJournal Journal => EditJournal.Read(m_path, m_folder.Manifest.CloudId);

    FolderSource Shown => m_cloud.Number < 0 ? null
        : (FolderSource)m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream.Clouds[m_cloud.Number].Source;

    void WaitForEdits(int count)
    {
        var watch = Stopwatch.StartNew();
        string State() => CloudEdits.IsBusy + ", " + Journal.Count + ", " + (Shown?.Edits?.Operations.Count ?? 0);
        string wanted = "False, " + count + ", " + count;
        // This world has no systems that stream.
        using var views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1) };
        var stream = m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream;
        Frames(() =>
        {
            FrameStep.Run(stream, views);
            return State() == wanted || watch.Elapsed.TotalSeconds > 10;
        });
        Assert.That(State(), Is.EqualTo(wanted));
    }

    static SceneView NewView()
    {
        var view = ScriptableObject.CreateInstance<SceneView>();
        view.camera = new GameObject("camera").AddComponent<UnityEngine.Camera>();
        view.camera.targetTexture = new RenderTexture(new RenderTextureDescriptor(100, 100));
        view.camera.projectionMatrix = Matrix4x4.Perspective(60, 1, 0.1f, 1000);
        return view;
    }

    static void Send(EditTool tool, SceneView view, Event sent)
    {
        // Unity's numbers of controls are the same from event to event.
        int before = GUIUtility.LastControl;
        GUILayoutUtility.Send(new Event { type = EventType.Layout }, () => tool.OnToolGUI(view));
        GUIUtility.LastControl = before;
        HandleUtility.nearestControl = GUIUtility.LastControl + 1;
        GUILayoutUtility.Send(sent, () => tool.OnToolGUI(view));
        GUIUtility.LastControl = before;
    }

    static void Press(EditTool tool, SceneView view, string button)
    {
        int before = GUIUtility.LastControl;
        GUILayout.Pressed = button;
        GUILayoutUtility.Send(new Event { type = EventType.Layout }, () => tool.OnToolGUI(view));
        (GUILayout.Pressed, GUIUtility.LastControl) = (null, before);
    }

    [Test]
    public void EditTool_Stroke_IsOneOperationThatUndoTakesBack()
    {
        var view = NewView();
        var tool = ScriptableObject.CreateInstance<EditTool>();
        tool.Activate();
        try
        {
            StreamPick first;
            using (var picker = new ScenePicker())
                first = Find(picker, Down());
            foreach (var type in new[] { EventType.MouseDown, EventType.MouseDrag, EventType.MouseUp })
            {
                var eye = (float3)first.Point.PositionWorld + new float3(0, 1, 0);
                view.camera.transform.position = new Vector3(eye.x, eye.y, eye.z);
                HandleUtility.PointedAlong = new Ray(view.camera.transform.position + new Vector3(0, -0.1f, 0),
                    new Vector3(0, -1, 0));
                var sent = new Event { type = type };
                Send(tool, view, sent);
                Assert.That(sent.type, Is.EqualTo(EventType.Used), type.ToString());
                if (type != EventType.MouseUp)
                    Frames(() => tool.Session.Stroke.Count > 0);
                Send(tool, view, new Event { type = EventType.Repaint });
            }
            WaitForEdits(1);
            Assert.That(tool.Session.Note, Is.Null);
            Assert.That(Journal.Operations[0].Action, Is.EqualTo(EditAction.Delete));
            Assert.That(Journal.Operations[0].Balls.Count, Is.InRange(1, 2));
            Assert.That(Journal.Operations[0].PointsChanged, Is.Positive);
            using (var picker = new ScenePicker())
                Assert.That(Find(picker, Down()).Point.Position, Is.Not.EqualTo(first.Point.Position));

            Undo.PerformUndo();
            WaitForEdits(0);
            using (var picker = new ScenePicker())
                Assert.That(Find(picker, Down()).Point.Position, Is.EqualTo(first.Point.Position));
            // A redo restores the field, and says so.
            EditPositions.instance.Counts[Array.IndexOf(EditPositions.instance.Clouds, m_path)] = 1;
            Undo.undoRedoPerformed();
            WaitForEdits(1);
        }
        finally
        {
            tool.Deactivate();
            UnityEngine.Object.DestroyImmediate(view.camera.gameObject);
        }
    }

    [Test]
    public void EditTool_Lasso_DeletesWhatTheCameraSeesInIt([Values(false, true)] bool isParallel)
    {
        var view = NewView();
        if (isParallel)
            view.camera.projectionMatrix = Matrix4x4.Ortho(-200, 200, -200, 200, 0.1f, 1000);
        var tool = ScriptableObject.CreateInstance<EditTool>();
        tool.Activate();
        try
        {
            Press(tool, view, "Lasso");
            Selection.activeObject = m_scene;
            var center = (float3)WorldOf(m_folder.Manifest.BoundsGeo.Center);
            view.camera.transform.position = new Vector3(center.x, center.y + 100, center.z);
            foreach (bool isDropped in new[] { true, false })
            {
                var type = EventType.MouseDown;
                foreach (var (x, z) in new[] { (-20f, -20f), (20f, -20f), (20f, 20f), (-20f, 20f) })
                {
                    var to = new Vector3(isParallel ? 0 : x / 100, -1, isParallel ? 0 : z / 100);
                    var from = view.camera.transform.position + (isParallel ? new Vector3(x, 0, z) : to * 0.1f);
                    HandleUtility.PointedAlong = new Ray(from, to);
                    Send(tool, view, new Event { type = type });
                    type = EventType.MouseDrag;
                }
                Send(tool, view, new Event { type = EventType.Repaint });
                Assert.That(tool.Session.Lasso.Count, Is.EqualTo(4));
                if (isDropped)
                    Send(tool, view, new Event { type = EventType.KeyDown, keyCode = KeyCode.Escape });
                Send(tool, view, new Event { type = EventType.MouseUp });
                Assert.That((tool.Session.Lasso.Count, CloudEdits.IsBusy), Is.EqualTo((0, !isDropped)), tool.Session.Note);
            }
            WaitForEdits(1);
            var operation = Journal.Operations[0];
            Assert.That((operation.Rings.Count, operation.Prism.IsPyramid), Is.EqualTo((1, !isParallel)));
            Assert.That(operation.PointsChanged, Is.InRange(100, 19_000));
            var above = (double3)center + new double3(0, 100, 0);
            using var picker = new ScenePicker();
            Assert.That(Find(picker, PointQuery.Ray(above, new double3(0, -1, 0), 10)).Point, Is.Null);
            Assert.That(Find(picker, PointQuery.Ray(above, new double3(0, -1, 0), 60)).Point, Is.Not.Null);
        }
        finally
        {
            Selection.activeObject = null;
            tool.Deactivate();
            UnityEngine.Object.DestroyImmediate(view.camera.gameObject);
        }
    }

    [Test]
    public void EditSession_Box_ChangesWhatLiesInItHoweverTheCloudIsTurned()
    {
        Assert.That(m_cloud.TryGetLocalBounds(out var bounds), Is.True);
        using var session = new EditSession { Action = EditAction.Classify, Class = 17 };
        // The half of it that Unity's x says.
        var half = new Bounds(bounds.center + new Vector3(bounds.size.x / 4, 0, 0),
            new Vector3(bounds.size.x / 2, bounds.size.y * 2, bounds.size.z * 2));
        session.ApplyBox(m_cloud, half);
        Assert.That(session.Note, Is.Null);
        WaitForEdits(1);
        var operation = Journal.Operations[0];
        Assert.That(operation.Value, Is.EqualTo(new byte[] { 17 }));
        Assert.That(operation.PointsChanged, Is.InRange(4_000, 16_000));
        var box = operation.Boxes[0];
        var grid = m_folder.Manifest.Grid;
        Assert.That(m_cloud.TryGetSpace(out var space), Is.True);
        foreach (var corner in new[] { box.A, box.B })
        {
            var local = space.FromGeo(grid.ToGeo(corner));
            Assert.That(math.abs(local.x - half.center.x), Is.EqualTo(half.size.x / 2).Within(0.05));
        }
    }

    [Test]
    public void EditSession_CloudThatIsNotShown_SaysSo()
    {
        using var session = new EditSession();
        m_cloud.enabled = false;
        session.ApplyBox(m_cloud, new Bounds(default, new Vector3(1, 1, 1)));
        Assert.That(session.Note, Does.Contain("not shown"));
        Assert.That(CloudEdits.IsBusy, Is.False);
        m_cloud.enabled = true;
    }
}
