namespace FastPoints.HostTests.Cli;

/// <summary>Tests with a folder for all of them.</summary>
public abstract class ScratchTests
{
    private protected ScratchFolder Scratch { get; private set; }

    [OneTimeSetUp]
    public void MakeScratch() => Scratch = new ScratchFolder();

    [OneTimeTearDown]
    public void DeleteScratch() => Scratch?.Dispose();
}

/// <summary>Tests with a folder each.</summary>
public abstract class ScratchPerTest
{
    private protected ScratchFolder Scratch { get; private set; }

    [SetUp]
    public void MakeScratch() => Scratch = new ScratchFolder();

    [TearDown]
    public void DeleteScratch() => Scratch.Dispose();
}
