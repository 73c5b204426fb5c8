namespace FastPoints.HostTests.Editor;

public sealed class CloudsWindowTests : EditorFixture
{
    CloudsWindow m_window;

    [SetUp]
    public void Open()
    {
        EditorUtility.s_dialogs.Clear();
        m_window = ScriptableObject.CreateInstance<CloudsWindow>();
    }

    [TearDown]
    public void Close()
    {
        (EditorUtility.s_agrees, EditorUtility.s_folder, GUILayout.Pressed, Event.current) = (false, "", null, null);
        UnityEngine.Object.DestroyImmediate(m_window);
    }

    void OnGui() =>
        typeof(CloudsWindow).GetMethod("OnGUI", BindingFlags.Instance | BindingFlags.NonPublic).Invoke(m_window, null);

    CloudList List() => CloudList.Collect(m_project.Paths, m_project.Imports.Assets.All,
        m_project.Imports.Queue.ReservedPaths.ToList());

    void Press(string button)
    {
        GUILayoutUtility.Send(new Event { type = EventType.Layout }, OnGui);
        GUILayout.Pressed = button;
        GUILayoutUtility.Send(new Event { type = EventType.MouseUp }, OnGui);
        GUILayout.Pressed = null;
    }

    void Collected(int unused) => ImportProject.Updates(() => GUILayoutUtility.Repaint(OnGui), () =>
        (typeof(CloudsWindow).GetField("m_list", BindingFlags.Instance | BindingFlags.NonPublic).GetValue(m_window) as CloudList)
        ?.Unused.Count == unused);

