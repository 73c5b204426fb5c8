using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Reading
{
    sealed class Tile
    {
        public string Path;
        public long FileBytes;

        // Shared by all tiles with equal schemas.
        public PointSchema Schema;

        public PositionTransform Transform;

        // A header gave the blocks: the reader can be closed and reopened.
        public bool IsKnown;

        public bool HasFixedStride;
        public int RecordBytes;
        public int FirstBlock;
        public int BlockCount;
        public int MaxPointsPerBlock;
        public long FirstPoint;
        public long Points;

        // Null while it is not open.
        public PointReader Reader;

        // It may hold a file's handle.
        public bool IsOpen;
        public int Users;

        // Larger for tiles that were used later.
        public long LastUse;

        // Indices among the cloud's; null for none.
        public List<int> Warnings;
    }
}
