namespace FastPoints.HostTests.Conformance;

/// <summary>Hard codes and texts from other projects, with units by PROJ's projinfo 9.1.1.</summary>
public sealed class CoordinateSystemConformanceTests
{
    const double Digits = 1e-10; // projinfo prints 15 digits.

    static string Here(string file) => Path.Combine(Checkout.Repository.Headless, "HostTests", "Conformance", file);

    static double Metres(string text) => text == "deg" ? double.NaN : text == "-" ? 0
        : double.Parse(text, CultureInfo.InvariantCulture);

    [Test]
    public void Codes_OfEpsg_HaveTheUnitsOfProj() => Assert.Multiple(() =>
    {
        var lines = File.ReadAllLines(Here("crs-codes.tsv")).Select(l => l.Split('\t')).ToList();
        Assert.That(lines, Has.Count.EqualTo(100));
        foreach (string[] line in lines)
        {
            var system = EpsgTable.Find(int.Parse(line[0]));
            Assert.That(system?.MetresPerUnit, Is.EqualTo(Metres(line[2])).Within(Digits).Percent, line[0]);
            Assert.That(system?.VerticalMetresPerUnit, Is.EqualTo(Metres(line[3])).Within(Digits).Percent, line[0]);
        }
    });

    [Test]
    public void Texts_OfAllKinds_HaveTheStatedUnits() => Assert.Multiple(() =>
    {
        using var texts = JsonDocument.Parse(File.ReadAllText(Here("crs-texts.json")));
        Assert.That(texts.RootElement.GetArrayLength(), Is.EqualTo(20));
        foreach (var text in texts.RootElement.EnumerateArray())
        {
            var info = new SourceInfo();
            Assert.That(CrsText.Read(text.GetProperty("text").GetString(), info.Crs));
            CrsText.Complete(info);
            var vertical = text.GetProperty("vertical");
            Assert.That(info.Crs.MetresPerUnit, Is.EqualTo(Metres(text.GetProperty("horizontal").ToString())).Within(1e-14),
                info.Crs.Name);
            Assert.That(info.Crs.VerticalMetresPerUnit,
                Is.EqualTo(vertical.ValueKind == JsonValueKind.Null ? 0 : vertical.GetDouble()).Within(1e-14), info.Crs.Name);
        }
    });
}
