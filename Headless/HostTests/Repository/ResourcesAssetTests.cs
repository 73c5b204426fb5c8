namespace FastPoints.HostTests.Repository;

public sealed class ResourcesAssetTests
{
    static string Package => Path.Combine(Checkout.Repository.Root, "Packages", "com.fastpoints.dots");

    static string GuidOf(string file) =>
        Regex.Match(File.ReadAllText(Path.Combine(Package, file + ".meta")), @"^guid: ([0-9a-f]{32})$",
            RegexOptions.Multiline).Groups[1].Value;

    /// <summary>Each public field, each shader file of the package, by Unity's number for its kind.</summary>
    [Test]
    public void Asset_OfThePackage_RefersToItsScriptAndAllShaders()
    {
        const string Folder = "Runtime/FastPoints.Rendering/";
        string asset = File.ReadAllText(Path.Combine(Package, Folder + "Resources", PointCloudResources.Path + ".asset"));
        Assert.That(asset,
            Does.Contain("m_Script: {fileID: 11500000, guid: " + GuidOf(Folder + "PointCloudResources.cs") + ", type: 3}"));
        foreach (var field in typeof(PointCloudResources).GetFields().Where(f => !f.IsStatic))
            Assert.That(asset, Does.Match(@"(?m)^  " + field.Name + @": \{fileID: (4800000|7200000), guid: "), field.Name);
        foreach (string file in Directory.GetFiles(Path.Combine(Package, "Shaders")).Select(Path.GetFileName))
        {
            string id = file.EndsWith(".shader") ? "4800000" : file.EndsWith(".compute") ? "7200000" : null;
            if (id != null)
                Assert.That(asset, Does.Contain("{fileID: " + id + ", guid: " + GuidOf("Shaders/" + file) + ", type: 3}"), file);
        }
    }
}
