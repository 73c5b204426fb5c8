using System;
using System.IO;
using System.Linq;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Tests.Reading;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using static FastPoints.Tests.Sources.EptTestClouds;
using Random = System.Random;

namespace FastPoints.Tests.Sources
{
    public class EptReaderTests
    {
        [SetUp]
        public void Register() => Decompressors.Zstandard = () => new StoredZstandard();

        [TearDown]
        public void Forget() => Decompressors.Zstandard = null;

        static EptDataType Named(string type) => (EptDataType)Enum.Parse(typeof(EptDataType), type);

        [TestCase(nameof(EptDataType.Binary), 99, 0)]
        [TestCase(nameof(EptDataType.Binary), 1, 0)]
        [TestCase(nameof(EptDataType.Zstandard), 2, 0)]
        [TestCase(nameof(EptDataType.Laszip), 99, 3)]
        [TestCase(nameof(EptDataType.Laszip), 1, 0)]
        [TestCase(nameof(EptDataType.Laszip), 2, 7)]
        public void Read_EachNode_HasItsPoints(string typeName, int levelsPerPage, int format)
        {
            var type = Named(typeName);
            using var folder = Make(type, 1500, levelsPerPage, format);
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(reader.Info.Format, Is.EqualTo("EPT"));
            Assert.That(reader.PointCount, Is.EqualTo(1500));
            Assert.That(reader.Info.PointsReadable, Is.EqualTo(1500));
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(folder.Nodes.Count));
            Assert.That(reader.Tree.PageCount, Is.EqualTo(folder.Pages.Count));
            CheckNodes(reader, folder, 3, false);
            Assert.That(reader.Info.Warnings, Is.Empty);
        }

        [TestCase(nameof(EptDataType.Binary), 1)]
        [TestCase(nameof(EptDataType.Zstandard), 4)]
        [TestCase(nameof(EptDataType.Laszip), 4)]
        public void Read_AnyNumberOfWorkersInReverse_IsTheSame(string typeName, int workers)
        {
            var type = Named(typeName);
            using (new WorkerCount(workers))
            using (var folder = Make(type))
            using (var reader = ReadPoints.Open(folder.IndexPath))
                CheckNodes(reader, folder, workers, true);
        }

        [TestCase(nameof(EptDataType.Binary)), TestCase(nameof(EptDataType.Zstandard))]
        [TestCase(nameof(EptDataType.Laszip))]
        public void Read_AnySelectionAndRange_MatchesTheWhole(string typeName)
        {
            var type = Named(typeName);
            using var folder = Make(type, 2500, 99, 7, 20000);
            using var reader = ReadPoints.Open(folder.Path);
            var schema = reader.Info.Schema;
            using var whole = reader.CreateRead(schema, 2500, Allocator.Persistent);
            whole.Begin(new BlockRange(0, 0, 2500));
            whole.Complete();
            for (int i = 0; i < schema.Count; i++)
            {
                var wanted = schema.Select(schema[i].Name, schema[(i * 5 + 2) % schema.Count].Name);
                CheckRange(reader, wanted, whole.Points, 97 * i % 2000, 1 + 61 * i % 500);
            }
        }

        [Test]
        public void ReadLevels_Few_ReadsOnlyTheirPages()
        {
            using var folder = Make(EptDataType.Binary, 2000, 1, 0, 50);
            using var reader = PointReaders.Open(folder.Path);
            Assert.That(reader.BlocksAreKnown, Is.False);
            for (int level = 1; level <= folder.Nodes.Max(node => node.Level) + 1; level++)
            {
                JobCoroutine.RunToEnd(reader.ReadLevels(level));
                Assert.That(reader.Tree.NodeCount, Is.EqualTo(folder.Nodes.Count(node => node.Level < level)));
            }
            Assert.That(reader.BlocksAreKnown, Is.False);
            JobCoroutine.RunToEnd(reader.IndexBlocks());
            CheckNodes(reader, folder, 2, false);
        }

        [TestCase(nameof(EptDataType.Binary)), TestCase(nameof(EptDataType.Laszip))]
        public void Node_Missing_IsAHoleAndAWarning(string typeName)
        {
            var type = Named(typeName);
            using var folder = Make(type);
            File.Delete(folder.DataPath(EptFolder.NameOf(folder.Nodes[2])));
            File.WriteAllBytes(folder.DataPath(EptFolder.NameOf(folder.Nodes[3])), new byte[0]);
            if (type == EptDataType.Laszip)
                File.Delete(folder.DataPath("0-0-0-0"));
            int lost = folder.Nodes[2].Records.Count + folder.Nodes[3].Records.Count
                + (type == EptDataType.Laszip ? folder.Nodes[0].Records.Count : 0);
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(Count(reader), Is.EqualTo(1500 - lost));
            CheckWarned(reader, "file is missing");
            CheckWarned(reader, "file is empty");
            CheckWarned(reader, "claims 1500 points");
            Assert.That(reader.Tree.NodesWithoutPoints(), Is.GreaterThanOrEqualTo(2));
        }

