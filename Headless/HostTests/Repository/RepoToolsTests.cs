namespace FastPoints.HostTests.Repository;

public sealed class RepoToolsTests
{
    [TestCase(2)]
    [TestCase(2, "nonsense")]
    [TestCase(2, "meta", "--wrong")]
    [TestCase(2, "meta", "api")]
    [TestCase(0, "--help")]
    public void Main_Arguments_ExitStatus(int status, params string[] arguments) =>
        Assert.That(Run(arguments, out _), Is.EqualTo(status));

    [Test]
    public void Main_MetaCheckOfFolderWithoutMetas_FailsAndNamesThem()
    {
        DirectoryInfo root = Directory.CreateTempSubdirectory("fastpoints-tools-");
        try
        {
            string package = Path.Combine(root.FullName, "Packages", "com.fastpoints.dots");
            Directory.CreateDirectory(package);
            File.WriteAllText(Path.Combine(package, "package.json"), "{}");

            Assert.That(Run(new[] { "meta", "--check", "--root", root.FullName }, out string said), Is.EqualTo(1));
            Assert.That(said, Does.Contain("package.json: no .meta"));
            Assert.That(Run(new[] { "meta", "--root", root.FullName }, out _), Is.EqualTo(0));
            Assert.That(Run(new[] { "meta", "--check", "--root", root.FullName }, out _), Is.EqualTo(0));
        }
        finally
        {
            root.Delete(true);
        }
    }

    [Test]
    public void Main_BuildsMissing_NamesWhatToRun()
    {
        DirectoryInfo root = Directory.CreateTempSubdirectory("fastpoints-tools-");
        try
        {
            Assert.That(Run(new[] { "formats", "--check", "--root", root.FullName }, out string said), Is.EqualTo(1));
            Assert.That(said, Does.Contain("dotnet build Headless/Generations.proj"));
        }
        finally
        {
            root.Delete(true);
        }
    }

    [Test]
    public void UnusedStandIns_OfThisRepository_AreNone() => Assert.That(UnusedStandIns.Check(Checkout.Repository), Is.Empty);

    internal static int Run(string[] arguments, out string said)
    {
        TextWriter output = Console.Out;
        TextWriter error = Console.Error;
        using var captured = new StringWriter();
        Console.SetOut(captured);
        Console.SetError(captured);
        try
        {
            return RepoTools.Program.Main(arguments);
        }
        finally
        {
            Console.SetOut(output);
            Console.SetError(error);
            said = captured.ToString();
        }
    }
}
