namespace FastPoints.HostTests.Editor;

public sealed class EditorImportsTests : EditorFixture
{
    string HandlePath(string name) => Path.Combine(m_project.Paths.Project, "Assets", name);

    [Test]
    public void Take_LargeFile_CreatesAHandleLinkedAfterConversion()
    {
        string source = m_project.Scratch.Demo("scan.las", 20_000);

        var asset = m_project.Imports.CreateAsset(source, "Assets");

        Assert.That(m_logged, Is.Empty);
        Assert.That(asset.ProjectPath, Is.EqualTo("PointClouds/scan.fastpoints"));
        Assert.That(asset.PlayerPath, Is.EqualTo("PointClouds/scan.fastpoints"));
        Assert.That(asset.Points, Is.EqualTo(-1), "nobody has counted them");
        Assert.That(new FileInfo(HandlePath("scan.pointcloud")).Length, Is.LessThan(2000));

        m_project.UpdateToTheEnd();

        Assert.That(asset.Points, Is.EqualTo(20_000));
        var handle = HandleFile.Read(HandlePath("scan.pointcloud"));
        Assert.That(handle.CloudId, Is.Not.Zero);
        Assert.That(handle.Stamp.Compare(new[] { source }), Is.EqualTo(SourceChange.None));
        Assert.That(Progress.Entries.Single().Status, Is.EqualTo(Progress.Status.Succeeded));
        var verified = CliCall.Of("verify", m_project.Paths.Absolute(handle.CloudPath), "--against", source, "--quiet");
        Assert.That(verified.Status, Is.EqualTo(ExitStatus.Done), verified.Error);
    }

