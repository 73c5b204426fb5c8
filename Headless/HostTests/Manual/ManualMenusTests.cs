namespace FastPoints.HostTests.Manual;

public sealed class ManualMenusTests
{
    static readonly string[] s_roots = { "Assets", "FastPoints", "GameObject", "Project Settings", "Tools" };

    [Test]
    public void Menus_NamedOnPages_Exist() => Assert.That(ManualPage.All().SelectMany(p => Unknown(p, Menus())), Is.Empty);

    [Test]
    public void Menus_Existing_AreNamedInTheManual()
    {
        var named = ManualPage.All().SelectMany(Named).ToHashSet();

        Assert.That(Menus().Where(m => !named.Contains(m)), Is.Empty);
    }

    [TestCase("Press *Assets > Import point clouds...* now", "Import point clouds")]
    [TestCase("*FastPoints > Point Clod*", "Point Clod")]
    [TestCase("*Project Settings > Fastpoints*", "Fastpoints")]
    public void UnknownMenus_PlantedMenu_IsFound(string text, string menu) =>
        Assert.That(Unknown(new ManualPage("a.md", text), Menus()), Has.Some.Contains(menu));

    [TestCase("*FastPoints > Samples*")]
    [TestCase("*Window > General > Progress*")]
    public void UnknownMenus_SubmenuAndUnitysOwn_AreKnown(string text) =>
        Assert.That(Unknown(new ManualPage("a.md", text), Menus()), Is.Empty);

    static HashSet<string> Menus()
    {
        var types = new[] { typeof(PointCloudSettings).Assembly, typeof(EditorImports).Assembly,
            typeof(PointFileReaders).Assembly, typeof(FastPoints.Surface.PointCloudCollider).Assembly,
            Assembly.Load("FastPoints.Samples"),
            Assembly.Load("FastPoints.Samples.Editor") }.SelectMany(a => a.GetTypes()).ToList();
        var methods = types.SelectMany(t => t.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic))
            .ToList();
        var menus = types.Select(t => t.GetCustomAttribute<AddComponentMenu>()?.componentMenu)
            // A component without a name of its own cannot be added by menu.
            .Where(m => !string.IsNullOrEmpty(m))
            .Where(m => !m.StartsWith("FastPoints/Samples/", StringComparison.Ordinal))
            .Concat(methods.Select(m => m.GetCustomAttribute<MenuItem>())
                .Where(m => m != null && !m.validate).Select(m => m.menuItem))
            .Concat(methods.Where(m => m.GetCustomAttribute<SettingsProviderAttribute>() != null)
                .Select(m => ((SettingsProvider)m.Invoke(null, null)).settingsPath.Replace("Project/", "Project Settings/")));
        return menus.Select(m => m.Replace("/", " > ")).ToHashSet();
    }

    static IEnumerable<string> Named(ManualPage page) =>
        Regex.Matches(page.Text, @"\*([^*\n]+ > [^*\n]+)\*").Select(m => m.Groups[1].Value);

    static IEnumerable<string> Unknown(ManualPage page, HashSet<string> menus) => Named(page)
        .Where(n => s_roots.Contains(n[..n.IndexOf(" > ", StringComparison.Ordinal)]))
        .Where(n => !menus.Any(m => m == n || m.StartsWith(n + " > ", StringComparison.Ordinal)))
        .Select(n => page.Path + ": " + n);
}
