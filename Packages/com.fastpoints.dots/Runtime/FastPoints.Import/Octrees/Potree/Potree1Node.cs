using FastPoints.Core;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    struct Potree1Node
    {
        public int Level;
        public int3 Cell;

        // According to the hierarchy.
        public long Claimed;
        public string Path;

        // -1 if there is no such file.
        public long Bytes;

        public long PointsOfLas;

        // Why such a file cannot be read, or null.
        public string Problem;
    }

    struct Potree1Page
    {
        public ByteReader Records;
        public long FileBytes;

        // Why it cannot be used, or null.
        public PointCloudException Problem;
    }
}