    [Test]
    public void Close_WhileCollecting_DoesNotWait()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("a.las", 1000), "Assets");
        int main = Environment.CurrentManagedThreadId;
        ManualResetEventSlim reads = new ManualResetEventSlim(), hasMore = new ManualResetEventSlim();
        bool isWaitedFor = false;
        using (WindowsRules.Hear((change, path, _) =>
        {
            if (!path.EndsWith("a.pointcloud") || Environment.CurrentManagedThreadId == main)
                return;
            reads.Set();
            isWaitedFor = !hasMore.Wait(TimeSpan.FromSeconds(20));
        }))
        {
            m_window.Collect();
            Assert.That(reads.Wait(ImportProject.MaxWait), Is.True);
            typeof(CloudsWindow).GetMethod("OnDisable", BindingFlags.Instance | BindingFlags.NonPublic).Invoke(m_window, null);
            Assert.That(isWaitedFor, Is.False);
            hasMore.Set();
        }
    }

    [Test]
    public void List_EachCloud_IsDescribed()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("a.las", 2000), "Assets");
        m_project.UpdateToTheEnd();
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("b.las", 3000), "Assets");
        m_project.Imports.CreateAsset(m_project.Copc("c.copc.laz"), "Assets");
        File.Delete(m_project.Scratch["b.las"]);

        var list = List();

        Assert.That(list.Rows.Select(r => r.Asset + ": " + r.State + ", " + r.Points),
            Is.EqualTo(new[]
            {
                "Assets/a.pointcloud: converted, 2000", "Assets/b.pointcloud: not converted, -1",
                "Assets/c.copc.pointcloud: streamed as it is, -1",
            }));
        Assert.That(list.Rows[0].Bytes, Is.EqualTo(Directory.GetFiles("PointClouds/a.fastpoints", "*",
            SearchOption.AllDirectories).Sum(f => new FileInfo(f).Length)).And.GreaterThan(2000));
        Assert.That(list.Rows.Select(r => r.MissingSource), Is.EqualTo(new[] { null, m_project.Scratch["b.las"], null }));
        Assert.That(list.Unused, Is.Empty);
        ImportProject.Updates(() => GUILayoutUtility.Repaint(OnGui), () => true);
    }

    [TestCase(true)]
    [TestCase(false)]
    public void DeleteUnused_CloudsWithoutAssets_AreDeleted(bool agrees)
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("a.las", 1000), "Assets");
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("b.las", 1000), "Assets");
        m_project.UpdateToTheEnd();
        File.Delete("Assets/b.pointcloud");
        AssetDatabase.Refresh();
        Collected(1);
        EditorUtility.s_agrees = agrees;

        Press("Delete unused");

        Assert.That(EditorUtility.s_dialogs.Single(), Does.Contain("1 converted clouds"));
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetDirectories("PointClouds").Select(Path.GetFileName),
            Is.EquivalentTo(agrees ? new[] { "a.fastpoints" } : new[] { "a.fastpoints", "b.fastpoints" }));
    }

    /// <summary>Another project may have assets of what lies there.</summary>
    [Test]
    public void Unused_OutsideTheProject_IsNotOffered()
    {
        m_project.Scratch.Converted("shared/far.fastpoints");
        var paths = new ProjectPaths(m_project.Paths.Project, m_project.Scratch["shared"]);
        Assert.That(CloudList.Collect(paths, new Dictionary<string, string>(), new string[0]).Unused, Is.Empty);
        var inside = new ProjectPaths(m_project.Scratch[""], "shared");
        Assert.That(CloudList.Collect(inside, new Dictionary<string, string>(), new string[0]).Unused, Has.Count.EqualTo(1));
    }

    [Test]
    public void List_OfThousands_IsShownPageByPage()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("z.las", 1000), "Assets");
        m_project.UpdateToTheEnd();
        Collected(0);
        var rows = ((CloudList)typeof(CloudsWindow).GetField("m_list", BindingFlags.Instance | BindingFlags.NonPublic)
            .GetValue(m_window)).Rows;
        rows.InsertRange(0, Enumerable.Range(0, 400).Select(i => new CloudList.Row { Asset = "Assets/" + i, State = "gone" }));

        var selected = new List<string>();
        foreach (string button in new[] { "Page 1 of 3: next", "Page 2 of 3: next", "Page 3 of 3: next" })
        {
            Press("Select");
            selected.Add(Selection.activeObject == null ? null : AssetDatabase.GetAssetPath(Selection.activeObject));
            Press(button);
        }

        Assert.That(selected, Is.EqualTo(new[] { null, null, "Assets/z.pointcloud" }));
        Selection.activeObject = null;
    }

    [Test]
    public void Queue_Buttons_OrderAndCancel()
    {
        foreach (string name in new[] { "a", "b", "c" })
            m_project.Imports.CreateAsset(m_project.Scratch.Demo(name + ".las", 1000), "Assets");
        var queue = m_project.Imports.Queue;
        queue.MoveFirst(queue.Requests[2]);
        Assert.That(queue.Requests.Select(r => r.Cloud), Is.EqualTo(new[] { "c", "a", "b" }.Select(n =>
            "PointClouds/" + n + ".fastpoints")));
        Press("Cancel 1");
        Assert.That(queue.Requests.Select(r => r.Cloud), Does.Not.Contain("PointClouds/c.fastpoints"));
        m_project.UpdateToTheEnd();
        Assert.That(Directory.Exists("PointClouds/c.fastpoints"), Is.False);
    }

    [TestCase("Export...")]
    [TestCase("Locate source...")]
    [TestCase("Delete unused")]
    public void Button_ThatOpensAPanel_ExitsGui(string button)
    {
        foreach (string name in new[] { "a", "b", "c" })
            m_project.Imports.CreateAsset(m_project.Scratch.Demo(name + ".las", 1000), "Assets");
        m_project.UpdateToTheEnd();
        File.Delete(m_project.Scratch["a.las"]);
        File.Delete("Assets/c.pointcloud");
        AssetDatabase.Refresh();
        Collected(1);
        Press(button);
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(button == "Delete unused" ? 1 : 0));
    }

    [Test]
    public void Convert_MissingDataPrompt_ConvertsThoseWithSources()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        foreach (string name in new[] { "a", "b", "c", "gone" })
            m_project.Imports.CreateAsset(m_project.Scratch.Demo(name + ".las", 1000), "Assets");
        m_project.Imports.CreateAsset(m_project.Copc("d.copc.laz"), "Assets");
        File.Copy("Assets/a.pointcloud", "Assets/a 1.pointcloud");
        File.Delete(m_project.Scratch["gone.las"]);
        AssetDatabase.Refresh();
        Collected(0);

        Press("Convert all missing (3)");

        Assert.That(m_project.Imports.Queue.Requests.Select(r => r.Cloud), Is.EquivalentTo(new[] { "a", "b", "c" }.Select(n =>
            "PointClouds/" + n + ".fastpoints")));
        foreach (var request in m_project.Imports.Queue.Requests.ToArray())
            m_project.Imports.Cancel(request);
        Collected(0);
        Press("Convert");
        Assert.That(m_project.Imports.Queue.Requests, Has.Count.EqualTo(3), "a button at each row");
    }

    [Test]
    public void Group_NotEnded_IsRejected()
    {
        void Unbalanced() => GUILayout.BeginHorizontal();
        Assert.That(() => GUILayoutUtility.Repaint(Unbalanced), Throws.InvalidOperationException);
        Assert.That(() => GUILayoutUtility.Repaint(GUILayout.EndHorizontal), Throws.InvalidOperationException);
        Assert.That(() => GUILayoutUtility.Repaint(() =>
        {
            Unbalanced();
            EditorUtility.OpenFolderPanel("", "", "");
            GUILayout.EndHorizontal();
        }), Throws.InvalidOperationException.With.Message.StartsWith("EndLayoutGroup: BeginLayoutGroup must be called first."));
        Assert.That(() => GUILayoutUtility.Repaint(() =>
        {
            Unbalanced();
            EditorUtility.OpenFolderPanel("", "", "");
            GUIUtility.ExitGUI();
        }), Throws.Nothing);
    }
}
