using FastPoints.RepoTools.Behaviour;

namespace FastPoints.HostTests.Repository;

public sealed class BehaviourLedgerTests
{
    private const string Header = "behaviour\twhat\tevidence\tsure\theld by\ttest\tstep\n";
    private const string Held =
        "assets-import\tIt imports.\tUnityCsReference 6000.0.78f1: "
            + "A.cs\tsource\tREADME.md\tPlantedTests.Import_Twice_ConvertsOnce\t\n";
    private const string Open = "builds-copy\tIt copies a | b.\tManual: Builds\tmanual\t-\tunverified\t13\n";
    private const string Earlier = "loads-early\tIt is early.\tManual: Loads\tmanual\t-\tunverified\t2, 15\n";

    private static readonly ILookup<string, string> s_tests =
        new[] { "public void Import_Twice_ConvertsOnce()" }.ToLookup(_ => "PlantedTests");

    [Test]
    public void Problems_RowsAsWanted_None() => Assert.That(Problems(Held + Open), Is.Empty);

    [TestCase("assets-import", "assets", "the key")]
    [TestCase("UnityCsReference 6000.0.78f1: A.cs", "", "no evidence")]
    [TestCase("\tsource\t", "\tcertain\t", "sure is 'certain'")]
    [TestCase("\tsource\t", "\texperience\t", "nobody looked it up")]
    [TestCase("UnityCsReference 6000.0.78f1", "com.unity.burst 1.6.0-pre.2", "sure as 'older'")]
    [TestCase("README.md", "Nowhere.cs", "there is no Nowhere.cs")]
    [TestCase("README.md", "-", "a test without a stand-in")]
    [TestCase("Import_Twice_ConvertsOnce", "Import_Twice", "there is no test PlantedTests.Import_Twice")]
    [TestCase("Once\t\n", "Once\t13\n", "it has no step")]
    [TestCase("\t13\n", "\t\n", "no step of try-in-unity.md shows it")]
    [TestCase("\t13\n", "\t99\n", "has no step 99")]
    [TestCase("builds-copy", "assets-import", "2 rows")]
    public void Problems_RowThatIsNot_IsReported(string part, string changed, string reported) =>
        Assert.That(Problems((Held + Open).Replace(part, changed)), Has.Some.Contains(reported));

    [Test]
    public void Parse_RowOfFiveColumns_Throws() =>
        Assert.That(() => BehaviourLedger.Parse(Header + "a-b\tc\td\te\tf\n"), Throws.TypeOf<ToolException>());

    [Test]
    public void UnverifiedTable_RowsOfSeveralSteps_AreInTheirOrder() =>
        Assert.That(BehaviourLedger.Parse(Header + Open + Held + Earlier).UnverifiedTable(),
            Does.EndWith("|---|---|\n| It is early. | 2, 15 |\n| It copies a \\| b. | 13 |\n"));

    [Test]
    public void Text_UnsortedRows_AreSorted() =>
        Assert.That(BehaviourLedger.Parse(Header + Open + Held).Text(), Is.EqualTo(Header + Held + Open));

    private static List<string> Problems(string rows) => BehaviourLedger.Parse(Header + rows)
        .Problems(new[] { Checkout.Repository.StandIns }, s_tests, new HashSet<string> { "13" }).ToList();
}
