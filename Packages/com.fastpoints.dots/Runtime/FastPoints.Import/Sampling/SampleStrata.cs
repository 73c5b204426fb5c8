namespace FastPoints.Sampling
{
    /// <summary>Points in file order, cut into equal strata (their lengths differ by at most one), with one position chosen in
    /// each by a seeded hash: a sample that is even over the file and the same wherever it is computed. Blittable, for
    /// jobs.</summary>
    internal readonly struct SampleStrata
    {
        public readonly long Points;

        public readonly int Count;

        public readonly uint Seed;

        // Points / Count and the remainder are stored: a 64-bit division takes as long as everything else that finds a
        // stratum's point.
        readonly long m_quotient;
        readonly long m_remainder;

        public SampleStrata(long points, int wanted, uint seed)
        {
            Points = points < 0 ? 0 : points;
            Count = (int)(wanted < 0 ? 0 : wanted < Points ? wanted : Points);
            Seed = seed;
            m_quotient = Count == 0 ? 0 : Points / Count;
            m_remainder = Count == 0 ? 0 : Points % Count;
        }

        /// <summary>First point of a stratum; <see cref="Points"/> for the one after the last. floor(i * points / count), with
        /// the product split so that it does not overflow.</summary>
        public long FirstOf(int stratum) => stratum * m_quotient + stratum * m_remainder / Count;

        public int StratumOf(long point)
        {
            int stratum = (int)(point * (double)Count / Points);
            stratum = stratum >= Count ? Count - 1 : stratum;
            while (FirstOf(stratum) > point)
                stratum--;
            while (FirstOf(stratum + 1) <= point)
                stratum++;
            return stratum;
        }

        public long Chosen(int stratum)
        {
            long first = FirstOf(stratum);
            return first + (long)(Hash((ulong)stratum << 32 | Seed) % (ulong)(FirstOf(stratum + 1) - first));
        }

        /// <summary>The finaliser of SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators",
        /// 2014).</summary>
        static ulong Hash(ulong value)
        {
            value += 0x9E3779B97F4A7C15UL;
            value = (value ^ value >> 30) * 0xBF58476D1CE4E5B9UL;
            value = (value ^ value >> 27) * 0x94D049BB133111EBUL;
            return value ^ value >> 31;
        }
    }
}
