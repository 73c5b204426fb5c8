namespace FastPoints.HostTests.Manual;

public sealed class ManualFactsTests
{
    static readonly Assembly[] s_assemblies =
    {
        typeof(JobCoroutine).Assembly, typeof(PointReaders).Assembly, typeof(PointRenderer).Assembly,
        typeof(PointCloudSettings).Assembly, typeof(EditorImports).Assembly, typeof(PreviewPicture).Assembly,
        typeof(FastPoints.Surface.PointCloudCollider).Assembly,
    };

    static readonly Lazy<Dictionary<string, Type>> s_types = new(() => s_assemblies.SelectMany(a => a.GetTypes())
        .Where(t => t.IsPublic && !t.Name.Contains('`', StringComparison.Ordinal)).GroupBy(t => t.Name)
        .ToDictionary(g => g.Key, g => g.First()));

    static JsonElement Manifest()
    {
        using JsonDocument json =
            JsonDocument.Parse(File.ReadAllText(Path.Combine(Checkout.Repository.PackageRoot, "package.json")));
        return json.RootElement.Clone();
    }

    [Test]
    public void Versions_OnTheInstallPage_AreThePackages()
    {
        var page = ManualPage.Of("install.md");
        var manifest = Manifest();
        var wanted = manifest.GetProperty("dependencies").EnumerateObject().Select(d => "`" + d.Name + "` " + d.Value.GetString())
            .Prepend("Unity " + manifest.GetProperty("unity").GetString() + " or later");

        Assert.That(page.TableUnder("## What it needs").Select(r => r[0] + " " + r[1]), Is.EqualTo(wanted));
    }

    /// <summary>A git URL that ends in what is no tag installs nothing.</summary>
    [Test]
    public void Tags_OfGitUrls_AreThere() => Assert.That(ManualPage.All()
        .SelectMany(p => Regex.Matches(p.Text, @"com\.fastpoints\.dots#([\w.-]+)").Select(m => m.Groups[1].Value))
        .Except(Tags()), Is.Empty);

    static string[] Tags()
    {
        var start = new ProcessStartInfo("git", "tag --list")
        {
            WorkingDirectory = Checkout.Repository.Root,
            RedirectStandardOutput = true,
        };
        using var git = Process.Start(start);
        string output = git.StandardOutput.ReadToEnd();
        git.WaitForExit();
        Assert.That(git.ExitCode, Is.Zero);
        return output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
    }

    [Test]
    public void GitUrls_OfAllPages_NameThePackagesFolder()
    {
        var paths = ManualPage.All().SelectMany(p => Regex.Matches(p.Text, @"\?path=(/[\w./-]*[\w])"))
            .Select(m => m.Groups[1].Value).ToList();

        Assert.That(paths, Is.Not.Empty);
        Assert.That(paths.Where(p => !File.Exists(Checkout.Repository.Root + p + "/package.json")), Is.Empty);
    }

    [Test]
    public void Samples_OfThePackage_AreNamedInTheManual()
    {
        string pages = string.Concat(ManualPage.All()
            .Where(p => p.Path.Contains("/Documentation~/", StringComparison.Ordinal)).Select(p => p.Text));

        Assert.That(Manifest().GetProperty("samples").EnumerateArray().Select(s => s.GetProperty("displayName").GetString())
            .Where(n => !pages.Contains(n, StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void Assemblies_OnTheApiPage_AreThePackages() => Assert.That(
        ManualPage.Of("api.md").TableUnder("## Assemblies").Select(r => r[0].Trim('`')),
        Is.EquivalentTo(s_assemblies.Select(a => a.GetName().Name)));

    [Test]
    public void Components_OfThePackage_AreOnTheApiPage()
    {
        var page = ManualPage.Of("api.md");
        var named = page.TableUnder("## Components of GameObjects").Concat(page.TableUnder("## Components of entities"))
            .SelectMany(r => ManualPage.Code(r[0]));
        var types = typeof(PointCloudSettings).Assembly.GetTypes().Concat(typeof(PointFileReaders).Assembly.GetTypes())
            .Concat(typeof(FastPoints.Surface.PointCloudCollider).Assembly.GetTypes())
            .Where(t => t.IsPublic && !t.IsAbstract &&
            (typeof(MonoBehaviour).IsAssignableFrom(t) || typeof(IComponentData).IsAssignableFrom(t) ||
                typeof(IBufferElementData).IsAssignableFrom(t)));

        Assert.That(named, Is.EquivalentTo(types.Select(t => t.Name)));
    }

    [Test]
    public void Beginnings_OnTheApiPage_Exist() => Assert.That(
        ManualPage.Of("api.md").TableUnder("## Where to begin").SelectMany(r =>
            ManualPage.Code(r[1])).Where(n => !IsThere(n)), Is.Empty);

    [TestCase("ConvertCloud.Run", true)]
    [TestCase("ConvertCloud.Walk", false)]
    [TestCase("ConvertClouds", false)]
    public void Exists_NameOfTheApi_IsDistinguished(string name, bool exists) =>
        Assert.That(IsThere(name), Is.EqualTo(exists));

    /// <summary>Pages speak of types of the package by names that begin with Point, Cloud or Stream: others may be
    /// Unity's.</summary>
    [Test]
    public void TypesInCode_OfTheTaskPages_Exist()
    {
        string[] pages = { "show.md", "style.md", "run-time.md", "players.md", "performance.md",
            "troubleshooting.md", "api.md", "internals/streaming.md" };
        var missing = pages.Select(ManualPage.Of).SelectMany(p => ManualPage.Code(ReferenceBlock.Remove(p.Text))
            .Where(c => Regex.IsMatch(c, @"^(Point|Cloud|Stream|Convert|Preview)[A-Z]\w+(\.\w+)?(\(\))?$"))
            .Where(c => !IsThere(c.TrimEnd('(', ')')))
            .Select(c => p.Name + ": " + c));

        Assert.That(missing, Is.Empty);
    }

    static bool IsThere(string name)
    {
        string[] parts = name.Split('.');
        return s_types.Value.TryGetValue(parts[0], out var type) ? parts.Length == 1 || type.GetMember(parts[1]).Length > 0
            : Enum.GetNames(typeof(ColorMode)).Contains(name);
    }
}
