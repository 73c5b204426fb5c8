namespace FastPoints.Cli.Bench;

/// <remarks>The interval is that of Hodges and Lehmann (1963) for the shift between two samples, on logarithms: of all ratios
/// of a sample of now to an earlier one, as many are cut off at each end as the rank-sum distribution of Mann and Whitney
/// gives for the confidence. It assumes no shape of the noise, and knows only noise that is within each run.</remarks>
public sealed class SampleComparison
{
    public const double Confidence = 0.95;

    SampleComparison(double ratio, double low, double high) => (Ratio, Low, High) = (ratio, low, high);

    public double Ratio { get; }

    /// <summary>The min and max ratio that the scatter allows; NaN if there are too few samples.</summary>
    public double Low { get; }
    public double High { get; }
    public bool IsUnknown => double.IsNaN(Low);
    public bool IsBeyondNoise => !IsUnknown && (Low > 1 || High < 1);

    /// <summary>Null if either has no sample, or one that is not above 0.</summary>
    public static SampleComparison? Of(IReadOnlyCollection<double> now, IReadOnlyCollection<double> before)
    {
        if (now.Count == 0 || before.Count == 0 || now.Concat(before).Any(v => !(v > 0)))
            return null;
        double ratio = WorkloadSamples.Median(now) / WorkloadSamples.Median(before);
        int cut = SmallRankSums(now.Count, before.Count, (1 - Confidence) / 2);
        if (cut == 0)
            return new SampleComparison(ratio, double.NaN, double.NaN);
        double[] ratios = now.SelectMany(n => before.Select(b => n / b)).Order().ToArray();
        return new SampleComparison(ratio, ratios[cut - 1], ratios[^cut]);
    }

    /// <summary>How many of the smallest values of Mann and Whitney's U together have at most that probability, if nothing
    /// differs between samples of these sizes.</summary>
    static int SmallRankSums(int first, int second, double probability)
    {
        // Ways to make each sum of ranks: those without the largest element and those with it.
        var ways = new double[first + 1, second + 1][];
        for (int m = 0; m <= first; m++)
            for (int n = 0; n <= second; n++)
            {
                var at = ways[m, n] = new double[m * n + 1];
                if (m == 0 || n == 0)
                {
                    at[0] = 1;
                    continue;
                }
                for (int u = 0; u < at.Length; u++)
                    at[u] = (u < ways[m, n - 1].Length ? ways[m, n - 1][u] : 0) + (u >= n ? ways[m - 1, n][u - n] : 0);
            }
        double[] all = ways[first, second];
        double allowed = probability * all.Sum(), sum = 0;
        int count = 0;
        while (count < all.Length && (sum += all[count]) <= allowed)
            count++;
        return count;
    }
}
