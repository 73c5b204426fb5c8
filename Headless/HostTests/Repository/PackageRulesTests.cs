namespace FastPoints.HostTests.Repository;

public sealed class PackageRulesTests
{
    const string Asmdef = "{ \"name\": \"NAME\", \"references\": [\"Unity.Burst\"], \"includePlatforms\": [PLATFORMS], "
        + "\"precompiledReferences\": [REFERENCES], "
        + "\"defineConstraints\": [DEFINES] }";
    const string Described = "Something that is described in more than fifty characters, as it should be.";

    string m_root;

    string Package => Path.Combine(m_root, "Packages", "com.fastpoints.dots");

    [SetUp]
    public void MakePackage()
    {
        m_root = Directory.CreateTempSubdirectory("fastpoints-package-").FullName;
        Put("package.json", $$"""
            { "name": "com.fastpoints.dots", "version": "1.2.0", "displayName": "Fast Points", "unity": "6000.0",
              "license": "MIT", "description": "{{Described}}",
              "dependencies": { "com.unity.burst": "1.8.21" },
              "samples": [ { "displayName": "First", "description": "The first.", "path": "Samples~/First" } ] }
            """);
        Put("CHANGELOG.md", "# Changelog\n\n## [1.2.0] - 2026-03-04\n\n### Added\n- [a] thing\n\n## [1.1.0] - 2026-01-02\n");
        Put("LICENSE.md", "MIT License");
        Put("Third Party Notices.md", "Data of others.");
        Put("README.md", "[Manual](Documentation~/index.md)");
        Put("Documentation~/index.md", "Put `Cloud` on a GameObject. See [above](../README.md), [here](#there) and "
            + "[there](https://example.org).");
        Put("Samples~/First/Start.cs", "");
        PutAsmdef("Samples~/First/Samples.First.asmdef");
        Put("Runtime/A/Cloud.cs", "// UnityEditor is not here\n"
            + "#if UNITY_EDITOR\nusing UnityEditor;\n#endif\npublic sealed class Cloud : MonoBehaviour\n{\n}");
        Put("Runtime/A/Cloud.cs.meta", "");
        PutAsmdef("Runtime/A/A.asmdef");
        Put("Editor/E.cs", "using UnityEditor;");
        PutAsmdef("Editor/A.Editor.asmdef", "\"Editor\"");
        PutAsmdef("Tests/T/T.asmdef", "", "\"nunit.framework.dll\"", "\"UNITY_INCLUDE_TESTS\"");
        PutAsmdef("Benchmarks/B/B.asmdef", "", "", "\"UNITY_INCLUDE_TESTS\"");
    }

    [TearDown]
    public void RemovePackage() => Directory.Delete(m_root, true);

    void Put(string file, string text)
    {
        string path = Path.Combine(Package, file);
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllText(path, text);
    }

    void PutAsmdef(string file, string platforms = "", string references = "", string defines = "") => Put(file,
        Asmdef.Replace("NAME", Path.GetFileNameWithoutExtension(file)).Replace("PLATFORMS", platforms)
            .Replace("REFERENCES", references)
            .Replace("DEFINES", defines));

    void Change(string file, string from, string to)
    {
        string text = File.ReadAllText(Path.Combine(Package, file));
        Assert.That(text, Does.Contain(from));
        Put(file, text.Replace(from, to));
    }

    string[] Problems(string tag = null) => PackageCommand.Run(new RepoTools.Repository(m_root), tag, null).Problems.ToArray();

    [Test]
    public void Check_ValidPackage_FindsNothing() => Assert.That(Problems(), Is.Empty);

    [Test]
    public void Check_WithoutSamples_FindsNothing()
    {
        Directory.Delete(Path.Combine(Package, "Samples~"), true);
        Change("package.json", "{ \"displayName\": \"First\", \"description\": \"The first.\", \"path\": "
            + "\"Samples~/First\" }", "");

        Assert.That(Problems(), Is.Empty);
    }

    [TestCase("UnityEngine:IMGUI", "", "com.unity.modules.imgui: wanted 1.0.0, since it is used")]
    [TestCase("UnityEngine:Core", ", \"com.unity.modules.imgui\": \"1.0.0\"", "com.unity.modules.imgui: wanted none")]
    [TestCase("UnityEngine:IMGUI", ", \"com.unity.modules.imgui\": \"1.0.0\"", null)]
    [TestCase("Unity.Mathematics|UnityEngine:Mathematics", "", null)]
    public void Check_EngineModules_AreTheUsedOnes(string assembly, string dependency, string problem)
    {
        Directory.CreateDirectory(Path.Combine(m_root, "Headless", "Api"));
        string used = Path.Combine(m_root, "Headless", "Api", "used.tsv");
        File.WriteAllText(used, "id\tassembly\nT:UnityEngine.X\t" + assembly + "\n");
        Change("package.json", "\"1.8.21\"", "\"1.8.21\"" + dependency);

        Assert.That(Problems(), problem == null ? Is.Empty : Has.Length.EqualTo(1).And.Some.Contains(problem));
    }

