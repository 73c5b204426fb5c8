namespace FastPoints.HostTests.Editor;

sealed class EditorProject : IDisposable
{
    static readonly TimeSpan s_longestRest = TimeSpan.FromSeconds(15);

    readonly string m_before = Environment.CurrentDirectory;

    public EditorProject()
    {
        // Requests made without a project.
        AssemblyReloadEvents.Reload();
        Directory.CreateDirectory(Scratch["project/Assets"]);
        Environment.CurrentDirectory = Scratch["project"];
        Application.AssetsPath = Scratch["project/Assets"];
        ScriptedImports.Register(typeof(CloudImporter).Assembly);
        Paths = new ProjectPaths(Scratch["project"]);
        PointFileReaders.Register();
        FastPointsSettings.instance.PointFiles = PointFiles.Import;
    }

    public ScratchFolder Scratch { get; } = new ScratchFolder();
    public ProjectPaths Paths { get; }

    public EditorImports Imports => PointCloudImports.Current; // The editor's own, so that what happens to assets reaches them.

    public string Copc(string name)
    {
        File.WriteAllText(Scratch[name], "LASF");
        return Scratch[name];
    }

    public PointCloudAsset Asset(string path) => AssetDatabase.LoadAssetAtPath<PointCloudAsset>(path);

    public void UpdateToTheEnd()
    {
        var now = DateTime.UtcNow;
        ImportProject.Updates(() =>
        {
            now = now.AddSeconds(0.3);
            Imports.Update(now);
        }, () => Imports.Queue.Requests.Count == 0);
    }

    public void Pull(string name)
    {
        string data = Paths.Absolute("PointClouds/" + name + ".fastpoints"), asset = "Assets/" + name + ".pointcloud";
        Imports.CreateAsset(Scratch.Demo(name + ".las", 1000), "Assets");
        AwaitIdle();
        Directory.Move(data, Scratch["old"]);
        Scratch.Demo(name + ".las", 3000);
        Imports.Convert(asset);
        AwaitIdle();
        Directory.Delete(data, true);
        Directory.Move(Scratch["old"], data);
        AssetDatabase.ImportAsset(asset, ImportAssetOptions.ForceUpdate);
    }

    /// <summary>Afterwards nothing reads the data, which can then be moved.</summary>
    void AwaitIdle()
    {
        UpdateToTheEnd();
        ImportProject.Updates(() => Imports.Update(DateTime.UtcNow),
            () => !Imports.Thumbnails.IsDrawing && !Imports.MissingData.IsSearchPending);
    }

    public static void Frames(World world, Func<bool> isDone)
    {
        for (var atRest = Stopwatch.StartNew(); !isDone() && atRest.Elapsed < s_longestRest;)
        {
            EditModeFrames.Update();
            if (EditorApplication.TakeUpdate())
            {
                world.Update();
                atRest.Restart();
            }
            Thread.Yield();
        }
        Assert.That(isDone(), Is.True, "nothing came of it before the editor came to rest");
    }

    public static void AwaitIdle(World world)
    {
        bool isIdle = false;
        ImportProject.Updates(() =>
        {
            EditModeFrames.Update();
            isIdle = !EditorApplication.TakeUpdate();
            if (!isIdle)
                world.Update();
        }, () => isIdle);
    }

    /// <summary>As the inspector's Apply: null for what importers begin with.</summary>
    public void Apply(string asset, Action<CloudImporter> settings)
    {
        ScriptedImports.Configure = settings == null ? null : importer => settings((CloudImporter)importer);
        AssetDatabase.ImportAsset(asset, ImportAssetOptions.ForceUpdate);
    }

    public void Dispose()
    {
        // What PointCloudImports holds is this project's, and so is what it has set aside.
        AssemblyReloadEvents.Reload();
        SessionState.EraseString("FastPoints.Imports");
        FastPointsSettings.instance.PointFiles = PointFiles.Ask;
        AssetDatabase.Clear();
        ScriptedImports.Clear();
        Progress.Entries.Clear();
        Undo.Clear();
        (EditorUtility.s_answer, EditorUtility.s_asked) = (-1, 0);
        EditorUtility.s_objects.Clear();
        UnityEngine.SceneManagement.SceneManager.s_open.Clear();
        UnityEngine.SceneManagement.SceneManager.s_closed.Clear();
        UnityEngine.SceneManagement.SceneManager.s_active = default;
        DragAndDrop.paths = Array.Empty<string>();
        DragAndDrop.objectReferences = Array.Empty<UnityEngine.Object>();
        Application.AssetsPath = null;
        CloudFeeds.Register(null);
        Environment.CurrentDirectory = m_before;
        Scratch.Dispose();
    }
}
