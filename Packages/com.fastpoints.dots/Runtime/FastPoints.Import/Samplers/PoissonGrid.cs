using System.Runtime.CompilerServices;
using FastPoints.Points;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Samplers
{
    /// <summary>The samples that <see cref="SamplePoissonJob"/> has taken, hashed by cells of twice the spacing.</summary>
    unsafe struct PoissonGrid
    {
        // Spacings beyond this many bits are compared in units of 2^-30 of them, so that squares fit a long.
        const int ExactBits = 30;

        [NativeDisableUnsafePtrRestriction] public readonly int* Heads;
        readonly int m_hashShift;

        // log2 of the spacing, the bits of distances that are dropped, and the square of the remaining spacing.
        readonly int m_cell;
        readonly int m_dropped;
        readonly long m_nearSq;

        public PoissonGrid(int* heads, int bits, int cellLog2)
        {
            Heads = heads;
            m_hashShift = 64 - bits;
            m_cell = cellLog2;
            m_dropped = math.max(0, cellLog2 - ExactBits);
            m_nearSq = 1L << 2 * (cellLog2 - m_dropped);
        }

        /// <summary>The slot of a position: cells form bars of two by two along x, so that neighbours share cache
        /// lines.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int SlotOf(Grid3 place)
        {
            long x = place.X >> m_cell + 1, y = place.Y >> m_cell + 1, z = place.Z >> m_cell + 1;
            return SlotOfCell(x, y, z);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        int SlotOfCell(long x, long y, long z) => SlotOf(x, BarOf(HashOfY(y) + HashOfZ(z), y, z));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong HashOfY(long y) => (ulong)(y >> 1) * 0x9E3779B97F4A7C15UL;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong HashOfZ(long z) => (ulong)(z >> 1) * 0xC2B2AE3D27D4EB4FUL;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        ulong BarOf(ulong hash, long y, long z) => (hash >> m_hashShift) * 4 + (ulong)((y & 1) << 1 | z & 1);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        int SlotOf(long x, ulong bar) => (int)(bar + (ulong)(x << 2) & ulong.MaxValue >> m_hashShift);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool IsNear(PoissonSample* a, in Grid3 b, out long distanceSq)
        {
            distanceSq = 0;
            long x = math.abs(a->Place.X - b.X), y = math.abs(a->Place.Y - b.Y), z = math.abs(a->Place.Z - b.Z);
            if ((x | y | z) >> m_cell != 0)
                return false;
            x >>= m_dropped;
            y >>= m_dropped;
            z >>= m_dropped;
            distanceSq = x * x + y * y + z * z;
            return distanceSq < m_nearSq;
        }

        /// <summary>Finds a sample nearer than the spacing, or -1.</summary>
        /// <param name="own">The slot of the point's own cell.</param>
        public int Find(PoissonSample* samples, in Grid3 point, out int own)
        {
            long x = point.X >> m_cell + 1, y = point.Y >> m_cell + 1, z = point.Z >> m_cell + 1;
            ulong hashOfY = HashOfY(y), hashOfZ = HashOfZ(z), bar = BarOf(hashOfY + hashOfZ, y, z);
            own = SlotOf(x, bar);
            int found = FindIn(own, samples, point);
            if (found >= 0)
                return found;

            // The sphere only reaches into the cells on the point's side of the middle, and into those at edges and the corner
            // if these are near.
            long spacing = 1L << m_cell, inX = point.X & spacing - 1, inY = point.Y & spacing - 1, inZ = point.Z & spacing - 1;
            bool isHighX = (point.X & spacing) != 0, isHighY = (point.Y & spacing) != 0, isHighZ = (point.Z & spacing) != 0;
            long besideX = isHighX ? x + 1 : x - 1, besideY = isHighY ? y + 1 : y - 1, besideZ = isHighZ ? z + 1 : z - 1;
            long xSq = SquareOf(isHighX ? spacing - inX : inX), ySq = SquareOf(isHighY ? spacing - inY : inY);
            long zSq = SquareOf(isHighZ ? spacing - inZ : inZ);
            if ((found = FindIn(SlotOf(besideX, bar), samples, point)) >= 0)
                return found;
            ulong hashBesideY = HashOfY(besideY);
            bar = BarOf(hashBesideY + hashOfZ, besideY, z);
            if ((found = FindIn(SlotOf(x, bar), samples, point)) >= 0 ||
                xSq + ySq < m_nearSq && (found = FindIn(SlotOf(besideX, bar), samples, point)) >= 0)
                return found;
            ulong hashBesideZ = HashOfZ(besideZ);
            bar = BarOf(hashOfY + hashBesideZ, y, besideZ);
            if ((found = FindIn(SlotOf(x, bar), samples, point)) >= 0 ||
                xSq + zSq < m_nearSq && (found = FindIn(SlotOf(besideX, bar), samples, point)) >= 0 || ySq + zSq >= m_nearSq)
                return found;
            bar = BarOf(hashBesideY + hashBesideZ, besideY, besideZ);
            if ((found = FindIn(SlotOf(x, bar), samples, point)) >= 0 || xSq + ySq + zSq >= m_nearSq)
                return found;
            return FindIn(SlotOf(besideX, bar), samples, point);
        }

        /// <summary>Square of a distance in the units of <see cref="m_nearSq"/>, not rounded up.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        long SquareOf(long distance)
        {
            distance >>= m_dropped;
            return distance * distance;
        }

        /// <summary>The nearest of the samples that are nearer to a point than the spacing, the first on the curve in a tie; -1
        /// for none.</summary>
        public int Nearest(PoissonSample* samples, in Grid3 point)
        {
            long x = point.X >> m_cell + 1, y = point.Y >> m_cell + 1, z = point.Z >> m_cell + 1;
            long besideX = x + (point.X >> m_cell & 1) * 2 - 1;
            long besideY = y + (point.Y >> m_cell & 1) * 2 - 1;
            long besideZ = z + (point.Z >> m_cell & 1) * 2 - 1;
            int nearest = -1;
            long nearestSq = m_nearSq;
            for (int n = 0; n < 8; n++)
            {
                int slot = SlotOfCell((n & 1) != 0 ? besideX : x, (n & 2) != 0 ? besideY : y, (n & 4) != 0 ? besideZ : z);
                for (int s = Heads[slot]; s >= 0; s = samples[s].Next)
                {
                    if (!IsNear(samples + s, point, out long distanceSq) || distanceSq > nearestSq ||
                        (distanceSq == nearestSq && nearest >= 0 && samples[s].Point > samples[nearest].Point))
                        continue;
                    nearest = s;
                    nearestSq = distanceSq;
                }
            }
            return nearest;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        int FindIn(int slot, PoissonSample* samples, in Grid3 point)
        {
            int s = Heads[slot];
            while (s >= 0 && !IsNear(samples + s, point, out _))
                s = samples[s].Next;
            return s;
        }
    }

    /// <summary>A point that was taken, in the hash grid that keeps others away from it. Blittable.</summary>
    internal struct PoissonSample
    {
        /// <summary>Position in grid steps from the corner.</summary>
        public Grid3 Place;
        public int Point;

        /// <summary>The next sample in the same slot, or -1.</summary>
        public int Next;
    }
}
