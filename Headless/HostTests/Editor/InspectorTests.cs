namespace FastPoints.HostTests.Editor;

public sealed class InspectorTests
{
    [Test]
    public void ClassesOf_KnownRange_AreNamedOrHiddenOnes()
    {
        Assert.That(ClassFilter.ClassesOf(2, 9, new[] { 40 }), Is.EqualTo(new[] { 2, 3, 4, 5, 6, 7, 9, 40 }), "8 is reserved");
        Assert.That(ClassFilter.ClassesOf(8, 66, new int[0]).Where(c => c == 8 || c > 22),
            Is.EqualTo(new[] { 8, 64, 65, 66 }), "the least is there for sure");
        Assert.That(ClassFilter.ClassesOf(double.NaN, double.NaN, new int[0]), Does.Contain(2).And.Not.Contains(64));
        Assert.That(ClassFilter.ClassesOf(5, 5, new int[0]), Is.EqualTo(new[] { 5 }));
        Assert.That(new[] { 2, 8, 64 }.Select(ClassFilter.Label),
            Is.EqualTo(new[] { "2 ground", "8 reserved", "64 of the user" }));
    }

    static IEnumerable<Type> Shown => new[] { typeof(PointCloudSystemGroup), typeof(PointCloudCamera), typeof(ScenePicking),
            typeof(FastPoints.Sources.PointFileReaders) }
        .SelectMany(t => t.Assembly.GetTypes()).Where(t => !t.IsAbstract && (t.IsPublic
            ? typeof(MonoBehaviour).IsAssignableFrom(t) || typeof(ScriptableObject).IsAssignableFrom(t)
            : typeof(UnityEditor.AssetImporters.ScriptedImporter).IsAssignableFrom(t)));

