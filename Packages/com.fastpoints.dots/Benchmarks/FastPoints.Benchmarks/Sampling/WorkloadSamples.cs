using System.Collections.Generic;
using System.Linq;

namespace FastPoints.Benchmarks
{
    public sealed class WorkloadSamples
    {
        public const string Time = "Time", PointsPerSecond = "Points/s", BytesPerSecond = "Bytes/s",
            Garbage = "GC", Error = "Error", TimesLimit = "Times limit";

        readonly List<double> m_ms = new List<double>();
        readonly List<double> m_garbageBytes = new List<double>();
        readonly List<double> m_errors = new List<double>();
        readonly WorkloadSamples m_limit;
        WorkloadResult m_result;

        /// <param name="limit">Samples of the workload that bounds this one, taken in turns with it; or null.</param>
        public WorkloadSamples(string name, WorkloadSamples limit)
        {
            Name = name;
            m_limit = limit;
        }

        public string Name { get; }
        public long Points => m_result.Points;

        /// <summary>Bytes of input that one run works on, 0 where bytes mean nothing.</summary>
        public long Bytes => m_result.Bytes;

        /// <summary>Unit of the error, null for exact work.</summary>
        public string ErrorUnit => m_result.ErrorUnit;

        public string Note => m_result.Note;
        public bool HadInput => m_result.Points > 0 || m_result.Bytes > 0;
        public IReadOnlyList<double> Ms => m_ms;
        public double MedianMs => Median(m_ms);
        public double MedianError => Median(m_errors);
        public double MedianGarbageBytes => Median(m_garbageBytes);
        public double MedianPointsPerSecond => PerSecond(Points, MedianMs);
        public double MedianBytesPerSecond => PerSecond(Bytes, MedianMs);

        public bool HasLimit => m_limit != null && m_limit.HadInput && HadInput;

        /// <summary>Time by point (by byte where no points are counted) over that of the limit, in each turn: what slows the
        /// machine for a while slows both.</summary>
        public IEnumerable<double> RatioToLimit => HasLimit
            ? m_ms.Zip(m_limit.m_ms, (own, limit) => own / limit * Amount(m_limit, this))
            : Enumerable.Empty<double>();

        public void Add(double ms, double garbageBytes, in WorkloadResult result)
        {
            m_ms.Add(ms);
            m_garbageBytes.Add(garbageBytes);
            m_errors.Add(result.Error);
            m_result = result;
        }

        public IEnumerable<SampleSeries> Series()
        {
            yield return new SampleSeries(Time, SeriesUnit.Millisecond, false, m_ms);
            if (Points > 0)
                yield return new SampleSeries(PointsPerSecond, SeriesUnit.Undefined, true,
                    m_ms.Select(ms => PerSecond(Points, ms)));
            if (Bytes > 0)
                yield return new SampleSeries(BytesPerSecond, SeriesUnit.Undefined, true,
                    m_ms.Select(ms => PerSecond(Bytes, ms)));
            yield return new SampleSeries(Garbage, SeriesUnit.Byte, false, m_garbageBytes);
            yield return new SampleSeries(ErrorUnit == null ? Error : Error + " (" + ErrorUnit + ")", SeriesUnit.Undefined,
                m_result.ErrorIncreaseIsBetter, m_errors);
            if (HasLimit)
                yield return new SampleSeries(TimesLimit, SeriesUnit.Undefined, false, RatioToLimit);
        }

        /// <summary>The middle one, or between the middle two; 0 of none.</summary>
        public static double Median(IEnumerable<double> values)
        {
            double[] sorted = values.OrderBy(v => v).ToArray();
            int middle = sorted.Length / 2;
            return sorted.Length == 0 ? 0 : sorted.Length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
        }

        static double PerSecond(long amount, double ms) => ms > 0 ? amount / ms * 1000 : 0;

        static double Amount(WorkloadSamples of, WorkloadSamples by) =>
            of.Points > 0 && by.Points > 0 ? (double)of.Points / by.Points
            : of.Bytes > 0 && by.Bytes > 0 ? (double)of.Bytes / by.Bytes : 1;
    }

    /// <summary>Unit of a series. The numbers are those of <c>Unity.PerformanceTesting.SampleUnit</c>, which its JSON
    /// holds.</summary>
    public enum SeriesUnit
    {
        Millisecond = 2,
        Byte = 4,

        /// <summary>No unit of time or size; the series' name says what it counts.</summary>
        Undefined = 8,
    }

    public readonly struct SampleSeries
    {
        public readonly string Name;
        public readonly SeriesUnit Unit;
        public readonly bool IncreaseIsBetter;
        public readonly IReadOnlyList<double> Samples;

        public SampleSeries(string name, SeriesUnit unit, bool increaseIsBetter, IEnumerable<double> samples)
        {
            Name = name;
            Unit = unit;
            IncreaseIsBetter = increaseIsBetter;
            Samples = samples.Where(s => !double.IsNaN(s) && !double.IsInfinity(s)).ToArray();
        }
    }
}
