using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // r, then a digit a level: 4 x + 2 y + z, each 0 for the lower half of the axis.
    internal static class PotreeNames
    {
        public static string NameOf(int level, int3 cell)
        {
            var name = new char[level + 1];
            name[0] = 'r';
            for (int i = 1; i <= level; i++)
                name[i] = (char)('0' + ChildOf(cell >> level - i));
            return new string(name);
        }

        public static bool TryParse(string name, int maxLevels, out int level, out int3 cell)
        {
            level = name.Length - 1;
            cell = default;
            if (level < 0 || level > maxLevels || name[0] != 'r')
                return false;
            for (int i = 1; i < name.Length; i++)
            {
                int child = name[i] - '0';
                if (child < 0 || child > 7)
                    return false;
                cell = Child(cell, child);
            }
            return true;
        }

        public static int3 Child(int3 cell, int child) => cell * 2 + new int3(child >> 2 & 1, child >> 1 & 1, child & 1);

        static int ChildOf(int3 cell) => (cell.x & 1) << 2 | (cell.y & 1) << 1 | cell.z & 1;
    }
}
