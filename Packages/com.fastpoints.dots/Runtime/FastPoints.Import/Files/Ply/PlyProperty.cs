using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>One property of a PLY element, as its header line declares it.</summary>
    public sealed class PlyProperty
    {
        public string Name;

        /// <summary>Of the value, or of a list's items.</summary>
        public AttributeType Type;

        public bool IsList;

        /// <summary>Of the number before a list's items. Always an integer.</summary>
        public AttributeType CountType;

        /// <summary>Byte at which the header line starts.</summary>
        public long LineOffset;
    }
}
