using System.Collections.Generic;
using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>One file of several, as far as it is kept while the file is not open.</summary>
    sealed class Tile
    {
        public string Path;
        public long FileBytes;

        /// <summary>One object for all tiles of equal schemas.</summary>
        public PointSchema Schema;

        public PositionTransform Transform;

        /// <summary>Whether a header gave the blocks: then the reader can be closed and opened again.</summary>
        public bool IsKnown;

        public bool HasFixedStride;
        public int RecordBytes;

        /// <summary>Over the whole cloud.</summary>
        public int FirstBlock;

        public int BlockCount;
        public int MaxPointsPerBlock;
        public long FirstPoint;
        public long Points;

        /// <summary>Null while it is not open.</summary>
        public PointReader Reader;

        /// <summary>Whether it may hold a file's handle.</summary>
        public bool IsOpen;

        /// <summary>Slots that read from it.</summary>
        public int Users;

        /// <summary>The larger, the later it was used.</summary>
        public long LastUse;

        /// <summary>Where the tile's warnings stand among the cloud's; null for none.</summary>
        public List<int> Warnings;
    }
}
