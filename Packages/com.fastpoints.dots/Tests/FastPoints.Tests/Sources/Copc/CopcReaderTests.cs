using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Sources
{
    [Category("Smoke")]
    public class CopcReaderTests
    {
        const int InfoAt = 375 + 54, RootOffsetAt = InfoAt + 40, RootBytesAt = InfoAt + 48;

        [TestCase(6, 0, 99), TestCase(7, 3, 1), TestCase(8, 0, 2)]
        public void Read_EachNode_HasItsPoints(int format, int extraBytes, int levelsPerPage)
        {
            var writer = new CopcFileWriter { PointFormat = format, ExtraBytes = extraBytes, LevelsPerPage = levelsPerPage };
            var bytes = writer.Write(LazRecords.Make(format, extraBytes, 3000, format));
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var reader = ReadPoints.Open(file.Path);
            Assert.That(reader.Info.Format, Is.EqualTo("COPC"));
            Assert.That(reader.PointCount, Is.EqualTo(3000));
            Assert.That(reader.Info.PointsReadable, Is.EqualTo(3000));
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(writer.Nodes.Count));
            Assert.That(reader.Tree.PageCount, Is.EqualTo(writer.Pages.Count));
            Assert.That(reader.Tree.LevelCount, Is.EqualTo(writer.Nodes.Max(node => node.Level) + 1).And.GreaterThan(3));
            CheckNodes(reader, file.Path, writer, 3);
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [TestCase(1), TestCase(4)]
        public void Read_AnyNumberOfWorkersInReverse_IsTheSame(int workers)
        {
            var writer = new CopcFileWriter();
            using (new WorkerCount(workers))
            using (var file = new TemporaryFile(writer.Write(LazRecords.Make(7, 0, 2000, 5)), ".copc.laz"))
            using (var reader = ReadPoints.Open(file.Path))
                CheckNodes(reader, file.Path, writer, workers, true);
        }

        [Test]
        public void Tree_Parents_ComeBeforeTheirChildren()
        {
            var writer = new CopcFileWriter { LevelsPerPage = 2 };
            using var file = new TemporaryFile(writer.Write(LazRecords.Make(7, 0, 3000, 6)), ".copc.laz");
            using var reader = ReadPoints.Open(file.Path);
            var known = new HashSet<int4>();
            for (int i = 0; i < reader.Tree.NodeCount; i++)
            {
                var node = reader.Tree[i];
                if (node.Level > 0)
                    Assert.That(known, Has.Member(new int4(node.Cell >> 1, node.Level - 1)));
                known.Add(new int4(node.Cell, node.Level));
            }
            Assert.That(reader.Tree.Cube.Size.x, Is.EqualTo(reader.Tree.Cube.Size.z).Within(1e-3));
            Assert.That(reader.Tree.Spacing, Is.EqualTo(reader.Tree.Cube.Size.x / 128).Within(1e-3));
        }

        [Test]
        public void ReadLevels_Few_ReadsOnlyTheirPages()
        {
            var writer = new CopcFileWriter { LevelsPerPage = 1, MaxNodePoints = 50 };
            using var file = new TemporaryFile(writer.Write(LazRecords.Make(7, 0, 3000, 7)), ".copc.laz");
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.BlocksAreKnown, Is.False);
            Assert.That(reader.BlockCount, Is.EqualTo(0));
            JobCoroutine.RunToEnd(reader.ReadLevels(1));
            Assert.That(reader.Tree.PageCount, Is.EqualTo(1));
            Assert.That(reader.BlockCount, Is.EqualTo(1));
            int levels = writer.Nodes.Max(node => node.Level) + 1;
            using (var read = reader.CreateRead(reader.Info.Schema, 50, Allocator.Persistent))
            {
                for (int level = 1; level <= levels; level++)
                {
                    int before = reader.BlockCount;
                    JobCoroutine.RunToEnd(reader.ReadLevels(level));
                    Assert.That(reader.Tree.NodeCount, Is.EqualTo(writer.Nodes.Count(node => node.Level < level)));
                    Assert.That(reader.Tree.LevelCount, Is.EqualTo(level));
                    // The slot was made when only the root was known.
                    for (int block = before; block < reader.BlockCount; block++)
                    {
                        read.Begin(new BlockRange(block, 0, reader.PointsInBlock(block)));
                        read.Complete();
                        Assert.That(read.Points.Count, Is.EqualTo(reader.PointsInBlock(block)));
                    }
                    Assert.That(reader.BlocksAreKnown, Is.False);
                }
            }
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            Assert.That(reader.BlocksAreKnown, Is.True);
            CheckNodes(reader, file.Path, writer, 3);
        }

        [Test]
        public void IndexBlocks_Cancelled_CanRestart()
        {
            var writer = new CopcFileWriter { LevelsPerPage = 1 };
            using var file = new TemporaryFile(writer.Write(LazRecords.Make(7, 0, 2000, 8)), ".copc.laz");
            using var reader = PointReaders.Open(file.Path);
            for (int steps = 1; steps < 9; steps++)
                using (var work = new CoroutineStack(reader.IndexBlocks()))
                    for (int i = 0; i < steps && work.MoveNext(); i++)
                        work.Current.Complete();
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            CheckNodes(reader, file.Path, writer, 3);
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Read_AnySelectionAndPrefix_MatchesTheWhole()
        {
            var writer = new CopcFileWriter { MaxNodePoints = 700 };
            using var file = new TemporaryFile(writer.Write(LazRecords.Make(7, 0, 2500, 9)), ".copc.laz");
            using var reader = ReadPoints.Open(file.Path);
            for (int i = 0; i < reader.Info.Schema.Count; i++)
            {
                var schema = reader.Info.Schema;
                var wanted = schema.Select(schema[i].Name, schema[(i * 5 + 2) % schema.Count].Name);
                for (int block = 0; block < reader.BlockCount; block++)
                    CheckPrefix(reader, wanted, block, Math.Min(reader.PointsInBlock(block), 1 + 97 * i % 700));
            }
        }

        [Test]
        public void Read_LongNode_HasOneNodePerBlock()
        {
            var writer = new CopcFileWriter { MaxNodePoints = 5000 };
            var records = LazRecords.Make(7, 0, 2500, 10);
            using var file = new TemporaryFile(writer.Write(records), ".copc.laz");
            using var source = RandomAccessFile.Open(file.Path);
            using var reader = CopcReader.TryOpen(LasFile.Read(source), source, 1000);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(3));
            Assert.That(reader.Tree[2].PointCount, Is.EqualTo(500));
            var got = LazFileReading.Records(reader, LazFileReading.LayoutOf(file.Path));
            Assert.That(LazFileReading.Difference(got, Flat(records), writer.RecordBytes), Is.Null);
        }

        [TestCase(RootOffsetAt, 1L << 40, "root page")]
        [TestCase(RootOffsetAt, -1L, "root page")]
        [TestCase(RootBytesAt, 0L, "root page")]
        [TestCase(RootBytesAt, 1L << 62, "root page")]
        [TestCase(InfoAt + 24, 0L, "cube")]
        [TestCase(InfoAt + 24, 0x7FF8000000000000L, "cube")]
        [TestCase(InfoAt, 0x7FF0000000000000L, "cube")]
        public void Open_BrokenInfo_ReadsTheFileAsLaz(int at, long value, string detail)
        {
            var writer = new CopcFileWriter();
            var bytes = writer.Write(LazRecords.Make(7, 0, 500, 11));
            BitConverter.GetBytes(value).CopyTo(bytes, at);
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var reader = ReadPoints.Open(file.Path);
            Assert.That(reader, Is.TypeOf<LazReader>());
            Assert.That(reader.Tree, Is.Null);
            Assert.That(reader.PointCount, Is.EqualTo(500));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains(detail));
        }

        static IEnumerable<TestCaseData> Lies()
        {
            // Field of the entry, its value, what is said of it. The entry is the second of the root page: a node of level 1.
            yield return Lie("LevelNegative", 0, -1, "no node of an octree");
            yield return Lie("LevelHuge", 0, 31, "no node of an octree");
            yield return Lie("CellOutside", 4, 2, "no node of an octree");
            yield return Lie("CellNegative", 12, -1, "no node of an octree");
            yield return Lie("OffsetInHeader", 16, 100, "none of the points'");
            yield return Lie("OffsetBehindTheFile", 16, int.MaxValue, "none of the points'");
            yield return Lie("BytesNegative", 24, -5, "bytes: left out");
            yield return Lie("BytesZero", 24, 0, "bytes: left out");
            yield return Lie("BytesHuge", 24, int.MaxValue, "cut there");
            yield return Lie("PointsNegative", 28, -2, "has -2 points");
            yield return Lie("PointsHuge", 28, int.MaxValue, "points in");
            yield return Lie("PointsNone", 28, 0, "in no node");
            yield return Lie("PageInsteadOfNode", 28, -1, "overlap|no node|left out");
        }

        static TestCaseData Lie(string name, int field, int value, string detail) =>
            new TestCaseData(field, value, detail).SetName("Hierarchy_" + name + "_IsToldAndNoPointIsLost");

        [TestCaseSource(nameof(Lies))]
        public void Hierarchy(int field, int value, string detail)
        {
            var writer = new CopcFileWriter();
            var records = LazRecords.Make(7, 0, 2000, 12);
            var bytes = writer.Write(records);
            BitConverter.GetBytes(value).CopyTo(bytes, (int)writer.Pages[0].Offset + CopcEntry.Bytes + field);
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var reader = ReadPoints.Open(file.Path);
            var got = LazFileReading.Present(reader, LazFileReading.LayoutOf(file.Path));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Match(detail));
            Assert.That(Sorted(got, writer.RecordBytes), Is.EqualTo(Sorted(Flat(records), writer.RecordBytes)));
        }

        [Test]
        public void Hierarchy_WrongCount_GivesNoPhantomPoints()
        {
            foreach (int change in new[] { -3, 4 })
            {
                var writer = new CopcFileWriter();
                var records = LazRecords.Make(7, 0, 2000, 13);
                var bytes = writer.Write(records);
                int at = (int)writer.Pages[0].Offset + CopcEntry.Bytes + 28;
                BitConverter.GetBytes(BitConverter.ToInt32(bytes, at) + change).CopyTo(bytes, at);
                using var file = new TemporaryFile(bytes, ".copc.laz");
                using var reader = ReadPoints.Open(file.Path);
                long points = ReadPoints.EachBlock(reader, reader.Info.Schema, read => { });
                Assert.That(points, Is.EqualTo(2000 + Math.Min(0, change)));
                Assert.That(reader.Info.Warnings, Is.Not.Empty);
            }
        }

        [Test]
        public void Hierarchy_NodeOffItsChunk_IsAHoleWithoutNoise()
        {
            var writer = new CopcFileWriter();
            var bytes = writer.Write(LazRecords.Make(7, 0, 2000, 14));
            int at = (int)writer.Pages[0].Offset + CopcEntry.Bytes + 16;
            BitConverter.GetBytes(BitConverter.ToInt32(bytes, at) + 7).CopyTo(bytes, at);
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var reader = ReadPoints.Open(file.Path);
            long points = ReadPoints.EachBlock(reader, reader.Info.Schema, read => { });
            Assert.That(points, Is.EqualTo(1900));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("no chunk's"));
        }

        [Test]
        public void Hierarchy_PagesThatPointAtThemselves_AreReadOnce()
        {
            var writer = new CopcFileWriter { LevelsPerPage = 1 };
            var records = LazRecords.Make(7, 0, 2000, 15);
            var bytes = writer.Write(records);
            // Every page entry of every page names the root page.
            var (rootOffset, rootBytes) = writer.Pages[writer.Pages.Count - 1];
            foreach (var (offset, count) in writer.Pages)
                for (int at = (int)offset; at < offset + count; at += CopcEntry.Bytes)
                    if (BitConverter.ToInt32(bytes, at + 28) == CopcEntry.PointCountOfPage)
                    {
                        BitConverter.GetBytes(rootOffset).CopyTo(bytes, at + 16);
                        BitConverter.GetBytes(rootBytes).CopyTo(bytes, at + 24);
                    }
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var reader = ReadPoints.Open(file.Path);
            Assert.That(reader.Tree.PageCount, Is.EqualTo(1));
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(1));
            var got = LazFileReading.Present(reader, LazFileReading.LayoutOf(file.Path));
            Assert.That(Sorted(got, writer.RecordBytes), Is.EqualTo(Sorted(Flat(records), writer.RecordBytes)));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("named twice"));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("in no node"));
        }

        [Test]
        public void Hierarchy_OverlappingPages_TakeTimeLinearInTheFile()
        {
            // 20,000 pages, each of all the entries behind it: read as told, they would be 200 million entries.
            var writer = new CopcFileWriter { MaxNodePoints = 2000 };
            var bytes = writer.Write(LazRecords.Make(7, 0, 1000, 16));
            const int Entries = 20000;
            int start = bytes.Length;
            Array.Resize(ref bytes, start + Entries * CopcEntry.Bytes);
            for (int i = 0; i < Entries; i++)
            {
                int at = start + i * CopcEntry.Bytes;
                BitConverter.GetBytes(1).CopyTo(bytes, at);
                BitConverter.GetBytes((long)at + CopcEntry.Bytes).CopyTo(bytes, at + 16);
                BitConverter.GetBytes((Entries - i - 1) * CopcEntry.Bytes).CopyTo(bytes, at + 24);
                BitConverter.GetBytes(CopcEntry.PointCountOfPage).CopyTo(bytes, at + 28);
            }
            BitConverter.GetBytes((long)start).CopyTo(bytes, RootOffsetAt);
            BitConverter.GetBytes((long)Entries * CopcEntry.Bytes).CopyTo(bytes, RootBytesAt);
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var reader = ReadPoints.Open(file.Path);
            Assert.That(reader.PointCount, Is.EqualTo(1000), "by the chunk table");
            Assert.That(reader.Tree.PageCount, Is.LessThan(3));
            Assert.That(reader.Info.Warnings.Count, Is.LessThan(20));
        }

        [Test]
        public void Read_TruncatedFile_GivesItsPointsAndReportsIt()
        {
            var writer = new CopcFileWriter();
            var bytes = writer.Write(LazRecords.Make(7, 0, 2000, 17));
            Array.Resize(ref bytes, bytes.Length / 2);
            using var file = new TemporaryFile(bytes, ".copc.laz");
            using var reader = ReadPoints.Open(file.Path);
            long points = ReadPoints.EachBlock(reader, reader.Info.Schema, read => { });
            Assert.That(points, Is.InRange(500, 1500));
            Assert.That(reader.Info.Warnings, Is.Not.Empty);
        }

        static void CheckNodes(PointReader reader, string path, CopcFileWriter writer, int slots, bool isReversed = false)
        {
            var layout = LazFileReading.LayoutOf(path);
            var nodes = writer.Nodes.ToDictionary(node => new int4(node.Cell, node.Level));
            var got = new byte[reader.PointCount * writer.RecordBytes];
            var ranges = ReadPoints.WholeBlocks(reader);
            if (isReversed)
                ranges.Reverse();
            LazFileReading.Read(reader, layout, ranges, reader.Info.Schema, slots, got);
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(nodes.Count));
            for (int i = 0; i < reader.Tree.NodeCount; i++)
            {
                var node = reader.Tree[i];
                var wanted = nodes[new int4(node.Cell, node.Level)].Records;
                Assert.That(node.PointCount, Is.EqualTo(wanted.Count));
                if (wanted.Count == 0)
                    continue;
                long first = reader.FirstPointOfBlock(node.Block);
                var part = got.Skip((int)first * writer.RecordBytes).Take(wanted.Count * writer.RecordBytes).ToArray();
                Assert.That(LazFileReading.Difference(part, Flat(wanted), writer.RecordBytes), Is.Null);
            }
        }

        static void CheckPrefix(PointReader reader, PointSchema wanted, int block, int count)
        {
            using var part = reader.CreateRead(wanted, count, Allocator.Persistent);
            using var whole = reader.CreateRead(reader.Info.Schema, reader.PointsInBlock(block), Allocator.Persistent);
            part.Begin(new BlockRange(block, 0, count));
            whole.Begin(new BlockRange(block, 0, reader.PointsInBlock(block)));
            part.Complete();
            whole.Complete();
            Assert.That(part.Points.Count, Is.EqualTo(count));
            for (int i = 0; i < wanted.Count; i++)
            {
                int bytes = count * wanted[i].Type.SizeOf();
                var got = part.Points.Bytes.GetSubArray(part.Points.Column(i).OffsetBytes, bytes).ToArray();
                int from = whole.Points.Column(reader.Info.Schema.IndexOf(wanted[i].Name)).OffsetBytes;
                Assert.That(got, Is.EqualTo(whole.Points.Bytes.GetSubArray(from, bytes).ToArray()));
            }
        }

        static byte[] Flat(List<byte[]> records) => records.SelectMany(record => record).ToArray();

        static List<string> Sorted(byte[] records, int recordBytes)
        {
            var texts = new List<string>();
            for (int at = 0; at < records.Length; at += recordBytes)
                texts.Add(System.Convert.ToBase64String(records, at, recordBytes));
            texts.Sort(StringComparer.Ordinal);
            return texts;
        }
    }
}
