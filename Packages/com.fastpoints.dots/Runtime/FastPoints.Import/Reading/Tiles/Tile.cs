using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Reading
{
    /// <summary>One of several files, as far as it is kept while the file is not open.</summary>
    sealed class Tile
    {
        public string Path;
        public long FileBytes;

        /// <summary>Shared by all tiles with equal schemas.</summary>
        public PointSchema Schema;

        public PositionTransform Transform;

        /// <summary>Whether a header gave the blocks, so that the reader can be closed and reopened.</summary>
        public bool IsKnown;

        public bool HasFixedStride;
        public int RecordBytes;

        /// <summary>Index of its first block and point in the whole cloud.</summary>
        public int FirstBlock;

        public int BlockCount;
        public int MaxPointsPerBlock;
        public long FirstPoint;
        public long Points;

        /// <summary>Null while it is not open.</summary>
        public PointReader Reader;

        /// <summary>Whether it may hold a file's handle.</summary>
        public bool IsOpen;

        /// <summary>Number of slots that read from it.</summary>
        public int Users;

        /// <summary>Larger for tiles that were used later.</summary>
        public long LastUse;

        /// <summary>Indices of the tile's warnings among the cloud's; null for none.</summary>
        public List<int> Warnings;
    }
}