        [TestCase(nameof(EptDataType.Binary), "cannot hold")]
        [TestCase(nameof(EptDataType.Zstandard), "zstandard stream is broken")]
        [TestCase(nameof(EptDataType.Laszip), "breaks off")]
        public void Node_Truncated_GivesItsPointsAndReportsIt(string typeName, string detail)
        {
            var type = Named(typeName);
            using var folder = Make(type);
            string path = folder.DataPath(EptFolder.NameOf(folder.Nodes[1]));
            var bytes = File.ReadAllBytes(path);
            File.WriteAllBytes(path, bytes.Take(bytes.Length * 3 / 5).ToArray());
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(Count(reader), Is.InRange(1400, 1499));
            CheckWarned(reader, detail);
        }

        [Test]
        public void Node_Longer_IsReported()
        {
            using var folder = Make(EptDataType.Binary);
            string path = folder.DataPath(EptFolder.NameOf(folder.Nodes[1]));
            File.WriteAllBytes(path, File.ReadAllBytes(path).Concat(new byte[500]).ToArray());
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(Count(reader), Is.EqualTo(1500));
            CheckWarned(reader, "more than the points");
        }

        [TestCase("{", "broken")]
        [TestCase("", "broken")]
        [TestCase("[1, 2]", "broken")]
        [TestCase("{ \"0-0-0-0\": 100 ", "broken")]
        [TestCase("{ \"0-0-0-0\": 1e2 }", "broken")]
        [TestCase("{ \"0-0-0-0\": 100, \"1-2-0-0\": 5 }", "an entry of the hierarchy is none")]
        [TestCase("{ \"0-0-0-0\": 100, \"99-0-0-0\": 5, \"x\": 3 }", "an entry of the hierarchy is none")]
        [TestCase("{ \"0-0-0-0\": 100, \"0-0-0-0\": 100 }", "twice")]
        [TestCase("{ \"0-0-0-0\": -1 }", "named twice")]
        [TestCase("{ \"0-0-0-0\": -7 }", "none")]
        [TestCase("{ \"0-0-0-0\": 100, \"1-0-0-0\": -1, \"1-0-0-1\": -1 }", "cannot be read")]
        [TestCase("{ \"0-0-0-0\": 99999999999999999999 }", "cannot hold")]
        [TestCase("\uFEFF { \"0-0-0-0\" : 100 , }", "claims 1500 points")]
        public void Page_Inconsistent_IsReportedAndTheRestIsRead(string page, string detail)
        {
            using var folder = Make(EptDataType.Binary);
            File.WriteAllText(folder.PagePath("0-0-0-0"), page);
            try
            {
                using var reader = ReadPoints.Open(folder.Path);
                Assert.That(Count(reader), Is.EqualTo(100));
                CheckWarned(reader, detail);
            }
            catch (PointCloudException failure)
            {
                Assert.That(failure.Code, Is.EqualTo(FailureCode.Truncated));
                Assert.That(failure.Message, Does.Contain("the nodes that are there hold 0"));
            }
        }

        [Test]
        public void Page_Missing_IsAHole()
        {
            using var folder = Make(EptDataType.Binary, 1500, 1);
            File.Delete(folder.PagePath(folder.Pages.First(page => page[0] == '1')));
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(Count(reader), Is.InRange(100, 1499));
            CheckWarned(reader, "the page of the hierarchy");
        }

        [Test]
        public void Page_OfTooManyBytes_IsAHole()
        {
            using var folder = Make(EptDataType.Binary, 1500, 1);
            using (var page = File.OpenWrite(folder.PagePath(folder.Pages.First(page => page[0] == '1'))))
                page.SetLength((32 << 20) + 1);
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(Count(reader), Is.InRange(100, 1499));
            CheckWarned(reader, "wanted at most 33554432");
        }

        [Test, Category("Long"), Explicit]
        public void Hierarchy_TooManyNodes_IsTruncated()
        {
            const int MaxNodes = 1 << 21;
            using var folder = Make(EptDataType.Binary);
            using (var page = new StreamWriter(folder.PagePath("0-0-0-0")))
            {
                page.Write("{\"0-0-0-0\":100");
                for (int i = 0; i < MaxNodes; i++)
                    page.Write(",\"7-" + (i >> 14) + "-" + (i >> 7 & 127) + "-" + (i & 127) + "\":0");
                page.Write("}");
            }
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(reader.Tree.NodeCount, Is.EqualTo(MaxNodes));
            CheckWarned(reader, "the others are left out");
        }

