using System.Collections.Generic;
using Unity.Mathematics;
using Random = System.Random;

namespace FastPoints.Tests
{
    /// <summary>A seeded cloud in an octree: points on a grid of steps, each in a node of a hashed level. A point's values follow
    /// from its number, which it carries, so that a reader's results can be compared.</summary>
    public sealed class PotreeTestCloud
    {
        /// <summary>Steps of the cube's edge: no multiple of the leaves', so that their corners lie between steps.</summary>
        public const int Edge = 1001;

        readonly int3[] m_positions;
        readonly SortedDictionary<string, List<int>> m_pointsOfNode;

        public PotreeTestCloud(int points, int depth, int seed)
        {
            var random = new Random(seed);
            m_positions = new int3[points];
            m_pointsOfNode = new SortedDictionary<string, List<int>>(Comparer<string>.Create((a, b) =>
                a.Length != b.Length ? a.Length.CompareTo(b.Length) : string.CompareOrdinal(a, b)));
            m_pointsOfNode.Add("r", new List<int>());
            for (int i = 0; i < points; i++)
            {
                // Along a line, so that there are not too many nodes: each may be a file.
                int along = random.Next(Edge);
                m_positions[i] = new int3(along, math.clamp(along + random.Next(-5, 6), 0, Edge - 1), random.Next(20));
                string name = NodeAt(m_positions[i], random.Next(depth + 1));
                for (int length = 1; length <= name.Length; length++)
                    if (!m_pointsOfNode.ContainsKey(name.Substring(0, length)))
                        m_pointsOfNode.Add(name.Substring(0, length), new List<int>());
                m_pointsOfNode[name].Add(i);
            }
        }

        public int Count => m_positions.Length;
        public IReadOnlyDictionary<string, List<int>> PointsOfNode => m_pointsOfNode;

        public int3 Position(int point) => m_positions[point];

        public int ChildMask(string node)
        {
            int mask = 0;
            for (int child = 0; child < 8; child++)
                mask |= m_pointsOfNode.ContainsKey(node + (char)('0' + child)) ? 1 << child : 0;
            return mask;
        }

        public static double3 Corner(string node)
        {
            double3 corner = 0;
            double edge = Edge;
            for (int i = 1; i < node.Length; i++)
            {
                edge /= 2;
                int child = node[i] - '0';
                corner += edge * new double3(child >> 2 & 1, child >> 1 & 1, child & 1);
            }
            return corner;
        }

        static string NodeAt(int3 position, int level)
        {
            string name = "r";
            double3 corner = 0;
            double edge = Edge;
            for (int i = 0; i < level; i++)
            {
                edge /= 2;
                int child = 0;
                for (int axis = 0; axis < 3; axis++)
                    if (position[axis] >= corner[axis] + edge)
                    {
                        child |= 4 >> axis;
                        corner[axis] += edge;
                    }
                name += (char)('0' + child);
            }
            return name;
        }

        public static byte ByteOf(int point, string attribute, int at)
        {
            uint hash = (uint)point * 2654435761u ^ (uint)at * 40503u;
            foreach (char c in attribute)
                hash = (hash ^ c) * 16777619u;
            return (byte)(hash >> 17);
        }
    }

    public sealed class PotreeTestAttribute
    {
        public readonly string Name;
        public readonly string Type;
        public readonly int Elements;
        public readonly int ElementBytes;

        public PotreeTestAttribute(string name, string type, int elements = 1)
        {
            Name = name;
            Type = type;
            Elements = elements;
            ElementBytes = type == "double" || type.EndsWith("64") ? 8 : type == "float" || type.EndsWith("32") ? 4
                : type.EndsWith("16") ? 2 : 1;
        }

        public int Bytes => Elements * ElementBytes;
    }
}
