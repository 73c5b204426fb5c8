using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // One entry of a hierarchy page: a node with points, a node without, or another page.
    // int level, x, y, z | ulong offset | int bytes | int points (-1: bytes at offset are a page that starts with this node)
    internal struct CopcEntry
    {
        public const int Bytes = 32;
        public const int PageCount = -1;

        // The cells of deeper nodes do not fit into an int.
        public const int MaxLevel = 30;

        public int Level;
        public int3 Cell;
        public ulong Offset;
        public int ByteSize;
        public int PointCount;

        public bool IsPage => PointCount == PageCount;

        public bool HasKey => Level >= 0 && Level <= MaxLevel && math.all(Cell >= 0) && math.all(Cell < 1 << Level);

        public int4 Key => new int4(Cell.x, Cell.y, Cell.z, Level);

        public static CopcEntry Read(ByteReader bytes, int at) => new CopcEntry
        {
            Level = bytes.Int32(at, "level"),
            Cell = new int3(bytes.Int32(at + 4, "x"), bytes.Int32(at + 8, "y"), bytes.Int32(at + 12, "z")),
            Offset = bytes.UInt64(at + 16, "offset of a node"),
            ByteSize = bytes.Int32(at + 24, "bytes of a node"),
            PointCount = bytes.Int32(at + 28, "points of a node"),
        };
    }
}
