using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Laz;
using FastPoints.Reading;
using FastPoints.Sources;
using NUnit.Framework;

namespace FastPoints.Tests.Laz
{
    public class LazManyChunksTests : FolderTests
    {
        const int Chunks = 300_000, PointsPerChunk = 10;

        string FilePath => Folder.File("cloud.laz");

        static List<int> Bytes(int chunks)
        {
            var random = new Random(7);
            var bytes = new List<int>();
            for (int i = 0; i < chunks; i++)
                bytes.Add(random.Next(40, 1000));
            return bytes;
        }

        long Write(List<int> bytes, List<int> points, byte[] table)
        {
            var writer = new LazFileWriter
            {
                PointFormat = 0,
                ChunkPoints = new[] { PointsPerChunk },
                HasVariableChunks = points != null,
                Claims = (long)bytes.Count * PointsPerChunk,
            };
            var head = writer.Write(LazRecords.Make(0, 0, 1, 5));
            long offset = writer.Chunks[0].Offset, end = offset;
            foreach (int count in bytes)
                end += count;
            using var file = new FileStream(FilePath, FileMode.Create, FileAccess.Write);
            file.Write(head, 0, (int)offset - LazChunkTable.TableOffsetSize);
            file.Write(BitConverter.GetBytes(end), 0, LazChunkTable.TableOffsetSize);
            file.Position = end;
            file.Write(table, 0, table.Length);
            return offset;
        }

        static long AllocatedBy(Action act)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            act();
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }

        [TestCase(false, 5), TestCase(true, 9)]
        public void Open_ManyChunks_TakesFewBytesForEach(bool isVariable, int bytesPerChunk)
        {
            var bytes = Bytes(Chunks);
            List<int> points = null;
            if (isVariable)
            {
                points = new List<int>();
                for (int i = 0; i < Chunks; i++)
                    points.Add(5 + i % 11);
            }
            long offset = Write(bytes, points, LazChunkTable.ToBytes(bytes, points));
            PointReader reader = null;
            try
            {
                long allocated = AllocatedBy(() => reader = PointReaders.Open(FilePath));
                Assert.That(reader.BlockCount, Is.EqualTo(Chunks));
                // Pages and pieces of the table come in full.
                Assert.That(allocated, Is.LessThan(Chunks * bytesPerChunk + 1_000_000));
                long first = 0;
                for (int i = 0; i < Chunks; i++)
                {
                    int inChunk = isVariable ? points[i] : PointsPerChunk;
                    if (i % 1000 == 999 || i > Chunks - 3)
                    {
                        Assert.That(reader.FirstPointOfBlock(i), Is.EqualTo(first));
                        Assert.That(reader.PointsInBlock(i), Is.EqualTo(inChunk));
                        reader.FileOfBlock(i, out long at);
                        Assert.That(at, Is.EqualTo(offset));
                    }
                    first += inChunk;
                    offset += bytes[i];
                }
                Assert.That(reader.PointCount, Is.EqualTo(first));
            }
            finally
            {
                reader?.Dispose();
            }
        }

        [Test]
        public void Open_MoreChunksClaimedThanBytes_IsRefusedInLittleMemory()
        {
            var bytes = Bytes(20);
            var table = LazChunkTable.ToBytes(bytes);
            BitConverter.GetBytes(uint.MaxValue).CopyTo(table, 4);
            Write(bytes, null, table);
            SourceInfo info = null;
            Assert.That(AllocatedBy(() => info = Warnings()), Is.LessThan(1_000_000));
            Assert.That(info.Warnings[0].Text, Does.Contain("claims 4294967295 chunks, there is room for "));
        }

        [Test]
        public void Open_MoreChunksClaimedThanTheTableHas_IsRefusedInLittleMemory()
        {
            // A hole that has room for ten million chunks, and a table of twenty of them.
            var bytes = Bytes(20);
            bytes[19] = 300_000_000;
            var table = LazChunkTable.ToBytes(bytes);
            BitConverter.GetBytes(10_000_000).CopyTo(table, 4);
            Write(bytes, null, table);
            SourceInfo info = null;
            Assert.That(AllocatedBy(() => info = Warnings()), Is.LessThan(1_000_000));
            Assert.That(info.Warnings[0].Text, Does.Contain("chunk table: "));
        }

        SourceInfo Warnings()
        {
            using var reader = PointReaders.Open(FilePath);
            return reader.Info;
        }
    }
}
