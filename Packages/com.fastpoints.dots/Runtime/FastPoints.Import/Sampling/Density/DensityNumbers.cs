namespace FastPoints.Sampling
{
    /// <summary>How the cells of a <see cref="DensityTree"/> are numbered.</summary>
    static class DensityNumbers
    {
        /// <summary>Numbers of the first cells: the whole cube and the space outside it; then come the bricks.</summary>
        public const int Root = 0, Outside = 1;

        /// <summary>The code of a point outside the cube.</summary>
        public const uint OutsideCode = uint.MaxValue;

        /// <summary>The most levels of cells: a code has three bits for each.</summary>
        public const int Levels = 8;

        public const int FineCells = 64;
        public const int CoarseCells = 8, CellsOfBrick = CoarseCells + FineCells, FirstBrick = 2;

        public static int CoarseCell(int brick, int coarse) => FirstBrick + brick * CellsOfBrick + coarse;

        public static int FineCell(int brick, int fine) => FirstBrick + brick * CellsOfBrick + CoarseCells + fine;

        /// <summary>A point's fine cell within its brick at a depth.</summary>
        public static int FineOf(uint code, int depth) => (int)(code >> 3 * (Levels - 2 * (depth + 1)) & FineCells - 1);
    }
}