        [TestCase("\"json\"", "\"gzip\"", FailureCode.Unsupported, "hierarchyType")]
        [TestCase("\"binary\"", "\"quantized\"", FailureCode.Unsupported, "dataType")]
        [TestCase("\"name\": \"X\"", "\"name\": \"U\"", FailureCode.BadInput, "no X")]
        [TestCase("\"size\": 8", "\"size\": 3", FailureCode.BadInput, "size")]
        [TestCase("\"type\": \"float\"", "\"type\": \"complex\"", FailureCode.BadInput, "type")]
        [TestCase("\"bounds\": [", "\"bounds\": [1, ", FailureCode.BadInput, "bounds")]
        [TestCase("\"points\": 1500", "\"points\": \"many\"", FailureCode.BadInput, "points")]
        public void Index_Wrong_NamesTheMember(string part, string wrong, FailureCode code, string detail)
        {
            using var folder = Make(EptDataType.Binary);
            File.WriteAllText(folder.IndexPath, folder.Index.Replace(part, wrong));
            Failures.Of(() => PointReaders.Open(folder.Path).Dispose(), code, detail, "ept.json");
        }

        [Test]
        public void Schema_WithoutScale_KeepsTheIntegers()
        {
            using var folder = Make(EptDataType.Binary);
            File.WriteAllText(folder.IndexPath, folder.Index.Replace(", \"scale\": 0.01, \"offset\": 0", "")
                .Replace("\"Odd\", \"type\": \"signed\"", "\"Odd\", \"scale\": 0.5, \"offset\": 3, \"type\": \"signed\""));
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(reader.Info.Transform.Scale, Is.EqualTo(new double3(1, 1, 1)));
            var odd = reader.Info.Schema[reader.Info.Schema.IndexOf("Odd")];
            Assert.That((odd.Scale, odd.Offset), Is.EqualTo((0.5, 3.0)));
            CheckNodes(reader, folder, 2, false);
        }

        [Test]
        public void CreateRead_ZstandardWithoutADecompressor_NamesWhatIsMissing()
        {
            Decompressors.Zstandard = null;
            using var folder = Make(EptDataType.Zstandard);
            using var reader = ReadPoints.Open(folder.Path);
            Assert.That(reader.PointCount, Is.EqualTo(1500));
            Failures.Of(() => reader.CreateRead(reader.Info.Schema, 10, Allocator.Persistent),
                FailureCode.Unsupported, "Decompressors.Zstandard", "convert");
        }

        [Test]
        public void CreateRead_MissingAttribute_IsRefused()
        {
            foreach (EptDataType type in Enum.GetValues(typeof(EptDataType)))
                using (var folder = Make(type))
                using (var reader = ReadPoints.Open(folder.Path))
                {
                    var wanted = new PointSchema(new[] { new PointAttribute("Nothing", AttributeType.UInt16) });
                    Assert.That(() => reader.CreateRead(wanted, 10, Allocator.Persistent), Throws.ArgumentException);
                }
        }

        [TestCase(nameof(EptDataType.Binary)), TestCase(nameof(EptDataType.Zstandard))]
        [TestCase(nameof(EptDataType.Laszip))]
        public void Mutation_OfAnyFile_EndsInAnErrorLineOrAResult(string typeName)
        {
            var type = Named(typeName);
            var random = new Random((int)type + 1);
            using var folder = Make(type, 400, 1, 7, 60);
            var files = Directory.GetFiles(folder.Path, "*", SearchOption.AllDirectories);
            for (int i = 0; i < 150; i++)
            {
                string file = random.Next(3) == 0 ? folder.IndexPath : files[random.Next(files.Length)];
                var sound = File.ReadAllBytes(file);
                File.WriteAllBytes(file, Damage(sound, random));
                try
                {
                    using var reader = ReadPoints.Open(folder.Path);
                    Assert.That(Count(reader), Is.LessThanOrEqualTo(400), "case " + i);
                }
                catch (PointCloudException failure)
                {
                    Assert.That(failure.Message, Does.Not.Contain("\n"), "case " + i);
                    Assert.That(failure.IsInputAtFault, Is.True, "case " + i + ": " + failure.Message);
                }
                File.WriteAllBytes(file, sound);
            }
        }

        static byte[] Damage(byte[] sound, Random random)
        {
            var bytes = (byte[])sound.Clone();
            if (random.Next(4) == 0)
                Array.Resize(ref bytes, random.Next(bytes.Length));
            for (int i = random.Next(1, 6); i > 0 && bytes.Length > 0; i--)
                bytes[random.Next(bytes.Length)] = random.Next(2) == 0 ? (byte)random.Next(256) : (byte)random.Next('0', '9' + 1);
            return bytes;
        }

        static void CheckRange(PointReader reader, PointSchema wanted, PointBatch whole, int first, int count)
        {
            using var part = reader.CreateRead(wanted, count, Allocator.Persistent);
            part.Begin(new BlockRange(0, first, count));
            part.Complete();
            Assert.That(part.Points.Count, Is.EqualTo(count));
            for (int i = 0; i < wanted.Count; i++)
            {
                int size = wanted[i].Type.SizeOf();
                int from = whole.Column(whole.Schema.IndexOf(wanted[i].Name)).OffsetBytes + first * size;
                Assert.That(part.Points.Bytes.GetSubArray(part.Points.Column(i).OffsetBytes, count * size).ToArray(),
                    Is.EqualTo(whole.Bytes.GetSubArray(from, count * size).ToArray()), wanted[i].ToString());
            }
        }
    }
}
