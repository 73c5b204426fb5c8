namespace FastPoints.Core
{
    /// <summary>A cube of a power-of-two side on a cloud's grid: it contains all positions from its corner to less than a side
    /// beyond it.</summary>
    /// <remarks>Sides end at 2^62, so that sums of corners and sides stay within a long.</remarks>
    public struct GridCube
    {
        /// <summary>Larger sides are refused.</summary>
        public const int MaxSideLog2 = 62;

        public Grid3 Corner;
        public int SideLog2;

        public GridCube(Grid3 corner, int sideLog2)
        {
            Corner = corner;
            SideLog2 = sideLog2;
        }

        /// <summary>Grid steps along an edge.</summary>
        public long Side => 1L << SideLog2;

        public bool Contains(Grid3 place) =>
            (ulong)(place.X - Corner.X) >> SideLog2 == 0 && (ulong)(place.Y - Corner.Y) >> SideLog2 == 0 &&
            (ulong)(place.Z - Corner.Z) >> SideLog2 == 0;

        public bool Contains(GridCube other) => other.SideLog2 <= SideLog2 && Contains(other.Corner);

        /// <summary>One of the eight cubes of half the side: bit 0 of the octant is x, bit 1 y, bit 2 z.</summary>
        public GridCube Child(int octant)
        {
            long half = 1L << (SideLog2 - 1);
            return new GridCube(
                Corner + new Grid3((octant & 1) * half, (octant >> 1 & 1) * half, (octant >> 2 & 1) * half), SideLog2 - 1);
        }

        /// <summary>The octant of a position inside.</summary>
        public int OctantOf(Grid3 place)
        {
            int bit = SideLog2 - 1;
            return (int)((place.X - Corner.X) >> bit & 1) | (int)((place.Y - Corner.Y) >> bit & 1) << 1 |
                (int)((place.Z - Corner.Z) >> bit & 1) << 2;
        }

        public override string ToString() => "(" + Corner + ") + 2^" + SideLog2;
    }
}