    [TestCaseSource(nameof(Shown))]
    public void Help_OfEachComponent_IsAPageOfTheManual(Type type)
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(HelpPages).TypeHandle);
        string root = Checkout.Repository.PackageRoot;
        var page = type.GetCustomAttribute<HelpURLAttribute>(true);
        Assert.That(page, Is.Not.Null);
        Assert.That(page.URL, Is.Not.Null, "Unity would throw");
        var asked = HelpPageAttribute.UrlOf;
        try
        {
            HelpPageAttribute.UrlOf = name => HelpPages.UrlOf(name, root);
            Assert.That(File.Exists(new Uri(page.URL).LocalPath), Is.True, page.URL);
            HelpPageAttribute.UrlOf = null;
            Assert.That(page.URL, Is.Empty, "a player");
        }
        finally
        {
            HelpPageAttribute.UrlOf = asked;
        }
    }

    [Test]
    public void Help_OfAComponent_OpensThePackagesManual()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(HelpPages).TypeHandle);
        using var scratch = new ScratchFolder();
        string root = scratch["a package"];
        Directory.CreateDirectory(Path.Combine(root, "Documentation~"));
        File.WriteAllText(Path.Combine(root, "Documentation~", "show.md"), "");
        var asked = HelpPageAttribute.UrlOf;
        var camera = new GameObject("camera").AddComponent<PointCloudCamera>();
        try
        {
            HelpPageAttribute.UrlOf = name => HelpPages.UrlOf(name, root);
            Assert.That(Help.GetHelpURLForObject(camera),
                Does.StartWith("file:///").And.EndsWith("/a%20package/Documentation~/show.md"));
            foreach (var (site, url) in new[]
            {
                ("https://example.org/docs/", "https://example.org/docs/show.html"),
                ("https://example.org/docs/index.html", "https://example.org/docs/show.html"),
                ("https://example.org/blob/main/index.md", "https://example.org/blob/main/show.md"),
            })
            {
                File.WriteAllText(Path.Combine(root, "package.json"), "{ \"documentationUrl\": \"" + site + "\" }");
                Assert.That(Help.GetHelpURLForObject(camera), Is.EqualTo(url));
            }
            File.Delete(Path.Combine(root, "package.json"));
            File.Delete(Path.Combine(root, "Documentation~", "show.md"));
            Assert.That(Help.GetHelpURLForObject(camera), Is.Empty, "copied without its manual");
        }
        finally
        {
            HelpPageAttribute.UrlOf = asked;
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
        }
    }

    [TestCaseSource(nameof(Shown))]
    public void Icon_OfEachComponent_IsASmallPicture(Type type)
    {
        var icon = type.GetCustomAttribute<IconAttribute>();
        if (type == typeof(PointCloudResources) || !type.IsPublic)
            return;
        const string package = "Packages/com.fastpoints.dots/";
        Assert.That(icon.path, Does.StartWith(package));
        string path = Path.Combine(Checkout.Repository.PackageRoot, icon.path[package.Length..]);
        var picture = Png.Read(path);
        Assert.That((picture.Width, picture.Height), Is.EqualTo((64, 64)));
        Assert.That(Enumerable.Range(0, 64 * 64).Count(i => picture.Rgba[i * 4 + 3] == 0), Is.InRange(1000, 3000), "see-through");
        Assert.That(File.ReadAllText(path + ".meta"), Does.Contain("textureType: 2").And.Contain("enableMipMap: 0"));
    }

    [Test]
    public void Toggle_AClass_AddsAndRemovesIt()
    {
        var hidden = new[] { 2, 6 };
        Assert.That(ClassFilter.Switch(hidden, 2, false), Is.SameAs(hidden));
        Assert.That(ClassFilter.Switch(hidden, 3, true), Is.SameAs(hidden));
        Assert.That(ClassFilter.Switch(hidden, 3, false), Is.EqualTo(new[] { 2, 3, 6 }));
        Assert.That(ClassFilter.Switch(hidden, 2, true), Is.EqualTo(new[] { 6 }));
        Assert.That(hidden, Is.EqualTo(new[] { 2, 6 }), "Undo keeps what was");
    }

    [Test]
    public void Describe_Frame_NamesDrawnAndInFlight()
    {
        var stats = new FrameStats
        {
            DrawnPoints = 1_234_567,
            SelectedPoints = 2_000_000,
            DrawnNodes = 12,
            CachedNodes = 40,
            PoolBytes = 3 << 20,
            ReadsInFlight = 3,
            SelectMs = 0.25,
            ListMs = 0.5,
        };
        var lines = FrameText.Describe(stats, 2_500_000, 512 << 20).ToDictionary(l => l.Key, l => l.Value);
        Assert.That(lines["Points"], Is.EqualTo("1,234,567 drawn of 2,000,000 selected, 2,500,000 at most"));
        Assert.That(lines["Graphics memory"], Is.EqualTo("3.0 of 512 MiB"));
        Assert.That(lines["Reads"], Does.StartWith("3 under way"));
        Assert.That(lines["Main thread"], Is.EqualTo("0.75 ms"));
        stats.IsSettled = true;
        Assert.That(FrameText.Describe(stats, 1, 1).Single(l => l.Key == "Reads").Value, Is.EqualTo("nothing is missing"));
    }

    [Test]
    public void CloudInspector_UnknownUnit_AsksForItAndAppliesTheAnswer()
    {
        using var project = new EditorProject();
        File.WriteAllText(project.Scratch["feet.xyz"], "0 0 0\n100 200 10\n");
        project.Imports.CreateAsset(project.Scratch["feet.xyz"], "Assets");
        var importer = new HandleImporter { Path = "Assets/feet.pointcloud" };
        var inspector = UnityEditor.Editor.Of<CloudImporterEditor>(importer);
        try
        {
            ImportProject.Updates(() =>
            {
                inspector.DrawInspector();
                project.Imports.Update(DateTime.UtcNow);
            }, () => project.Imports.Queue.Requests.Count == 0);
            inspector.DrawInspector();
            GUILayoutUtility.Send(new Event { type = EventType.Layout }, inspector.OnInspectorGUI);
            GUILayout.Pressed = "US survey feet: 30.48 x 60.96 x 3.048 m";
            GUILayoutUtility.Send(new Event { type = EventType.MouseUp }, inspector.OnInspectorGUI);
            Assert.That(importer.MetresPerUnit, Is.EqualTo(1200.0 / 3937));
        }
        finally
        {
            (GUILayout.Pressed, Event.current) = (null, null);
            Object.DestroyImmediate(inspector);
        }
    }

    /// <summary>Both events of each repaint, through a cloud's life: no control may come that was not laid out, and all of
    /// the fields that are drawn are there.</summary>
    [Test]
    public void CloudInspector_DuringAConversion_LogsNothing()
    {
        using var project = new EditorProject();
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        var buttons = new[] { "Pause", "Go on", "Look whether the source has changed", "Verify", "Convert again", "Cancel" };
        try
        {
            project.Imports.CreateAsset(project.Scratch.Demo("scan.las", 20_000), "Assets");
            var importer = new HandleImporter { Path = "Assets/scan.pointcloud" };
            var inspector = UnityEditor.Editor.Of<CloudImporterEditor>(importer);
            void Draw()
            {
                inspector.DrawInspector();
                project.Imports.Update(DateTime.UtcNow);
            }
            ImportProject.Updates(Draw, () => project.Imports.Queue.Requests.Count == 0);
            foreach (string button in buttons)
            {
                GUILayoutUtility.Send(new Event { type = EventType.Layout }, inspector.OnInspectorGUI);
                GUILayout.Pressed = button;
                GUILayoutUtility.Send(new Event { type = EventType.MouseUp }, inspector.OnInspectorGUI);
                GUILayout.Pressed = null;
                Draw();
            }
            ImportProject.Updates(Draw,
                () => !project.Imports.Verification.IsChecking && project.Imports.Queue.Requests.Count == 0);
            Object.DestroyImmediate(inspector);
            Assert.That(logged.Where(l => !l.StartsWith("Log: ")), Is.Empty);
        }
        finally
        {
            GUILayout.Pressed = null;
            Event.current = null;
            Debug.s_sink = null;
        }
    }

    [Test]
    public void ComponentInspectors_OfAScene_LogNothing()
    {
        var scene = new GameObject("scan");
        try
        {
            var editor = UnityEditor.Editor.Of<PointCloudEditor>(scene.AddComponent<FastPoints.Entities.PointCloud>());
            editor.Draw();
            scene.AddComponent<FastPoints.Entities.PointCloudSettings>();
            editor.Draw();
            Object.DestroyImmediate(editor);
            foreach (var provider in TypeCache.GetMethodsWithAttribute<SettingsProviderAttribute>())
            {
                var page = (SettingsProvider)provider.Invoke(null, null);
                Assert.That((page.scope, page.settingsPath), Is.EqualTo((SettingsScope.Project, "Project/FastPoints")));
                GUILayoutUtility.Repaint(() => page.guiHandler(""));
            }
        }
        finally
        {
            Event.current = null;
            Object.DestroyImmediate(scene);
        }
    }

    [Test]
    public void SettingsPage_Browse_ChangesTheFolderWithUndo()
    {
        using var project = new EditorProject();
        var settings = FastPointsSettings.instance;
        Directory.CreateDirectory("Elsewhere");
        SettingsProvider page = null;
        foreach (var provider in TypeCache.GetMethodsWithAttribute<SettingsProviderAttribute>())
            page = (SettingsProvider)provider.Invoke(null, null);
        try
        {
            GUILayoutUtility.Send(new Event { type = EventType.Layout }, () => page.guiHandler(""));
            (GUILayout.Pressed, EditorUtility.s_folder) = ("Browse...", Path.GetFullPath("Elsewhere"));
            GUILayoutUtility.Send(new Event { type = EventType.MouseUp }, () => page.guiHandler(""));
            Assert.That(settings.Place, Is.EqualTo("Elsewhere"), "relative, since it is in the project");
            Assert.That(PointCloudImports.Current.Paths.Clouds, Is.EqualTo(Path.GetFullPath("Elsewhere")));
            Assert.That(EditorGUIUtility.labelWidth, Is.EqualTo(150), "of whatever is drawn next");
            while (settings.Place == "Elsewhere")
                Undo.PerformUndo();
            Assert.That(PointCloudImports.Current.Paths.Clouds, Is.EqualTo(project.Paths.Clouds));
            Assert.That(File.ReadAllText("ProjectSettings/FastPoints.asset"), Does.Contain("Place: PointClouds"));
        }
        finally
        {
            (GUILayout.Pressed, EditorUtility.s_folder, Event.current) = (null, "", null);
            settings.Place = ProjectPaths.DefaultClouds;
        }
    }

    /// <summary>Unity's drawers of [Min] and [Range] go through float.</summary>
    [Test]
    public void Fields_OfDoubles_AreDrawnWithoutRounding()
    {
        var types = new[] { typeof(PointCloudImports), typeof(FastPoints.Entities.PointCloud) }
            .SelectMany(t => t.Assembly.GetTypes());
        var rounded = types.SelectMany(t => t.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            .Where(f => f.FieldType == typeof(double) &&
                (f.IsDefined(typeof(MinAttribute)) || f.IsDefined(typeof(UnityEngine.RangeAttribute))));
        Assert.That(rounded, Is.Empty);
    }

    [Test]
    public void Menu_CopiedLink_MakesACloudOfIt()
    {
        MethodInfo Item(bool isCheck) => typeof(SceneMenu).GetMethods(BindingFlags.Static | BindingFlags.NonPublic).Single(m =>
            m.GetCustomAttribute<MenuItem>() is { menuItem: "GameObject/Point Cloud/Cloud of Copied Link" } item &&
            item.validate == isCheck);
        string before = GUIUtility.systemCopyBuffer;
        try
        {
            GUIUtility.systemCopyBuffer = "C:/town.fastpoints";
            Assert.That(Item(true).Invoke(null, null), Is.False);
            GUIUtility.systemCopyBuffer = " https://127.0.0.1:1/old%20town.fastpoints?sig=x\n";
            Assert.That(Item(true).Invoke(null, null), Is.True);
            Item(false).Invoke(null, [new MenuCommand(null)]);
            var made = (GameObject)Selection.activeObject;
            Assert.That(made.name, Is.EqualTo("old town.fastpoints"));
            var cloud = made.GetComponent<FastPoints.Entities.PointCloud>();
            Assert.That(cloud.Path, Is.EqualTo("https://127.0.0.1:1/old%20town.fastpoints?sig=x"));
            Assert.That(PointCloudEditor.RemoteNote(cloud),
                Does.StartWith("Remote: read from https://127.0.0.1:1/old%20town.fastpoints,"));
            cloud.Path = "town.fastpoints";
            Assert.That(PointCloudEditor.RemoteNote(cloud), Is.Null);
            Object.DestroyImmediate(made);
        }
        finally
        {
            GUIUtility.systemCopyBuffer = before;
            Undo.Clear();
        }
    }

    [Test]
    public void Menu_OfGameObjects_AddsUnderTheSelectionWithUndo()
    {
        var parent = new GameObject("parent");
        try
        {
            foreach (var (item, type) in new[]
            {
                ("Point Cloud", typeof(FastPoints.Entities.PointCloud)), ("Origin", typeof(PointCloudOrigin)),
                ("Clip Box", typeof(PointCloudClipBox)), ("Settings", typeof(FastPoints.Entities.PointCloudSettings)),
            })
            {
                var method = typeof(SceneMenu).GetMethods(BindingFlags.Static | BindingFlags.NonPublic)
                    .Single(m => m.GetCustomAttribute<MenuItem>()?.menuItem == "GameObject/Point Cloud/" + item);
                Assert.That(method.GetCustomAttribute<MenuItem>().priority, Is.LessThan(50), "of the Hierarchy's menu, too");
                method.Invoke(null, new object[] { new MenuCommand(parent) });
                var made = (GameObject)Selection.activeObject;
                Assert.That(made.transform.parent, Is.SameAs(parent.transform));
                Assert.That(made.GetComponentsInChildren<Component>(true).Select(c => c.GetType()), Does.Contain(type));
                Undo.PerformUndo();
                Assert.That(made == null, Is.True);
            }
        }
        finally
        {
            Object.DestroyImmediate(parent);
            Undo.Clear();
        }
    }

    [Test]
    public void Menu_OfGameObjectsInAPrefabStage_AddsToThePrefab()
    {
        ObjectFactory.s_stage = new GameObject("prefab");
        try
        {
            typeof(SceneMenu).GetMethod("AddClipBox", BindingFlags.Static | BindingFlags.NonPublic)
                .Invoke(null, new object[] { new MenuCommand(null) });
            var made = (GameObject)Selection.activeObject;
            Assert.That(made.GetComponentsInChildren<PointCloudClipBox>(true), Has.Length.EqualTo(1));
            Assert.That(made.transform.parent, Is.SameAs(ObjectFactory.s_stage.transform));
        }
        finally
        {
            Object.DestroyImmediate(ObjectFactory.s_stage);
            ObjectFactory.s_stage = null;
            Undo.Clear();
        }
    }

    [Test]
    public void FindProperty_NotSerializedField_IsNull()
    {
        var asset = new SerializedObject(ScriptableObject.CreateInstance<FastPoints.Entities.PointCloudAsset>());
        Assert.That(asset.FindProperty("m_Script"), Is.Not.Null);
        Assert.That(asset.FindProperty("ProjectPath"), Is.Not.Null);
        Assert.That(asset.FindProperty("Unknown"), Is.Null);
        Assert.That(() => EditorGUILayout.PropertyField(asset.FindProperty("Unknown")), Throws.TypeOf<NullReferenceException>());
    }

    [Test]
    public void Layout_ExtraControlAtRepaint_IsRejected()
    {
        int controls = 1;
        void Draw()
        {
            for (int i = 0; i < controls; i++)
                GUILayout.Label("one");
            controls++;
        }
        Assert.That(() => GUILayoutUtility.Repaint(Draw), Throws.ArgumentException);
        controls = 1;
        GUILayoutUtility.Send(new Event { type = EventType.Layout }, Draw);
        Assert.That(() => GUILayoutUtility.Send(new Event { type = EventType.MouseUp }, Draw),
            Throws.Nothing, "a click may change it");
        Event.current = null;
    }

    [Test]
    public void ImporterInspector_WithoutApply_IsRefused()
    {
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(text);
        try
        {
            var inspector = UnityEditor.Editor.Of<CarelessInspector>(new HandleImporter());
            inspector.DrawInspector();
            Object.DestroyImmediate(inspector);
            Assert.That(logged.Single(), Does.Contain("must call ApplyRevertGUI"));
        }
        finally
        {
            Debug.s_sink = null;
            Event.current = null;
        }
    }

    [Test]
    public void Check_SoundAndDamagedCloud_ReportsIt()
    {
        using var project = new EditorProject();
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        try
        {
            var asset = project.Imports.CreateAsset(project.Scratch.Demo("scan.las", 20_000), "Assets");
            project.UpdateToTheEnd();
            string path = project.Paths.Absolute(asset.ProjectPath);
            CloudVerification Verify()
            {
                project.Imports.Verification.Begin(path);
                ImportProject.Updates(() => project.Imports.Update(DateTime.UtcNow),
                    () => !project.Imports.Verification.IsChecking);
                return project.Imports.Verification.Check;
            }
            Assert.That(Verify().Describe(), Is.EqualTo("20,000 points are as they were converted"));
            Assert.That(Progress.Entries.Last().Status, Is.EqualTo(Progress.Status.Succeeded));

            string damaged = Directory.GetFiles(path, "*.bin", SearchOption.AllDirectories)
                .OrderByDescending(f => new FileInfo(f).Length).First();
            var bytes = File.ReadAllBytes(damaged);
            bytes[bytes.Length / 2] ^= 4;
            File.WriteAllBytes(damaged, bytes);
            Assert.That(Verify().Describe(), Does.Match("^\\d+ problems:\n.*\\.bin"));
            Assert.That(Progress.Entries.Last().Status, Is.EqualTo(Progress.Status.Failed));
            Assert.That(logged.Last(), Does.StartWith("Error: FastPoints: " + path));

            project.Imports.Verification.Begin(path);
            Assert.That(Progress.Cancel(Progress.Entries.Count - 1), Is.True);
            Assert.That(project.Imports.Verification.IsChecking, Is.False);
            project.Imports.Verification.Begin(path);
            project.Imports.Suspend();
            Assert.That(Progress.Entries.Last().Status, Is.EqualTo(Progress.Status.Canceled));
        }
        finally
        {
            Debug.s_sink = null;
        }
    }

    sealed class CarelessInspector : UnityEditor.AssetImporters.ScriptedImporterEditor
    {
        public override void OnInspectorGUI() { }
    }
}
