using FastPoints.Points;

namespace FastPoints.Files
{
    enum TileColumnKind : byte
    {
        /// <summary>Values as they are.</summary>
        Copy,
        /// <summary>The tile has no such attribute.</summary>
        Zero,
        /// <summary>Integers to wider ones: stored * Factor.</summary>
        Integer,
        /// <summary>Positions to places on the common grid: stored * Factor + Shift, as int64.</summary>
        Place,
        /// <summary>Any numbers to floats: stored * Scale + Offset.</summary>
        Real,
    }

    /// <summary>How one column of a tile becomes that of the whole cloud. Blittable: jobs carry arrays of these.</summary>
    struct TileColumn
    {
        public TileColumnKind Kind;
        public PointColumn From;
        public PointColumn To;
        public long Factor;
        public long Shift;
        public double Scale;
        public double Offset;
    }
}
