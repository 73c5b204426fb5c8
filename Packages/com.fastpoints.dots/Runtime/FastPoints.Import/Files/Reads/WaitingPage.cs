using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>A page of an octree's hierarchy that is known and not read.</summary>
    public struct WaitingPage
    {
        /// <summary>Key of the node that it begins with.</summary>
        public int4 Root;

        /// <summary>Where it lies in its file; nothing where it is a file of its own.</summary>
        public long Offset;
        public long Bytes;

        /// <summary>Rises from page to page.</summary>
        public int Number;
    }
}
