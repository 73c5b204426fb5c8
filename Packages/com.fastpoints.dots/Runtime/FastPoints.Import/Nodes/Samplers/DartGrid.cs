using System;
using System.Runtime.CompilerServices;
using Unity.Burst.Intrinsics;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>The samples of one spacing, for queries whether another point is nearer to one of them.</summary>
    /// <remarks> Space is divided into tiles of 16 spacings, and a tile into cells of two spacings, so that all samples
    /// nearer than the spacing are in two by two by two cells. A cell's samples are in buckets of eight, which are
    /// compared together:
    /// <code>
    /// bucket: eight times x, y of 16 bits | eight times z, 0 of 16 bits
    /// </code>
    /// Coordinates are whole steps, or 2048ths of wider spacings, without their upper bits: within eight cells differences are
    /// right without them. All is whole numbers, so that every processor finds the same. Where 2048ths are compared, points
    /// count as near up to two of them beyond the spacing, so that none is nearer than it.
    /// </remarks>
    internal unsafe struct DartGrid : IDisposable
    {
        public const int TileSpacingsLog2 = 4; // Edge of a tile: log2 of the spacings.

        public const ulong TakenFlag = 1UL << 63;
        const int ExactBits = 11;

        const int Side = 8;
        const int CellsOfTile = Side * Side * Side;

        // The tile's cells and those around them.
        const int LocalSide = Side + 2;
        const int LocalCells = LocalSide * LocalSide * LocalSide;
        const int FirstOfLocal = 1 + LocalSide + LocalSide * LocalSide;

        const int Lanes = 8;
        const int WordsOfBucket = 2 * Lanes;
        const int MinSlots = 4096;
        const int DartsOfBucket = 7;

        NativeList<uint> m_buckets;

        // For each bucket: its number of samples, and the full bucket of the same cell, or 0. Empty cells have the
        // first bucket; its second number says whether any cell has two.
        NativeList<int> m_links;
        NativeList<int> m_pointOfLane;

        NativeList<Grid3> m_tiles;
        NativeList<int> m_cells;
        NativeList<int> m_tileOfSlot;
        NativeArray<int> m_local;

        int m_cell;
        int m_dropped;
        int m_nearSq;
        bool m_hasPoints;

        public DartGrid(Allocator allocator)
        {
            this = default;
            m_buckets = new NativeList<uint>(64, allocator);
            m_links = new NativeList<int>(64, allocator);
            m_pointOfLane = new NativeList<int>(64, allocator);
            m_tiles = new NativeList<Grid3>(64, allocator);
            m_cells = new NativeList<int>(64, allocator);
            m_tileOfSlot = new NativeList<int>(64, allocator);
            m_local = new NativeArray<int>(LocalCells, allocator);
        }

        /// <summary>The same grid, for this spacing.</summary>
        /// <param name="hasPoints">Whether <see cref="Nearest"/> will be called.</param>
        public DartGrid For(int cellLog2, bool hasPoints)
        {
            var grid = this;
            grid.m_cell = cellLog2;
            grid.m_dropped = math.max(0, cellLog2 - ExactBits);
            int near = (1 << cellLog2 - grid.m_dropped) + (grid.m_dropped > 0 ? 2 : 0);
            grid.m_nearSq = near * near;
            grid.m_hasPoints = hasPoints;
            return grid;
        }

        /// <param name="darts">At most as many are thrown. In most clouds there is room for their samples at once: a list that
        /// grows is copied, in one slice.</param>
        public void Clear(int darts)
        {
            m_buckets.Clear();
            int words = darts / DartsOfBucket * WordsOfBucket;
            if (m_buckets.Capacity < words)
            {
                m_buckets.SetCapacity(WordsOfBucket);
                m_buckets.SetCapacity(words);
            }
            m_links.Clear();
            m_tiles.Clear();
            m_cells.Clear();
            ClearSlots(MinSlots);
            NewBucket(0);
        }

        /// <param name="position">From the corner of a cube of the octree.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public ulong DartOf(in Grid3 position, int priorityClass) =>
            (ushort)(position.X >> m_dropped) | (ulong)(ushort)(position.Y >> m_dropped) << 16 |
            (ulong)(ushort)(position.Z >> m_dropped) << 32 | (ulong)priorityClass << 48;

        public static int ClassOf(ulong dart) => (int)(dart >> 48 & 0xFF);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Grid3 TileOf(in Grid3 position)
        {
            int shift = math.min(63, m_cell + TileSpacingsLog2);
            return new Grid3(position.X >> shift, position.Y >> shift, position.Z >> shift);
        }

        /// <summary>Makes a tile the current one, with the cells around it.</summary>
        /// <returns>Whether it or one beside it is known.</returns>
        public bool BeginTile(in Grid3 tile)
        {
            int* local = (int*)m_local.GetUnsafePtr();
            UnsafeUtility.MemClear(local, LocalCells * sizeof(int));
            int* cells = m_cells.GetUnsafePtr();
            bool isKnown = false;
            for (int n = 0; n < 27; n++)
            {
                int dx = n % 3 - 1, dy = n / 3 % 3 - 1, dz = n / 9 - 1;
                int found = FindTile(tile + new Grid3(dx, dy, dz));
                if (found < 0)
                    continue;
                isKnown = true;
                int* from = cells + (long)found * CellsOfTile;
                for (int z = dz < 0 ? Side - 1 : 0, endZ = dz > 0 ? 1 : Side; z < endZ; z++)
                    for (int y = dy < 0 ? Side - 1 : 0, endY = dy > 0 ? 1 : Side; y < endY; y++)
                        for (int x = dx < 0 ? Side - 1 : 0, endX = dx > 0 ? 1 : Side; x < endX; x++)
                            local[FirstOfLocal + x + Side * dx + LocalSide * (y + Side * dy) +
                                LocalSide * LocalSide * (z + Side * dz)] = from[x + Side * (y + Side * z)];
            }
            // The empty bucket is half the range of 16 bits away from the tile.
            int spacing = 1 << m_cell - m_dropped, size = spacing << TileSpacingsLog2, middle = size / 2;
            uint farX = (ushort)((int)tile.X * size + size + middle), y0 = (ushort)((int)tile.Y * size + middle);
            uint* bucket = m_buckets.GetUnsafePtr();
            for (int lane = 0; lane < Lanes; lane++)
            {
                bucket[lane] = farX | y0 << 16;
                bucket[Lanes + lane] = (ushort)((int)tile.Z * size + middle);
            }
            return isKnown;
        }

        public void EndTile(in Grid3 tile)
        {
            int found = FindTile(tile);
            if (found < 0)
            {
                found = m_tiles.Length;
                if (2 * found >= m_tileOfSlot.Length)
                {
                    ClearSlots(2 * m_tileOfSlot.Length);
                    for (int t = 0; t < found; t++)
                        Insert(m_tiles[t], t);
                }
                m_tiles.Add(tile);
                Insert(tile, found);
                m_cells.ResizeUninitialized((found + 1) * CellsOfTile);
            }
            int* to = m_cells.GetUnsafePtr() + (long)found * CellsOfTile;
            int* local = (int*)m_local.GetUnsafePtr() + FirstOfLocal;
            for (int z = 0; z < Side; z++)
                for (int y = 0; y < Side; y++)
                    UnsafeUtility.MemCpy(to + Side * (y + Side * z), local + LocalSide * (y + LocalSide * z), Side * sizeof(int));
        }

        /// <summary>Whether a sample is nearer to a dart of the current tile than the spacing.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool IsNear(ulong dart)
        {
            if (X86.Avx2.IsAvx2Supported)
            {
                int* at = (int*)m_local.GetUnsafePtr() + OwnOf(dart, out int ox, out int oy, out int oz);
                uint* buckets = m_buckets.GetUnsafePtr();
                var xy = X86.Avx.mm256_set1_epi32((int)dart);
                var z = X86.Avx.mm256_set1_epi32((int)(dart >> 32 & 0xFFFF));
                var near = X86.Avx.mm256_set1_epi32(m_nearSq);
                if (X86.Avx2.mm256_movemask_epi8(X86.Avx2.mm256_cmpgt_epi32(near, DistancesSq(buckets, at[0], xy, z))) != 0)
                    return true;
                var min = DistancesSq(buckets, at[ox], xy, z);
                min = X86.Avx2.mm256_min_epi32(min, DistancesSq(buckets, at[oy], xy, z));
                min = X86.Avx2.mm256_min_epi32(min, DistancesSq(buckets, at[oz], xy, z));
                min = X86.Avx2.mm256_min_epi32(min, DistancesSq(buckets, at[ox + oy], xy, z));
                min = X86.Avx2.mm256_min_epi32(min, DistancesSq(buckets, at[ox + oz], xy, z));
                min = X86.Avx2.mm256_min_epi32(min, DistancesSq(buckets, at[oy + oz], xy, z));
                min = X86.Avx2.mm256_min_epi32(min, DistancesSq(buckets, at[ox + oy + oz], xy, z));
                if (X86.Avx2.mm256_movemask_epi8(X86.Avx2.mm256_cmpgt_epi32(near, min)) != 0)
                    return true;
                if (m_links[1] == 0)
                    return false;
            }
            return IsNearPlain(dart);
        }

        /// <summary>The same without intrinsics: Burst vectorizes its inner loop on other processors.</summary>
        internal bool IsNearPlain(ulong dart)
        {
            int* at = (int*)m_local.GetUnsafePtr() + OwnOf(dart, out int ox, out int oy, out int oz);
            for (int n = 0; n < 8; n++)
            {
                int bucket = at[(n & 1) * ox + (n >> 1 & 1) * oy + (n >> 2) * oz];
                for (; bucket != 0; bucket = m_links[2 * bucket + 1])
                {
                    short* sample = (short*)(m_buckets.GetUnsafePtr() + (long)bucket * WordsOfBucket);
                    bool isNear = false;
                    for (int lane = 0; lane < Lanes; lane++)
                        isNear |= DistanceSq(sample + 2 * lane, dart) < m_nearSq;
                    if (isNear)
                        return true;
                }
            }
            return false;
        }

        /// <summary>The point of the sample nearest to a dart of the current tile, the first on the curve in a tie.</summary>
        /// <returns>Whether one is nearer than the spacing.</returns>
        public bool Nearest(ulong dart, out int point)
        {
            int* at = (int*)m_local.GetUnsafePtr() + OwnOf(dart, out int ox, out int oy, out int oz);
            int* links = m_links.GetUnsafePtr(), pointOfLane = m_pointOfLane.GetUnsafePtr();
            uint* buckets = m_buckets.GetUnsafePtr();
            int nearest = m_nearSq;
            point = -1;
            for (int n = 0; n < 8; n++)
            {
                int bucket = at[(n & 1) * ox + (n >> 1 & 1) * oy + (n >> 2) * oz];
                for (; bucket != 0; bucket = links[2 * bucket + 1])
                {
                    short* sample = (short*)(buckets + (long)bucket * WordsOfBucket);
                    for (int lane = 0; lane < links[2 * bucket]; lane++)
                    {
                        int other = pointOfLane[bucket * Lanes + lane],
                            distanceSq = DistanceSq(sample + 2 * lane, dart);
                        if (distanceSq > nearest || distanceSq == nearest && (point < 0 || other > point))
                            continue;
                        nearest = distanceSq;
                        point = other;
                    }
                }
            }
            return nearest < m_nearSq;
        }

        public void Add(ulong dart, int point)
        {
            ref int cell = ref ((int*)m_local.GetUnsafePtr())[OwnOf(dart, out _, out _, out _)];
            if (cell == 0 || m_links[2 * cell] == Lanes)
            {
                int fresh = NewBucket(dart);
                m_links[2 * fresh + 1] = cell;
                if (cell != 0)
                    m_links[1] = 1;
                cell = fresh;
            }
            int lane = m_links[2 * cell]++;
            uint* bucket = m_buckets.GetUnsafePtr() + (long)cell * WordsOfBucket;
            bucket[lane] = (uint)dart;
            bucket[Lanes + lane] = (uint)(dart >> 32 & 0xFFFF);
            if (m_hasPoints)
                m_pointOfLane[cell * Lanes + lane] = point;
        }

        public void Dispose()
        {
            m_buckets.Dispose();
            m_links.Dispose();
            m_pointOfLane.Dispose();
            m_tiles.Dispose();
            m_cells.Dispose();
            m_tileOfSlot.Dispose();
            m_local.Dispose();
        }

        /// <summary>Creates a bucket whose empty entries are too far from all darts of the tile.</summary>
        int NewBucket(ulong dart)
        {
            int number = m_links.Length / 2;
            m_links.Add(0);
            m_links.Add(0);
            m_buckets.ResizeUninitialized((number + 1) * WordsOfBucket);
            if (m_hasPoints)
                m_pointOfLane.ResizeUninitialized((number + 1) * Lanes);
            uint* bucket = m_buckets.GetUnsafePtr() + (long)number * WordsOfBucket;
            uint far = (ushort)(dart + (1 << 14)) | (uint)dart & 0xFFFF0000;
            for (int lane = 0; lane < Lanes; lane++)
            {
                bucket[lane] = far;
                bucket[Lanes + lane] = (uint)(dart >> 32 & 0xFFFF);
            }
            return number;
        }

        /// <summary>Finds the cell of a dart in the current tile, and the steps to the cells on its side.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        int OwnOf(ulong dart, out int ox, out int oy, out int oz)
        {
            int shift = m_cell - m_dropped;
            int x = (int)((uint)(ushort)dart >> shift), y = (int)((uint)(ushort)(dart >> 16) >> shift);
            int z = (int)((uint)(ushort)(dart >> 32) >> shift);
            ox = (x & 1) * 2 - 1;
            oy = ((y & 1) * 2 - 1) * LocalSide;
            oz = ((z & 1) * 2 - 1) * (LocalSide * LocalSide);
            return FirstOfLocal + (x >> 1 & 7) + LocalSide * (y >> 1 & 7) + LocalSide * LocalSide * (z >> 1 & 7);
        }

        // Burst checks each method alone: an intrinsic guarded only by the caller is refused for other processors.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static v256 DistancesSq(uint* buckets, int number, v256 xy, v256 z)
        {
            v256 result = default;
            if (X86.Avx2.IsAvx2Supported)
            {
                uint* bucket = buckets + (long)number * WordsOfBucket;
                var dxy = X86.Avx2.mm256_sub_epi16(X86.Avx.mm256_loadu_si256(bucket), xy);
                var dz = X86.Avx2.mm256_sub_epi16(X86.Avx.mm256_loadu_si256(bucket + Lanes), z);
                result = X86.Avx2.mm256_add_epi32(X86.Avx2.mm256_madd_epi16(dxy, dxy), X86.Avx2.mm256_madd_epi16(dz, dz));
            }
            return result;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static int DistanceSq(short* sample, ulong dart)
        {
            int x = (short)(sample[0] - (int)dart), y = (short)(sample[1] - (int)(dart >> 16));
            int z = (short)(sample[2 * Lanes] - (int)(dart >> 32));
            return x * x + y * y + z * z;
        }

        void ClearSlots(int slots)
        {
            m_tileOfSlot.ResizeUninitialized(slots);
            UnsafeUtility.MemSet(m_tileOfSlot.GetUnsafePtr(), 0xFF, (long)slots * sizeof(int));
        }

        int FindTile(in Grid3 tile)
        {
            int mask = m_tileOfSlot.Length - 1;
            int* tileOfSlot = m_tileOfSlot.GetUnsafePtr();
            var tiles = m_tiles.GetUnsafePtr();
            int slot = SlotOf(tile) & mask;
            for (; tileOfSlot[slot] >= 0; slot = slot + 1 & mask)
            {
                ref var other = ref tiles[tileOfSlot[slot]];
                if (other.X == tile.X && other.Y == tile.Y && other.Z == tile.Z)
                    return tileOfSlot[slot];
            }
            return -1;
        }

        void Insert(in Grid3 tile, int number)
        {
            int mask = m_tileOfSlot.Length - 1, slot = SlotOf(tile) & mask;
            while (m_tileOfSlot[slot] >= 0)
                slot = slot + 1 & mask;
            m_tileOfSlot[slot] = number;
        }

        static int SlotOf(in Grid3 tile) =>
            (int)(((ulong)tile.X * 0x9E3779B97F4A7C15UL + (ulong)tile.Y * 0xC2B2AE3D27D4EB4FUL +
                (ulong)tile.Z * 0x165667B19E3779F9UL) >> 33);
    }
}
