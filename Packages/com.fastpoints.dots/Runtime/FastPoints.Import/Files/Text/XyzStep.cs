using FastPoints.Points;

namespace FastPoints.Files
{
    enum XyzStepKind : byte
    {
        /// <summary>A column without a name: anything.</summary>
        Skip,
        /// <summary>A number that nobody asked for.</summary>
        Check,
        /// <summary>A coordinate, as a whole number of 10^-Decimals.</summary>
        Place,
        Integer,
        Float32,
        Float64,
    }

    /// <summary>What is done with one column of a line. Blittable: jobs carry arrays of these.</summary>
    struct XyzStep
    {
        public XyzStepKind Kind;
        public AttributeType Type;
        public int Bytes;
        public int Decimals;

        /// <summary>Whether a line without the value, not even in text, is no point.</summary>
        public bool IsPosition;

        /// <summary>Whether the batch has the column: coordinates are read in any case, so that the same lines are points
        /// whatever is asked for.</summary>
        public bool IsStored;

        /// <summary>Where its column starts in the batch.</summary>
        public int ColumnOffsetBytes;
    }
}
