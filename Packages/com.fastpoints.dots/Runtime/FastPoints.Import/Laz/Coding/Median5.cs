using System.Runtime.CompilerServices;

namespace FastPoints.Laz
{
    /// <summary>The middle one of five values, sorted, of which the largest and the smallest are given up in turn as new ones
    /// come: LASzip's prediction of coordinate differences. Six ints: the values and which end is next. HPC#.</summary>
    internal static unsafe class Median5
    {
        public const int Ints = 6;

        public static void Initialize(int* median)
        {
            for (int i = 0; i < 5; i++)
                median[i] = 0;
            median[5] = 1;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int Get(int* median) => median[2];

        /// <summary>Inserts without a branch: of the four values that stay, each place gets clamp(added, left, right) = added +
        /// min(right - added, 0) + max(left - added, 0), at most one of which is not zero.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Add(int* median, int added)
        {
            int dropsLargest = median[5];
            long middle = (long)median[2] - added;
            int* kept = median + (1 - dropsLargest);
            long d0 = (long)kept[0] - added, d1 = (long)kept[1] - added, d2 = (long)kept[2] - added, d3 = (long)kept[3] - added;
            long below0 = d0 & d0 >> 63, below1 = d1 & d1 >> 63, below2 = d2 & d2 >> 63, below3 = d3 & d3 >> 63;
            median[0] = (int)(added + below0);
            median[1] = (int)(added + below1 + (d0 - below0));
            median[2] = (int)(added + below2 + (d1 - below1));
            median[3] = (int)(added + below3 + (d2 - below2));
            median[4] = (int)(added + (d3 - below3));

            // The largest stays due while values come in below the middle; the smallest until one comes that is not above it.
            int isBelow = (int)(-middle >> 63) & 1;
            int isNotAbove = ~(int)(middle >> 63) & 1;
            median[5] = dropsLargest != 0 ? isBelow : isNotAbove;
        }
    }
}
