using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using FastPoints.Las;
using FastPoints.Sources;

namespace FastPoints.Tests
{
    /// <summary>An EPT octree in a folder of its own, gone when disposed. Records start with X, Y, Z as int32.</summary>
    sealed class EptFolder : IDisposable
    {
        readonly CopcFileWriter m_tree;
        readonly int m_pointFormat;
        readonly TemporaryFolder m_folder = new TemporaryFolder();

        public EptFolder(EptDataType dataType, List<byte[]> records, (string Name, string Type, int Size)[] extraDimensions,
            int pointFormat = 3, int maxNodePoints = 100, int levelsPerPage = 99)
        {
            DataType = dataType;
            m_pointFormat = pointFormat;
            RecordBytes = records[0].Length;
            m_tree = new CopcFileWriter { MaxNodePoints = maxNodePoints };
            var (min, edgeBits) = m_tree.Split(records);
            foreach (var node in m_tree.Nodes)
                m_folder.Write(DataPath(NameOf(node)), NodeFile(node.Records));
            WritePages(m_tree.Nodes[0], levelsPerPage);
            Index = IndexText(records.Count, min, edgeBits, extraDimensions);
            File.WriteAllText(IndexPath, Index);
        }

        public string Path => m_folder.Path;
        public EptDataType DataType { get; }
        public int RecordBytes { get; }

        public IReadOnlyList<CopcFileWriter.Node> Nodes => m_tree.Nodes;
        public string Index { get; }
        public string IndexPath => m_folder.File("ept.json");
        public List<string> Pages { get; } = new List<string>();

        public static string NameOf(CopcFileWriter.Node node) => EptEntry.NameOf(node.Level, node.Cell);

        public string DataPath(string node) => m_folder.File("ept-data/" + node
            + (DataType == EptDataType.Binary ? ".bin" : DataType == EptDataType.Zstandard ? ".zst" : ".laz"));

        public string PagePath(string node) => m_folder.File("ept-hierarchy/" + node + ".json");

        /// <summary>Writes a laszip node anew, its positions as whole numbers on a grid of its own: factor times as coarse as the
        /// others' (negative: the other way round), its offset <paramref name="shift"/> of their steps beside theirs. The node's
        /// records become what lies on that grid.</summary>
        public void MoveToGrid(CopcFileWriter.Node node, long factor, long shift)
        {
            var stored = new List<byte[]>();
            foreach (var record in node.Records)
            {
                var own = (byte[])record.Clone();
                for (int axis = 0; axis < 3; axis++)
                {
                    long whole = (BitConverter.ToInt32(record, 4 * axis) - shift) / factor;
                    whole = Math.Max(int.MinValue, Math.Min(int.MaxValue, whole));
                    BitConverter.GetBytes((int)whole).CopyTo(own, 4 * axis);
                    BitConverter.GetBytes(checked((int)(whole * factor + shift))).CopyTo(record, 4 * axis);
                }
                stored.Add(own);
            }
            WriteNode(node, stored, 0.01 * factor, 0.01 * shift);
        }

        public void WriteNode(CopcFileWriter.Node node, List<byte[]> records, double scale, double offset)
        {
            var bytes = NodeFile(records);
            for (int axis = 0; axis < 3; axis++)
            {
                BitConverter.GetBytes(scale).CopyTo(bytes, LasHeader.At.Scale + 8 * axis);
                BitConverter.GetBytes(offset).CopyTo(bytes, LasHeader.At.Offset + 8 * axis);
            }
            File.WriteAllBytes(DataPath(NameOf(node)), bytes);
        }

        byte[] NodeFile(List<byte[]> records)
        {
            var flat = records.SelectMany(record => record).ToArray();
            switch (DataType)
            {
                case EptDataType.Binary:
                    return flat;
                case EptDataType.Zstandard:
                    return StoredZstandard.Frame(flat);
                default:
                    return new LazFileWriter
                    {
                        PointFormat = m_pointFormat,
                        ItemVersion = m_pointFormat < 6 ? 2 : 3,
                        ExtraBytes = RecordBytes - LasPointFormat.Of(m_pointFormat).RecordBytes,
                        // Most nodes are several chunks.
                        ChunkPoints = new[] { 37 },
                    }.Write(records);
            }
        }

        void WritePages(CopcFileWriter.Node root, int levelsPerPage)
        {
            var page = new List<string>();
            var open = new Queue<CopcFileWriter.Node>();
            open.Enqueue(root);
            while (open.Count > 0)
            {
                var node = open.Dequeue();
                bool isPage = node.Level - root.Level >= levelsPerPage;
                page.Add("\"" + NameOf(node) + "\": "
                    + (isPage ? -1 : node.Records.Count).ToString(CultureInfo.InvariantCulture));
                if (isPage)
                    WritePages(node, levelsPerPage);
                else
                    foreach (var child in node.Children)
                        open.Enqueue(child);
            }
            Pages.Add(NameOf(root));
            m_folder.Write(PagePath(NameOf(root)), "{\n\t" + string.Join(",\n\t", page) + "\n}\n");
        }

        string IndexText(int points, long[] min, int edgeBits, (string Name, string Type, int Size)[] extraDimensions)
        {
            double edge = Math.Pow(2, edgeBits) * 0.01;
            var bounds = new List<string>();
            for (int i = 0; i < 6; i++)
                bounds.Add((min[i % 3] * 0.01 + (i < 3 ? 0 : edge)).ToString("R", CultureInfo.InvariantCulture));
            var text = new StringBuilder("{ \"bounds\": [" + string.Join(", ", bounds) + "],\n");
            text.Append("\"dataType\": \"" + DataType.ToString().ToLowerInvariant() + "\", \"hierarchyType\": \"json\",\n");
            text.Append("\"points\": " + points + ", \"span\": 128, \"srs\": {}, \"version\": \"1.0.0\",\n\"schema\": [");
            foreach (string axis in new[] { "X", "Y", "Z" })
                text.Append("\n{ \"name\": \"" + axis
                    + "\", \"type\": \"signed\", \"size\": 4, \"scale\": 0.01, \"offset\": 0 },");
            foreach (var (name, type, size) in extraDimensions)
                text.Append("\n{ \"name\": \"" + name + "\", \"type\": \"" + type + "\", \"size\": " + size + " },");
            text.Length--;
            return text.Append("] }\n").ToString();
        }

        public void Dispose() => m_folder.Dispose();
    }
}