    [Test]
    public void Check_ThisPackage_FindsNothing() =>
        Assert.That(PackageCommand.Run(Checkout.Repository, null, null).Problems, Is.Empty);

    [TestCase("File.Replace(a, b, null);", "File.Replace")]
    [TestCase("System.IO.File.Move(a, b);", "System.IO.File.Move")]
    [TestCase("File.Delete(a);", "File.Delete")]
    [TestCase("File.Copy(a, b, true);", "File.Copy")]
    [TestCase("Directory.Move(a, b);", "Directory.Move")]
    [TestCase("Directory.Delete(a, true);", "Directory.Delete")]
    [TestCase("new FileInfo(a).MoveTo(b);", ".MoveTo")]
    [TestCase("using var s = new FileStream(a, FileMode.Open);", "new FileStream")]
    [TestCase("FileUtil.DeleteFileOrDirectory(a);", "FileUtil.DeleteFileOrDirectory")]
    public void Check_FilesAreChangedElsewhere_IsAProblem(string code, string found)
    {
        foreach (string folder in new[] { "Runtime/A/B.cs", "Editor/B.cs" })
        {
            Put(folder, "class B\n{\n    void C()\n    {\n        // " + code + "\n        " + code + "\n    }\n}");
            Assert.That(Problems(), Is.EqualTo(new[]
            {
                folder + ":6: " + found + ": FileChanges does this, and tries again what Windows refuses",
            }));
            File.Delete(Path.Combine(Package, folder));
        }
        Put("Runtime/A/Core/FileChanges.cs", code);
        Put("Tests/T/B.cs", code);
        Assert.That(Problems(), Is.Empty);
    }

    [Test]
    public void Workflow_OfARelease_DatesTheChangelogOnceAllTestsHavePassed()
    {
        string workflow = File.ReadAllText(Path.Combine(Checkout.Repository.Root, ".github", "workflows", "release.yml"));
        Assert.That(workflow, Does.Contain("uses: ./.github/workflows/test.yml").And.Contain("needs: test"));
        Change("CHANGELOG.md", "[1.2.0] - 2026-03-04", "[Unreleased]");
        Assert.That(Problems("v1.2.0"), Has.Some.Contains("wanted the entry [1.2.0]"));
        string line = workflow.Split('\n').Single(l => l.Contains("run: sed")).Trim()["run: ".Length..];
        var start = new System.Diagnostics.ProcessStartInfo("bash", new[] { "-c", line }) { WorkingDirectory = m_root };
        start.Environment["GITHUB_REF_NAME"] = "v1.2.0";
        using (var shell = System.Diagnostics.Process.Start(start))
            shell.WaitForExit();
        Assert.That(Problems("v1.2.0"), Is.Empty);
    }

    [TestCase("package.json", "\"1.2.0\"", "\"1.2\"", "version: wanted a semantic version, got \"1.2\"")]
    [TestCase("package.json", "com.fastpoints.dots", "com.FastPoints", "name: wanted")]
    [TestCase("package.json", "Fast Points", "Fast: Points", "displayName: wanted")]
    [TestCase("package.json", Described, "Short.", "description: wanted")]
    [TestCase("package.json", "6000.0", "6000.0.78f1", "unity: wanted MAJOR.MINOR")]
    [TestCase("package.json", "\"unity\"", "\"unityRelease\": \"78\", \"unity\"", "unityRelease: wanted")]
    [TestCase("package.json", "\"MIT\"", "\"\"", "license: wanted")]
    [TestCase("package.json", "1.8.21", "^1.8", "dependencies.com.unity.burst: wanted one version")]
    [TestCase("package.json", "The first.", "", "wanted a displayName and a description")]
    [TestCase("package.json", "Samples~/First", "Samples~/Second", "Samples~/Second\": there is no such folder")]
    [TestCase("package.json", "Samples~/First", "Samples~/Second", "Samples~/First is not among the samples")]
    [TestCase("CHANGELOG.md", "[1.2.0]", "[1.3.0]", "wanted [1.2.0] or [Unreleased] first, got [1.3.0]")]
    [TestCase("CHANGELOG.md", "## ", "### ", "got no entry")]
    [TestCase("CHANGELOG.md", " - 2026-03-04", "", "[1.2.0]: wanted a date as YYYY-MM-DD, got \"\"")]
    [TestCase("CHANGELOG.md", "2026-03-04", "2026-3-4", "[1.2.0]: wanted a date as YYYY-MM-DD, got \"2026-3-4\"")]
    [TestCase("CHANGELOG.md", "2026-03-04", "2025-03-04", "[1.1.0] of 2026-01-02 stands below [1.2.0] of 2025-03-04")]
    [TestCase("CHANGELOG.md", "[1.1.0]", "[1.2.0]", "[1.2.0] is there 2 times")]
    [TestCase("CHANGELOG.md", "[1.1.0]", "[1.1]", "[1.1] is no semantic version")]
    [TestCase("CHANGELOG.md", "## [1.1.0] - 2026-01-02", "## [Unreleased]", "[Unreleased] stands below [1.2.0]")]
    [TestCase("LICENSE.md", "MIT License", " ", "LICENSE.md is empty")]
    [TestCase("README.md", "index.md", "none.md", "README.md: the link to Documentation~/none.md leads nowhere")]
    [TestCase("Documentation~/index.md", "Cloud", "Clouds", "Cloud (Runtime/A/Cloud.cs) is on no page")]
    [TestCase("Runtime/A/Cloud.cs", "#if UNITY_EDITOR", "#if UNITY_6000_0_OR_NEWER", "Runtime/A/Cloud.cs: names UnityEditor")]
    [TestCase("Runtime/A/A.asmdef", "\"A\"", "\"B\"", "Runtime/A/A.asmdef: the assembly is called B")]
    [TestCase("Runtime/A/A.asmdef", "Unity.Burst", "Unity.Entities",
        "A.asmdef: references Unity.Entities and not Unity.Collections")]
    [TestCase("Samples~/First/Samples.First.asmdef", "Unity.Burst", "Unity.Entities",
        "First.asmdef: references Unity.Entities and not")]
    [TestCase("Runtime/A/A.asmdef", "[]", "[\"Editor\"]", "only an editor or a test would have it")]
    [TestCase("Editor/A.Editor.asmdef", "[\"Editor\"]", "[\"Editor\", \"iOS\"]", "wanted Editor and nothing else")]
    [TestCase("Tests/T/T.asmdef", "nunit.framework.dll", "other.dll", "no test assembly")]
    [TestCase("Tests/T/T.asmdef", "UNITY_INCLUDE_TESTS", "OTHER", "a test assembly without UNITY_INCLUDE_TESTS")]
    [TestCase("Benchmarks/B/B.asmdef", "UNITY_INCLUDE_TESTS", "OTHER", "B.asmdef: every player would have it")]
    public void Check_PlantedMistake_IsReported(string file, string from, string to, string reported)
    {
        Change(file, from, to);

        Assert.That(Problems(), Has.Some.Contains(reported));
    }

