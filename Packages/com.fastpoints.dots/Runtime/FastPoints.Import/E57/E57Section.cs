using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.E57
{
    /// <summary>A scan's binary section, and where its packets contain the starts of record ranges: separately for each
    /// bytestream, since a packet need not hold the same records of each.</summary>
    sealed class E57Section
    {
        public const int HeaderBytes = 32;
        const int SectionId = 1;

        /// <summary>Records between two marks, unless records are long: a range costs what it holds, rounded up to
        /// that.</summary>
        const int DefaultMarkRecords = 4096;
        const int MinMarkRecords = 64;
        const long MaxMarkBytes = 512 << 10;
        const int MarksPerBlock = 8;

        /// <summary>Extents closer to each other than this are read as one.</summary>
        const int GapPages = 16;

        public readonly E57Scan Scan;
        public readonly List<E57Mark>[] MarksOfStream;

        /// <summary>For each stream, the logical offset behind its last packet.</summary>
        public readonly long[] EndOfStream;

        /// <summary>Logical offsets of the first packet and of the section's end.</summary>
        public long DataStart;
        public long End;

        /// <summary>Number of records that exist, as the walk found.</summary>
        public long Records;

        /// <summary>Its index among the scans that are read.</summary>
        public int Index;

        /// <summary>Index of its first block and point in the whole file.</summary>
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

        /// <summary>The most records that the section can hold.</summary>
        public long RecordsPossible => (long)Math.Min(Scan.RecordsClaimed, (ulong)Math.Max(0, End - DataStart) * 8);

        /// <summary>Reads the section's header; anomalies become warnings.</summary>
        /// <param name="problem">Why the section cannot be read; null if it can.</param>
        /// <param name="offset">Byte of the file that the problem is about.</param>
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

        /// <summary>Pages that hold some records of some fields, as ranges in the file's order.</summary>
        /// <param name="isWanted">Whether each stream is wanted; null for all.</param>
        /// <param name="firstPages">Filled with first pages; one entry for each stream.</param>
        /// <param name="endPages">Filled with end pages likewise.</param>
        /// <returns>The number of ranges.</returns>
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

        /// <summary>Logical offset behind the last packet that records before this one need, or sometimes behind one
        /// more.</summary>
        public long EndOf(int stream, long endRecord)
        {
            var marks = MarksOfStream[stream];
            long mark = (endRecord + MarkRecords - 1) / MarkRecords;
            return mark < marks.Count ? marks[(int)mark].PacketOffset + marks[(int)mark].PacketBytes : EndOfStream[stream];
        }
    }

    /// <summary>The packet in which one bytestream reaches a multiple of so many records: reading can start there.</summary>
    struct E57Mark
    {
        public int Stream;

        /// <summary>Bytes of the packet.</summary>
        public int PacketBytes;

        /// <summary>Logical offset of the packet.</summary>
        public long PacketOffset;

        /// <summary>Bytes of the bytestream in the packets before it.</summary>
        public long BytesBefore;
    }
}
