using FastPoints.Core;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    struct Potree1Node
    {
        public int Level;
        public int3 Cell;

        /// <summary>Points according to the hierarchy.</summary>
        public long Claimed;
        public string Path;

        /// <summary>-1 if there is no such file.</summary>
        public long Bytes;

        /// <summary>Points according to the header of a LAS or LAZ file.</summary>
        public long PointsOfLas;

        /// <summary>Why such a file cannot be read, or null.</summary>
        public string Problem;
    }

    /// <summary>An .hrc file that was read.</summary>
    struct Potree1Page
    {
        public ByteReader Records;
        public long FileBytes;

        /// <summary>Why it cannot be used, or null.</summary>
        public PointCloudException Problem;
    }
}
