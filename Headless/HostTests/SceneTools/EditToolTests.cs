namespace FastPoints.HostTests.SceneTools;

public sealed class EditToolTests : SceneToolFixture
{
    [SetUp]
    public void Listen()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(EditQueue).TypeHandle);
        // Other tests end what listens.
        if (EditorApplication.update?.GetInvocationList().Any(d => d.Method.DeclaringType == typeof(EditQueue)) != true)
            EditQueue.Listen();
    }

    [TearDown]
    public void EndEdits()
    {
        for (var watch = Stopwatch.StartNew(); EditQueue.IsBusy && watch.Elapsed.TotalSeconds < 10; Thread.Yield())
            EditorApplication.update?.Invoke();
        File.Delete(EditJournal.PathOf(m_path));
        Undo.Clear();
    }

    EditJournal Journal => EditJournal.Read(m_path, m_folder.Manifest.CloudId);

    FolderSource Shown => m_cloud.Number < 0 ? null
        : (FolderSource)m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream.Clouds[m_cloud.Number].Source;

    void WaitForEdits(int count, Func<bool> also = null)
    {
        var watch = Stopwatch.StartNew();
        string State() => EditQueue.IsBusy + ", " + Journal.Count + ", " +
            (Shown?.Edits?.Operations.Count(o => o.PointsChanged > 0) ?? 0);
        string wanted = "False, " + count + ", " + count;
        // This world has no systems that stream.
        using var views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1) };
        var stream = m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream;
        Frames(() =>
        {
            FrameStep.Run(stream, views);
            return State() == wanted && also?.Invoke() != false || watch.Elapsed.TotalSeconds > 10;
        });
        Assert.That((State(), also?.Invoke() != false), Is.EqualTo((wanted, true)));
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
                if (type == EventType.MouseDrag)
                    WaitForDraft(tool.Session, 128);
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
            AppliedEditCounts.instance.Counts[Array.IndexOf(AppliedEditCounts.instance.Clouds, m_path)] = 1;
            Undo.undoRedoPerformed();
            WaitForEdits(1);
        }
        finally
        {
            tool.Deactivate();
            UnityEngine.Object.DestroyImmediate(view.camera.gameObject);
        }
    }

    /// <summary>Those that are to be deleted are marked, so that the next pick does not go through them.</summary>
    void WaitForDraft(EditSession session, byte green)
    {
        WaitForEdits(0, () => (session.Update(1), Shown.Edits?.Last.Balls.Count).Item2 == session.Stroke.Count);
        Assert.That(Shown.Edits.Last.Value, Is.EqualTo(new byte[] { 255, green, 0 }));
        Assert.That(EditJournal.DraftAt(EditJournal.PathOf(m_path)), Is.SameAs(Shown.Edits.Last));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void EditSession_Stroke_IsShownAsItGrowsAndGoesWithEscapeOrWhereItCannotBeWritten(bool isEnded)
    {
        using var session = new EditSession { Action = EditAction.Color, Radius = 3 };
        Drag(session, Down());
        WaitForDraft(session, 0);
        Drag(session, Down(east: 20));
        WaitForDraft(session, 0);
        Assert.That(session.Stroke.Count, Is.EqualTo(2));
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(text);
        using (isEnded ? EditCloud.Lock(m_path) : null)
            try
            {
                if (isEnded)
                    session.EndStroke();
                else
                    session.ClearStroke();
                session.Update(10);
                WaitForEdits(0, () => Shown.Edits == null);
            }
            finally
            {
                Debug.s_sink = null;
            }
        Assert.That(EditJournal.DraftAt(EditJournal.PathOf(m_path)), Is.Null);
        Assert.That(logged, isEnded ? Has.One.Contains("is being written by") : Is.Empty);
    }

    [TestCase(false)]
    [TestCase(true)]
    public void EditSession_CloudConvertedAnewDuringAStroke_WritesAndShowsNothing(bool isShown)
    {
        using var session = new EditSession { Radius = 3 };
        var manifest = Shown.Folder.Manifest;
        manifest.CloudId ^= 1;
        Drag(session, Down());
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(text);
        try
        {
            // The stroke is of what was there before; what is shown may not know yet.
            if (isShown)
                manifest.CloudId ^= 1;
            session.EndStroke();
            session.Update(10);
            if (!isShown)
                manifest.CloudId ^= 1;
            WaitForEdits(0, () => Shown.Edits == null);
        }
        finally
        {
            Debug.s_sink = null;
        }
        Assert.That(isShown ? session.Note : logged.Single(), Does.Contain("another conversion"));
        Assert.That(EditJournal.DraftAt(EditJournal.PathOf(m_path)), Is.Null);
    }

    /// <summary>Classes are not drawn here: nothing is made to show them. Notes of picks stay.</summary>
    [Test]
    public void EditSession_StrokeOfWhatIsNotDrawn_HasNoDraft()
    {
        using var session = new EditSession { Action = EditAction.Classify, Class = 17, Radius = 3 };
        Drag(session, Down());
        session.Update(10);
        Assert.That(EditJournal.DraftAt(EditJournal.PathOf(m_path)), Is.Null);
    }

    [Test]
    public void EditModeFrames_Draft_AsksForAFrame()
    {
        var group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
        Frames(() => !group.NeedsFrame);
        EditModeFrames.Update();
        EditorApplication.TakeUpdate();
        EditModeFrames.Update();
        Assert.That(EditorApplication.TakeUpdate(), Is.False);
        EditJournal.SetDraft(EditJournal.PathOf(m_path), new EditOperation());
        EditModeFrames.Update();
        EditJournal.SetDraft(null, null);
        Assert.That(EditorApplication.TakeUpdate(), Is.True);
    }

    void Drag(EditSession session, PointQuery ray)
    {
        int before = session.Stroke.Count;
        session.Drag(ray);
        Frames(() =>
        {
            session.Update(10);
            return session.Stroke.Count > before;
        });
    }

    [Test]
    public void EditTool_Lasso_DeletesWhatTheCameraSeesInIt([Values(false, true)] bool isParallel)
    {
        var view = NewView();
        if (isParallel)
            view.camera.projectionMatrix = Matrix4x4.Ortho(-200, 200, -200, 200, 0.1f, 1000);
        var tool = ScriptableObject.CreateInstance<EditTool>();
        tool.Activate();
        Selection.activeObject = m_scene;
        var above = WorldOf(m_folder.Manifest.BoundsGeo.Center) + new double3(0, 100, 0);
        var eye = new Vector3((float)above.x, (float)above.y, (float)above.z);
        view.camera.transform.position = eye;
        try
        {
            GUILayout.Pressed = "Lasso";
            GUILayoutUtility.Send(new Event { type = EventType.Layout }, () => tool.OnToolGUI(view));
            (GUILayout.Pressed, GUIUtility.LastControl) = (null, 0);
            foreach (var end in new[] { EventType.KeyDown, EventType.MouseUp })
            {
                var type = EventType.MouseDown;
                foreach (var (x, z) in new[] { (-20f, -20f), (20f, -20f), (20f, 20f), (-20f, 20f) })
                {
                    HandleUtility.PointedAlong = isParallel ? new Ray(eye + new Vector3(x, 0, z), new Vector3(0, -1, 0))
                        : new Ray(eye + new Vector3(x / 1000, -0.1f, z / 1000), new Vector3(x / 100, -1, z / 100));
                    Send(tool, view, new Event { type = type });
                    type = EventType.MouseDrag;
                }
                Send(tool, view, new Event { type = EventType.Repaint });
                Assert.That(tool.Session.Lasso.Count, Is.EqualTo(4));
                Send(tool, view, new Event { type = end, keyCode = KeyCode.Escape });
                Assert.That((tool.Session.Lasso.Count, EditQueue.IsBusy), Is.EqualTo((0, end == EventType.MouseUp)));
            }
            WaitForEdits(1);
            Assert.That(Journal.Operations[0].Prism.IsPyramid, Is.EqualTo(!isParallel));
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
        Assert.That(EditQueue.IsBusy, Is.False);
        m_cloud.enabled = true;
    }
}
