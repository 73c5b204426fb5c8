using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using Unity.Mathematics;

namespace FastPoints.Tests
{
    /// <summary>Writes Potree 2 trees as PotreeConverter 2 does, in pages of the hierarchy of few levels.</summary>
    public sealed class Potree2Writer
    {
        public bool IsBrotli;
        public int StepSize = 2;
        public double Scale = 0.001;
        public double3 Offset = new double3(500000.123, 4000000.456, -7.5);

        public PotreeTestAttribute[] Attributes =
        {
            new PotreeTestAttribute("position", "int32", 3), new PotreeTestAttribute("intensity", "uint16"),
            new PotreeTestAttribute("return number", "uint8"), new PotreeTestAttribute("number of returns", "uint8"),
            new PotreeTestAttribute("classification", "uint8"), new PotreeTestAttribute("scan angle rank", "uint8"),
            new PotreeTestAttribute("user data", "uint8"), new PotreeTestAttribute("point source id", "uint16"),
            new PotreeTestAttribute("gps-time", "double"), new PotreeTestAttribute("rgb", "uint16", 3),
            new PotreeTestAttribute("a pair", "float", 2), new PotreeTestAttribute("i8", "int8"),
            new PotreeTestAttribute("i16", "int16"), new PotreeTestAttribute("u32", "uint32"),
            new PotreeTestAttribute("i64", "int64"),
            new PotreeTestAttribute("u64", "uint64"), new PotreeTestAttribute("odd", "undefined", 3),
            new PotreeTestAttribute("number", "uint32"),
        };

        public int RecordBytes => Attributes.Sum(attribute => attribute.Bytes);

        public void Write(TemporaryFolder folder, PotreeTestCloud cloud)
        {
            var octree = new MemoryStream();
            var places = new Dictionary<string, (long Offset, long Bytes)>();
            foreach (var node in cloud.PointsOfNode)
            {
                var bytes = node.Value.Count == 0
                    ? new byte[0]
                    : IsBrotli ? Columns(cloud, node.Value) : Records(cloud, node.Value);
                places.Add(node.Key, (octree.Position, bytes.Length));
                octree.Write(bytes, 0, bytes.Length);
            }
            folder.Write("octree.bin", octree.ToArray());
            var hierarchy = Hierarchy(cloud, places, out int firstPage);
            folder.Write("hierarchy.bin", hierarchy);
            folder.Write("metadata.json", Metadata(cloud, firstPage));
        }

        byte[] Records(PotreeTestCloud cloud, List<int> points)
        {
            var bytes = new MemoryStream();
            foreach (int point in points)
                foreach (var attribute in Attributes)
                    bytes.Write(Bytes(cloud, point, attribute), 0, attribute.Bytes);
            return bytes.ToArray();
        }

        byte[] Columns(PotreeTestCloud cloud, List<int> points)
        {
            var bytes = new MemoryStream();
            var writer = new BinaryWriter(bytes);
            foreach (var attribute in Attributes)
                foreach (int point in points)
                {
                    if (attribute.Name == "position")
                    {
                        // One step higher than in DEFAULT, as the converter's overflow makes them.
                        var p = cloud.Position(point) + 1;
                        writer.Write(Morton.Encode((uint)p.x >> 16, (uint)p.y >> 16, (uint)p.z >> 16));
                        writer.Write(Morton.Encode((uint)p.x & 0xFFFF, (uint)p.y & 0xFFFF, (uint)p.z & 0xFFFF));
                        continue;
                    }
                    var value = Bytes(cloud, point, attribute);
                    if (attribute.Name == "rgb")
                        writer.Write(Morton.Encode(BitConverter.ToUInt16(value, 0), BitConverter.ToUInt16(value, 2),
                            BitConverter.ToUInt16(value, 4)));
                    else
                        writer.Write(value);
                }
            var packed = new MemoryStream();
            using (var brotli = new BrotliStream(packed, CompressionLevel.Fastest, true))
                brotli.Write(bytes.ToArray(), 0, (int)bytes.Length);
            return packed.ToArray();
        }

