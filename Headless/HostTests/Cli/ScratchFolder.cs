namespace FastPoints.HostTests.Cli;

sealed class ScratchFolder : IDisposable
{
    public string Root { get; } = Directory.CreateTempSubdirectory("fastpoints-test-").FullName;

    public string this[string name] => Path.Combine(Root, name);

    public string Demo(string name = "demo.las", int points = 3000)
    {
        var call = CliCall.Of("demo-cloud", "-o", this[name], "--points", points.ToString(), "--quiet");
        Assert.That(call.Status, Is.EqualTo(0), call.Error);
        return this[name];
    }

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
