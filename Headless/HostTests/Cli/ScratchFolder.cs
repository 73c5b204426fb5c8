namespace FastPoints.HostTests.Cli;

/// <summary>A folder of a test's own, gone afterwards.</summary>
sealed class ScratchFolder : IDisposable
{
    public string Root { get; } = Directory.CreateTempSubdirectory("fastpoints-test-").FullName;

    public string this[string name] => Path.Combine(Root, name);

    /// <summary>A small scan.</summary>
    public string Demo(string name = "demo.las", int points = 3000)
    {
        var call = CliCall.Of("demo-cloud", "-o", this[name], "--points", points.ToString(), "--quiet");
        Assert.That(call.Status, Is.EqualTo(0), call.Error);
        return this[name];
    }

    /// <summary>A small scan, converted.</summary>
    /// <returns>The folder's path.</returns>
    public string Converted(string name = "scan.fastpoints", int points = 3000)
    {
        var call = CliCall.Of("convert", Demo($"s{points}.las", points), "-o", this[name], "--quiet");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        return this[name];
    }

    public void Dispose()
    {
        FileChanges.AwaitDeletes();
        Directory.Delete(Root, true);
    }
}
