namespace FastPoints.HostTests.Repository
{
    public sealed class RepositoryTests
    {
        // In two halves, or this file would be the first to be found.
        private static readonly string[] s_foreign =
        {
            "/wo" + "rk/", "/tmp/bash" + "_jobs", "nuget" + ".org", "npmjs" + ".org", "deb.debian" + ".org", "pypi" + ".org",
        };

        private static readonly string[] s_text =
        {
            ".cs", ".md", ".json", ".csproj", ".props", ".proj", ".slnx", ".asmdef", ".meta", ".tsv",
            ".hlsl", ".shader", ".compute", ".yml", ".txt", ".sh", "", ".html", ".xml",
        };

        [Test]
        public void Files_Committed_ContainNoMachinePathsOrRegistryNames()
        {
            var found = new List<string>();
            foreach (string file in Checkout.Files().Where(f => s_text.Contains(Path.GetExtension(f))))
                found.AddRange(Foreign(File.ReadAllText(Path.Combine(Checkout.Repository.Root, file)))
                    .Select(p => $"{file}: {p}"));

            Assert.That(found, Is.Empty);
        }

        [Test]
        public void ForeignPaths_PlantedPath_IsFound() =>
            Assert.That(Foreign("see /wo" + "rk/here and nuget" + ".org"), Has.Count.EqualTo(2));

        [Test]
        public void Paths_Committed_StayUnder140Characters() =>
            Assert.That(Checkout.Files().Where(f => f.Length >= 140), Is.Empty);

        [Test]
        public void Version_PackageChangelogAndProjects_AreEqual()
        {
            string package = Checkout.Repository.PackageRoot;
            using JsonDocument manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(package, "package.json")));
            string version = manifest.RootElement.GetProperty("version").GetString();
            string changelog = Regex.Match(File.ReadAllText(Path.Combine(package, "CHANGELOG.md")), @"^## \[(.+?)\]",
                RegexOptions.Multiline).Groups[1].Value;
            string built = typeof(RepositoryTests).Assembly
                .GetCustomAttribute<AssemblyInformationalVersionAttribute>().InformationalVersion;

            Assert.That(changelog, Is.EqualTo(version).Or.EqualTo("Unreleased"));
            Assert.That(built.Split('+')[0], Is.EqualTo(version));
        }

        /// <summary>The workflow runs Unity's test runner with an editor of each generation, in each project.</summary>
        [Test]
        public void Workflow_OfTests_HasEachGenerationAndProject()
        {
            string root = Checkout.Repository.Root;
            string workflow = File.ReadAllText(Path.Combine(root, ".github", "workflows", "test.yml"));
            string versions = Regex.Match(workflow, @"version: \[(.*)\]").Groups[1].Value;
            List<string> projects = Regex.Matches(workflow, @"project: \[?(\w+)\]?$", RegexOptions.Multiline)
                .Select(m => m.Groups[1].Value).ToList();

            Assert.That(versions.Split(", ").Select(v => v[..v.LastIndexOf('.')]), Is.EqualTo(RepoTools.Repository.Generations));
            Assert.That(projects,
                Is.EquivalentTo(Directory.GetDirectories(Path.Combine(root, "Projects")).Select(Path.GetFileName)));
        }

        private static List<string> Foreign(string text) => s_foreign.Where(p => text.Contains(p)).ToList();
    }
}
