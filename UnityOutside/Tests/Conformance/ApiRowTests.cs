namespace UnityOutside.Tests.Conformance;

public sealed class ApiRowTests
{
    [Test]
    public void Row_AsOlderGeneration_HasItsColumns()
    {
        ApiRow row = ApiRow.Parse("M:A.B\tA\tmethod\tSystem.Void\tstatic\tin x\tT:unmanaged\t\t*\t" +
            "detail{6000.0:ref x | 6000.3:ref x} constraints{6000.0:T:struct&I{``0}; U}");

        Assert.That(row.As("6000.0").Detail, Is.EqualTo("ref x"));
        Assert.That(row.As("6000.0").Constraints, Is.EqualTo("T:struct&I{``0}; U"));
        Assert.That(row.As("6000.3").Constraints, Is.EqualTo("T:unmanaged"));
        Assert.That(row.As("6000.5").Detail, Is.EqualTo("in x"));
    }

    [TestCase("", false, false)]
    [TestCase("warn", false, false)]
    [TestCase("error", true, true)]
    [TestCase("warn@6000.3,error@6000.5", false, true)]
    [TestCase("warn@6000.5,error@6000.7", false, false)]
    public void IsError_Obsolete_FromItsGenerationOn(string obsolete, bool in6000_3, bool in6000_5)
    {
        ApiRow row = ApiRow.Parse("M:A.B\tA\tmethod\tSystem.Void\t\t\t\t" + obsolete + "\t*");

        Assert.That(row.IsError("6000.3"), Is.EqualTo(in6000_3));
        Assert.That(row.IsError("6000.5"), Is.EqualTo(in6000_5));
    }

    [Test]
    public void Parameters_KindsDefaultsAndCommasInQuotes_AreReported()
    {
        ApiRow row = ApiRow.Parse("M:A.B\tA\tmethod\tSystem.Void\tstatic\tthis ref a, out b, c=\"x, y\", params d");

        Assert.That(row.Parameters().Select(p => $"{p.Kind}:{p.Name}:{p.Default}"),
            Is.EqualTo(new[] { "ref:a:", "out:b:", ":c:\"x, y\"", ":d:" }));
    }

    [Test]
    public void Compose_ParsedLine_RoundTrips()
    {
        const string line = "T:A.B\tA|UnityEngine:C\tstruct\t\tunmanaged\t\t\t\t6000.0,6000.3";

        Assert.That(ApiRow.Parse(line).Compose(), Is.EqualTo(line));
    }
}
