namespace FastPoints.HostTests.Cli;

public abstract class ScratchTests
{
    private protected ScratchFolder Scratch { get; private set; }

    [OneTimeSetUp]
    public void MakeScratch() => Scratch = new ScratchFolder();

    [OneTimeTearDown]
    public void DeleteScratch() => Scratch?.Dispose();
}

public abstract class ScratchPerTest
{
    private protected ScratchFolder Scratch { get; private set; }

    [SetUp]
    public void MakeScratch() => Scratch = new ScratchFolder();

    [TearDown]
    public void DeleteScratch() => Scratch.Dispose();
}
