using FastPoints.Core;

namespace FastPoints.Nodes
{
    /// <summary>What a sampler knows of a range's points before it decides how to handle them.</summary>
    internal unsafe struct RangeSurvey
    {
        // There is one for each side from a step's to the largest cube's, and one beyond all.
        public const int Sides = GridCube.MaxSideLog2 + 3;

        /// <summary>Number of points.</summary>
        public int Left;

        /// <summary>log2 of the side of the smallest cube with all of them.</summary>
        public int Largest;

        /// <summary>Number of cells of any size, apart from those below.</summary>
        public int AnyCell;

        /// <summary>For each log2 of a side: how many more such cells there are if cells are smaller than this.</summary>
        public fixed int CellsBelow[Sides];

        /// <summary>The finest cells with which a node does not become too large: those that the sizes give, or coarser ones in a
        /// filled volume.</summary>
        /// <param name="cells">The number of cells with points.</param>
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
