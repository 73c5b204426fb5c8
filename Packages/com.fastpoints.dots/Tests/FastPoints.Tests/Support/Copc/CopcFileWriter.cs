using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.Las;
using FastPoints.Sources;
using Unity.Mathematics;

namespace FastPoints.Tests
{
    /// <summary>A whole COPC file from records of point format 6 to 8: an octree over their X, Y, Z, in which a node takes some
    /// of the points of its cell and its children the others; nodes as chunks, the hierarchy in an EVLR.</summary>
    public sealed class CopcFileWriter
    {
        public sealed class Node
        {
            public int Level;
            public int3 Cell;
            public List<byte[]> Records = new List<byte[]>();
            public readonly List<Node> Children = new List<Node>();
        }

        const int InfoVlrAt = 375, InfoAt = InfoVlrAt + 54;

        public int PointFormat = 7;
        public int ItemVersion = 3;
        public int ExtraBytes;
        public double3 Scale = new double3(0.01, 0.01, 0.01);
        public int MaxNodePoints = 100;
        public int MaxLevel = 20;
        public int LevelsPerPage = 99;
        public List<Node> Nodes { get; } = new List<Node>();
        public List<(long Offset, int Bytes)> Pages { get; } = new List<(long, int)>();
        public int RecordBytes => LasPointFormat.Of(PointFormat).RecordBytes + ExtraBytes;

        public byte[] Write(IReadOnlyList<byte[]> records)
        {
            Pages.Clear();
            var (min, edgeBits) = Split(records);
            var ordered = new List<byte[]>(records.Count);
            var counts = new List<int>();
            foreach (var node in Nodes)
            {
                ordered.AddRange(node.Records);
                counts.Add(node.Records.Count);
            }
            var laz = new LazFileWriter
            {
                PointFormat = PointFormat,
                ItemVersion = ItemVersion,
                ExtraBytes = ExtraBytes,
                Scale = Scale,
                HasVariableChunks = true,
                ChunkPoints = counts.ToArray(),
                FirstVlr = InfoVlr(),
            };
            var points = laz.Write(ordered);
            var file = new MemoryStream();
            file.Write(points, 0, points.Length);
            WriteHierarchy(file, laz.Chunks);
            var bytes = file.ToArray();
            PutNumber(bytes, LasHeader.At.EvlrOffset, points.Length, 8);
            PutNumber(bytes, LasHeader.At.EvlrCount, 1, 4);
            PutInfo(bytes, min, edgeBits);
            return bytes;
        }

        /// <summary>Makes the nodes; for other formats too whose records start with X, Y, Z as int32.</summary>
        /// <returns>The cube's corner, and its edge as a power of two; grid units.</returns>
        public (long[] Min, int EdgeBits) Split(IReadOnlyList<byte[]> records)
        {
            Nodes.Clear();
            var (min, edgeBits) = Cube(records);
            MakeNodes(records, min, edgeBits);
            return (min, edgeBits);
        }

        static (long[] Min, int EdgeBits) Cube(IReadOnlyList<byte[]> records)
        {
            var min = new[] { long.MaxValue, long.MaxValue, long.MaxValue };
            var max = new[] { long.MinValue, long.MinValue, long.MinValue };
            foreach (var record in records)
                for (int axis = 0; axis < 3; axis++)
                {
                    min[axis] = Math.Min(min[axis], RecordFields.Int32(record, 4 * axis));
                    max[axis] = Math.Max(max[axis], RecordFields.Int32(record, 4 * axis));
                }
            int bits = 0;
            while (1L << bits <= Math.Max(max[0] - min[0], Math.Max(max[1] - min[1], max[2] - min[2])))
                bits++;
            return (min, bits);
        }

