using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Sources;
using Unity.Collections;

namespace FastPoints.Tests.Reading
{
    /// <summary>Reads whole columns, or ranges, of any reader, block by block on the test's thread.</summary>
    static class ReadPoints
    {
        public static PointReader Open(string path)
        {
            var reader = PointReaders.Open(path);
            try
            {
                IndexBlocks(reader);
                return reader;
            }
            catch
            {
                reader.Dispose();
                throw;
            }
        }

        public static void IndexBlocks(PointReader reader)
        {
            if (!reader.BlocksAreKnown)
                JobCoroutine.RunToEnd(reader.IndexBlocks());
        }

        public static List<BlockRange> WholeBlocks(PointReader reader) =>
            Enumerable.Range(0, reader.BlockCount)
                .Select(block => new BlockRange(block, 0, reader.PointsInBlock(block))).ToList();

        public static void InTurns(PointReader reader, PointSchema wanted, IReadOnlyList<BlockRange> ranges, int slots,
            Action<BlockRead> visit)
        {
            var reads = new BlockRead[Math.Max(1, Math.Min(slots, ranges.Count))];
            try
            {
                for (int i = 0; i < reads.Length; i++)
                    reads[i] = reader.CreateRead(wanted, Math.Max(1, reader.MaxPointsPerBlock), Allocator.Persistent);
                for (int i = 0; i < ranges.Count + reads.Length; i++)
                {
                    var read = reads[i % reads.Length];
                    if (i >= reads.Length && i - reads.Length < ranges.Count)
                    {
                        read.Complete();
                        visit(read);
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
        }

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
