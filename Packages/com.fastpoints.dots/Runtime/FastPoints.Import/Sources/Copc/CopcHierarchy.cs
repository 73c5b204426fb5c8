using System;
using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // Upper levels first; each node is added once. Entries that the file cannot hold are left out with a warning. Time and
    // memory are bounded by the file's size: a page is read once, and neither all pages nor all chunks take more bytes than it
    // has.
    sealed class CopcHierarchy
    {
        const int PieceBytes = 64 << 10; // 2,048 entries.

        const int MaxWarnings = 8;

        readonly LazBlocks m_blocks;
        readonly SourceTree m_tree;
        readonly long m_fileBytes;
        readonly UnreadPages m_pages = new UnreadPages(CopcEntry.MaxLevel + 1);
        readonly HashSet<long> m_pageOffsets = new HashSet<long>();
        readonly HashSet<ulong> m_chunkOffsets = new HashSet<ulong>();
        readonly HashSet<int4> m_keys = new HashSet<int4>();
        readonly byte[] m_piece = new byte[PieceBytes];
        readonly CopcInfo m_copc;
        long m_pageBytesLeft;
        long m_chunkBytesLeft;
        int m_warnings;
        int m_unreported;

        public CopcHierarchy(LazBlocks blocks, CopcInfo copc, SourceTree tree)
        {
            m_blocks = blocks;
            m_copc = copc;
            m_tree = tree;
            m_fileBytes = m_pageBytesLeft = m_chunkBytesLeft = blocks.Source.Length;
            AddPage(default, (long)copc.RootPageOffset, (long)copc.RootPageBytes, copc.FileOffset);
        }

        // Coroutine: the pages that may contain nodes of the first levels, as far as they concern the node and what is below it.
        public IEnumerator<JobStep> Read(int4 node, int levels)
        {
            while (m_pages.TryPeek(node, levels, out var next))
            {
                // A page takes effect when it is completely read, so that this work can be abandoned and begun again.
                yield return JobStep.Of(Read(next));
                m_tree.PageCount++;
            }
        }

        public bool IsKnown(int4 node, int levels) => !m_pages.TryPeek(node, levels, out _);

        public void WarnUnreported()
        {
            if (m_unreported > 0)
                m_blocks.Info.Warn(m_copc.FileOffset, NumberText.Of(m_unreported)
                    + " more entries of the octree's hierarchy are wrong");
            m_unreported = 0;
        }

        IEnumerator<JobStep> Read(UnreadPage page)
        {
            var entries = new List<(CopcEntry Entry, long At)>();
            using (var read = new NativeFileRead(PieceBytes, Allocator.Persistent))
                for (long done = 0; done < page.Bytes; done += PieceBytes)
                {
                    int bytes = (int)Math.Min(PieceBytes, page.Bytes - done);
                    while (!read.TryFetch(m_blocks.File.Path, page.Offset + done, bytes))
                        yield return default;
                    yield return read.Begin(m_blocks.File, page.Offset + done, bytes);
                    read.End();
                    NativeArray<byte>.Copy(read.Buffer, m_piece, bytes);
                    Collect(new ByteReader(m_piece, m_blocks.Info.Path, page.Offset + done), bytes, entries);
                }
            m_pages.Remove(page);
            Add(entries);
        }

        void Collect(ByteReader piece, int bytes, List<(CopcEntry, long)> entries)
        {
            for (int at = 0; at + CopcEntry.Bytes <= bytes; at += CopcEntry.Bytes)
            {
                var entry = CopcEntry.Read(piece, at);
                if (entry.HasKey)
                    entries.Add((entry, piece.FileOffset + at));
                else
                    Warn(piece.FileOffset + at, Name(entry) + " is no node of an octree: left out");
            }
        }

        // Level by level: a parent comes before its children.
        void Add(List<(CopcEntry Entry, long At)> entries)
        {
            entries.Sort((a, b) => a.Entry.Level != b.Entry.Level ? a.Entry.Level.CompareTo(b.Entry.Level)
                : a.At.CompareTo(b.At));
            foreach (var (entry, at) in entries)
                if (entry.IsPage)
                    AddPage(entry.Key, (long)Math.Min(entry.Offset, long.MaxValue), entry.ByteSize, at);
                else
                    AddNode(entry, at);
        }

        // at: offset of the entry in the file, as everywhere here.
        void AddPage(int4 root, long offset, long bytes, long at)
        {
            if (bytes < CopcEntry.Bytes || offset > m_fileBytes - bytes)
                Warn(at, "a page of the octree's hierarchy would lie at byte " + NumberText.Of(offset) + " with "
                    + NumberText.Of(bytes)
                    + " bytes, the file has " + NumberText.Of(m_fileBytes) + ": its nodes are left out");
            else if (!m_pageOffsets.Add(offset))
                Warn(at, "the page at byte " + NumberText.Of(offset) + " of the octree's hierarchy is named twice: read once");
            else if (bytes > m_pageBytesLeft)
                Warn(at, "the pages of the octree's hierarchy overlap: that at byte " + NumberText.Of(offset) + " is left out");
            else
            {
                if (bytes % CopcEntry.Bytes != 0)
                    Warn(at, "the page at byte " + NumberText.Of(offset) + " of the octree's hierarchy has "
                        + NumberText.Of(bytes) + " bytes, wanted a multiple of " + NumberText.Of(CopcEntry.Bytes));
                m_pageBytesLeft -= bytes;
                m_pages.Add(root, offset, bytes);
            }
        }

        void AddNode(CopcEntry entry, long at)
        {
            string problem = Problem(entry, out long bytes);
            if (problem == null && !m_keys.Add(entry.Key))
                problem = "is there twice: the second is left out";
            if (problem == null && entry.PointCount > 0 && !m_chunkOffsets.Add(entry.Offset))
                problem = "has the chunk of another node: left out";
            if (problem != null)
            {
                Warn(at, Name(entry) + " " + problem);
                return;
            }
            if (bytes < entry.ByteSize)
                Warn(at, Name(entry) + " would end at byte " + NumberText.Of((long)entry.Offset + entry.ByteSize)
                    + ", the file has " + NumberText.Of(m_fileBytes) + ": cut there");
            m_chunkBytesLeft -= bytes;
            AddBlocks(entry, bytes);
        }

        void AddBlocks(CopcEntry entry, long bytes)
        {
            int firstBlock = m_blocks.Count;
            if (entry.PointCount > 0)
            {
                m_blocks.Chunks.Add(new LazChunk { Offset = (long)entry.Offset, Bytes = bytes, Points = entry.PointCount });
                m_blocks.AddChunk(m_blocks.Chunks.Count - 1);
            }
            var node = new SourceNode { Level = entry.Level, Cell = entry.Cell, Block = -1 };
            if (firstBlock == m_blocks.Count)
                m_tree.Add(node);
            for (int block = firstBlock; block < m_blocks.Count; block++)
            {
                node.Block = block;
                node.PointCount = m_blocks.PointsOf(block);
                m_tree.Add(node);
            }
        }

        string Problem(CopcEntry entry, out long bytes)
        {
            bytes = 0;
            if (entry.PointCount == 0)
                return null;
            if (entry.PointCount < 0)
                return "has " + NumberText.Of(entry.PointCount) + " points: left out";
            if (entry.Offset < m_blocks.Las.Header.PointsOffset || entry.Offset >= (ulong)m_fileBytes)
                return "would start at byte " + NumberText.Of(entry.Offset) + ", which is none of the points': left out";
            bytes = Math.Min(entry.ByteSize, m_fileBytes - (long)entry.Offset);
            if (bytes < m_blocks.Format.RecordBytes || bytes > LazBlocks.MaxLayeredChunkBytes)
                return "has " + NumberText.Of(entry.ByteSize) + " bytes: left out";
            if (entry.PointCount > LazChunk.MaxPoints(bytes))
                return "claims " + NumberText.Of(entry.PointCount) + " points in " + NumberText.Of(bytes) + " bytes: left out";
            return bytes > m_chunkBytesLeft ? "lies where others do, all together are longer than the file: left out" : null;
        }

        static string Name(CopcEntry entry) => "node " + NumberText.Of(entry.Level) + "-" + NumberText.Of(entry.Cell.x) + "-"
            + NumberText.Of(entry.Cell.y) + "-" + NumberText.Of(entry.Cell.z);

        // The first few; a hierarchy that is noise is not listed.
        void Warn(long at, string text)
        {
            if (m_warnings++ < MaxWarnings)
                m_blocks.Info.Warn(at, text);
            else
                m_unreported++;
        }
    }

    // One entry of a hierarchy page: a node with points, a node without, or another page.
    // int level, x, y, z | ulong offset | int bytes | int points (-1: bytes at offset are a page that starts with this node)
    internal struct CopcEntry
    {
        public const int Bytes = 32;
        public const int PointCountOfPage = -1;
        public const int MaxLevel = 30; // The cells of deeper nodes do not fit into an int.

        public int Level;
        public int3 Cell;
        public ulong Offset;
        public int ByteSize;
        public int PointCount;

        public bool IsPage => PointCount == PointCountOfPage;
        public bool HasKey => Level >= 0 && Level <= MaxLevel && math.all(Cell >= 0) && math.all(Cell < 1 << Level);
        public int4 Key => new int4(Cell.x, Cell.y, Cell.z, Level);

        public static CopcEntry Read(ByteReader bytes, int at) => new CopcEntry
        {
            Level = bytes.Int32(at, "level"),
            Cell = new int3(bytes.Int32(at + 4, "x"), bytes.Int32(at + 8, "y"), bytes.Int32(at + 12, "z")),
            Offset = bytes.UInt64(at + 16, "offset of a node"),
            ByteSize = bytes.Int32(at + 24, "bytes of a node"),
            PointCount = bytes.Int32(at + 28, "points of a node"),
        };

        public void Put(byte[] bytes, int at)
        {
            LasHeader.Put(bytes, at, 4, (ulong)Level);
            for (int axis = 0; axis < 3; axis++)
                LasHeader.Put(bytes, at + 4 + 4 * axis, 4, (ulong)Cell[axis]);
            LasHeader.Put(bytes, at + 16, 8, Offset);
            LasHeader.Put(bytes, at + 24, 4, (ulong)ByteSize);
            LasHeader.Put(bytes, at + 28, 4, (ulong)PointCount);
        }
    }
}
