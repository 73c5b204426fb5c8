using System;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;

namespace FastPoints.Tests.Files
{
    /// <summary>Clouds of the same points in another order: what is compared of them.</summary>
    static class PotreeTwins
    {
        /// <summary>An open source whose blocks are known.</summary>
        public static PointReader Open(string path)
        {
            var reader = PointReaders.Open(path);
            if (!reader.BlocksAreKnown)
                WorkPump.RunToEnd(reader.FindBlocks());
            return reader;
        }

        /// <summary>One column's bits, as the file has them.</summary>
        public static ulong[] Bits(PointReader reader, string name) =>
            reader.Info.Schema[reader.Info.Schema.IndexOf(name)].Type.SizeOf() switch
            {
                1 => Array.ConvertAll(ReadPoints.Column<byte>(reader, name), v => (ulong)v),
                2 => Array.ConvertAll(ReadPoints.Column<ushort>(reader, name), v => (ulong)v),
                4 => Array.ConvertAll(ReadPoints.Column<uint>(reader, name), v => (ulong)v),
                _ => ReadPoints.Column<ulong>(reader, name),
            };

        /// <summary>A hash of each point, sorted: equal for clouds of the same points in any order.</summary>
        /// <param name="quantise">From a georeferenced coordinate to the grid that is compared, by axis; null for the stored
        /// numbers.</param>
        public static ulong[] Hashes(PointReader reader, string[] names, Func<double, int, int> quantise)
        {
            var hashes = new ulong[reader.PointCount];
            for (int axis = 0; axis < 3; axis++)
            {
                var stored = ReadPoints.Column<int>(reader, new[] { "X", "Y", "Z" }[axis]);
                var transform = reader.Info.Transform;
                for (int i = 0; i < hashes.Length; i++)
                    Mix(ref hashes[i], (uint)(quantise == null ? stored[i]
                        : quantise(stored[i] * transform.Scale[axis] + transform.Offset[axis], axis)));
            }
            foreach (string name in names)
            {
                var bits = Bits(reader, name);
                for (int i = 0; i < hashes.Length; i++)
                    Mix(ref hashes[i], bits[i]);
            }
            Array.Sort(hashes);
            return hashes;
        }

        static void Mix(ref ulong hash, ulong value)
        {
            hash = (hash ^ value) * 0x9E3779B97F4A7C15UL;
            hash ^= hash >> 29;
        }
    }
}
