using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>The cells that samples are compared in: cubes of a 256th of the longest edge of a box, counted from its lowest
    /// corner. A cell's place is a Morton code of 27 bits, so that eight consecutive cells are one of a 256th, 64 one of a 128th,
    /// 512 one of a 64th, and 2^18 one of an eighth. Blittable, for jobs.</summary>
    public readonly struct ErrorGrid
    {
        public const int Cells = 512;

        /// <summary>Cells of a 64th of the edge, each with 512 of the finest in it.</summary>
        public const int Blocks = 64 * 64 * 64;

        public const int Regions = 8 * 8 * 8;

        public readonly BoundsGeo Bounds;

        /// <summary>0 for a box without extent: all is in one cell.</summary>
        public readonly double CellsPerUnit;

        public ErrorGrid(BoundsGeo bounds)
        {
            Bounds = bounds;
            double edge = math.cmax(bounds.Size);
            double perUnit = Cells / edge;
            CellsPerUnit = edge > 0 && perUnit <= double.MaxValue ? perUnit : 0;
        }

        public bool TryCell(double x, double y, double z, out uint cell)
        {
            double3 min = Bounds.Min, max = Bounds.Max;
            cell = 0;
            // Written so that a coordinate that is no number is outside.
            if (!(x >= min.x && x <= max.x && y >= min.y && y <= max.y && z >= min.z && z <= max.z))
                return false;
            uint cellX = Along(x - min.x), cellY = Along(y - min.y), cellZ = Along(z - min.z);
            cell = (uint)Morton.Encode(cellX, cellY, cellZ);
            return true;
        }

        uint Along(double distance) => (uint)math.min(Cells - 1, (int)(distance * CellsPerUnit));
    }
}
