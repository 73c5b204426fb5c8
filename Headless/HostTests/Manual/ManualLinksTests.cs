namespace FastPoints.HostTests.Manual;

public sealed class ManualLinksTests
{
    [Test]
    public void Links_OfAllPages_Resolve() => Assert.That(ManualPage.All().SelectMany(Broken), Is.Empty);

    [Test]
    public void TableOfContents_HasEachPageOnce()
    {
        string folder = Path.Combine(Checkout.Repository.PackageRoot, "Documentation~");
        var pages = Directory.GetFiles(folder, "*.md", SearchOption.AllDirectories)
            .Select(f => Path.GetRelativePath(folder, f).Replace('\\', '/')).Where(n => n != "TableOfContents.md");

        Assert.That(ManualPage.Of("TableOfContents.md").Links(), Is.EquivalentTo(pages));
    }

    [Test]
    public void Pictures_OfTheManual_AreShownAndSmall()
    {
        string root = Checkout.Repository.Root;
        var shown = ManualPage.All().SelectMany(p => p.Links().Select(l => Path.GetFullPath(Path.Combine(root,
            Path.GetDirectoryName(p.Path), l.Split('#')[0])))).ToHashSet();
        var pictures = Directory.GetFiles(Path.Combine(Checkout.Repository.PackageRoot, "Documentation~", "images"), "*",
            SearchOption.AllDirectories);

        Assert.That(pictures.Where(p => !shown.Contains(p)), Is.Empty);
        Assert.That(pictures.Where(p => Path.GetFileName(p).StartsWith("style-", StringComparison.Ordinal) &&
            new FileInfo(p).Length > 150_000), Is.Empty);
    }

    [TestCase("[a](absent.md)", "absent.md")]
    [TestCase("[a](install.md#no-such-heading)", "install.md#no-such-heading")]
    [TestCase("![a](images/absent.png)", "images/absent.png")]
    public void BrokenLinks_PlantedLink_IsFound(string text, string link) => Assert.That(
        Broken(new ManualPage("Packages/com.fastpoints.dots/Documentation~/planted.md", text)), Has.Some.Contains(link));

    [TestCase("[a](install.md#by-git-url)")]
    [TestCase("`[a](absent.md)`")]
    [TestCase("[a](https://semver.org/)")]
    public void BrokenLinks_GoodLink_FindsNone(string text) => Assert.That(
        Broken(new ManualPage("Packages/com.fastpoints.dots/Documentation~/planted.md", text)), Is.Empty);

    static IEnumerable<string> Broken(ManualPage page)
    {
        foreach (string link in page.Links().Where(l => !l.Contains("://", StringComparison.Ordinal)))
        {
            string[] parts = link.Split('#');
            string path = parts[0].Length == 0 ? Path.Combine(Checkout.Repository.Root, page.Path)
                : Path.Combine(Checkout.Repository.Root, Path.GetDirectoryName(page.Path), parts[0]);
            bool exists = File.Exists(path) || Directory.Exists(path) || parts[0].Length == 0;
            if (!exists || (parts.Length > 1 && !Target(page, path).Anchors().Contains(parts[1])))
                yield return page.Path + ": " + link;
        }
    }

    static ManualPage Target(ManualPage page, string path) =>
        path.EndsWith(page.Path, StringComparison.Ordinal) ? page : new ManualPage(path, File.ReadAllText(path));
}
