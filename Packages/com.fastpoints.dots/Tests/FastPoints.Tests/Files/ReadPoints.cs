using System;
using FastPoints.Files;
using FastPoints.Points;
using Unity.Collections;

namespace FastPoints.Tests.Files
{
    /// <summary>Reads whole columns, or ranges, of any reader, block by block on the test's thread.</summary>
    static class ReadPoints
    {
        /// <summary>One column of all points.</summary>
        public static T[] Column<T>(PointReader reader, string name) where T : unmanaged
        {
            var values = new T[reader.PointCount];
            long done = 0;
            EachBlock(reader, reader.Info.Schema.Select(name), read =>
            {
                var column = read.Points.Column<T>(0);
                for (int i = 0; i < read.Points.Count; i++)
                    values[done++] = column[i];
            });
            return values;
        }

        /// <summary>Calls back with the decoded slot of each block in turn.</summary>
        /// <returns>Points that were read.</returns>
        public static long EachBlock(PointReader reader, PointSchema wanted, Action<BlockRead> visit)
        {
            long points = 0;
            using (var read = reader.CreateRead(wanted, reader.MaxPointsPerBlock, Allocator.Persistent))
                for (int block = 0; block < reader.BlockCount; block++)
                {
                    read.Begin(new BlockRange(block, 0, reader.PointsInBlock(block)));
                    read.Complete();
                    points += read.Points.Count;
                    visit(read);
                }
            return points;
        }
    }
}
