namespace UnityOutside.Tests.Threads;

public sealed class ThreadTableTests
{
    [TestCase("P:A.B\tmain\tset:extern; get:any", "get", "6000.0", "any")]
    [TestCase("P:A.B\tmain\tset:extern; get:any", "set", "6000.0", "main")]
    [TestCase("P:A.B\tmain\textern", "get", "6000.0", "main")]
    [TestCase("M:A.B\tmain\textern\tany@6000.3", "", "6000.0", "main")]
    [TestCase("M:A.B\tmain\textern\tany@6000.3", "", "6000.3", "any")]
    [TestCase("M:A.B\tmain\textern\tany@6000.3", "", "6000.5", "any")]
    [TestCase("M:A.B\tunknown\tabstract\tfrom 6000.3,any@6000.5", "", "6000.3", "unknown")]
    [TestCase("M:A.B\tunknown\tabstract\tfrom 6000.3,any@6000.5", "", "6000.5", "any")]
    public void Row_OfAGeneration_MatchesItsColumns(string line, string accessor, string generation, string expected) =>
        Assert.That(ThreadRow.Parse(line).In(generation, accessor), Is.EqualTo(expected));

    [Test]
    public void Table_Read_HasItsLinesAndRecordsLookups()
    {
        ThreadTable table = ThreadTable.Read(new StringReader(ThreadRow.Header + "\nM:A.B\tany\tpure\nM:A.C\tmain\textern\n"));

        Assert.That(table.Find("M:A.C").Threads, Is.EqualTo("main"));
        Assert.That(table.Find("M:A.D"), Is.Null);
        Assert.That(table.Touched, Is.EqualTo(new[] { new ThreadRow("M:A.C", "main", "extern", "") }));
    }
}
