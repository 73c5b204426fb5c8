namespace FastPoints.HostTests.Cli;

public sealed class EditTests : ScratchTests
{
    const int Points = 20_000;
    const string Box = "441048,5611993,110,441068,5612009,140";

    string m_cloud;

    [OneTimeSetUp]
    public void MakeCloud() => m_cloud = Scratch.Converted("street.fastpoints", Points);

    [SetUp]
    public void ForgetEdits() => File.Delete(m_cloud + ".edits");

    CliCall Edit(params string[] args) => CliCall.Of(["edit", m_cloud, "--json", "-", .. args]);

    static long Changed(CliCall call)
    {
        Assert.That(call.Status, Is.Zero, call.Error);
        return call.Json.GetProperty("pointsChanged").GetInt64();
    }

    long Exported(string name, params string[] args)
    {
        var call = CliCall.Of(["export", m_cloud, "-o", Scratch[name], "--json", "-", "--force", .. args]);
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Json.GetProperty("pointsLost").GetInt64(), Is.Zero);
        return call.Json.GetProperty("points").GetInt64();
    }

    [Test]
    public void Delete_InABox_LeavesWhatCutLeaves()
    {
        Exported("cut.las", "--cut", Box);
        long changed = Changed(Edit("--delete", "--clip", Box));
        Assert.That(Exported("edited.las"), Is.EqualTo(Points - changed).And.LessThan(Points));
        Assert.That(File.ReadAllBytes(Scratch["edited.las"]), Is.EqualTo(File.ReadAllBytes(Scratch["cut.las"])));
        Assert.That(Exported("stored.las", "--as-stored"), Is.EqualTo(Points));
        var listed = Edit("--list").Json.GetProperty("operations")[0];
        Assert.That(listed.GetProperty("pointsChanged").GetInt64(), Is.EqualTo(changed));
    }

    [Test]
    public void Picture_OfAnEditedCloud_HasWhatIsLeftOrSaysWhyNot()
    {
        CliCall Draw() => CliCall.Of("picture", m_cloud, "-o", Scratch["p.png"], "--size", "64x48", "--force", "--json", "-");
        static long PointsOf(CliCall call) => call.Json.GetProperty("points").GetInt64();
        long changed = Changed(Edit("--delete", "--clip", Box));
        Assert.That(PointsOf(Draw()), Is.EqualTo(Points - changed).And.LessThan(Points));
        byte[] edits = File.ReadAllBytes(m_cloud + ".edits");
        edits[0] ^= 1;
        File.WriteAllBytes(m_cloud + ".edits", edits);
        var refused = Draw();
        Assert.That((refused.Status, PointsOf(refused)), Is.EqualTo((0, (long)Points)));
        Assert.That(refused.Error, Does.Contain(".edits"));
    }

    [TestCase("--where", "Intensity > 20000 && Z > 120"), TestCase("--classes", "2,5"), TestCase("--returns", "first")]
    public void Delete_ByAFilter_IsWhatTheFilterOfExportHas(string option, string value)
    {
        long matching = Exported("matching.las", option, value);
        Assert.That(Changed(Edit("--delete", option, value)), Is.EqualTo(matching).And.InRange(1, Points - 1));
        Assert.That(Exported("rest.las"), Is.EqualTo(Points - matching));
    }

    [Test]
    public void Delete_InPolygonsWithHoles_IsWhatExportHas()
    {
        File.WriteAllText(Scratch["a.wkt"], "MULTIPOLYGON(((441040 5611990, 441071.3 5611988.17, 441060 5612017), "
            + "(441055 5611997, 441060 5611997, 441057.5 5612001.1)), "
            + "((441050 5612000, 441080 5612000, 441080 5612003, 441050 5612004)))");
        long matching = Exported("matching.las", "--polygon", Scratch["a.wkt"]);
        Assert.That(Changed(Edit("--delete", "--polygon", Scratch["a.wkt"])), Is.EqualTo(matching).And.InRange(1, Points - 1));
        Assert.That(Edit("--list").Json.GetProperty("operations")[0].GetProperty("rings").GetInt32(), Is.EqualTo(3));
    }

    [Test]
    public void Delete_InALasso_OfAnEyeFarAbove_IsWhatABoxHas() => Assert.That(Changed(Edit("--delete", "--lasso",
        "441058,5612001,1e9,441048,5611993,120,441068,5611993,120,441068,5612009,120,441048,5612009,120")),
        Is.EqualTo(Exported("matching.las", "--as-stored", "--clip", "441048,5611993,0,441068,5612009,1000")).Within(30));

    [Test]
    public void Edit_OneAfterAnother_SeesWhatTheOneBeforeMade()
    {
        long moved = Changed(Edit("--classify", "77", "--where", "Classification == 2", "--sphere", "441058,5612001,120,8",
            "--sphere", "441068,5612001,120,8"));
        Assert.That(moved, Is.GreaterThan(20));
        Assert.That(Changed(Edit("--colour", "255,0,10", "--where", "Classification == 77")), Is.EqualTo(moved));
        Assert.That(Exported("red.las", "--where", "Red == 65535 && Green == 0 && Blue == 2570"), Is.EqualTo(moved));
        Assert.That(Exported("none.las", "--where", "Classification == 77", "--as-stored"), Is.Zero);
        Assert.That(Changed(Edit("--hide", "--classes", "77")), Is.EqualTo(moved));
        Assert.That(Exported("hidden.las"), Is.EqualTo(Points), "hidden points are kept");
        Assert.That(Changed(Edit("--delete", "--classes", "77")), Is.EqualTo(moved));
        Assert.That(Exported("rest.las"), Is.EqualTo(Points - moved));
        var info = CliCall.Of("info", m_cloud, "--json", "-").Json;
        Assert.That(info.GetProperty("files")[0].GetProperty("edits").GetInt32(), Is.EqualTo(4));
        Assert.That(info.GetProperty("files")[0].GetProperty("points").GetInt64(), Is.EqualTo(Points));
        Assert.That(CliCall.Of("verify", m_cloud).Status, Is.Zero, "verify proves what is stored");
    }

    [Test]
    public void UndoAndRedo_OneCallAfterAnother_GoStepByStep()
    {
        long first = Changed(Edit("--delete", "--classes", "2")), second = Changed(Edit("--delete", "--classes", "5"));
        Assert.That(Changed(Edit("--undo")), Is.EqualTo(second));
        Assert.That(Exported("a.las"), Is.EqualTo(Points - first));
        Assert.That(Changed(Edit("--undo")), Is.EqualTo(first));
        Assert.That(Edit("--undo").Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(Exported("b.las"), Is.EqualTo(Points));
        Assert.That(Changed(Edit("--redo")), Is.EqualTo(first));
        var list = Edit("--list").Json.GetProperty("operations");
        Assert.That(list.EnumerateArray().Select(o => o.GetProperty("undone").GetBoolean()), Is.EqualTo(new[] { false, true }));
        Assert.That(CliCall.Of("edit", m_cloud, "--list").Output, Does.Contain("(undone)"));
    }

    [Test]
    public void Convert_OfAnEditedCloud_BakesIt()
    {
        Assert.That(CliCall.Of("convert", m_cloud, "-o", Scratch["same.fastpoints"]).Status, Is.EqualTo(ExitStatus.BadInput));
        long gone = Changed(Edit("--delete", "--classes", "2"));
        var call = CliCall.Of("convert", m_cloud, "-o", Scratch["baked.fastpoints"], "--json", "-");
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Json.GetProperty("points").GetInt64(), Is.EqualTo(Points - gone));
        Assert.That(call.Json.GetProperty("pointsLost").GetInt64(), Is.Zero);
        Assert.That(CliCall.Of("verify", Scratch["baked.fastpoints"]).Status, Is.Zero);
    }

    [Test]
    public void Edit_OfNothing_WritesNothingDown()
    {
        var call = Edit("--delete", "--where", "Classification == 200");
        Assert.That(Changed(call), Is.Zero);
        Assert.That(call.Error, Does.Contain("no point is changed"));
        Assert.That(File.Exists(m_cloud + ".edits"), Is.False);
    }

    [TestCase("--delete"), TestCase("--list", "--clip", Box), TestCase("--delete", "--hide", "--clip", Box), TestCase,
     TestCase("--classify", "256", "--clip", Box), TestCase("--colour", "1,2", "--clip", Box),
     TestCase("--colour", "1,2,256", "--clip", Box), TestCase("--hide", "--sphere", "1,2,3"), TestCase("--redo"),
     TestCase("--hide", "--lasso", "0,0,0,1,0,0,0,1,0"), TestCase("--hide", "--lasso", "0,0,0,1,0,0,-1,0,0,0,1,9"),
     TestCase("--hide", "--every-nth", "2"), TestCase("--hide", "--where", "NoSuch > 1"), TestCase("--hide", "--where", "Z >")]
    public void Edit_OfWhatCannotBe_IsWrongUsage(params string[] args)
    {
        Assert.That(Edit(args).Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(File.Exists(m_cloud + ".edits"), Is.False);
    }

    [Test]
    public void Edit_WhileAnotherEdits_IsRefused()
    {
        using (var held = Hold())
            Assert.That(Edit("--delete", "--classes", "2").Error, Does.Contain("is being written by process"));
        Assert.That(Changed(Edit("--delete", "--classes", "2")), Is.GreaterThan(0));
        Assert.That(Directory.GetFiles(Scratch.Root, "*.lock"), Is.Empty);
    }

    FolderLock Hold()
    {
        Assert.That(FolderLock.TakeOrGetOwner(m_cloud + ".edits.lock", out var held), Is.Null);
        return held;
    }

    [TestCase(3), TestCase(20, Category = "Long")]
    public void Kill_AtRandomTimes_LeavesTheJournalWhole(int kills)
    {
        var random = new System.Random(kills);
        for (int kill = 0; kill < kills; kill++)
        {
            int before = Edit("--list").Json.GetProperty("operations").GetArrayLength();
            var start = new ProcessStartInfo(Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"))
            {
                RedirectStandardError = true,
                RedirectStandardOutput = true,
            };
            foreach (string arg in new[] { "edit", m_cloud, "--classify", (kill + 100).ToString(), "--clip", Box })
                start.ArgumentList.Add(arg);
            using (var process = Process.Start(start))
            {
                process.WaitForExit(random.Next(100, 400));
                process.Kill();
                process.WaitForExit();
            }
            var list = Edit("--list");
            Assert.That(list.Status, Is.Zero, list.Error);
            Assert.That(list.Json.GetProperty("operations").GetArrayLength(), Is.InRange(before, before + 1));
        }
        Assert.That(Changed(Edit("--delete", "--clip", Box)), Is.GreaterThan(100));
    }
}
