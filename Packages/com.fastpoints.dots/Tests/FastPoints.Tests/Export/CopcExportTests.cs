using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using FastPoints.Build;
using FastPoints.Export;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Streaming;
using FastPoints.Tests.Las;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Tests.Export
{
    public unsafe class CopcExportTests : FolderTests
    {
        ExportResult Run(PointReader reader, ExportSettings settings = null, string name = "out.copc.laz")
        {
            ExportResult result = null;
            JobCoroutine.RunToEnd(ExportCloud.Run(reader, Folder.File(name), settings ?? new ExportSettings(),
                r => result = r, null));
            Assert.That(Directory.Exists(Folder.File(name + ".octree")), Is.False);
            Assert.That(Directory.GetFiles(Folder.Path, "*.tmp"), Is.Empty);
            Assert.That(CheckFile(Folder.File(name)), Is.EqualTo(result.Points));
            return result;
        }

        ConvertedReader Convert(PointReader reader, ConvertSettings settings = null)
        {
            string target = Folder.File("cloud.fastpoints");
            JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, target, settings ?? new ConvertSettings(), _ => { }, null));
            return ConvertedReader.Open(target);
        }

        /// <summary>The points as sorted text of the named attributes; scan angles as formats 6 to 8 count them.</summary>
        static string[] Rows(PointReader reader, string[] names, double3 step)
        {
            ReadPoints.IndexBlocks(reader);
            var rows = new List<string>();
            var wanted = reader.Info.Schema.Select(names);
            var values = new double[reader.MaxPointsPerBlock];
            ReadPoints.EachBlock(reader, wanted, read =>
            {
                var texts = Enumerable.Range(0, read.Points.Count).Select(_ => new StringBuilder()).ToArray();
                foreach (string name in names)
                {
                    var column = read.Points.Column(wanted.IndexOf(name));
                    int axis = Array.IndexOf(new[] { "X", "Y", "Z" }, name);
                    bool isWhole = name == AttributeNames.ScanAngle && column.Type == AttributeType.Int8;
                    fixed (double* to = values)
                        for (int first = 0; first < read.Points.Count; first += ColumnValues.BatchLength)
                            ColumnValues.ToDoubles((byte*)read.Points.Bytes.GetUnsafeReadOnlyPtr() + column.OffsetBytes,
                                column.Type, first, Math.Min(ColumnValues.BatchLength, read.Points.Count - first), to + first);
                    for (int i = 0; i < texts.Length; i++)
                    {
                        double value = isWhole ? Math.Round(values[i] / 0.006) : values[i];
                        if (axis >= 0)
                            value = Math.Round((value * reader.Info.Transform.Scale[axis] + reader.Info.Transform.Offset[axis])
                                / step[axis]);
                        texts[i].Append(value.ToString("R", CultureInfo.InvariantCulture)).Append(' ');
                    }
                }
                rows.AddRange(texts.Select(text => text.ToString()));
            });
            rows.Sort(string.CompareOrdinal);
            return rows.ToArray();
        }

        void CheckTwin(PointReader source, double3 step, params string[] without)
        {
            using var made = ReadPoints.Open(Folder.File("out.copc.laz"));
            var names = source.Info.Schema.Select(a => a.Name).Where(n => !without.Contains(n)).ToArray();
            Assert.That(Rows(made, names, step), Is.EqualTo(Rows(source, names, step)));
        }

        struct Entry
        {
            public int4 Key;
            public long Offset;
            public int Bytes, Points;
        }

        static Dictionary<int4, Entry> ReadPages(byte[] bytes, long at, long length, out int pages, long fileOffset = 0)
        {
            var nodes = new Dictionary<int4, Entry>();
            var left = new Queue<(int4 Key, long At, long Bytes)>();
            left.Enqueue((default, at, length));
            for (pages = 0; left.Count > 0; pages++)
            {
                var page = left.Dequeue();
                bool hasKey = false;
                for (long e = page.At - fileOffset; e < page.At - fileOffset + page.Bytes; e += 32)
                {
                    int Int(int i) => BitConverter.ToInt32(bytes, (int)e + i);
                    var entry = new Entry
                    {
                        Key = new int4(Int(4), Int(8), Int(12), Int(0)),
                        Offset = BitConverter.ToInt64(bytes, (int)e + 16),
                        Bytes = Int(24),
                        Points = Int(28),
                    };
                    Assert.That(entry.Key.w >= 0 && math.all(entry.Key.xyz >= 0) && math.all(entry.Key.xyz < 1 << entry.Key.w));
                    hasKey |= entry.Points >= 0 && entry.Key.Equals(page.Key);
                    if (entry.Points < 0)
                        left.Enqueue((entry.Key, entry.Offset, entry.Bytes));
                    else
                        nodes.Add(entry.Key, entry);
                }
                Assert.That(hasKey, "a page begins with its own node");
            }
            foreach (var key in nodes.Keys.Where(k => k.w > 0))
                Assert.That(nodes.ContainsKey(new int4(key.xyz >> 1, key.w - 1)), "the parent of " + key);
            return nodes;
        }

        /// <summary>Whether all that COPC 1.0 asks for holds.</summary>
        /// <returns>The points.</returns>
        static long CheckFile(string path)
        {
            var bytes = File.ReadAllBytes(path);
            long Long(long at) => BitConverter.ToInt64(bytes, (int)at);
            string Text(long at) => Encoding.ASCII.GetString(bytes, (int)at, 16).TrimEnd('\0');
            Assert.That((bytes[24], bytes[25], BitConverter.ToUInt16(bytes, 94)), Is.EqualTo(((byte)1, (byte)4, (ushort)375)));
            Assert.That(bytes[104] & 63, Is.InRange(6, 8));
            Assert.That((Text(377), BitConverter.ToUInt16(bytes, 393), BitConverter.ToUInt16(bytes, 395)),
                Is.EqualTo(("copc", (ushort)1, (ushort)160)));
            Assert.That(bytes.Skip(429 + 72).Take(88), Is.All.Zero);
            Assert.That((Text(Long(235) + 2), BitConverter.ToUInt16(bytes, (int)Long(235) + 18)),
                Is.EqualTo(("copc", (ushort)1000)));
            Assert.That(Long(235) + 60, Is.LessThanOrEqualTo(Long(469)));
            Assert.That(Long(235) + 60 + Long(Long(235) + 20), Is.GreaterThanOrEqualTo(Long(469) + Long(477)));
            var nodes = ReadPages(bytes, Long(469), Long(477), out _);
            Assert.That(nodes.Values.Sum(n => (long)n.Points), Is.EqualTo(Long(247)));
            Assert.That(nodes.Values.Where(n => n.Points == 0), Is.All.Matches<Entry>(n => n.Bytes == 0 && n.Offset == 0));

            using var reader = ReadPoints.Open(path);
            Assert.That(reader.Info.Format, Is.EqualTo("COPC"));
            Assert.That(reader.Info.Warnings, Is.Empty);
            using (var file = RandomAccessFile.Open(path))
            {
                var las = LasFile.Read(file);
                var format = LazFormat.Read(las);
                Assert.That((format.Compressor, format.ChunkPoints), Is.EqualTo((LazCompressor.LayeredChunked, uint.MaxValue)));
                var chunks = LazChunkTable.Read(file, format, las.Info, las.Header.PointsOffset).Chunks;
                Assert.That(Enumerable.Range(0, chunks.Count).Select(c =>
                    (chunks[c].Offset, chunks[c].Bytes, (int)chunks[c].Points)),
                    Is.EqualTo(nodes.Values.Where(n => n.Points > 0).OrderBy(n => n.Offset)
                        .Select(n => (n.Offset, (long)n.Bytes, n.Points))));
            }
            CheckPoints(reader, nodes, bytes);
            return Long(247);
        }

        static void CheckPoints(PointReader reader, Dictionary<int4, Entry> nodes, byte[] bytes)
        {
            double Double(int at) => BitConverter.ToDouble(bytes, at);
            var center = new double3(Double(429), Double(437), Double(445));
            double half = Double(453);
            double minTime = double.PositiveInfinity, maxTime = double.NegativeInfinity;
            double3 min = double.PositiveInfinity, max = double.NegativeInfinity;
            var returns = new long[16];
            var nodeOfBlock = Enumerable.Range(0, reader.Tree.NodeCount).Where(n => reader.Tree[n].Block >= 0)
                .ToDictionary(n => reader.Tree[n].Block);
            var wanted = reader.Info.Schema.Select("X", "Y", "Z", AttributeNames.ReturnNumber, AttributeNames.GpsTime);
            ReadPoints.EachBlock(reader, wanted, read =>
            {
                var node = reader.Tree[nodeOfBlock[read.Range.Block]];
                Assert.That(nodes[new int4(node.Cell, node.Level)].Points, Is.EqualTo(read.Points.Count));
                double edge = 2 * half / (1L << node.Level);
                var corner = center - half + new double3(node.Cell) * edge;
                for (int i = 0; i < read.Points.Count; i++)
                {
                    var at = reader.Info.Transform.ToGeo(new double3(read.Points.Column<int>(0)[i],
                        read.Points.Column<int>(1)[i], read.Points.Column<int>(2)[i]));
                    if (!math.all(at > corner) || !math.all(at < corner + edge))
                        Assert.Fail(at + " is not in " + corner + " + " + edge);
                    min = math.min(min, at);
                    max = math.max(max, at);
                    returns[read.Points.Column<byte>(wanted.IndexOf(AttributeNames.ReturnNumber))[i]]++;
                    double time = read.Points.Column<double>(wanted.IndexOf(AttributeNames.GpsTime))[i];
                    minTime = math.min(minTime, time);
                    maxTime = math.max(maxTime, time);
                }
            });
            if (reader.PointCount == 0)
                return;
            Assert.That(new[] { max.x, min.x, max.y, min.y, max.z, min.z },
                Is.EqualTo(Enumerable.Range(0, 6).Select(i => Double(179 + 8 * i))));
            Assert.That(returns.Skip(1), Is.EqualTo(Enumerable.Range(0, 15)
                .Select(i => BitConverter.ToInt64(bytes, 255 + 8 * i))));
            Assert.That(new[] { minTime, maxTime }, Is.EqualTo(new[] { Double(485), Double(493) }));
        }

        [Test]
        public void Run_EachPointFormat_WritesEveryRecordOnce([Values(0, 1, 2, 3, 6, 7, 8)] int format, [Values(0, 3)] int extra,
            [Values] bool isConverted)
        {
            var writer = new LazFileWriter { PointFormat = format, ItemVersion = format < 6 ? 2 : 3, ExtraBytes = extra };
            using var source = PointReaders.Open(Folder.Write("source.laz",
                writer.Write(LazRecords.Make(format, extra, 5000, 70 + format))));
            using (var stored = isConverted ? Convert(source) : null)
            {
                var result = Run(stored ?? source);
                Assert.That(result.Points, Is.EqualTo(5000));
                Assert.That(result.Note, format < 6 ? Does.StartWith("point format " + format + " becomes ") : Is.Null);
                Assert.That(result.Warnings, Is.Empty);
            }
            CheckTwin(source, source.Info.Transform.Scale);
        }

        /// <summary>Steps that differ by axis: the octree of a converted cloud has no cubes then, one of its own has.</summary>
        [TestCase(0.01, 0.01, 0.001), TestCase(1e-7, 1e-7, 0.01), TestCase(0.01, 0.01, 0.003)]
        public void Run_StepsOfEachAxis_AreWrittenInCubes(double x, double y, double z)
        {
            var step = new double3(x, y, z);
            using var source = Scan(20000);
            source.Info.Transform = new PositionTransform { Scale = step, Offset = new double3(7, 51, -20) };
            using var stored = Convert(source);
            Run(stored);
            CheckTwin(source, step);
        }

        MemoryPointReader Scan(int count) => new MemoryPointReader(TestBatches.Scan(count, 5), 3000);

        [Test]
        public void Run_Doubles_AreWithinTheStatedError()
        {
            var random = new Unity.Mathematics.Random(5);
            var points = Enumerable.Range(0, 40000).Select(_ => new double3(4e5, 5e6, 100)
                + math.floor(random.NextDouble3() * new double3(9000, 3000, 200)) / 8 + 1e-4).ToArray();
            using var source = new MemoryPointReader(TestBatches.OfPositions(points), 3000);
            Assert.That(Run(source).PositionError, Is.LessThan(1e-6));
            CheckTwin(source, 0.125);
        }

        /// <summary>Numbers of more than 32 bits are rounded, and no point leaves its cube by that.</summary>
        [Test]
        public void Run_WideNumbers_AreWrittenInTheirCubes()
        {
            var batch = TestBatches.New(20000, AttributeType.Int64);
            var random = new Unity.Mathematics.Random(3);
            for (int i = 0; i < batch.Count; i++)
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Put(batch, axis, i, (long)random.NextUInt() * 70001 - (long)random.NextUInt());
            using var source = new MemoryPointReader(batch, 3000);
            Assert.That(Run(source).PositionError, Is.GreaterThan(0));
        }

        [Test]
        public void Run_MoreEqualPointsThanANodeHolds_UsesDeeperLevels([Values(1, 3, 17)] int places)
        {
            using var source = Repeated(200000, places);
            Run(source);
            CheckTwin(source, 1);
        }

        [Test]
        public void Run_MoreEqualPointsThanAllLevelsHold_Fails()
        {
            using var source = Repeated(300000, 1);
            TestBatches.Set(source.Points, 0, 0, 1 << 28);
            Failures.Of(() => Run(source), FailureCode.Unsupported, "points at one place");
            FileChanges.AwaitDeletes();
            Assert.That(Directory.GetFileSystemEntries(Folder.Path), Is.Empty);
        }

        static MemoryPointReader Repeated(int count, int places)
        {
            var batch = TestBatches.New(count, AttributeType.Int32);
            for (int i = 0; i < count; i++)
                for (int axis = 0; axis < 3; axis++)
                    TestBatches.Set(batch, axis, i, i % places * 7 + 1);
            return new MemoryPointReader(batch, 30000);
        }

        [Test]
        public void Run_PartsOfACloud_AreTheRequestedParts()
        {
            using var source = Scan(60000);
            source.Info.Transform = new PositionTransform { Scale = 0.01, Offset = default };
            var box = new ClipBox(new double3(100, 100, 0), new double3(300, 300, 100));
            using var stored = Convert(source);
            foreach (var reader in new PointReader[] { source, stored })
            {
                long Count(ExportSettings settings) => Run(reader, settings).Points;
                long inside = Count(new ExportSettings { Clips = new[] { box } });
                Assert.That(inside, Is.GreaterThan(2000).And.LessThan(9000));
                var cut = new ClipBox(new double3(100, 100, 0), new double3(300, 300, 100), true);
                Assert.That(Count(new ExportSettings { Clips = new[] { cut } }), Is.EqualTo(60000 - inside));
                long two = Count(new ExportSettings { Classes = new[] { 2, 7 }, Attributes = new[] { AttributeNames.Red } });
                Assert.That(two, Is.EqualTo(ReadPoints.Column<byte>(source, AttributeNames.Classification)
                    .Count(c => c == 2 || c == 7)));
                Assert.That(Count(new ExportSettings { Budget = 12345 }), Is.InRange(12340, 12345));
                long root = Count(new ExportSettings { Level = 0 });
                Assert.That(Count(new ExportSettings { Level = 1 }), Is.GreaterThan(root));
                Assert.That(Count(new ExportSettings { Classes = new int[0] }), Is.Zero);
            }
        }

        /// <summary>What a LAS file has around its points; GeoTIFF keys alone are a named loss, and no WKT is invented.</summary>
        [TestCase(true), TestCase(false)]
        public void Run_HeaderAndRecordsOfAFile_AreKept(bool hasWkt)
        {
            using var file = new LasTestFile { Minor = 2, Format = 1, GlobalEncoding = 1 };
            file.Vlr("somebody", 77, new byte[] { 1, 2, 3 });
            if (hasWkt)
                file.Vlr("LASF_Projection", 2112, Encoding.UTF8.GetBytes("LOCAL_CS[\"site\",UNIT[\"metre\",1]]\0"));
            else
                file.Vlr("LASF_Projection", 34735, new byte[] { 1, 0, 1, 0, 0, 0, 1, 0, 0, 12, 0, 0, 1, 0, 181, 8 });
            using var source = PointReaders.Open(Folder.Write("source.las", file.RandomPoints(200, 1).ToBytes()));
            var result = Run(source);
            using var made = RandomAccessFile.Open(Folder.File("out.copc.laz"));
            var las = LasFile.Read(made);
            Assert.That(las.Header.GlobalEncoding, Is.EqualTo(hasWkt ? 17 : 1));
            Assert.That(las.Vlrs.Payload(las.Vlrs.Find("somebody", 77)).Bytes, Is.EqualTo(new byte[] { 1, 2, 3 }));
            Assert.That(las.Vlrs.Find("LASF_Projection", (ushort)(hasWkt ? 2112 : 34735)), Is.Not.Null);
            Assert.That(result.Losses.Select(loss => loss.What), hasWkt ? Is.Empty : Has.Some.Contains("as WKT"));
            Assert.That(result.Losses.Select(loss => loss.Where), Is.All.EqualTo(source.Info.Path));
        }

        [Test]
        public void Run_NoPoints_WritesAnEmptyFile()
        {
            using var source = new MemoryPointReader(TestBatches.OfPositions(), 2);
            Assert.That(Run(source).Points, Is.Zero);
        }

        [Test]
        public void Run_NonFinitePositions_AreCounted()
        {
            using var source = new MemoryPointReader(TestBatches.OfPositions(new double3(1, 2, 3),
                new double3(double.NaN, 2, 3), new double3(7, 8, 9)), 2);
            var result = Run(source);
            Assert.That((result.Points, result.PointsLeftOut, result.PointsRead), Is.EqualTo((2L, 1L, 3L)));
        }

        /// <summary>Neither the file nor the octree beside it; what another left there is taken over.</summary>
        [Test]
        public void Run_CancelledAnywhere_LeavesNothing()
        {
            string path = Folder.File("out.copc.laz");
            for (int steps = 0; ; steps += 1 + steps / 3)
            {
                using var source = Scan(3000);
                var work = new CoroutineStack(ExportCloud.Run(source, path, new ExportSettings(), _ => { }, null));
                bool isRunning = true;
                for (int i = 0; i < steps && (isRunning = work.MoveNext()); i++)
                    work.Current.Complete();
                work.Dispose();
                FileChanges.AwaitDeletes();
                if (!isRunning)
                    break;
                Assert.That(Directory.GetFileSystemEntries(Folder.Path), Is.Empty, steps + " steps");
            }
            using var again = Scan(3000);
            using (Convert(again))
                Directory.Move(Folder.File("cloud.fastpoints"), path + ".octree");
            Assert.That(Run(again).Points, Is.EqualTo(3000));
        }

        [Test]
        public void Run_OverItsSource_IsRefused()
        {
            using var source = Scan(3000);
            Run(source);
            var bytes = File.ReadAllBytes(Folder.File("out.copc.laz"));
            using (var made = PointReaders.Open(Folder.File("out.copc.laz")))
                Failures.Of(() => Run(made), FailureCode.WriteFailed, "is the source");
            Assert.That(File.ReadAllBytes(Folder.File("out.copc.laz")), Is.EqualTo(bytes));
            using (var made = PointReaders.Open(Folder.File("out.copc.laz")))
                Assert.That(Run(made, name: "again.copc.laz").Points, Is.EqualTo(3000));
        }

        [TestCase(1, 1), TestCase(40, 2048), TestCase(9000, 2048), TestCase(9000, 100), TestCase(9000, 20000)]
        public void Pages_OfAnyNumberOfNodes_HoldEachOnce(int count, int maxEntries)
        {
            var random = new Unity.Mathematics.Random((uint)count);
            var nodes = new Dictionary<int4, CopcEntry>();
            while (nodes.Count < count)
            {
                int level = random.NextInt(0, 14);
                var key = new int4((int3)(random.NextDouble3() * random.NextDouble3() * (1 << level)), level);
                nodes[key] = new CopcEntry { Level = level, Cell = key.xyz, Offset = 1, ByteSize = 9, PointCount = 1 };
            }
            var bytes = CopcPages.ToBytes(nodes.Values.ToList(), 1000, out int rootBytes, maxEntries);
            var read = ReadPages(bytes, 1000, rootBytes, out int pages, 1000);
            Assert.That(nodes.Keys.ToHashSet().SetEquals(read.Values.Where(n => n.Points > 0).Select(n => n.Key)), Is.True);
            Assert.That(bytes.Length / 32, Is.EqualTo(read.Count + pages - 1));
            Assert.That(pages, read.Count > maxEntries ? Is.GreaterThan(1) : Is.EqualTo(1));
        }
    }
}
