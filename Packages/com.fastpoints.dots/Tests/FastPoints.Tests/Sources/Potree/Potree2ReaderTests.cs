using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Sources
{
    [Category("Smoke")]
    public class Potree2ReaderTests : FolderTests
    {
        const int Points = 3000, Depth = 5;

        static readonly PotreeTestCloud s_cloud = new PotreeTestCloud(Points, Depth, 7);

        PointReader Write(bool isBrotli)
        {
            new Potree2Writer { IsBrotli = isBrotli }.Write(Folder, s_cloud);
            return PointReaders.Open(Folder.Path);
        }

        static ulong? Value(int point, string column) => column switch
        {
            "X" or "Y" or "Z" => PotreeCheck.Position(s_cloud, point, column),
            "number" => (ulong)point,
            "Intensity" => PotreeCheck.Bits(point, "intensity", 0, 2),
            "ReturnNumber" => PotreeCheck.Bits(point, "return number", 0, 1),
            "NumberOfReturns" => PotreeCheck.Bits(point, "number of returns", 0, 1),
            "Classification" => PotreeCheck.Bits(point, "classification", 0, 1),
            "ScanAngle" => PotreeCheck.Bits(point, "scan angle rank", 0, 1),
            "UserData" => PotreeCheck.Bits(point, "user data", 0, 1),
            "PointSourceId" => PotreeCheck.Bits(point, "point source id", 0, 2),
            "GpsTime" => PotreeCheck.Bits(point, "gps-time", 0, 8),
            "Red" => PotreeCheck.Bits(point, "rgb", 0, 2),
            "Green" => PotreeCheck.Bits(point, "rgb", 2, 2),
            "Blue" => PotreeCheck.Bits(point, "rgb", 4, 2),
            "a pair[0]" => PotreeCheck.Bits(point, "a pair", 0, 4),
            "a pair[1]" => PotreeCheck.Bits(point, "a pair", 4, 4),
            "odd[0]" => PotreeCheck.Bits(point, "odd", 0, 1),
            "odd[1]" => PotreeCheck.Bits(point, "odd", 1, 1),
            "odd[2]" => PotreeCheck.Bits(point, "odd", 2, 1),
            "i8" => PotreeCheck.Bits(point, column, 0, 1),
            "i16" => PotreeCheck.Bits(point, column, 0, 2),
            "u32" => PotreeCheck.Bits(point, column, 0, 4),
            "i64" or "u64" => PotreeCheck.Bits(point, column, 0, 8),
            _ => throw new ArgumentException("nobody wrote " + column),
        };

        static void Find(PointReader reader) => JobCoroutine.RunToEnd(reader.IndexBlocks());

        static List<int> ReadAll(PointReader reader, int slots = 3) =>
            PotreeCheck.Read(reader, reader.Info.Schema, ReadPoints.WholeBlocks(reader), slots, "number", Value);

        [TestCase(false), TestCase(true)]
        public void Read_AllPoints_HaveTheirValues(bool isBrotli)
        {
            using var reader = Write(isBrotli);
            Find(reader);
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(1), "the attribute without a type");
            Assert.That(reader.Info.Schema.Count, Is.EqualTo(25));
            Assert.That(reader.Info.Transform.Offset, Is.EqualTo(new double3(500000.123, 4000000.456, -7.5)));
            Assert.That(reader.Info.Schema[reader.Info.Schema.IndexOf("i16")].Scale, Is.EqualTo(0.25));
            Assert.That(reader.Info.Schema[reader.Info.Schema.IndexOf("i16")].Offset, Is.EqualTo(100));
            Assert.That(reader.Info.Crs.Epsg, Is.EqualTo(25832));
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(s_cloud.PointsOfNode.Count));
            foreach (int workers in new[] { 0, 4 })
                using (new WorkerCount(workers))
                    Assert.That(ReadAll(reader).OrderBy(i => i), Is.EqualTo(Enumerable.Range(0, Points)));
        }

        [TestCase(false), TestCase(true)]
        public void Read_AnySubsetAnyRangeAnyOrder_IsTheSame(bool isBrotli)
        {
            using var reader = Write(isBrotli);
            Find(reader);
            PotreeCheck.CheckSubsets(reader, "number", Value);
        }

        /// <summary>Blocks of one node's size leave most of a tile empty; these take several tiles a column.</summary>
        [TestCase(false), TestCase(true)]
        public void Read_NodesOfManyTiles_HaveTheirValues(bool isBrotli)
        {
            var cloud = new PotreeTestCloud(70000, 0, 5);
            var writer = new Potree2Writer { IsBrotli = isBrotli };
            writer.Attributes = writer.Attributes.Where(a => a.Name == "position" || a.Name == "rgb" ||
                a.Name == "number").ToArray();
            writer.Write(Folder, cloud);
            using var reader = PointReaders.Open(Folder.Path);
            Find(reader);
            var got = PotreeCheck.Read(reader, reader.Info.Schema, new[] { new BlockRange(0, 20001, 40000) }, 1, "number",
                (point, column) => PotreeCheck.Position(cloud, point, column) ?? Value(point, column));
            Assert.That(got, Is.EqualTo(Enumerable.Range(20001, 40000)));
        }

        [Test]
        public void ReadLevels_SomeLevels_ReadsTheirPagesOnlyAndKeepsIndices()
        {
            using var reader = Write(false);
            Assert.That(reader.BlocksAreKnown, Is.False);
            Assert.That(reader.Tree.LevelCount, Is.EqualTo(2), "the first page but for its proxies");
            var first = Enumerable.Range(0, reader.BlockCount).Select(reader.PointsInBlock).ToList();
            JobCoroutine.RunToEnd(reader.ReadLevels(2));
            Assert.That(reader.Tree.LevelCount, Is.EqualTo(2));
            JobCoroutine.RunToEnd(reader.ReadLevels(3));
            Assert.That(reader.Tree.LevelCount, Is.InRange(4, 5), "leaves of the next page's level stand in this one");
            Assert.That(reader.BlocksAreKnown, Is.False);
            var upper = s_cloud.PointsOfNode.Where(n => n.Key.Length <= 3).SelectMany(n => n.Value).OrderBy(i => i);
            var ranges = ReadPoints.WholeBlocks(reader);
            var nodes = Enumerable.Range(0, reader.Tree.NodeCount).Select(i => reader.Tree[i]).ToList();
            var blocks = nodes.Where(n => n.Level < 3 && n.Block >= 0).Select(n => ranges[n.Block]).ToList();
            Assert.That(PotreeCheck.Read(reader, reader.Info.Schema, blocks, 2, "number", Value).OrderBy(i => i),
                Is.EqualTo(upper));
            Find(reader);
            Assert.That(reader.BlocksAreKnown, Is.True);
            Assert.That(Enumerable.Range(0, nodes.Count).Select(i => reader.Tree[i]), Is.EqualTo(nodes));
            Assert.That(Enumerable.Range(0, first.Count).Select(reader.PointsInBlock), Is.EqualTo(first));
            Assert.That(reader.PointCount, Is.EqualTo(Points));
        }

        [Test]
        public void Open_WithoutOctree_ShowsTheHierarchyAndNamesTheFile()
        {
            Write(false).Dispose();
            File.Delete(Folder.File("octree.bin"));
            using var reader = PointReaders.Open(Folder.File("metadata.json"));
            Find(reader);
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(s_cloud.PointsOfNode.Count));
            Assert.That(reader.Info.Warnings.Last().Text, Does.Contain("octree.bin"));
            var failure = Failures.Of(() => reader.CreateRead(reader.Info.Schema, 1, Allocator.Persistent), FailureCode.NotFound);
            Assert.That(failure.Path, Is.EqualTo(Folder.File("octree.bin")));
        }

        [TestCase(false), TestCase(true)]
        public void Read_TruncatedOctree_GivesItsPoints(bool isBrotli)
        {
            Write(isBrotli).Dispose();
            var bytes = File.ReadAllBytes(Folder.File("octree.bin"));
            Folder.Write("octree.bin", bytes.Take(bytes.Length / 2).ToArray());
            using var reader = PointReaders.Open(Folder.Path);
            Find(reader);
            var got = ReadAll(reader);
            Assert.That(got.Count, Is.InRange(Points / 3, Points * 2 / 3));
            Assert.That(got.Distinct().Count(), Is.EqualTo(got.Count));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("cannot be as the hierarchy says"));
            Assert.That(reader.Info.Warnings.Count, Is.LessThan(8), "many of a kind are counted");
        }

        [Test]
        public void Read_BrokenBrotli_IsAHoleAndAWarning()
        {
            Write(true).Dispose();
            var bytes = File.ReadAllBytes(Folder.File("octree.bin"));
            for (int i = 40; i < 60; i++)
                bytes[i] ^= 0x55;
            Folder.Write("octree.bin", bytes);
            using var reader = PointReaders.Open(Folder.Path);
            Find(reader);
            int first = reader.PointsInBlock(0);
            var got = PotreeCheck.Read(reader, reader.Info.Schema, ReadPoints.WholeBlocks(reader), 2, "number",
                (point, column) => point < Points ? null : throw new InvalidOperationException("a point that nobody wrote"));
            Assert.That(got.Count, Is.EqualTo(Points - first));
            Assert.That(reader.Info.Warnings.Last().Text, Does.Contain("node r: its Brotli stream is broken"));
        }

        [Test]
        public void Read_WithoutABrotliDecoder_NamesWhereToRegisterOne()
        {
            var before = Decompressors.Brotli;
            try
            {
                Decompressors.Brotli = () => new NoDecompressor();
                using var reader = Write(true);
                using var read = reader.CreateRead(reader.Info.Schema, reader.MaxPointsPerBlock, Allocator.Persistent);
                read.Begin(new BlockRange(0, 0, 1));
                Failures.Of(read.Complete, FailureCode.Unsupported, "Decompressors.Brotli", "not on this platform");
                Assert.That(read.Points.Count, Is.Zero);
            }
            finally
            {
                Decompressors.Brotli = before;
            }
        }

        sealed class NoDecompressor : StreamDecompressor
        {
            public override void Start() => throw new PlatformNotSupportedException("not on this platform");
            public override bool Decode(ReadOnlySpan<byte> input, Span<byte> output, out int consumed, out int written) =>
                throw new AssertionException("asked to decode although it could not start");
            public override void Dispose() { }
        }

        static void Put(byte[] hierarchy, int node, int at, byte[] value) => value.CopyTo(hierarchy, node * 22 + at);

        [TestCase(0L), TestCase(22L), TestCase(-22L), TestCase(long.MaxValue), TestCase(long.MinValue)]
        public void Open_PagesInALoopOrOutsideTheFile_Terminates(long page)
        {
            Write(false).Dispose();
            var bytes = File.ReadAllBytes(Folder.File("hierarchy.bin"));
            for (int node = 0; node < bytes.Length / 22; node++)
            {
                if (bytes[node * 22] != 2)
                    continue;
                Put(bytes, node, 6, BitConverter.GetBytes(page));
                Put(bytes, node, 14, BitConverter.GetBytes((long)bytes.Length));
            }
            Folder.Write("hierarchy.bin", bytes);
            using var reader = PointReaders.Open(Folder.Path);
            Find(reader);
            Assert.That(reader.Tree.IsHierarchyRead, Is.True);
            Assert.That(reader.Tree.NodeCount, Is.LessThanOrEqualTo(bytes.Length / 22));
            Assert.That(reader.Info.Warnings.Count, Is.GreaterThan(1));
            Assert.That(reader.PointCount, Is.LessThanOrEqualTo(Points), "no byte is given twice");
        }

        [Test]
        public void Open_WrongCountsAndMasks_AllocateNothing([Values(false, true)] bool isBrotli)
        {
            Write(isBrotli).Dispose();
            var bytes = File.ReadAllBytes(Folder.File("hierarchy.bin"));
            for (int node = 0; node < bytes.Length / 22; node++)
            {
                bytes[node * 22 + 1] = 255;
                Put(bytes, node, 2, BitConverter.GetBytes(uint.MaxValue));
            }
            Folder.Write("hierarchy.bin", bytes);
            long octree = new FileInfo(Folder.File("octree.bin")).Length;
            using var reader = PointReaders.Open(Folder.Path);
            Find(reader);
            Assert.That(reader.Tree.NodeCount, Is.LessThanOrEqualTo(bytes.Length / 22));
            Assert.That(reader.PointCount, Is.LessThanOrEqualTo(octree / (isBrotli ? 1 : new Potree2Writer().RecordBytes)));
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("ends early"));
        }

        [TestCase("\"encoding\": \"DEFAULT\"", "\"encoding\": \"ZIP\"", FailureCode.Unsupported,
            "wanted DEFAULT or BROTLI, got ZIP")]
        [TestCase("\"scale\": [0.001", "\"scale\": [0", FailureCode.BadInput, "numbers above 0")]
        [TestCase("\"scale\": [0.001, ", "\"scale\": [", FailureCode.BadInput, "\"scale\"")]
        [TestCase("\"name\": \"position\"", "\"name\": \"place\"", FailureCode.BadInput, "a position of three int32")]
        [TestCase("\"firstChunkSize\": ", "\"first\": ", FailureCode.BadInput, "hierarchy.firstChunkSize")]
        [TestCase("\"size\": 12", "\"size\": 8", FailureCode.BadInput, "a position of three int32")]
        [TestCase("\"size\": 12", "\"size\": 1e99", FailureCode.BadInput, "attributes[0].size")]
        public void Open_BrokenIndex_NamesTheMember(string from, string to, FailureCode code, string detail)
        {
            Write(false).Dispose();
            string text = File.ReadAllText(Folder.File("metadata.json"));
            Assert.That(text, Does.Contain(from));
            Folder.Write("metadata.json", text.Replace(from, to));
            Failures.Of(() => PointReaders.Open(Folder.Path), code, detail);
        }
    }
}
