using FastPoints.Points;

namespace FastPoints.Files
{
    enum PlyStepKind : byte
    {
        /// <summary>Values that nobody asked for.</summary>
        Skip,
        /// <summary>A value that goes into a column.</summary>
        Value,
        /// <summary>A list, passed over.</summary>
        List,
    }

    /// <summary>One step through one instance of an element. Blittable: jobs carry arrays of these.</summary>
    struct PlyStep
    {
        public PlyStepKind Kind;

        /// <summary>Of the value, or of a list's count.</summary>
        public AttributeType Type;

        /// <summary>Skip: values. List: bytes of an item.</summary>
        public int Count;

        /// <summary>In a binary file: of the skipped values, of the value, of a list's count.</summary>
        public int Bytes;

        /// <summary>Value: where its column starts in the batch.</summary>
        public int ColumnOffsetBytes;
    }
}
