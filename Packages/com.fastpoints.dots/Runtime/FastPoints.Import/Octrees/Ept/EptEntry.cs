using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    /// <summary>One entry of a hierarchy page: <c>"level-x-y-z": points</c>.</summary>
    internal struct EptEntry
    {
        /// <summary>The point count that stands for "a page of its own".</summary>
        public const long PageCount = -1;

        /// <summary>The cells of deeper nodes do not fit into an int.</summary>
        public const int MaxLevel = 30;

        /// <summary>-1 if the key is invalid.</summary>
        public int Level;
        public int3 Cell;
        public long Points;

        /// <summary>Offset of the key in its page.</summary>
        public int At;

        public bool IsPage => Points == PageCount;

        public bool HasKey => Level >= 0 && Level <= MaxLevel && math.all(Cell >= 0) && math.all(Cell < 1 << Level);

        public int4 Key => new int4(Cell.x, Cell.y, Cell.z, Level);

        public string Name => NameOf(Level, Cell);

        /// <summary>The name of the node's files, without extensions.</summary>
        public static string NameOf(int level, int3 cell) =>
            NumberText.Of(level) + "-" + NumberText.Of(cell.x) + "-" + NumberText.Of(cell.y) + "-" + NumberText.Of(cell.z);
    }
}