    [Test]
    public void Update_HandleInUseAtTheEnd_IsWrittenLater()
    {
        using var windows = WindowsRules.On();
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 3000), "Assets");
        using (WindowsRules.ReadAt((change, _, to) => change == FileChange.Replace && to == HandlePath("scan.pointcloud"),
            (_, to) => to))
        {
            m_project.UpdateToTheEnd();
            Assert.That(asset.Points, Is.EqualTo(-1));
        }
        m_project.Imports.Update(DateTime.UtcNow.AddHours(1));
        Assert.That(asset.Points, Is.EqualTo(3000));
        Assert.That(m_logged, Is.Empty);
    }

    [Test]
    public void CreateAsset_TwoFilesOfOneName_AreTwoClouds()
    {
        Directory.CreateDirectory(m_project.Scratch["other"]);
        string one = m_project.Scratch.Demo("scan.las", 3000), two = m_project.Scratch.Demo("other/scan.las", 4000);
        var first = m_project.Imports.CreateAsset(one, "Assets");
        var second = m_project.Imports.CreateAsset(two, "Assets");
        Assert.That(second.ProjectPath, Is.EqualTo("PointClouds/scan 2.fastpoints"));

        m_project.UpdateToTheEnd();

        Assert.That((first.Points, second.Points), Is.EqualTo((3000L, 4000L)));
    }

    [Test]
    public void Take_ConvertedFolder_IsReferencedInPlace()
    {
        string folder = m_project.Scratch.Converted("far.fastpoints");

        var asset = m_project.Imports.CreateAsset(folder, "Assets");

        Assert.That(asset.Points, Is.EqualTo(3000));
        Assert.That(asset.Paths.FullPath, Is.EqualTo(folder));
        Assert.That(asset.PlayerPath, Does.Match("^PointClouds/far-[0-9a-f]{8}\\.fastpoints$"));
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
    }

    [Test]
    public void CreateAsset_MissingSource_ReportsItAndCanBeRetried()
    {
        string source = m_project.Scratch.Demo("scan.las", 3000);
        m_project.Imports.CreateAsset(source, "Assets");
        File.Move(source, source + ".away");
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), () => m_logged.Count > 0);
        Assert.That(m_logged.Single(), Does.StartWith("Error: FastPoints: ").And.EndsWith("no such file or folder"));

        File.Move(source + ".away", source);
        m_project.Imports.Queue.Resume(m_project.Imports.RequestOf("Assets/scan.pointcloud"));
        m_project.UpdateToTheEnd();
        Assert.That(m_project.Asset("Assets/scan.pointcloud").Points, Is.EqualTo(3000));
    }

    [Test]
    public void CreateAsset_NormalsOn_TheCloudGetsThemAndTheHandleStays()
    {
        FastPointsSettings.instance.Normals = true;
        try
        {
            m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 20_000), "Assets");
            m_project.UpdateToTheEnd();
        }
        finally
        {
            FastPointsSettings.instance.Normals = false;
        }
        var asset = m_project.Asset("Assets/scan.pointcloud");
        Assert.That(asset.Points, Is.EqualTo(20_000));
        Assert.That(ImportProject.NormalLayerOf(asset.Paths.FullPath), Is.EqualTo(1));
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
    }

    [Test]
    public void Suspend_InTheMiddle_IsFinishedAfterTheReload()
    {
        string source = m_project.Scratch.Demo("scan.las", 100_000);
        m_project.Imports.CreateAsset(source, "Assets");
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow),
            () => m_project.Imports.Queue.Session?.Progress.Current == "read");
        m_project.Imports.Suspend();

        using var reloaded = new EditorImports(m_project.Paths, FastPointsSettings.instance);
        var asset = m_project.Asset("Assets/scan.pointcloud");
        ImportProject.Updates(() => reloaded.Update(DateTime.UtcNow), () => asset.Points > 0);
        Assert.That(asset.Points, Is.EqualTo(100_000));
    }

    [Test]
    public void Reload_WhileAnotherEditorImports_KeepsTheRequests()
    {
        Directory.CreateDirectory("PointClouds");
        Assert.That(FolderLock.TakeOrGetOwner(Path.Combine("PointClouds", ImportQueue.LockName), out var held), Is.Null);
        using (held)
        {
            m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 3000), "Assets");
            for (int reload = 0; reload < 2; reload++)
            {
                m_project.Imports.Update(DateTime.UtcNow);
                AssemblyReloadEvents.Reload();
            }
            Assert.That(m_project.Imports.Queue.Requests, Has.Count.EqualTo(1));
        }
        m_project.UpdateToTheEnd();
        Assert.That(m_project.Asset("Assets/scan.pointcloud").Points, Is.EqualTo(3000));
        AssemblyReloadEvents.Reload();
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty, "once");
    }

    /// <summary>Unity calls those who hear of updates in a loop: what one throws would starve the others.</summary>
    [Test]
    public void Update_OnePartThrows_IsReportedOnceAndTheOthersContinue()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("one.las", 3000), "Assets");
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("two.las", 3000), "Assets");
        m_project.Imports.Queue.ConversionEnded += (_, __) => throw new InvalidOperationException("planted in the queue");

        m_project.UpdateToTheEnd();

        Assert.That(m_logged.Single(), Does.Contain("planted in the queue"));
        Assert.That(() => LoggedExceptions.ThrowFirst(), Throws.InvalidOperationException);
        Assert.That(m_project.Asset("Assets/two.pointcloud").Points, Is.EqualTo(3000));
    }

    [Test]
    public void Export_UnexpectedException_IsOneErrorAndTheNextContinues()
    {
        string source = m_project.Scratch.Demo("scan.las", 3000), written = m_project.Scratch["written.las"];
        m_project.Imports.Exports.Begin(new[] { source }, m_project.Scratch["never.las"],
            new ExportSettings { Classes = new[] { 100_000 } });
        m_project.Imports.Exports.Begin(new[] { source }, written, new ExportSettings());
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), () => !m_project.Imports.Exports.IsExporting);

        Assert.That(m_logged, Has.Count.EqualTo(2));
        Assert.That(m_logged[0], Does.StartWith("Error: FastPoints: ").And.Contains("IndexOutOfRangeException")
            .And.Contains("never.las"));
        Assert.That(Progress.Entries.Select(e => e.Status),
            Is.EqualTo(new[] { Progress.Status.Failed, Progress.Status.Succeeded }));
        Assert.That(File.Exists(written), Is.True);
    }

    [Test]
    public void Verify_UnexpectedException_IsNoSuccess()
    {
        string cloud = m_project.Scratch.Converted("far.fastpoints");
        using (WindowsRules.Hear((change, path, _) =>
        {
            if (change == FileChange.Open && path.EndsWith(".bin"))
                throw new InvalidOperationException("planted");
        }))
        {
            m_project.Imports.Verification.Begin(cloud);
            for (int i = 0; i < 3; i++)
                Assert.That(() => m_project.Imports.Update(DateTime.UtcNow), Throws.Nothing);
            ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow),
                () => !m_project.Imports.Verification.IsChecking);
        }
        Assert.That(m_logged.Single(), Does.StartWith("Error: FastPoints: " + cloud).And.Contains("planted"));
        Assert.That(Progress.Entries.Single().Status, Is.EqualTo(Progress.Status.Failed));
        Assert.That(m_project.Imports.Verification.Check.Result.Ok, Is.False);
    }

    /// <summary>A team's version control would see changes that nobody made: here the second has a copy with its own time, and
    /// shows it in a scene where it is converted.</summary>
    [Test]
    public void Handle_OfOneFileOnTwoMachines_IsTheSame()
    {
        using var world = StreamingWorld();
        string source = m_project.Scratch.Demo("scan.las", 5000);
        using (var file = new FileStream(source, FileMode.Open))
        {
            // The header's largest X is not that of the points: it is how a preview is placed.
            file.Position = 179;
            var claimed = new byte[8];
            file.ReadExactly(claimed);
            file.Position = 179;
            file.Write(BitConverter.GetBytes(BitConverter.ToDouble(claimed) + 500));
        }
        string Converted(Action show)
        {
            m_project.Imports.CreateAsset(source, "Assets");
            show();
            m_project.UpdateToTheEnd();
            string handle = File.ReadAllText(HandlePath("scan.pointcloud"));
            AssetDatabase.DeleteAsset("Assets/scan.pointcloud");
            CloudCatalog.Delete(m_project.Paths.Absolute("PointClouds/scan.fastpoints"));
            FileChanges.AwaitDeletes();
            return handle;
        }
        string here = Converted(() => { });
        File.SetLastWriteTimeUtc(source, new DateTime(2020, 1, 2, 3, 4, 5, DateTimeKind.Utc));
        UnityEngine.Object shown = null;
        string there = Converted(() =>
        {
            var cloud = PointCloudDrops.AddToScene(m_project.Asset("Assets/scan.pointcloud"), Vector3.zero, null);
            EditorProject.Frames(world, () => world.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity));
            shown = cloud.gameObject;
        });

        UnityEngine.Object.DestroyImmediate(shown);
        Assert.That(there, Is.EqualTo(here));
    }

    [Test]
    public void ProgressPause_AnotherWaiting_RunsFirst()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("one.las", 100_000), "Assets");
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow),
            () => Progress.Entries.Count == 1 && m_project.Imports.Queue.Session?.State == ConversionState.Building);
        Assert.That(Progress.Pause(0), Is.True);
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("two.las", 3000), "Assets");
        var asset = m_project.Asset("Assets/two.pointcloud");
        var now = DateTime.UtcNow;
        ImportProject.Updates(() => m_project.Imports.Update(now = now.AddSeconds(0.3)), () => asset.Points == 3000);

        var paused = m_project.Imports.Queue.Requests.Single();
        Assert.That(paused.State, Is.EqualTo(ImportState.Paused));
        Assert.That(Progress.Entries[0].HasEnded, Is.True, "the window shows what runs");
        m_project.Imports.Queue.Resume(paused);
        m_project.UpdateToTheEnd();
        Assert.That(m_project.Asset("Assets/one.pointcloud").Points, Is.EqualTo(100_000));
        Assert.That(m_logged, Is.Empty);
    }

    [Test]
    public void ProgressButtons_PauseAndCancelTheConversion()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 100_000), "Assets");
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), () => Progress.Entries.Count == 1);
        var shown = Progress.Entries[0];
        Assert.That(shown.Name, Is.EqualTo("Convert scan.pointcloud"));
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow),
            () => m_project.Imports.Queue.Session.State == ConversionState.Building);

        Assert.That(Progress.Pause(0), Is.True);
        Assert.That(Progress.Entries[0].Status, Is.EqualTo(Progress.Status.Paused));
        Assert.That(m_project.Imports.Queue.Session.State, Is.EqualTo(ConversionState.Paused));
        Assert.That(Progress.Resume(0), Is.True);
        Assert.That(m_project.Imports.Queue.Session.State, Is.EqualTo(ConversionState.Building));
        Assert.That(Progress.Cancel(0), Is.True);
        Assert.That(shown.Status, Is.EqualTo(Progress.Status.Canceled));
        m_project.UpdateToTheEnd();
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetDirectories(m_project.Paths.Clouds), Is.Empty);
        Assert.That(Directory.GetFiles(m_project.Paths.Clouds).Select(Path.GetFileName),
            Is.SubsetOf(new[] { "scan.preview.png", "scan.cancelled", ".gitignore" }));
        Assert.That(m_logged, Is.Empty);
    }

    /// <summary>Unity's window shows as paused what says that it is.</summary>
    [Test]
    public void ProgressPause_BeforeTheFileIsOpen_IsRefused()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        m_project.Imports.Update(DateTime.UtcNow);
        Assert.That(m_project.Imports.Queue.Session.State, Is.EqualTo(ConversionState.Opening));
        Assert.That(Progress.Pause(0), Is.False);
        Assert.That(Progress.Entries[0].Status, Is.EqualTo(Progress.Status.Running));
    }

    /// <summary>Unity cancels what it manages when scripts are reloaded, with the callback of its window's button.</summary>
    [Test]
    public void Reload_DuringAShownConversion_DoesNotCancelIt()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 100_000), "Assets");
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), () => Progress.Entries.Count == 1);

        AssemblyReloadEvents.Reload();

        Assert.That(Progress.Entries.All(e => e.HasEnded), Is.True, "nobody would end it");
        var asset = m_project.Asset("Assets/scan.pointcloud");
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), () => asset.Points > 0);
        Assert.That(asset.Points, Is.EqualTo(100_000));
    }

    [Test]
    public void PointFile_InAssets_IsImportedByItsHeaderAndConverted()
    {
        m_project.Scratch.Demo("project/Assets/scan.las", 5000);
        AssetDatabase.Refresh();
        var asset = m_project.Asset("Assets/scan.las");
        Assert.That(ScriptedImports.Last.Errors, Is.Empty);
        Assert.That((asset.name, asset.Points), Is.EqualTo(("scan", 5000L)));
        Assert.That(asset.Paths.FullPath, Does.Match("/project/PointClouds/[0-9a-f]{32}\\.fastpoints$"));

        m_project.UpdateToTheEnd();
        Assert.That(m_project.Imports.Catalog.Find(m_project.Imports.HandleOf("Assets/scan.las"), out var cloud),
            Is.EqualTo(CatalogMatch.InPlace));
        Assert.That(cloud.Manifest.Points, Is.EqualTo(5000));

        m_project.Imports.CreatePointFileHandles(new[] { "Assets/scan.las" });
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty, "it is converted already");
    }

    [Test]
    public void Import_UpAxisAndUnit_SetThePlacement()
    {
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        m_project.UpdateToTheEnd();
        Assert.That(asset.TryGetSpace(out var bounds, out var asIs), Is.True);
        Assert.That((asIs.Up, asIs.OriginGeo), Is.EqualTo((UpAxis.Z, asset.Origin)));

        m_project.Apply("Assets/scan.pointcloud", i => (i.UpAxis, i.MetresPerUnit) = (UpAxis.Y, 0.001));

        Assert.That(asset.TryGetSpace(out _, out var turned), Is.True);
        Assert.That((turned.Up, turned.Scale), Is.EqualTo((UpAxis.Y, new double3(0.001, 0.001, 0.001))));
        Assert.That(turned.OriginGeo.y, Is.EqualTo(bounds.Min.y).Within(0.5), "another floor");
        Assert.That((asset.File().Up, asset.File().MetresPerUnitOverride), Is.EqualTo((UpAxis.Y, 0.001)));

        m_project.Apply("Assets/scan.pointcloud", null);
        Assert.That(asset.TryGetSpace(out _, out var back), Is.True);
        Assert.That(back, Is.EqualTo(asIs));
    }

    [Test]
    public void Import_ConvertedWithAnotherUpAxis_StaysInPlace()
    {
        ScriptedImports.Configure = importer => ((CloudImporter)importer).UpAxis = UpAxis.Y;
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        m_project.UpdateToTheEnd();

        var handle = m_project.Imports.HandleOf("Assets/scan.pointcloud");
        Assert.That(handle.OriginUp, Is.EqualTo(UpAxis.Y));
        Assert.That(asset.Origin, Is.EqualTo(handle.Origin));
        Assert.That(asset.Origin.y, Is.EqualTo(asset.BoundsMin.y).Within(0.5));
    }

    [Test]
    public void PointCloud_UpAxisOfTheAssetChanged_IsRotated()
    {
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        m_project.UpdateToTheEnd();
        using var world = StreamingWorld();
        var cloud = PointCloudDrops.AddToScene(asset, null, null);
        void ShownAs(UpAxis up) => ImportProject.Updates(() =>
        {
            SceneLoop.Update();
            world.Update();
        }, () => cloud.TryGetSpace(out var space) && space.Up == up);
        ShownAs(UpAxis.Z);

        m_project.Apply("Assets/scan.pointcloud", importer => importer.UpAxis = UpAxis.X);

        ShownAs(UpAxis.X);
        UnityEngine.Object.DestroyImmediate(cloud.gameObject);
    }

    [TestCase("Assets/x.pointcloud", "{}")]
    [TestCase("Assets/x.las", "LASF")]
    public void Import_DamagedFile_IsAnEmptyAssetAndAnError(string path, string content)
    {
        File.WriteAllText(Path.Combine(m_project.Paths.Project, path), content);
        AssetDatabase.Refresh();
        Assert.That(ScriptedImports.Last.Errors.Single(), Does.StartWith(path + ": "));
        Assert.That(m_project.Asset(path).Points, Is.EqualTo(-1));
    }

    [Test]
    public void CreateAsset_Copc_IsStreamedDirectlyUnlessSettingsConvertIt()
    {
        var asset = m_project.Imports.CreateAsset(m_project.Copc("scan.copc.laz"), "Assets");

        Assert.That(m_logged, Is.Empty);
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
        Assert.That(asset.Paths.FullSources().Single(), Does.EndWith("scan.copc.laz"));
        Assert.That(asset.PlayerSource, Does.Match("^PointClouds/[0-9a-f]{8}/scan.copc.laz$"));

        FastPointsSettings.instance.ConvertOctrees = true;
        m_project.Imports.CreateAsset(m_project.Copc("other.copc.laz"), "Assets");
        Assert.That(m_project.Imports.Queue.Requests, Has.Count.EqualTo(1));
    }

    [Test]
    public void CreateAsset_ConvertAtOnceOff_ShowsThePreviewOnly()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
        Assert.That(asset.PlayerSource, Is.Empty, "a player cannot stream it");
        using var world = StreamingWorld();
        var cloud = PointCloudDrops.AddToScene(asset, null, null);
        EditorProject.Frames(world, () => world.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity));
        Assert.That(cloud.Error, Is.Null);
        UnityEngine.Object.DestroyImmediate(cloud.gameObject);
    }

    static World StreamingWorld()
    {
        var world = new World("default");
        World.DefaultGameObjectInjectionWorld = world;
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(world, typeof(PointCloudSystemGroup),
            typeof(OpenCloudsSystem), typeof(PlaceCloudsSystem), typeof(AddCloudsSystem), typeof(ReceiveNodesSystem),
            typeof(ControlNodesSystem), typeof(SelectNodesSystem), typeof(UploadNodesSystem), typeof(RequestNodesSystem),
            typeof(ListNodesSystem));
        world.GetExistingSystemManaged<PointCloudSystemGroup>().Begin(new MemoryNodePool(1 << 24, 1 << 20));
        return world;
    }

    [Test]
    public void PointCloud_DuringConversion_ShowsPreviewThenCloudInPlace()
    {
        using var world = StreamingWorld();
        var stream = world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream;
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        var cloud = PointCloudDrops.AddToScene(asset, new Vector3(1, 2, 3), null);
        Assert.That(cloud.transform.position.z, Is.EqualTo(3));
        EditorProject.Frames(world, () => world.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity));
        var entity = cloud.Entity;
        Assert.That(cloud.TryGetSpace(out var space), Is.True);

        EditorProject.AwaitIdle(world);
        m_project.UpdateToTheEnd();

        NodeSource Shown() => stream.Clouds[world.EntityManager.GetComponentData<StreamedPointCloud>(entity).Number].Source;
        EditorProject.Frames(world, () => Shown() is FolderSource);
        Assert.That(cloud.Entity, Is.EqualTo(entity), "it was not opened anew");
        Assert.That(cloud.TryGetSpace(out var later) && later.Equals(space), Is.True);
        var origin = HandleFile.Read(HandlePath("scan.pointcloud")).Origin;
        Assert.That(origin, Is.EqualTo(space.OriginGeo));
        Assert.That(asset.HasOrigin && asset.Origin.Equals(origin), Is.True);

        EditorProject.AwaitIdle(world);
        CloudCatalog.Delete(m_project.Paths.Absolute(asset.ProjectPath));
        EditorImports.Refresh("Assets/scan.pointcloud");
        EditorProject.Frames(world, () => Shown() is TreeSource);
        Assert.That(m_logged, Is.Empty);
        UnityEngine.Object.DestroyImmediate(cloud.gameObject);
    }

    [Test]
    public void EditModeFrames_LoadingCloud_AreRequestedUntilItIsShown()
    {
        using var world = StreamingWorld();
        int Asked()
        {
            int before = EditorApplication.s_queuedUpdates;
            EditModeFrames.Update();
            return EditorApplication.s_queuedUpdates - before;
        }
        EditorProject.AwaitIdle(world);
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        var cloud = PointCloudDrops.AddToScene(asset, null, null);
        world.Update();
        Assert.That(Asked(), Is.EqualTo(1));
        EditorProject.AwaitIdle(world);
        Assert.That(world.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity), Is.True);
        EditorApplication.isPlaying = true;
        UnityEngine.Object.DestroyImmediate(cloud.gameObject);
        world.Update();
        Assert.That(Asked(), Is.Zero, "the player loop runs anyway");
        EditorApplication.isPlaying = false;
    }

    [Test]
    public void Refresh_CloudWithoutAGameObject_OpensItsFolderAgain()
    {
        using var world = StreamingWorld();
        var group = world.GetExistingSystemManaged<PointCloudSystemGroup>();
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        var entity = world.EntityManager.CreateEntity();
        world.EntityManager.AddComponentData(entity, new Unity.Transforms.LocalToWorld { Value = float4x4.identity });
        world.EntityManager.AddComponentData(entity, asset.File());
        asset.Paths.WriteTo(world.EntityManager.AddBuffer<PointCloudPathByte>(entity));
        EditorProject.Frames(world, () => world.EntityManager.HasComponent<StreamedPointCloud>(entity));
        EditorProject.AwaitIdle(world);
        m_project.UpdateToTheEnd();
        EditorProject.Frames(world, () => group.Stream.Clouds[
            world.EntityManager.GetComponentData<StreamedPointCloud>(entity).Number].Source is FolderSource);
    }

    [Test]
    public void EditModeFrames_IdleBuild_RunOnceASecondUntilItEnds()
    {
        string folder = m_project.Scratch.Converted("far.fastpoints");
        var asset = m_project.Imports.CreateAsset(folder, "Assets");
        Directory.Move(folder, folder + ".part");
        using var world = StreamingWorld();
        var group = world.GetExistingSystemManaged<PointCloudSystemGroup>();
        var cloud = PointCloudDrops.AddToScene(asset, null, null);
        EditorProject.Frames(world, () => world.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity));
        EditorProject.AwaitIdle(world);
        Assert.That(group.NeedsFrame, Is.False);
        int looks = 0;
        for (var watch = Stopwatch.StartNew(); watch.Elapsed.TotalSeconds < 2.5;)
        {
            EditModeFrames.Update();
            if (EditorApplication.TakeUpdate())
            {
                looks += group.NeedsFrame ? 0 : 1;
                world.Update();
            }
            Thread.Sleep(1);
        }
        Assert.That(looks, Is.InRange(1, 3));
        Directory.Move(folder + ".part", folder);
        EditorProject.Frames(world, () => group.Stream.Clouds[world.EntityManager.GetComponentData<StreamedPointCloud>(
            cloud.Entity).Number].Source is FolderSource { Folder: { IsUnfinished: false } });
        UnityEngine.Object.DestroyImmediate(cloud.gameObject);
    }

    [TestCase(false)]
    [TestCase(true)]
    public void EditModeFrames_PausedPlayMode_OnlyStream(bool isChosen)
    {
        using var world = StreamingWorld();
        using var other = new World("other");
        if (isChosen)
            (World.DefaultGameObjectInjectionWorld, PointCloudSystemGroup.ObjectWorld) = (other, world);
        var group = world.GetExistingSystemManaged<PointCloudSystemGroup>();
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        m_project.UpdateToTheEnd();
        var cloud = PointCloudDrops.AddToScene(asset, null, null);
        EditorApplication.isPlaying = EditorApplication.isPaused = true;
        try
        {
            int queued = EditorApplication.s_queuedUpdates, repaints = SceneView.Repaints;
            ImportProject.Updates(EditModeFrames.Update,
                () => world.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity));
            Assert.That(SceneView.Repaints, Is.GreaterThan(repaints));
            Assert.That(EditorApplication.s_queuedUpdates, Is.EqualTo(queued), "a frame would end the pause");
            ImportProject.Updates(EditModeFrames.Update, () => !group.NeedsFrame);
            repaints = SceneView.Repaints;
            EditModeFrames.Update();
            Assert.That(SceneView.Repaints, Is.EqualTo(repaints), "there is nothing to do");
        }
        finally
        {
            EditorApplication.isPlaying = EditorApplication.isPaused = false;
            PointCloudSystemGroup.ObjectWorld = null;
            UnityEngine.Object.DestroyImmediate(cloud.gameObject);
        }
    }
}
