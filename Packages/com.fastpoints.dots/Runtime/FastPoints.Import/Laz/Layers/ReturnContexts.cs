namespace FastPoints.Laz
{
    /// <summary>Which contexts a point takes by its return number r and its pulse's number of returns n: LASzip's tables, which
    /// are part of the format. Odd combinations (r of 0, r above n) have contexts too.</summary>
    /// <remarks>
    /// Written into a decoder's state at its start, since code compiled by Burst or .NET reaches native memory with less
    /// checking than a managed array. One entry a combination:
    /// <code>
    /// point formats 0 to 5, by n * 8 + r (the flag byte's lower six bits), a byte:
    ///   bits 0-3 map of r and n   4-6 level |n - r|   7 n is 1
    /// point formats 6 to 10, by n * 16 + r (the return byte), a ushort:
    ///   bits 0-2 map   3-5 level, at most 7   6-7 kind of return (2 if first, + 1 if last)
    ///   8 n is 1   9-10 its kind as the last point's (1 if first, + 2 if last)
    /// </code>
    /// </remarks>
    static unsafe class ReturnContexts
    {
        public const int MapMask = 15;
        public const int LevelShift = 4;
        public const int LevelMask = 7;
        public const int SingleShift = 7;

        public const int ExtendedMapMask = 7;
        public const int ExtendedLevelShift = 3;
        public const int ExtendedReturnKindShift = 6;
        public const int ExtendedReturnKindMask = 3;
        public const int ExtendedSingleShift = 8;
        public const int ExtendedLastReturnKindShift = 9;

        static readonly byte[] s_legacyMap =
        {
            15, 14, 13, 12, 11, 10, 9, 8,
            14, 0, 1, 3, 6, 10, 10, 9,
            13, 1, 2, 4, 7, 11, 11, 10,
            12, 3, 4, 5, 8, 12, 12, 11,
            11, 6, 7, 8, 9, 13, 13, 12,
            10, 10, 11, 12, 13, 14, 14, 13,
            9, 10, 11, 12, 13, 14, 15, 14,
            8, 9, 10, 11, 12, 13, 14, 15,
        };

        static readonly byte[] s_extendedMap =
        {
            0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5,
            1, 0, 1, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
            2, 1, 2, 4, 4, 4, 4, 4, 4, 4, 4, 3, 3, 3, 3, 3,
            3, 3, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
            4, 3, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
            5, 3, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
            3, 3, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4,
            4, 3, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4,
            4, 3, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4,
            5, 3, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4,
            5, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4,
            5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 4, 4, 4,
            5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4, 4,
            5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4,
            5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5,
            5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5,
        };

        public static void WriteLegacy(byte* contexts)
        {
            for (int i = 0; i < 64; i++)
            {
                int n = i >> 3, r = i & 7;
                int level = n > r ? n - r : r - n;
                contexts[i] = (byte)(s_legacyMap[i] | level << LevelShift | (n == 1 ? 1 << SingleShift : 0));
            }
        }

        public static void WriteExtended(ushort* contexts)
        {
            for (int i = 0; i < 256; i++)
            {
                int n = i >> 4, r = i & 15;
                int level = n > r ? n - r : r - n;
                bool isFirst = r == 1, isLast = r >= n;
                contexts[i] = (ushort)(s_extendedMap[i] | (level < 7 ? level : 7) << ExtendedLevelShift
                    | ((isFirst ? 2 : 0) + (isLast ? 1 : 0)) << ExtendedReturnKindShift
                    | (n == 1 ? 1 << ExtendedSingleShift : 0)
                    | ((isFirst ? 1 : 0) + (isLast ? 2 : 0)) << ExtendedLastReturnKindShift);
            }
        }
    }
}
