using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Las;
using FastPoints.Reading;
using FastPoints.Scenes;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Sources
{
    public class Potree1ReaderTests : FolderTests
    {
        const int Points = 1500, Depth = 5;

        static readonly PotreeTestCloud s_cloud = new PotreeTestCloud(Points, Depth, 11);

        PointReader Write(Potree1Writer writer)
        {
            writer.Write(Folder, s_cloud);
            return Open();
        }

        PointReader Open() => ReadPoints.Open(Folder.Path);

        /// <summary>What a column has for a point; null for normals.</summary>
        static ulong? Value(int point, string column)
        {
            switch (column)
            {
                case "X": case "Y": case "Z": return PotreeCheck.Position(s_cloud, point, column);
                case "INDICES": return (ulong)point;
                case "Red": return PotreeCheck.Bits(point, "COLOR_PACKED", 0, 1);
                case "Green": return PotreeCheck.Bits(point, "COLOR_PACKED", 1, 1);
                case "Blue": return PotreeCheck.Bits(point, "COLOR_PACKED", 2, 1);
                case "Alpha": return PotreeCheck.Bits(point, "COLOR_PACKED", 3, 1);
                case "Intensity": return PotreeCheck.Bits(point, "INTENSITY", 0, 2);
                case "Classification": return PotreeCheck.Bits(point, "CLASSIFICATION", 0, 1);
                case "ReturnNumber": return PotreeCheck.Bits(point, "RETURN_NUMBER", 0, 1);
                case "NumberOfReturns": return PotreeCheck.Bits(point, "NUMBER_OF_RETURNS", 0, 1);
                case "PointSourceId": return PotreeCheck.Bits(point, "SOURCE_ID", 0, 2);
                case "GpsTime": return PotreeCheck.Bits(point, "GPS_TIME", 0, 8);
                case "SPACING": return PotreeCheck.Bits(point, "SPACING", 0, 4);
                case "NormalX":
                case "NormalY":
                case "NormalZ":
                    var normal = PotreeNormals.FromOctahedron(PotreeTestCloud.ByteOf(point, "NORMAL_OCT16", 0),
                        PotreeTestCloud.ByteOf(point, "NORMAL_OCT16", 1));
                    return (uint)BitConverter.SingleToInt32Bits(normal[column[6] - 'X']);
                case "reflectance": return PotreeCheck.Bits(point, column, 0, 8);
                case "pair[0]": return PotreeCheck.Bits(point, "pair", 0, 2);
                case "pair[1]": return PotreeCheck.Bits(point, "pair", 2, 2);
                default: throw new ArgumentException("nobody wrote " + column);
            }
        }

        static List<int> ReadAll(PointReader reader) =>
            PotreeCheck.Read(reader, reader.Info.Schema, ReadPoints.WholeBlocks(reader), 3, "INDICES", Value);

        [TestCase("1.4"), TestCase("1.5"), TestCase("1.7"), TestCase("1.8")]
        public void Read_AllPoints_HaveTheirValues(string version)
        {
            var writer = new Potree1Writer { Version = version };
            if (version == "1.8")
                writer.Attributes = writer.Attributes.Concat(new[]
                {
                    new PotreeTestAttribute("reflectance", "double"), new PotreeTestAttribute("pair", "int16", 2),
                }).ToArray();
            using var reader = Write(writer);
            Assert.That(reader.Info.Warnings, Is.Empty);
            Assert.That(reader.Info.PointsClaimed, Is.EqualTo(Points));
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(s_cloud.PointsOfNode.Count));
            Assert.That(reader.Tree.LevelCount, Is.EqualTo(Depth + 1));
            foreach (int workers in new[] { 0, 4 })
                using (new WorkerCount(workers))
                    Assert.That(ReadAll(reader).OrderBy(i => i), Is.EqualTo(Enumerable.Range(0, Points)));
        }

        [Test]
        public void Read_AnySubsetAnyRangeAnyOrder_IsTheSame()
        {
            using var reader = Write(new Potree1Writer());
            PotreeCheck.CheckSubsets(reader, "INDICES", Value);
        }

        [Test]
        public void Read_DecimalScale_IsWithinOneStep()
        {
            using var reader = Write(new Potree1Writer { Scale = 0.001, Min = new double3(481260.37, 3812921.09, -0.1) });
            int lower = 0;
            PotreeCheck.Read(reader, reader.Info.Schema, ReadPoints.WholeBlocks(reader), 1, "INDICES", (point, column) => null);
            var numbers = ReadPoints.Column<int>(reader, "INDICES");
            for (int axis = 0; axis < 3; axis++)
            {
                var stored = ReadPoints.Column<int>(reader, new[] { "X", "Y", "Z" }[axis]);
                for (int i = 0; i < stored.Length; i++)
                {
                    int difference = stored[i] - s_cloud.Position(numbers[i])[axis];
                    Assert.That(difference, Is.EqualTo(0).Or.EqualTo(-1));
                    lower -= difference;
                }
            }
            Assert.That(lower, Is.LessThan(Points * 2));
        }

        [Test]
        public void ReadLevels_SomeLevels_ReadsTheirPagesOnly()
        {
            new Potree1Writer().Write(Folder, s_cloud);
            using var reader = PointReaders.Open(Folder.Path);
            Assert.That(reader.Tree.LevelCount, Is.EqualTo(3));
            Assert.That(reader.BlocksAreKnown, Is.False);
            JobCoroutine.RunToEnd(reader.ReadLevels(3));
            Assert.That(reader.Tree.LevelCount, Is.EqualTo(3), "nothing more is needed for three levels");
            JobCoroutine.RunToEnd(reader.ReadLevels(4));
            Assert.That(reader.Tree.LevelCount, Is.EqualTo(5));
            Assert.That(reader.BlocksAreKnown, Is.False);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            Assert.That(reader.BlocksAreKnown, Is.True);
            Assert.That(reader.PointCount, Is.EqualTo(Points));
        }

        [Test]
        public void Open_MovedAndRenamed_FindsTheNodes()
        {
            var writer = new Potree1Writer { OctreeFolder = "nodes", ExtraMembers = "\"projection\": \"+proj=utm +zone=32\"," };
            writer.Write(Folder, s_cloud);
            Folder.Move();
            using (var reader = Open())
                Assert.That(reader.Info.Crs.Name, Is.EqualTo("+proj=utm +zone=32"));
            Directory.Move(Folder.File("nodes"), Folder.File("other name"));
            using (var reader = Open())
            {
                Assert.That(reader.Info.Warnings.Select(w => w.Text), Is.EqualTo(new[]
                {
                    "the nodes are not in \"nodes\" but in \"other name\"",
                }));
                Assert.That(ReadAll(reader).Count, Is.EqualTo(Points));
            }
            Directory.Move(Folder.File("other name/r"), Folder.File("r"));
            using (var reader = Open())
                Assert.That(ReadAll(reader).Count, Is.EqualTo(Points));
            Directory.Delete(Folder.File("r"), true);
            Failures.Of(() => PointReaders.Open(Folder.Path), FailureCode.NotFound, "the nodes are not there");
        }

        [TestCase("1.4"), TestCase("1.7")]
        public void Read_MissingAndShortNodes_AreHolesAndWarnings(string version)
        {
            var writer = new Potree1Writer { Version = version };
            writer.Write(Folder, s_cloud);
            var nodes = s_cloud.PointsOfNode.Where(n => n.Key.Length == 3 && n.Value.Count > 2).Take(2).ToList();
            File.Delete(Folder.File("data/" + writer.PathOf(nodes[0].Key) + ".bin"));
            string cut = Folder.File("data/" + writer.PathOf(nodes[1].Key) + ".bin");
            File.WriteAllBytes(cut, File.ReadAllBytes(cut).Take(60).ToArray());
            using var reader = Open();
            var got = ReadAll(reader);
            Assert.That(got.OrderBy(i => i), Is.EqualTo(Enumerable.Range(0, Points).Except(nodes[0].Value)
                .Except(nodes[1].Value.Skip(1))));
            var texts = reader.Info.Warnings.Select(w => w.Text).ToList();
            Assert.That(texts, Has.Some.Contains("node " + nodes[0].Key + ": its file is missing"));
            Assert.That(texts,
                Has.Some.Contains("node " + nodes[1].Key + ": its file does not hold").And.Some.Contains("got 1 and"));
            Assert.That(texts.Count, Is.EqualTo(2));
        }

        /// <summary>The converters wrote 0 for nodes that they had written to disk before: nothing is odd then.</summary>
        [Test]
        public void Read_HierarchyWithoutCounts_HasAllPointsAndNoWarning()
        {
            new Potree1Writer().Write(Folder, s_cloud);
            foreach (string path in Directory.GetFiles(Folder.File("data"), "*.hrc", SearchOption.AllDirectories))
            {
                byte[] bytes = File.ReadAllBytes(path);
                for (int entry = 5; entry < bytes.Length; entry += 5)
                    Array.Clear(bytes, entry + 1, 4);
                File.WriteAllBytes(path, bytes);
            }
            using var reader = Open();
            Assert.That(ReadAll(reader).OrderBy(i => i), Is.EqualTo(Enumerable.Range(0, Points)));
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [Test]
        public void Read_MissingHierarchyFile_LosesTheNodesBelow()
        {
            var writer = new Potree1Writer();
            writer.Write(Folder, s_cloud);
            string node = s_cloud.PointsOfNode.Keys.First(name => name.Length == 3 && s_cloud.ChildMask(name) != 0);
            File.Delete(Folder.File("data/" + writer.PathOf(node) + ".hrc"));
            using var reader = Open();
            Assert.That(reader.Info.Warnings.Single().Text,
                Does.StartWith("node " + node + ": the hierarchy below it is not there"));
            Assert.That(ReadAll(reader).OrderBy(i => i), Is.EqualTo(s_cloud.PointsOfNode
                .Where(n => n.Key == node || !n.Key.StartsWith(node)).SelectMany(n => n.Value).OrderBy(i => i)));
        }

        [Test]
        public void Open_WrongHierarchy_IsComparedWithTheFiles()
        {
            var writer = new Potree1Writer();
            writer.Write(Folder, s_cloud);
            string root = Folder.File("data/r/r.hrc");
            var bytes = File.ReadAllBytes(root);
            for (int at = 0; at < bytes.Length; at += 5)
            {
                bytes[at] = 255;
                BitConverter.GetBytes(uint.MaxValue).CopyTo(bytes, at + 1);
            }
            File.WriteAllBytes(root, bytes);
            using var reader = Open();
            Assert.That(reader.PointCount, Is.LessThanOrEqualTo(Points));
            Assert.That(ReadAll(reader).Distinct().Count(), Is.EqualTo(reader.PointCount), "no point twice");
            Assert.That(reader.Info.Warnings.Select(w => w.Text), Has.Some.Contains("ends early"));
            Assert.That(reader.Info.Warnings.Count, Is.LessThan(20));
        }

        [Test]
        public void Read_OneUnknownName_IsKeptAsBytes()
        {
            var writer = new Potree1Writer();
            writer.Attributes = writer.Attributes.Concat(new[] { new PotreeTestAttribute("WHATEVER", "uint8", 3) }).ToArray();
            writer.Write(Folder, s_cloud);
            using var reader = Open();
            Assert.That(reader.Info.Warnings.Single().Text, Does.Contain("\"WHATEVER\" is not known: its 3 bytes"));
            var numbers = ReadPoints.Column<int>(reader, "INDICES");
            var last = ReadPoints.Column<byte>(reader, "WHATEVER[2]");
            Assert.That(last, Is.EqualTo(numbers.Select(n => PotreeTestCloud.ByteOf(n, "WHATEVER", 2))));
        }

        [Test]
        public void Read_SeveralNormalsAndColors_KeepsAll()
        {
            var writer = new Potree1Writer
            {
                Attributes = new[]
                {
                    new PotreeTestAttribute("POSITION_CARTESIAN", "int32", 3), new PotreeTestAttribute("INDICES", "uint32"),
                    new PotreeTestAttribute("RGB_PACKED", "uint8", 3), new PotreeTestAttribute("NORMAL_SPHEREMAPPED", "uint8", 2),
                    new PotreeTestAttribute("NORMAL_OCT16", "uint8", 2), new PotreeTestAttribute("NORMAL", "float", 3),
                },
            };
            using var reader = Write(writer);
            Assert.That(reader.Info.Schema.Select(a => a.Name), Is.EqualTo(new[]
            {
                "X", "Y", "Z", "INDICES", "Red", "Green", "Blue", "NormalX", "NormalY", "NormalZ", "NORMAL_OCT16[0]",
                "NORMAL_OCT16[1]", "NormalX (2)", "NormalY (2)", "NormalZ (2)",
            }));
            var numbers = ReadPoints.Column<int>(reader, "INDICES");
            Assert.That(ReadPoints.Column<float>(reader, "NormalY"),
                Is.EqualTo(numbers.Select(n => PotreeNormals.FromSphereMap(
                    PotreeTestCloud.ByteOf(n, "NORMAL_SPHEREMAPPED", 0),
                    PotreeTestCloud.ByteOf(n, "NORMAL_SPHEREMAPPED", 1)).y)));
            Assert.That(ReadPoints.Column<byte>(reader, "NORMAL_OCT16[1]"), Is.EqualTo(numbers.Select(n =>
                PotreeTestCloud.ByteOf(n, "NORMAL_OCT16", 1))));
            Assert.That(ReadPoints.Column<uint>(reader, "NormalZ (2)"), Is.EqualTo(numbers.Select(n =>
                (uint)PotreeCheck.Bits(n, "NORMAL", 8, 4))));
        }

        /// <summary>Nodes in LAS, each with its own offset, as PotreeConverter 1.5 and later write them.</summary>
        [Test]
        public void Read_LasNodes_ShareOneGrid([Values(0.0, 0.3)] double between)
        {
            var writer = new Potree1Writer { Version = "1.4" };
            writer.Write(Folder, s_cloud);
            string text = File.ReadAllText(Folder.File("cloud.js"));
            int from = text.IndexOf("[", text.IndexOf("pointAttributes")), to = text.IndexOf("]", from) + 1;
            Folder.Write("cloud.js", text.Substring(0, from) + "\"LAS\"" + text.Substring(to));
            foreach (var node in s_cloud.PointsOfNode)
            {
                File.Delete(Folder.File("data/" + node.Key + ".bin"));
                if (node.Value.Count > 0)
                    WriteLas(node.Key, node.Value, writer, node.Key == "r" ? 0 : between);
            }
            using (var reader = Open())
            {
                Assert.That(reader.Info.Warnings, Is.Empty);
                Assert.That(reader.PointCount, Is.EqualTo(Points));
                var numbers = ReadPoints.Column<uint>(reader, "number");
                Assert.That(numbers.OrderBy(n => n), Is.EqualTo(Enumerable.Range(0, Points).Select(i => (uint)i)));
                for (int axis = 0; axis < 3; axis++)
                    Assert.That(ReadPoints.Column<int>(reader, new[] { "X", "Y", "Z" }[axis]),
                        Is.EqualTo(numbers.Select(n => s_cloud.Position((int)n)[axis])));

                // Ranges in the middle of nodes, and a subset.
                var ranges = ReadPoints.WholeBlocks(reader).Where(r => r.Count > 4)
                    .Select(r => new BlockRange(r.Block, 2, r.Count - 3)).ToList();
                var got = PotreeCheck.Read(reader, reader.Info.Schema.Select("number", "Y"), ranges, 3, "number",
                    (point, column) => PotreeCheck.Position(s_cloud, point, column));
                Assert.That(got.Count, Is.EqualTo(ranges.Sum(r => r.Count)));

                var node = s_cloud.PointsOfNode.First(n => n.Key.Length == 4 && n.Value.Count > 3);
                string path = Folder.File("data/" + node.Key + ".las");
                var bytes = File.ReadAllBytes(path);
                bytes[LasHeader.At.PointFormat] = 0;
                File.WriteAllBytes(path, bytes);
                Assert.That(ReadPoints.EachBlock(reader, reader.Info.Schema, _ => { }), Is.EqualTo(Points - node.Value.Count));
                var warning = reader.Info.Warnings.Single();
                Assert.That(warning.Text, Does.StartWith("node " + node.Key + ": its file is not what the"));
                Assert.That(warning.Path, Is.EqualTo(path));
                File.WriteAllBytes(path, bytes.Take(100).ToArray());
                Assert.That(() => ReadPoints.EachBlock(reader, reader.Info.Schema, _ => { }),
                    Throws.TypeOf<PointCloudException>().With.Message.StartsWith(path));
            }
        }

        void WriteLas(string node, List<int> points, Potree1Writer tree, double between)
        {
            var corner = math.floor(PotreeTestCloud.Corner(node));
            var settings = new LasWriterSettings
            {
                PointFormat = 1,
                Scale = tree.Scale,
                Offset = tree.Min + (corner + between) * tree.Scale,
                ExtraBytes = new[] { new PointAttribute("number", AttributeType.UInt32) },
            };
            using var las = LasWriter.Create(Folder.File("data/" + node + ".las"), settings);
            using var batch = new PointBatch(las.Schema, points.Count, Allocator.Persistent);
            var bytes = batch.Bytes;
            for (int i = 0; i < bytes.Length; i++)
                bytes[i] = 0;
            for (int axis = 0; axis < 3; axis++)
            {
                var column = batch.Column<int>(axis);
                for (int i = 0; i < points.Count; i++)
                    column[i] = (int)(s_cloud.Position(points[i])[axis] - corner[axis]);
            }
            var numbers = batch.Column<uint>("number");
            for (int i = 0; i < points.Count; i++)
                numbers[i] = (uint)points[i];
            batch.Count = points.Count;
            las.Append(batch);
            las.Complete();
        }

        [TestCase("\"version\": \"1.7\"", "\"version\": \"1.3\"", FailureCode.Unsupported, "wanted 1.4 to 1.8, got 1.3")]
        [TestCase("\"scale\": ", "\"scale\": -", FailureCode.BadInput, "numbers above 0")]
        [TestCase("\"scale\": ", "\"scale\": 1e-300, \"s\": ", FailureCode.Unsupported, "steps of the bounding box")]
        [TestCase("POSITION_CARTESIAN", "COLOR_PACKED", FailureCode.BadInput, "a position of three int32")]
        [TestCase("\"lx\"", "\"l\"", FailureCode.BadInput, "boundingBox.lx")]
        [TestCase("\"INTENSITY\"", "\"A\", \"B\"", FailureCode.Unsupported, "A and B")]
        public void Open_BrokenIndex_NamesTheMember(string from, string to, FailureCode code, string detail)
        {
            new Potree1Writer().Write(Folder, new PotreeTestCloud(9, 0, 1));
            string text = File.ReadAllText(Folder.File("cloud.js"));
            Assert.That(text, Does.Contain(from));
            Folder.Write("cloud.js", text.Replace(from, to));
            Failures.Of(() => PointReaders.Open(Folder.Path), code, detail);
        }
    }
}
