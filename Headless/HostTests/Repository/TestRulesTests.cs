namespace FastPoints.HostTests.Repository;

public sealed class TestRulesTests
{
    [Test]
    public void Tests_OfThePackage_FollowUnitysRunner()
    {
        using GenerationBuilds builds = Checkout.Builds(RepoTools.Repository.Generations[0]);

        Assert.That(builds.Package.SelectMany(TestRules.Check), Is.Empty);
    }

    [Test]
    public void Smoke_OfThePackage_HasTestsOfEachRoom()
    {
        using GenerationBuilds builds = Checkout.Builds(RepoTools.Repository.Generations[0]);
        ModuleDefinition shared = builds.Package.Single(m => m.Assembly.Name.Name == "FastPoints.Tests");
        ModuleDefinition unity = builds.Package.Single(m => m.Assembly.Name.Name == "FastPoints.UnityTests");

        Assert.That(TestRules.WithoutSmoke(shared), Is.Empty);
        Assert.That(TestRules.WithoutSmoke(unity), Is.Empty);
    }

    [TestCase("Quick", null)]
    [TestCase("LongAlone", "LongAlone: Long or Large and not Explicit")]
    [TestCase("ExplicitAlone", "ExplicitAlone: Explicit and neither Long nor Large")]
    [TestCase("ExplicitSmoke", "ExplicitSmoke: Explicit and of the category Smoke")]
    [TestCase("Reloading", "Reloading: Begin runs again where scripts are loaded anew")]
    [TestCase("LongCase", "LongCase: wanted its categories as attributes")]
    public void Check_PlantedTest_IsReported(string test, string reported)
    {
        using var module = ModuleDefinition.ReadModule(typeof(Planted).Assembly.Location);
        string[] problems = TestRules.Check(module).Where(p => p.Contains(nameof(Planted) + "." + test + ":")).ToArray();

        Assert.That(problems, reported == null ? Is.Empty : Has.Some.Contains(reported));
    }

    [Test]
    public void Workflow_OfTests_SkipsLongTests()
    {
        string workflow = File.ReadAllText(Path.Combine(Checkout.Repository.Root, ".github", "workflows", "test.yml"));
        string filters = Regex.Match(workflow, "customParameters: (.*)").Groups[1].Value;

        Assert.That(filters, Does.Contain("-testCategory").And.Contain("'Smoke'").And.Contain("'!Performance;!Long;!Large'"));
    }

    /// <summary>Abstract, so that nobody runs them.</summary>
    abstract class Planted
    {
        [SetUp]
        public void Begin() { }

        [UnityTest]
        public IEnumerator Reloading()
        {
            yield return null;
        }

        [Test]
        public void Quick() { }

        [Test, Category("Long")]
        public void LongAlone() { }

        [Test, Explicit]
        public void ExplicitAlone() { }

        [Test, Category("Large"), Category("Smoke"), Explicit]
        public void ExplicitSmoke() { }

        [TestCase(1, Category = "Long", Explicit = true)]
        public void LongCase(int value) { }
    }
}
