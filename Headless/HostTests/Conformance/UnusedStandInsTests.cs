namespace FastPoints.HostTests.Conformance;

public sealed class UnusedStandInsTests
{
    [Test]
    public void Check_OfThisRepository_FindsNothing() =>
        Assert.That(UnusedStandIns.Check(Checkout.Repository), Is.Empty);
}
