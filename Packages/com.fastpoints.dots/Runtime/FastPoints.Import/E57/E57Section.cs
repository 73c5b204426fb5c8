using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.E57
{
    // Marks are kept separately for each bytestream, since a packet need not hold the same records of each.
    sealed class E57Section
    {
        public const int HeaderBytes = 32;
        const int SectionId = 1;

        // Between two marks, unless records are long: a range costs what it holds, rounded up to that.
        const int DefaultMarkRecords = 4096;
        const int MinMarkRecords = 64;
        const long MaxMarkBytes = 512 << 10;
        const int MarksPerBlock = 8;

        // Extents closer to each other than this are read as one.
        const int GapPages = 16;

        public readonly E57Scan Scan;
        public readonly List<E57Mark>[] MarksOfStream;

        // For each stream, the logical offset behind its last packet.
        public readonly long[] EndOfStream;

        // Logical.
        public long DataStart;
        public long End;
        public long Records;
        public int Index;
        public int FirstBlock;
        public long FirstPoint;

        public E57Section(E57Scan scan)
        {
            Scan = scan;
            MarksOfStream = new List<E57Mark>[scan.Fields.Count];
            EndOfStream = new long[scan.Fields.Count];
            for (int i = 0; i < MarksOfStream.Length; i++)
                MarksOfStream[i] = new List<E57Mark>();
            MarkRecords = DefaultMarkRecords;
            while (MarkRecords > MinMarkRecords && MarkRecords * scan.RecordBits / 8 > MaxMarkBytes)
                MarkRecords /= 2;
        }

        public int MarkRecords { get; }
        public int BlockPoints => MarkRecords * MarksPerBlock;
        public int BlockCount => (int)((Records + BlockPoints - 1) / BlockPoints);
        public long RecordsPossible => (long)Math.Min(Scan.RecordsClaimed, (ulong)Math.Max(0, End - DataStart) * 8);

        // problem: why the section cannot be read, at byte "offset" of the file.
        public static E57Section Read(E57Scan scan, FileSource source, Crc32C crc, SourceInfo info, out string problem,
            out long offset)
        {
            var section = new E57Section(scan);
            problem = null;
            offset = (long)Math.Min(scan.SectionOffset, (ulong)source.Length);
            if (scan.RecordsClaimed == 0)
                return section;
            if (!E57Pages.IsContentOffset(scan.SectionOffset) || scan.SectionOffset >= (ulong)source.Length)
            {
                problem = "fileOffset: wanted a place in the file, got " + scan.SectionOffset;
                offset = -1;
                return section;
            }
            long start = E57Pages.ToLogical(offset), fileEnd = E57Pages.LogicalLength(source.Length);
            if (start + HeaderBytes > fileEnd)
            {
                problem = "the file ends before its binary section";
                return section;
            }
            var header = new ByteReader(E57Pages.Read(source, crc, start, HeaderBytes, "header of a binary section",
                out long damagedPage), source.Path, offset);
            ulong length = header.UInt64(8, "length"), data = header.UInt64(16, "data offset");
            if (header.UInt8(0, "section id") != SectionId)
                problem = "section id: wanted 1, got " + header.UInt8(0, "section id");
            else if (!E57Pages.IsContentOffset(data) || data >= (ulong)source.Length || (long)data < offset)
                problem = "offset of its first packet: wanted a place in the section, got " + data;
            if (problem != null)
                return section;
            if (damagedPage >= 0)
                info.Warn(damagedPage * E57Pages.PageBytes, scan.Label + ": the checksum of page " + damagedPage +
                    " is wrong, which holds the section's header; it is read as it is");
            section.DataStart = E57Pages.ToLogical((long)data);
            section.End = length > (ulong)(fileEnd - start) ? fileEnd : start + (long)length;
            if (length > (ulong)(fileEnd - start))
                info.Warn(offset, scan.Label + ": the file ends before its binary section: wanted " + length + " bytes, got " +
                    (fileEnd - start));
            return section;
        }

        // Pages with some records of some fields, as ranges in the file's order: firstPages and endPages, one entry for each
        // stream, are filled as far as the number returned. isWanted: by stream; null for all.
        public int PagesOf(long firstRecord, long endRecord, bool[] isWanted, long[] firstPages, long[] endPages)
        {
            int runs = 0;
            for (int stream = 0; stream < EndOfStream.Length; stream++)
            {
                if (Scan.Fields[stream].Bits <= 0 || isWanted != null && !isWanted[stream])
                    continue;
                long first = MarkOf(stream, firstRecord).PacketOffset / E57Pages.DataBytes;
                long end = (EndOf(stream, endRecord) + E57Pages.DataBytes - 1) / E57Pages.DataBytes;
                int at = runs++;
                for (; at > 0 && firstPages[at - 1] > first; at--)
                {
                    firstPages[at] = firstPages[at - 1];
                    endPages[at] = endPages[at - 1];
                }
                firstPages[at] = first;
                endPages[at] = end;
            }
            int merged = 0;
            for (int i = 1; i < runs; i++)
            {
                if (firstPages[i] > endPages[merged] + GapPages)
                {
                    merged++;
                    firstPages[merged] = firstPages[i];
                    endPages[merged] = endPages[i];
                }
                else
                {
                    endPages[merged] = Math.Max(endPages[merged], endPages[i]);
                }
            }
            return runs == 0 ? 0 : merged + 1;
        }

        public E57Mark MarkOf(int stream, long record) => MarksOfStream[stream][(int)(record / MarkRecords)];

        // Logical, behind the last packet that records before this one need, or sometimes behind one more.
        public long EndOf(int stream, long endRecord)
        {
            var marks = MarksOfStream[stream];
            long mark = (endRecord + MarkRecords - 1) / MarkRecords;
            return mark < marks.Count ? marks[(int)mark].PacketOffset + marks[(int)mark].PacketBytes : EndOfStream[stream];
        }
    }

    // The packet in which one bytestream reaches a multiple of MarkRecords: reading can start there.
    struct E57Mark
    {
        public int Stream;
        public int PacketBytes;

        // Logical.
        public long PacketOffset;

        // Of the bytestream in the packets before it.
        public long BytesBefore;
    }
}
