using System.Runtime.CompilerServices;
using FastPoints.Points;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Samplers
{
    /// <summary>The parts of one tile in which no point can be taken any more, as cells of a quarter of the spacing, a bit each:
    /// most darts need one look and no distance. A bit says "nowhere in this cell"; where it is not set, distances
    /// decide.</summary>
    /// <remarks>
    /// A sample covers a cell where the farthest two places of its own cell and that one are nearer than the spacing: about two
    /// fifths of what it really keeps off, and after a tile four fifths of its darts. A row of a tile is one word:
    /// <code>
    /// word y + 64 z, bit x: cell (x, y, z)
    /// </code>
    /// </remarks>
    unsafe struct PoissonCover
    {
        /// <summary>Words of the memory that it works in.</summary>
        public const int Words = CellsPerTile * CellsPerTile + (RowsOfSample * RowsOfSample + 7) / 8;

        // A tile has an edge of 16 spacings.
        public const int TileSpacingsLog2 = CellsPerTileLog2 - CellsPerSpacingLog2;
        const int CellsPerTileLog2 = 6;
        const int CellsPerTile = 1 << CellsPerTileLog2;
        const int CellsPerSpacingLog2 = 2;

        // A sample covers cells up to this many away from its own.
        const int Reach = (1 << CellsPerSpacingLog2) - 1;
        const int RowsOfSample = 2 * Reach + 1;

        // In the memory's last words, for each row around a sample's own: the cells that it covers, the first one Reach before
        // its own.
        const int BeginOfMasks = CellsPerTile * CellsPerTile;

        [NativeDisableUnsafePtrRestriction] readonly ulong* m_rows;
        [NativeDisableUnsafePtrRestriction] readonly byte* m_masks;
        readonly int m_shift;
        readonly Grid3 m_corner;

        /// <param name="memory">Memory with room for <see cref="Words"/>, which is kept while the spacing is the same.</param>
        /// <param name="spacingLog2">log2 of the samples' spacing.</param>
        /// <param name="place">Any position in the tile.</param>
        public PoissonCover(ulong* memory, int spacingLog2, Grid3 place)
        {
            m_rows = memory;
            m_masks = (byte*)(memory + BeginOfMasks);
            m_shift = ShiftOf(spacingLog2);
            long whole = -1L << m_shift + CellsPerTileLog2;
            m_corner = new Grid3(place.X & whole, place.Y & whole, place.Z & whole);
        }

        static int ShiftOf(int spacingLog2) => math.max(0, spacingLog2 - CellsPerSpacingLog2);

        /// <summary>Begins a new spacing: finds which cells a sample covers.</summary>
        public static void Begin(ulong* memory, int spacingLog2)
        {
            var masks = (byte*)(memory + BeginOfMasks);
            // Squares are in steps, since positions are whole numbers; cells of many steps count as 256 steps.
            int shift = ShiftOf(spacingLog2), step = math.min(shift, 8), spacing = spacingLog2 - shift + step;
            for (int z = -Reach; z <= Reach; z++)
            {
                for (int y = -Reach; y <= Reach; y++)
                {
                    int covered = 0;
                    for (int x = -Reach; x <= Reach; x++)
                        if (FarthestSq(x, step) + FarthestSq(y, step) + FarthestSq(z, step) < 1 << 2 * spacing)
                            covered |= 1 << x + Reach;
                    masks[(z + Reach) * RowsOfSample + y + Reach] = (byte)covered;
                }
            }
        }

        /// <summary>Begins a new tile, with nothing covered.</summary>
        public void Clear() => UnsafeUtility.MemClear(m_rows, BeginOfMasks * sizeof(ulong));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool IsCovered(Grid3 place) =>
            (m_rows[RowOf(place)] >> (int)(place.X - m_corner.X >> m_shift) & 1) != 0;

        /// <summary>Adds a sample of the tile.</summary>
        public void Cover(Grid3 place)
        {
            int x = (int)(place.X - m_corner.X >> m_shift) - Reach;
            int y = (int)(place.Y - m_corner.Y >> m_shift) - Reach;
            int z = (int)(place.Z - m_corner.Z >> m_shift) - Reach;
            for (int dz = math.max(0, -z), endZ = math.min(RowsOfSample, CellsPerTile - z); dz < endZ; dz++)
            {
                for (int dy = math.max(0, -y), endY = math.min(RowsOfSample, CellsPerTile - y); dy < endY; dy++)
                {
                    ulong covered = m_masks[dz * RowsOfSample + dy];
                    if (covered != 0)
                        m_rows[y + dy + CellsPerTile * (z + dz)] |= x >= 0 ? covered << x : covered >> -x;
                }
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        int RowOf(Grid3 place) =>
            (int)(place.Y - m_corner.Y >> m_shift) + CellsPerTile * (int)(place.Z - m_corner.Z >> m_shift);

        /// <summary>Square of the largest distance between positions in two cells along one axis.</summary>
        static int FarthestSq(int cells, int shift)
        {
            int farthest = (math.abs(cells) + 1 << shift) - 1;
            return farthest * farthest;
        }
    }
}