    [TestCase("Runtime/notes.txt", "nobody expects it here")]
    [TestCase("Library/x.cs", "nobody expects it here")]
    [TestCase("Runtime/small.laz.bytes", "nobody expects it here")]
    [TestCase("notes.md", "nobody expects it here")]
    [TestCase("Documentation~/picture.jpg", "nobody expects it here")]
    [TestCase("Runtime/A/.DS_Store", "a hidden file")]
    [TestCase("Runtime/Old~/x.cs", "Old~ is not at the package's top")]
    [TestCase("Samples/First/x.cs", "Samples and Samples~ are both there")]
    [TestCase("Shaders/Loose.cs", "Shaders/Loose.cs: in no assembly")]
    [TestCase("Runtime/A/0123456789012345678901234567890123456789/0123456789012345678901234567890123456789/"
        + "01234567890123456789012345678901234567890123456789.cs", "some systems take no more than 140")]
    public void Check_AFileTooMany_IsReported(string file, string reported)
    {
        Put(file, "");

        Assert.That(Problems(), Has.Some.Contains(reported));
    }

    [TestCase("README.md")]
    [TestCase("LICENSE.md")]
    [TestCase("CHANGELOG.md")]
    [TestCase("Documentation~/index.md")]
    public void Check_AFileTooFew_IsReported(string file)
    {
        File.Delete(Path.Combine(Package, file));

        Assert.That(Problems(), Does.Contain(file + " is not there"));
    }

    [TestCase("1.2.0", true)]
    [TestCase("v1.2.0", true)]
    [TestCase("v1.3.0", false)]
    public void Check_Tag_IsTheVersion(string tag, bool isRight) =>
        Assert.That(Problems(tag), isRight ? Is.Empty : Has.Some.Contains("the tag: wanted 1.2.0"));

    [Test]
    public void Check_ReleaseWithUnreleasedChanges_IsReported()
    {
        Change("CHANGELOG.md", "## [1.2.0] - 2026-03-04", "## [Unreleased]");

        Assert.That(Problems(), Is.Empty);
        Assert.That(Problems("v1.2.0"), Has.Some.Contains("wanted the entry [1.2.0] with its date first, got [Unreleased]"));
    }

    [TestCase("[ PACKAGE ]")]
    [TestCase("{ \"com.fastpoints.dots\": PACKAGE }")]
    [TestCase("PACKAGE")]
    public void Pack_FilesLeftOutAndAdded_AreReported(string json)
    {
        var pack = NpmPack.Parse(json.Replace("PACKAGE",
            "{ \"size\": 10, \"unpackedSize\": 20, \"files\": [ { \"path\": \"package.json\" }, { "
                + "\"path\": \"extra\" } ] }"));

        Assert.That(pack.Check(new[] { "package.json", "README.md" }),
            Is.EquivalentTo(new[] { "README.md: npm pack leaves it out", "extra: npm pack adds it" }));
        Assert.That(pack.PackedBytes, Is.EqualTo(10));
    }
}
