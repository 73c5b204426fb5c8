namespace FastPoints.Points
{
    /// <summary>Where one attribute's values lie in a batch's memory. Blittable: jobs carry arrays of these.</summary>
    public struct PointColumn
    {
        /// <summary>Byte offset of the first value; a multiple of 64.</summary>
        public int OffsetBytes;

        public AttributeType Type;
    }
}
