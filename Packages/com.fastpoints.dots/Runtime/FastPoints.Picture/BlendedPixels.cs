using System.Runtime.CompilerServices;
using System.Threading;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    /// <summary>
    /// Surface splatting (Botsch, Hornung, Zwicker, Kobbelt, "High-quality surface splatting on today's GPUs", 2005) with discs
    /// that face the camera: of the points that a pixel lies in, all that are at most a window behind the nearest are averaged,
    /// each with a weight that falls from its middle to its rim. Sums are whole numbers, so that no order matters:
    /// <code>
    /// word 0: bit 63 .. 32 green, 31 .. 0 red     word 1: bit 63 .. 32 weights, 31 .. 0 blue
    /// </code>
    /// </summary>
    internal static class BlendedPixels
    {
        public const int WordsPerPixel = 2;
        public const int MaxWeight = 32; // Of a point in its middle; 1 at its rim.

        // 255 times it fits 32 bits. Points after the first half a million in a pixel are left out.
        const uint MaxWeightSum = (1u << 24) - 1024;

        // How far behind the nearest point others are still blended with it: a point's diameter, in world units.
        public static double WindowOf(float sizePx, double pixelsPerUnit) => sizePx / pixelsPerUnit;

        // By the squared distance from the middle, 1 at the rim.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint WeightOf(double distanceSq) =>
            (uint)math.max(1, (int)math.floor(MaxWeight * (1 - distanceSq) + 0.5));

        // Any number of threads may do so at the same time.
        public static unsafe void Add(ulong* pixel, uint color, uint weight)
        {
            if ((uint)(pixel[1] >> 32) > MaxWeightSum)
                return;
            ulong red = color & 255, green = color >> 8 & 255, blue = color >> 16 & 255;
            Interlocked.Add(ref *(long*)pixel, (long)(green * weight << 32 | red * weight));
            Interlocked.Add(ref *(long*)(pixel + 1), (long)((ulong)weight << 32 | blue * weight));
        }

        // The mean, rounded; the nearest point's colour if none was added.
        public static uint ColorOf(ulong word0, ulong word1, uint nearest)
        {
            ulong weights = word1 >> 32, half = weights / 2;
            if (weights == 0)
                return nearest;
            uint red = (uint)(((word0 & uint.MaxValue) + half) / weights);
            uint green = (uint)(((word0 >> 32) + half) / weights);
            uint blue = (uint)(((word1 & uint.MaxValue) + half) / weights);
            return red | green << 8 | blue << 16;
        }
    }
}