        void MakeNodes(IReadOnlyList<byte[]> records, long[] min, int edgeBits)
        {
            var open = new Queue<Node>();
            open.Enqueue(new Node { Records = new List<byte[]>(records) });
            while (open.Count > 0)
            {
                var node = open.Dequeue();
                Nodes.Add(node);
                int shift = edgeBits - node.Level - 1;
                if (node.Records.Count <= MaxNodePoints || node.Level >= MaxLevel || shift < 0)
                    continue;
                // Evenly spaced in the order of the records, so that a node is a sample of its cell.
                var all = node.Records;
                node.Records = new List<byte[]>(MaxNodePoints);
                var children = new SortedDictionary<int, Node>();
                long taken = 0;
                for (int i = 0; i < all.Count; i++)
                {
                    if ((long)(i + 1) * MaxNodePoints / all.Count > taken)
                    {
                        taken++;
                        node.Records.Add(all[i]);
                        continue;
                    }
                    var cell = new int3();
                    for (int axis = 0; axis < 3; axis++)
                        cell[axis] = (int)(RecordFields.Int32(all[i], 4 * axis) - min[axis] >> shift);
                    int octant = (cell.x & 1) | (cell.y & 1) << 1 | (cell.z & 1) << 2;
                    if (!children.TryGetValue(octant, out var child))
                        children.Add(octant, child = new Node { Level = node.Level + 1, Cell = cell });
                    child.Records.Add(all[i]);
                }
                foreach (var child in children.Values)
                {
                    node.Children.Add(child);
                    open.Enqueue(child);
                }
            }
        }

        void WriteHierarchy(MemoryStream file, List<(long Offset, int Bytes)> chunks)
        {
            long headerAt = file.Position;
            file.Write(new byte[LasVlr.ExtendedHeaderBytes], 0, LasVlr.ExtendedHeaderBytes);
            var chunkOfNode = new Dictionary<Node, int>();
            for (int i = 0, chunk = 0; i < Nodes.Count; i++)
                chunkOfNode[Nodes[i]] = chunk++;
            WritePage(file, Nodes[0], chunks, chunkOfNode);
            long end = file.Position;
            var header = new byte[LasVlr.ExtendedHeaderBytes];
            Encoding.ASCII.GetBytes(CopcInfo.UserId).CopyTo(header, 2);
            PutNumber(header, 18, CopcInfo.HierarchyRecord, 2);
            PutNumber(header, 20, end - headerAt - header.Length, 8);
            file.Position = headerAt;
            file.Write(header, 0, header.Length);
            file.Position = end;
        }

        (long Offset, int Bytes) WritePage(MemoryStream file, Node root, List<(long Offset, int Bytes)> chunks,
            Dictionary<Node, int> chunkOfNode)
        {
            var page = new BinaryWriter(new MemoryStream());
            var open = new Queue<Node>();
            open.Enqueue(root);
            while (open.Count > 0)
            {
                var node = open.Dequeue();
                bool isPage = node != root && node.Level - root.Level >= LevelsPerPage;
                var place = isPage ? WritePage(file, node, chunks, chunkOfNode) : chunks[chunkOfNode[node]];
                page.Write(node.Level);
                page.Write(node.Cell.x);
                page.Write(node.Cell.y);
                page.Write(node.Cell.z);
                page.Write(place.Offset);
                page.Write(place.Bytes);
                page.Write(isPage ? CopcEntry.PointCountOfPage : node.Records.Count);
                if (!isPage)
                    foreach (var child in node.Children)
                        open.Enqueue(child);
            }
            var bytes = ((MemoryStream)page.BaseStream).ToArray();
            Pages.Add((file.Position, bytes.Length));
            file.Write(bytes, 0, bytes.Length);
            return Pages[Pages.Count - 1];
        }

        static byte[] InfoVlr()
        {
            var vlr = new byte[LasVlr.HeaderBytes + CopcInfo.Bytes];
            Encoding.ASCII.GetBytes(CopcInfo.UserId).CopyTo(vlr, 2);
            PutNumber(vlr, 18, CopcInfo.InfoRecord, 2);
            PutNumber(vlr, 20, CopcInfo.Bytes, 2);
            return vlr;
        }

        void PutInfo(byte[] bytes, long[] min, int edgeBits)
        {
            double half = Scale.x * Math.Pow(2, edgeBits) / 2;
            for (int axis = 0; axis < 3; axis++)
                PutDouble(bytes, InfoAt + 8 * axis, min[axis] * Scale[axis] + half);
            PutDouble(bytes, InfoAt + 24, half);
            PutDouble(bytes, InfoAt + 32, 2 * half / 128);
            PutNumber(bytes, InfoAt + 40, Pages[Pages.Count - 1].Offset, 8);
            PutNumber(bytes, InfoAt + 48, Pages[Pages.Count - 1].Bytes, 8);
        }

        static void PutNumber(byte[] bytes, int at, long value, int count)
        {
            for (int i = 0; i < count; i++)
                bytes[at + i] = (byte)(value >> 8 * i);
        }

        static void PutDouble(byte[] bytes, int at, double value) =>
            PutNumber(bytes, at, BitConverter.DoubleToInt64Bits(value), 8);
    }
}
