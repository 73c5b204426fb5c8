using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    internal struct EptEntry
    {
        // A page of its own.
        public const long PageCount = -1;

        // The cells of deeper nodes do not fit into an int.
        public const int MaxLevel = 30;

        // -1 if the key is invalid.
        public int Level;
        public int3 Cell;
        public long Points;
        public int At;

        public bool IsPage => Points == PageCount;

        public bool HasKey => Level >= 0 && Level <= MaxLevel && math.all(Cell >= 0) && math.all(Cell < 1 << Level);

        public int4 Key => new int4(Cell.x, Cell.y, Cell.z, Level);

        public string Name => NameOf(Level, Cell);

        public static string NameOf(int level, int3 cell) =>
            NumberText.Of(level) + "-" + NumberText.Of(cell.x) + "-" + NumberText.Of(cell.y) + "-" + NumberText.Of(cell.z);
    }
}
