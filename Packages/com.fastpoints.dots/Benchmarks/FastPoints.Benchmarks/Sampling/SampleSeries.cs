using System.Collections.Generic;
using System.Linq;

namespace FastPoints.Benchmarks
{
    /// <summary>Unit of a series. The numbers are those of <c>Unity.PerformanceTesting.SampleUnit</c>, which its JSON
    /// holds.</summary>
    public enum SeriesUnit
    {
        Millisecond = 2,
        Byte = 4,

        /// <summary>No unit of time or size; the series' name says what it counts.</summary>
        Undefined = 8,
    }

    /// <summary>What one figure of a workload was in each sample: a sample group of the Performance Testing package.</summary>
    public readonly struct SampleSeries
    {
        public readonly string Name;
        public readonly SeriesUnit Unit;
        public readonly bool IncreaseIsBetter;
        public readonly IReadOnlyList<double> Samples;

        /// <param name="samples">What is not finite is left out: neither JSON nor a median can hold it.</param>
        public SampleSeries(string name, SeriesUnit unit, bool increaseIsBetter, IEnumerable<double> samples)
        {
            Name = name;
            Unit = unit;
            IncreaseIsBetter = increaseIsBetter;
            Samples = samples.Where(s => !double.IsNaN(s) && !double.IsInfinity(s)).ToArray();
        }
    }
}
