namespace FastPoints.HostTests.Manual;

public sealed class ManualCommandsTests
{
    /// <summary>Options by verb; those of the main job under an empty name.</summary>
    static readonly Lazy<Dictionary<string, HashSet<string>>> s_options = new(() => Verbs().Append("")
        .ToDictionary(v => v, v => Options(CliCall.Of(v.Length == 0 ? new[] { "--help" } : new[] { v, "--help" }).Output)));

    [Test]
    public void Commands_OfAllPages_Parse() => Assert.That(ManualPage.All().SelectMany(Problems), Is.Empty);

    [Test]
    public void Options_InText_AreThoseOfSomeCommand() => Assert.That(ManualPage.All().SelectMany(UnknownOptions), Is.Empty);

    [Test]
    public void Verbs_OfTheCommandLine_AreOnTheServersPage() => Assert.That(Verbs().Where(v =>
        !ManualPage.Of("server.md").Text.Contains("./fastpoints " + v, StringComparison.Ordinal)), Is.Empty);

    [TestCase("    ./fastpoints transform a.las\n", "transform")]
    [TestCase("    ./fastpoints convert a.las -o b --ram 3\n", "--ram")]
    [TestCase("`./fastpoints picture a -o p.png --style colour=rgb`", "colour")]
    [TestCase("`./fastpoints picture a -o p.png --style edl=-1`", "edl")]
    public void Problems_PlantedCommand_IsFound(string text, string wrong) =>
        Assert.That(Problems(new ManualPage("a.md", text)), Has.Some.Contains(wrong));

    [Test]
    public void UnknownOptions_PlantedOption_IsFound() =>
        Assert.That(UnknownOptions(new ManualPage("a.md", "With `--memmory` it is bounded")), Has.Some.Contains("--memmory"));

    static List<string> Verbs()
    {
        string help = CliCall.Of("--help").Output;
        var verbs = Regex.Matches(help, @"^  ([a-z][a-z-]+)\s", RegexOptions.Multiline).Select(m => m.Groups[1].Value).ToList();
        Assert.That(verbs, Does.Contain("convert").And.Contain("demo-cloud"));
        return verbs;
    }

    static HashSet<string> Options(string text) => Regex.Matches(text, @"--[a-z][a-z-]*").Select(m => m.Value)
        .Append("--help").ToHashSet();

    static IEnumerable<string> Problems(ManualPage page)
    {
        foreach (Match call in Regex.Matches(page.Text, @"\./fastpoints ([^`#\n]*)"))
        {
            string[] words = call.Groups[1].Value.Split(' ', StringSplitOptions.RemoveEmptyEntries);
            if (words.Length == 0)
                continue;
            bool isVerb = s_options.Value.ContainsKey(words[0]);
            // The main job takes files: a word without a suffix in small letters is a verb, or would be.
            if (!isVerb && Regex.IsMatch(words[0], "^[a-z][a-z-]*$"))
                yield return page.Path + ": no verb " + words[0];
            var options = s_options.Value[isVerb ? words[0] : ""];
            foreach (string option in words.Where(w => w.StartsWith("--", StringComparison.Ordinal)).SelectMany(Options))
                if (!options.Contains(option))
                    yield return page.Path + ": no option " + option + " in " + call.Value;
            for (int i = 0; i + 1 < words.Length; i++)
                if (words[i] == "--style" && words[i + 1].Contains('=', StringComparison.Ordinal))
                    foreach (string problem in StyleProblems(words[i + 1]))
                        yield return page.Path + ": " + problem;
        }
    }

    static IEnumerable<string> StyleProblems(string style)
    {
        foreach (string pair in style.Split(',').Where(p => !p.Contains("...", StringComparison.Ordinal)))
        {
            string[] parts = pair.Split('=');
            if (new PictureOptions().SetStyle(parts[0], parts[^1]) is { } error)
                yield return pair + ": " + error;
        }
    }

    static IEnumerable<string> UnknownOptions(ManualPage page)
    {
        string root = Checkout.Repository.Root;
        var known = s_options.Value.Values.SelectMany(o => o).Concat(Options(File.ReadAllText(Path.Combine(root, "test"))))
            .Concat(Options(File.ReadAllText(Path.Combine(root, "Headless/RepoTools/Program.cs")))).ToHashSet();
        return ManualPage.Code(page.Text).Where(c => c.StartsWith("--", StringComparison.Ordinal)).SelectMany(Options)
            .Where(o => !known.Contains(o)).Select(o => page.Path + ": " + o);
    }
}
