using FastPoints.RepoTools.Meta;

namespace FastPoints.HostTests.Repository;

public sealed class MetaFilesTests
{
    private string m_root;

    [SetUp]
    public void MakePackage()
    {
        m_root = Directory.CreateTempSubdirectory("fastpoints-meta-").FullName;
        Put("package.json", "{}");
        Put("Runtime/A/One.cs", "");
        Put("Shaders/Draw.shader", "");
        Put("Documentation~/manual.md", "");
        Put("Samples~/First/Go.cs", "");
        Put(".hidden/x.cs", "");
    }

    [TearDown]
    public void RemovePackage() => Directory.Delete(m_root, true);

    [Test]
    public void Run_NewPackage_WritesMetasOfImportedFilesOnly()
    {
        ToolResult result = new MetaFiles(m_root).Run(false);

        Assert.That(result.Problems, Is.Empty);
        string[] metas = Directory.GetFiles(m_root, "*.meta", SearchOption.AllDirectories)
            .Select(f => Path.GetRelativePath(m_root, f).Replace('\\', '/'))
            .OrderBy(f => f, System.StringComparer.Ordinal).ToArray();
        Assert.That(metas, Is.EqualTo(new[]
        {
            "Runtime.meta", "Runtime/A.meta", "Runtime/A/One.cs.meta", "Samples~/First.meta",
            "Samples~/First/Go.cs.meta", "Shaders.meta", "Shaders/Draw.shader.meta",
            "package.json.meta",
        }));
        Assert.That(Check(), Is.Empty);
    }

    [TestCase("Runtime.meta", "folderAsset: yes\nDefaultImporter:")]
    [TestCase("Runtime/A/One.cs.meta", "\nMonoImporter:\n")]
    [TestCase("Shaders/Draw.shader.meta", "\nShaderImporter:\n")]
    [TestCase("package.json.meta", "\nPackageManifestImporter:\n")]
    public void Run_NewPackage_NamesTheImporter(string meta, string block)
    {
        new MetaFiles(m_root).Run(false);

        Assert.That(File.ReadAllText(Path.Combine(m_root, meta)),
            Does.StartWith("fileFormatVersion: 2\nguid: ").And.Contain(block));
    }

    [Test]
    public void Run_FileMovedWithItsMeta_LeavesTheMetaAlone()
    {
        new MetaFiles(m_root).Run(false);
        string meta = Read("Runtime/A/One.cs.meta");
        Move("Runtime/A/One.cs", "Runtime/A/Two.cs");
        Move("Runtime/A/One.cs.meta", "Runtime/A/Two.cs.meta");
        new MetaFiles(m_root).Run(false);

        Assert.That(Read("Runtime/A/Two.cs.meta"), Is.EqualTo(meta));
    }

    [Test]
    public void Run_FileMovedWithoutItsMeta_KeepsItsGuid()
    {
        new MetaFiles(m_root).Run(false);
        string meta = Read("Runtime/A/One.cs.meta");
        Directory.CreateDirectory(Path.Combine(m_root, "Runtime/B"));
        Move("Runtime/A/One.cs", "Runtime/B/One.cs");
        new MetaFiles(m_root).Run(false);

        Assert.That(Read("Runtime/B/One.cs.meta"), Is.EqualTo(meta));
        Assert.That(Check(), Is.Empty);
    }

    [Test]
    public void Run_NewFileAtAnOldPath_GetsAnotherGuid()
    {
        new MetaFiles(m_root).Run(false);
        Move("Runtime/A/One.cs", "Runtime/A/Two.cs");
        Move("Runtime/A/One.cs.meta", "Runtime/A/Two.cs.meta");
        Put("Runtime/A/One.cs", "");
        ToolResult result = new MetaFiles(m_root).Run(false);

        Assert.That(result.Problems, Is.Empty);
        Assert.That(MetaText.Parse(Read("Runtime/A/One.cs.meta")).Guid,
            Is.Not.EqualTo(MetaText.Parse(Read("Runtime/A/Two.cs.meta")).Guid));
    }

    [Test]
    public void Check_FileWithoutMeta_IsReported() => Assert.That(Check(), Has.Some.Contains("One.cs: no .meta"));

    [Test]
    public void Check_MetaWithoutFile_IsReported()
    {
        new MetaFiles(m_root).Run(false);
        File.Delete(Path.Combine(m_root, "Shaders/Draw.shader"));

        Assert.That(Check(), Has.Some.Contains("Draw.shader.meta: nothing beside it"));
    }

    [Test]
    public void Check_GuidGivenTwice_IsReported()
    {
        new MetaFiles(m_root).Run(false);
        Put("Runtime/A/Copy.cs", "");
        File.Copy(Path.Combine(m_root, "Runtime/A/One.cs.meta"), Path.Combine(m_root, "Runtime/A/Copy.cs.meta"));

        Assert.That(Check(), Has.Some.Contains("is given twice: Runtime/A/Copy.cs.meta, Runtime/A/One.cs.meta"));
    }

    [TestCase("guid: 0123", "guid")]
    [TestCase("fileFormatVersion: 2\nguid: 0123456789abcdef0123456789abcdef\nTextScriptImporter:\n", "wanted MonoImporter")]
    public void Check_MalformedMeta_IsReported(string text, string reported)
    {
        new MetaFiles(m_root).Run(false);
        Put("Runtime/A/One.cs.meta", text);

        Assert.That(Check(), Has.Some.Contains("One.cs.meta").And.Some.Contains(reported));
    }

    [Test]
    public void Package_Committed_HasItsMetas() =>
        Assert.That(new MetaFiles(Checkout.Repository.PackageRoot).Run(true).Problems, Is.Empty);

    private System.Collections.Generic.IReadOnlyList<string> Check() => new MetaFiles(m_root).Run(true).Problems;
    private string Read(string path) => File.ReadAllText(Path.Combine(m_root, path));
    private void Move(string from, string to) => File.Move(Path.Combine(m_root, from), Path.Combine(m_root, to));

    private void Put(string path, string text)
    {
        string file = Path.Combine(m_root, path);
        Directory.CreateDirectory(Path.GetDirectoryName(file));
        File.WriteAllText(file, text);
    }
}
