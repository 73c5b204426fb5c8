using FastPoints.UnityTests.Performance;

namespace FastPoints.HostTests.Editor;

public sealed class TestProjectFixtureTests : EditorFixture
{
    static readonly List<string> s_calls = new List<string>();

    [SetUp]
    public void Forget() => s_calls.Clear();

    [TearDown]
    public void Stop() => (EditorApplication.isPlaying, Application.isBatchMode) = (false, false);

    [Test]
    public void Run_ScriptReload_RunsSetUpAgainAndUnitySetUpNot()
    {
        new EditModeRun(typeof(Listing), nameof(Listing.Play)).Run();

        Assert.That(s_calls, Is.EqualTo(new[]
        {
            "UnitySetUp", "SetUp", "before: 7", "SetUp", "after: 0", "TearDown", "UnityTearDown",
        }));
    }

    [Test]
    public void Run_FailedTest_RunsTearDowns()
    {
        Assert.That(() => new EditModeRun(typeof(Listing), nameof(Listing.Fail)).Run(), Throws.InvalidOperationException);
        Assert.That(s_calls, Is.EqualTo(new[] { "UnitySetUp", "SetUp", "TearDown", "UnityTearDown" }));
    }

    [Test]
    public void Project_OfATestThatEntersPlayMode_IsKeptToItsEnd()
    {
        new EditModeRun(typeof(Keeping), nameof(Keeping.Play)).Run();

        Assert.That(s_calls, Is.EqualTo(new[] { "kept" }));
        Assert.That(EditorApplication.isPlaying, Is.False);
        Assert.That(Directory.Exists(TestProject.Folder), Is.False, "taken away when the test ends");
    }

    [Test]
    public void Project_ReopenedAfterAReload_IsKept()
    {
        new EditModeRun(typeof(Keeping), nameof(Keeping.BeginAgain)).Run();

        Assert.That(s_calls, Is.EqualTo(new[] { "kept" }));
    }

    [Test]
    public void Project_OfEachTest_BeginsEmpty()
    {
        new EditModeRun(typeof(Keeping), nameof(Keeping.Leave)).Run();
        new EditModeRun(typeof(Keeping), nameof(Keeping.Leave)).Run();

        Assert.That(s_calls, Is.EqualTo(new[] { "0 files", "0 files" }));
    }

    [TestCase(nameof(Keeping.Update))]
    [TestCase(nameof(Keeping.Fail))]
    public void Project_OfTheUser_IsRestored(string test)
    {
        SessionState.SetString("FastPoints.PointFilePrompt", "yes");
        FastPointsSettings.instance.PointFiles = PointFiles.Ask;
        m_project.Scratch.Demo("project/Assets/users.las", 500);
        AssetDatabase.Refresh();

        try
        {
            new EditModeRun(typeof(Keeping), test).Run();
        }
        catch (System.InvalidOperationException)
        {
            Assert.That(test, Is.EqualTo(nameof(Keeping.Fail)));
        }

        Assert.That(s_calls, Is.EqualTo(new[] { "updated" }));
        Assert.That(FastPointsSettings.instance.PointFiles, Is.EqualTo(PointFiles.Ask));
        Assert.That(AssetDatabase.Overrides, Is.Empty);
    }

    [TestCase(nameof(ImporterTests.PointFile_InAssets_GetsOurImporterIfNoOtherClaimsIt))]
    [TestCase(nameof(ImporterTests.Handle_OfAFileOutside_KnowsItsPointsWhenItIsConverted))]
    public void ImporterTests_InBatchMode_Pass(string test)
    {
        Application.isBatchMode = true;
        Assert.That(() => new EditModeRun(typeof(ImporterTests), test).Run(), Throws.Nothing);
    }

    [Test]
    public void PlayModeTests_InBatchMode_LoseNoConversion()
    {
        Application.isBatchMode = true;
        const string test = nameof(PlayModeTests.PlayMode_DuringAConversion_LosesNothing);
        Assert.That(() => new EditModeRun(typeof(PlayModeTests), test).Run(), Throws.Nothing);
    }

    [Test]
    public void FrameRateTests_InBatchMode_MeasureNothing()
    {
        Application.isBatchMode = true;
        var run = new EditModeRun(typeof(FrameRateTests), nameof(FrameRateTests.EditorFrames_BesideAConversion_AreMeasured));
        Assert.That(run.Run, Throws.TypeOf<IgnoreException>());
    }

    sealed class Listing
    {
        [SetUp]
        public void SetUp() => s_calls.Add("SetUp");

        [UnitySetUp]
        public IEnumerator UnitySetUp()
        {
            s_calls.Add("UnitySetUp");
            yield return null;
        }

        public IEnumerator Play()
        {
            int variable = 7;
            s_calls.Add("before: " + variable);
            yield return new EnterPlayMode();
            s_calls.Add("after: " + variable);
            yield return new ExitPlayMode();
        }

        public IEnumerator Fail()
        {
            yield return null;
            throw new System.InvalidOperationException();
        }

        [TearDown]
        public void TearDown() => s_calls.Add("TearDown");

        [UnityTearDown]
        public IEnumerator UnityTearDown()
        {
            s_calls.Add("UnityTearDown");
            yield break;
        }
    }

    sealed class Keeping : TestProjectFixture
    {
        public IEnumerator Play()
        {
            File.WriteAllText(TestProject.Folder + "/scan.txt", "");
            yield return TestProject.EnterPlayMode();
            s_calls.Add(File.Exists(TestProject.Folder + "/scan.txt") ? "kept" : "gone");
        }

        public IEnumerator BeginAgain()
        {
            File.WriteAllText(TestProject.Folder + "/scan.txt", "");
            AssemblyReloadEvents.Reload();
            var again = BeginProject();
            while (again.MoveNext())
                yield return again.Current;
            s_calls.Add(File.Exists(TestProject.Folder + "/scan.txt") ? "kept" : "gone");
        }

        public IEnumerator Update()
        {
            PointCloudImports.Current.Update(System.DateTime.UtcNow);
            s_calls.Add("updated");
            yield return null;
        }

        public IEnumerator Fail()
        {
            var steps = Update();
            while (steps.MoveNext())
                yield return steps.Current;
            throw new System.InvalidOperationException();
        }

        public IEnumerator Leave()
        {
            s_calls.Add(Directory.GetFiles(TestProject.Folder).Length + " files");
            File.WriteAllText(TestProject.Folder + "/left.txt", "");
            yield break;
        }
    }
}
