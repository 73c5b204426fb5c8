namespace FastPoints.HostTests.Remote;

[SetUpFixture]
public sealed class RemoteSetUp
{
    [OneTimeSetUp]
    public void Register() => HttpFile.Register();
}
