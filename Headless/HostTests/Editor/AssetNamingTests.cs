using Random = System.Random;

namespace FastPoints.HostTests.Editor;

public sealed class AssetNamingTests
{
    [TestCase("scan", "scan")]
    [TestCase("scan 2.copc", "scan 2.copc")]
    [TestCase("a/b\\c:d*e?f\"g<h>i|j", "a_b_c_d_e_f_g_h_i_j")]
    [TestCase("tab\tnew\nline", "tab_new_line")]
    [TestCase("  .hidden", "hidden")]
    [TestCase("backup~", "backup")]
    [TestCase("ends. . .", "ends")]
    [TestCase("...", "cloud")]
    [TestCase("", "cloud")]
    [TestCase("con", "_con")]
    [TestCase("LPT1.north", "_LPT1.north")]
    [TestCase("NUL .x", "_NUL .x")]
    [TestCase("conout$", "_conout$")]
    [TestCase("COM\u00B2.x", "_COM\u00B2.x")]
    [TestCase("console", "console")]
    [TestCase("\uD83D\uDE00", "\uD83D\uDE00")]
    public void Safe_AnyName_IsOneForEverySystem(string name, string wanted) =>
        Assert.That(AssetNaming.Safe(name), Is.EqualTo(wanted));

    [Test]
    public void Safe_ComposedAndDecomposedName_AreOne() =>
        Assert.That(AssetNaming.Safe("u\u0308ber"), Is.EqualTo("u\u0308ber".Normalize()));

    [Test]
    public void Safe_HalfACharacter_IsReplaced()
    {
        Assert.That(AssetNaming.Safe("\uD83Dalone"), Is.EqualTo("_alone"));
        Assert.That(AssetNaming.Safe("alone\uDE00"), Is.EqualTo("alone_"));
    }

    [TestCase("a")]
    [TestCase("\u00E9")]
    [TestCase("\u6F22")]
    [TestCase("\uD83D\uDE00")]
    public void Safe_LongName_IsCutBetweenCharacters(string character)
    {
        string safe = AssetNaming.Safe(string.Concat(System.Linq.Enumerable.Repeat(character, 500)));

        Assert.That(Encoding.UTF8.GetByteCount(safe), Is.LessThanOrEqualTo(AssetNaming.MaxBytes)
            .And.GreaterThan(AssetNaming.MaxBytes - Encoding.UTF8.GetByteCount(character)));
        Assert.That(safe.Length % character.Length, Is.Zero, "no character is cut in two");
    }

    [Test]
    public void Safe_OfASafeName_IsTheName()
    {
        var random = new Random(8);
        const string odd = "ab .~_/:CONnul1\u00FC\u0308\u0131\u6F22\uD83D\uDE00\t";
        for (int i = 0; i < 5000; i++)
        {
            var name = new StringBuilder();
            for (int c = random.Next(12); c >= 0; c--)
                name.Append(odd[random.Next(odd.Length)]);
            string safe = AssetNaming.Safe(name.ToString());
            Assert.That(AssetNaming.Safe(safe), Is.EqualTo(safe), name.ToString());
        }
    }

    [Test]
    public void Next_NamesThatDifferInCaseAlone_GetNumbers()
    {
        var names = new FreePaths("", "", new string[0]);
        foreach (string wanted in new[] { "scan", "Scan 2", "SCAN 3", "scan 2 2" })
            Assert.That(names.Next(wanted == "scan 2 2" ? "scan 2" : "SCAN"), Is.EqualTo(wanted).IgnoreCase);
        Assert.That(new FreePaths("in", ".x", new[] { Path.Combine("in", "Scan.x") }).Next("scan"),
            Is.EqualTo(Path.Combine("in", "scan 2.x")));
    }
}
