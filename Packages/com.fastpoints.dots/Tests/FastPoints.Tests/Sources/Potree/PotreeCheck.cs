using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Sources
{
    static class PotreeCheck
    {
        /// <param name="value">Bits that a column must have for a point; null for a column that is not checked so.</param>
        public static List<int> Read(PointReader reader, PointSchema wanted,
            IReadOnlyList<BlockRange> ranges, int slots, string number, Func<int, string, ulong?> value)
        {
            var numbers = new List<int>();
            ReadPoints.InTurns(reader, wanted, ranges, slots, read => Check(read, number, value, numbers));
            return numbers;
        }

        public static void CheckSubsets(PointReader reader, string number, Func<int, string, ulong?> value)
        {
            var random = new Random(3);
            for (int i = 0; i < 12; i++)
            {
                var names = reader.Info.Schema.Select(a => a.Name).Where(n => n == number || random.Next(4) == 0);
                var ranges = ReadPoints.WholeBlocks(reader).OrderBy(_ => random.Next()).Select(whole =>
                {
                    int first = random.Next(whole.Count);
                    return new BlockRange(whole.Block, first, random.Next(1, whole.Count - first + 1));
                }).ToList();
                var got = Read(reader, reader.Info.Schema.Select(names.ToArray()), ranges, 1 + i % 4, number, value);
                Assert.That(got.Count, Is.EqualTo(ranges.Sum(range => range.Count)));
            }
        }

        static void Check(BlockRead read, string number, Func<int, string, ulong?> value, List<int> numbers)
        {
            var points = read.Points;
            var own = points.Column<int>(number);
            for (int i = 0; i < points.Count; i++)
                numbers.Add(own[i]);
            for (int column = 0; column < points.Schema.Count; column++)
            {
                var attribute = points.Schema[column];
                int size = attribute.Type.SizeOf();
                var bytes = points.Column<byte>(column, size);
                for (int i = 0; i < points.Count; i++)
                {
                    ulong? wanted = value(own[i], attribute.Name);
                    if (wanted == null)
                        continue;
                    ulong got = 0;
                    for (int k = size - 1; k >= 0; k--)
                        got = got << 8 | bytes[i * size + k];
                    if (got != wanted)
                        Assert.Fail("point " + own[i] + " of block " + read.Range.Block + ", "
                            + attribute.Name + ": wanted " + wanted + ", got " + got);
                }
            }
        }

        static NativeArray<byte> Column<T>(this PointBatch points, int column, int size) where T : unmanaged =>
            points.Bytes.GetSubArray(points.Column(column).OffsetBytes, points.Capacity * size);

        public static ulong Bits(int point, string attribute, int first, int count)
        {
            ulong bits = 0;
            for (int i = count - 1; i >= 0; i--)
                bits = bits << 8 | PotreeTestCloud.ByteOf(point, attribute, first + i);
            return bits;
        }

        /// <summary>What X, Y or Z must be, or null for another column.</summary>
        public static ulong? Position(PotreeTestCloud cloud, int point, string column) =>
            column == "X" ? (uint)cloud.Position(point).x : column == "Y" ? (uint)cloud.Position(point).y
            : column == "Z" ? (ulong?)(uint)cloud.Position(point).z : null;
    }

    static class PotreeTwins
    {
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
