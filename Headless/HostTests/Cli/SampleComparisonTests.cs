namespace FastPoints.HostTests.Cli;

public sealed class SampleComparisonTests
{
    /// <summary>Of seven against seven, eight ratios are cut off at each end, as the tables of Mann and Whitney have it
    /// (critical U of 8 at 5 %, two-sided): the ninth is the interval's end.</summary>
    [Test]
    public void Of_SevenAgainstSeven_HasTheTabulatedThreshold()
    {
        double[] now = [1.01, 1.02, 1.04, 1.08, 1.16, 1.32, 1.64], before = [1, 1.001, 1.002, 1.003, 1.004, 1.005, 1.006];
        double[] ratios = now.SelectMany(n => before.Select(b => n / b)).Order().ToArray();

        var comparison = SampleComparison.Of(now, before)!;

        Assert.That(comparison.Ratio, Is.EqualTo(1.08 / 1.003).Within(1e-12));
        Assert.That(comparison.Low, Is.EqualTo(ratios[8]).Within(1e-12));
        Assert.That(comparison.High, Is.EqualTo(ratios[^9]).Within(1e-12));
        Assert.That(comparison.IsBeyondNoise, Is.True);
    }

    [Test]
    public void Of_TheSameSamples_IsWithinTheNoise()
    {
        double[] samples = [1, 1.1, 0.9, 1.2, 1.05];

        var comparison = SampleComparison.Of(samples, samples)!;

        Assert.That(comparison.Ratio, Is.EqualTo(1));
        Assert.That(comparison.IsBeyondNoise, Is.False);
    }

    [Test]
    public void Of_ScatterWiderThanTheChange_IsWithinTheNoise() => Assert.That(
        SampleComparison.Of([10, 14, 9, 15, 11, 13, 12], [9, 13, 10, 14, 11, 8, 12])!.IsBeyondNoise, Is.False);

    [TestCase(3, 3)]
    [TestCase(1, 20)]
    public void Of_TooFewSamples_IsUnknown(int now, int before)
    {
        var comparison = SampleComparison.Of(Enumerable.Repeat(2.0, now).ToArray(), Enumerable.Repeat(1.0, before).ToArray())!;

        Assert.That(comparison.Ratio, Is.EqualTo(2));
        Assert.That(comparison.IsUnknown, Is.True);
        Assert.That(comparison.IsBeyondNoise, Is.False);
    }

    /// <summary>The limits hold what they promise: of runs that differ by chance alone, about one in twenty is marked.</summary>
    [Test]
    public void Of_RunsThatDifferByChance_MarksAboutOneInTwenty()
    {
        const int Runs = 4000;
        var random = new System.Random(7);
        int marked = Enumerable.Range(0, Runs).Count(_ => SampleComparison.Of(Samples(random), Samples(random))!.IsBeyondNoise);

        Assert.That((double)marked / Runs, Is.InRange(0.02, 0.06));
    }

    static double[] Samples(System.Random random) =>
        Enumerable.Range(0, 7).Select(_ => 1 - System.Math.Log(random.NextDouble())).ToArray();

    [Test]
    public void Of_ZeroTimes_IsNull()
    {
        Assert.That(SampleComparison.Of([0, 1, 2, 3], [1, 1, 1, 1]), Is.Null);
        Assert.That(SampleComparison.Of([], [1, 1, 1, 1]), Is.Null);
    }
}