        static byte[] Bytes(PotreeTestCloud cloud, int point, PotreeTestAttribute attribute)
        {
            var bytes = new byte[attribute.Bytes];
            if (attribute.Name == "number")
                return BitConverter.GetBytes(point);
            for (int i = 0; i < bytes.Length; i++)
                bytes[i] = PotreeTestCloud.ByteOf(point, attribute.Name, i);
            if (attribute.Name == "position")
                for (int axis = 0; axis < 3; axis++)
                    BitConverter.GetBytes(cloud.Position(point)[axis]).CopyTo(bytes, 4 * axis);
            return bytes;
        }

        byte[] Hierarchy(PotreeTestCloud cloud, Dictionary<string, (long Offset, long Bytes)> places, out int firstPage)
        {
            var roots = cloud.PointsOfNode.Keys.Where(name => (name.Length - 1) % StepSize == 0
                && (name == "r" || cloud.ChildMask(name) != 0)).ToList();
            var pages = roots.ToDictionary(root => root, root => cloud.PointsOfNode.Keys
                .Where(name => name.StartsWith(root, StringComparison.Ordinal) &&
                    name.Length - root.Length <= StepSize).ToList());
            var starts = new Dictionary<string, long>();
            long end = 0;
            foreach (string root in roots)
            {
                starts.Add(root, end);
                end += 22 * pages[root].Count;
            }
            var bytes = new MemoryStream();
            var writer = new BinaryWriter(bytes);
            foreach (string root in roots)
                foreach (string name in pages[root])
                {
                    bool isProxy = name != root && pages.ContainsKey(name);
                    int mask = cloud.ChildMask(name);
                    writer.Write((byte)(isProxy ? 2 : mask == 0 ? 1 : 0));
                    writer.Write((byte)mask);
                    writer.Write((uint)cloud.PointsOfNode[name].Count);
                    writer.Write(isProxy ? starts[name] : places[name].Offset);
                    writer.Write(isProxy ? 22L * pages[name].Count : places[name].Bytes);
                }
            firstPage = 22 * pages["r"].Count;
            return bytes.ToArray();
        }

        string Metadata(PotreeTestCloud cloud, int firstPage)
        {
            var max = Offset + PotreeTestCloud.Edge * Scale;
            string lows = Numbers(Offset), highs = Numbers(max);
            var text = new StringBuilder("{ \"version\": \"2.0\", \"name\": \"test\", \"points\": " + cloud.Count
                + ", \"projection\": \"EPSG:25832\", \"hierarchy\": { \"firstChunkSize\": " + firstPage
                + ", \"stepSize\": " + StepSize + ", \"depth\": 4 }, \"offset\": " + lows + ", \"scale\": " + Numbers(Scale)
                + ", \"spacing\": 0.1, \"boundingBox\": { \"min\": " + lows + ", \"max\": " + highs + " }, \"encoding\": \""
                + (IsBrotli ? "BROTLI" : "DEFAULT") + "\", \"attributes\": [");
            string separator = "";
            foreach (var attribute in Attributes)
            {
                text.Append(separator + "{ \"name\": \"" + attribute.Name + "\", \"description\": \"\""
                    + ", \"size\": " + attribute.Bytes + ", \"numElements\": " + attribute.Elements
                    + ", \"elementSize\": " + attribute.ElementBytes + ", \"type\": \"" + attribute.Type + "\""
                    + (attribute.Name == "i16" ? ", \"scale\": [0.25], \"offset\": [100]" : "") + " }");
                separator = ", ";
            }
            return text.Append("] }").ToString();
        }

        static string Numbers(double3 values) =>
            string.Format(CultureInfo.InvariantCulture, "[{0:R}, {1:R}, {2:R}]", values.x, values.y, values.z);
    }
}
