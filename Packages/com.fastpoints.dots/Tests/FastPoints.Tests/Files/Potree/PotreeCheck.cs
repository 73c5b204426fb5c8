using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Files;
using FastPoints.Points;
using FastPoints.Tests.Support;
using NUnit.Framework;
using Unity.Collections;

namespace FastPoints.Tests.Files
{
    /// <summary>Holds what a reader gives against the cloud that a test wrote.</summary>
    static class PotreeCheck
    {
        /// <summary>Reads ranges in the order given, several at once, and checks all values of all wanted columns.</summary>
        /// <param name="number">The column that has the points' numbers.</param>
        /// <param name="value">Bits that a column must have for a point; null for a column that is not checked so.</param>
        /// <returns>Numbers of the points that came.</returns>
        public static List<int> Read(PointReader reader, PointSchema wanted,
            IReadOnlyList<BlockRange> ranges, int slots, string number, Func<int, string, ulong?> value)
        {
            var numbers = new List<int>();
            var reads = new BlockRead[slots];
            try
            {
                for (int i = 0; i < slots; i++)
                    reads[i] = reader.CreateRead(wanted, reader.MaxPointsPerBlock, Allocator.Persistent);
                for (int i = 0; i < ranges.Count + slots; i++)
                {
                    var read = reads[i % slots];
                    if (i >= slots && i - slots < ranges.Count)
                    {
                        read.Complete();
                        Check(read, number, value, numbers);
                    }
                    if (i < ranges.Count)
                        read.Begin(ranges[i]);
                }
            }
            finally
            {
                foreach (var read in reads)
                    read?.Dispose();
            }
            return numbers;
        }

        public static List<BlockRange> WholeBlocks(PointReader reader) =>
            Enumerable.Range(0, reader.BlockCount)
                .Select(block => new BlockRange(block, 0, reader.PointsInBlock(block))).ToList();

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

        /// <summary>Bits of hashed bytes of an attribute.</summary>
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
}
