using FastPoints.Points;

namespace FastPoints.Records
{
    /// <summary>From a column of a batch to its place in a record. Blittable.</summary>
    public struct RecordField
    {
        public PointColumn Column;

        /// <summary>From the record's first attribute byte.</summary>
        public int RecordOffset;

        /// <summary>Index of the attribute in the cloud's schema.</summary>
        public int Attribute;
    }
}
