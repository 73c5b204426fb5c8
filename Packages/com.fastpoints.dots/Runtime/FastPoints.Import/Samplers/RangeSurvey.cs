namespace FastPoints.Samplers
{
    /// <summary>What a sampler sees of a range's points before it decides what becomes of them.</summary>
    internal unsafe struct RangeSurvey
    {
        // Sides from a step's to the largest cube's, and one beyond all.
        public const int Sides = Points.GridCube.MaxSideLog2 + 3;

        /// <summary>Points that are in no node yet.</summary>
        public int Left;

        /// <summary>log2 of the side of the smallest cube that has them all.</summary>
        public int Largest;

        /// <summary>Cells of any size without a point of a node above, but for those below.</summary>
        public int AnyCell;

        /// <summary>By log2 of a side: such cells that there are more of where cells are smaller than this.</summary>
        public fixed int CellsBelow[Sides];

        /// <summary>The finest cells with which a node does not become too large: those that the sizes say, coarser in a filled
        /// volume.</summary>
        /// <param name="cells">How many of them have points of which none is in a node above.</param>
        public readonly int FinestCell(in NodeSizes sizes, out int cells)
        {
            int finest = Largest > sizes.CellsLog2 ? Largest - sizes.CellsLog2 : 0;
            int best = Largest, more = AnyCell;
            for (int side = Sides - 1; side > Largest; side--)
                more += CellsBelow[side];
            cells = more;
            for (int cell = Largest - 1; cell >= finest; cell--)
            {
                more += CellsBelow[cell + 1];
                if (more > sizes.MaxPointsPerNode)
                    break;
                best = cell;
                cells = more;
            }
            return best;
        }
    }
}
