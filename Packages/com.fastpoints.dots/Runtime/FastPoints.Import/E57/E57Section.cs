using System;
using System.Collections.Generic;
using FastPoints.Reading;

namespace FastPoints.E57
{
    // Checkpoints are separate for each bytestream, since a packet need not hold the same records of each.
    sealed class E57Section
    {
        public const int HeaderBytes = 32;
        const int SectionId = 1;

        // Between two checkpoints, unless records are long: a range costs its own records, rounded up to that.
        const int DefaultCheckpointRecords = 4096;
        const int MinCheckpointRecords = 64;
        const long MaxCheckpointBytes = 512 << 10;
        const int CheckpointsPerBlock = 8;
        const int GapPages = 16; // Extents closer to each other than this are read as one.

        public readonly E57Scan Scan;
        public readonly List<E57Checkpoint>[] CheckpointsOfStream;
        public readonly long[] EndOfStream; // For each stream, the logical offset behind its last packet.

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
            CheckpointsOfStream = new List<E57Checkpoint>[scan.Fields.Count];
            EndOfStream = new long[scan.Fields.Count];
            for (int i = 0; i < CheckpointsOfStream.Length; i++)
                CheckpointsOfStream[i] = new List<E57Checkpoint>();
            CheckpointRecords = DefaultCheckpointRecords;
            while (CheckpointRecords > MinCheckpointRecords && CheckpointRecords * scan.RecordBits / 8 > MaxCheckpointBytes)
                CheckpointRecords /= 2;
        }

        public int CheckpointRecords { get; }
        public int BlockPoints => CheckpointRecords * CheckpointsPerBlock;
        public int BlockCount => (int)((Records + BlockPoints - 1) / BlockPoints);
        public long RecordsPossible => (long)Math.Min(Scan.RecordsClaimed, (ulong)Math.Max(0, End - DataStart) * 8);

        // problem: why the section cannot be read, at byte "offset" of the file.
        public static E57Section Read(E57Scan scan, RandomAccessFile source, Crc32C crc, SourceInfo info, out string problem,
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
            int ranges = 0;
            for (int stream = 0; stream < EndOfStream.Length; stream++)
            {
                if (Scan.Fields[stream].Bits <= 0 || isWanted != null && !isWanted[stream])
                    continue;
                long first = CheckpointOf(stream, firstRecord).PacketOffset / E57Pages.DataBytes;
                long end = (EndOf(stream, endRecord) + E57Pages.DataBytes - 1) / E57Pages.DataBytes;
                int at = ranges++;
                for (; at > 0 && firstPages[at - 1] > first; at--)
                {
                    firstPages[at] = firstPages[at - 1];
                    endPages[at] = endPages[at - 1];
                }
                firstPages[at] = first;
                endPages[at] = end;
            }
            int merged = 0;
            for (int i = 1; i < ranges; i++)
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
            return ranges == 0 ? 0 : merged + 1;
        }

        public E57Checkpoint CheckpointOf(int stream, long record) =>
            CheckpointsOfStream[stream][(int)(record / CheckpointRecords)];

        // Logical, behind the last packet that records before this one need, or sometimes behind one more.
        public long EndOf(int stream, long endRecord)
        {
            var checkpoints = CheckpointsOfStream[stream];
            long checkpoint = (endRecord + CheckpointRecords - 1) / CheckpointRecords;
            return checkpoint < checkpoints.Count ? checkpoints[(int)checkpoint].PacketOffset +
                checkpoints[(int)checkpoint].PacketBytes : EndOfStream[stream];
        }
    }

    // The packet in which one bytestream reaches a multiple of CheckpointRecords: reading can start there.
    struct E57Checkpoint
    {
        public int Stream;
        public int PacketBytes;
        public long PacketOffset; // Logical.
        public long BytesBefore; // Of the bytestream in the packets before it.
    }

    sealed class E57Blocks
    {
        const int MaxBlockPages = 24 << 10; // It bounds a slot's memory, whatever a file claims.
        const ulong MaxRecordsWithoutBits = 65536; // Records that take no bytes at all prove nothing about their number.

        readonly List<E57Section> m_sections;
        readonly HashSet<int> m_reportedBlocks = new HashSet<int>();
        readonly Dictionary<string, (string Text, RunningWarning Warning)> m_warnings =
            new Dictionary<string, (string, RunningWarning)>();
        int m_blockCount;
        int m_maxPoints;
        int m_maxPages = 1;

        public E57Blocks(E57File file, SourceInfo info, E57Schema schema, List<E57Section> sections)
        {
            File = file;
            Info = info;
            Schema = schema;
            m_sections = sections;
            foreach (var section in sections)
                HasVectors |= schema.HasVectorPositions || E57Schema.HasRotatedNormals(section.Scan);
            AreKnown = info.PointsClaimed == 0;
        }

        public E57File File { get; }
        public SourceInfo Info { get; }
        public E57Schema Schema { get; }

        public bool HasVectors { get; } // Whether some scan's positions or normals pass through rows of doubles.

        public bool AreKnown { get; private set; }
        public int Count => Known(m_blockCount);
        public int MaxPoints => Known(m_maxPoints);
        public int MaxPages => Known(m_maxPages);

        public IEnumerator<JobStep> Find()
        {
            if (AreKnown)
                yield break;
            long points = 0;
            foreach (var section in m_sections)
            {
                if (section.Scan.RecordsClaimed > 0 && section.Scan.RecordBits == 0)
                {
                    AddWithoutBits(section);
                }
                else if (section.Scan.RecordsClaimed > 0)
                {
                    using (var walk = new E57Walk(File, section, Info))
                        yield return JobStep.Of(walk.Run());
                    LimitPages(section);
                }
                section.FirstBlock = m_blockCount;
                section.FirstPoint = points;
                m_blockCount += section.BlockCount;
                points += section.Records;
                m_maxPoints = (int)Math.Max(m_maxPoints, Math.Min(section.BlockPoints, section.Records));
            }
            if (points == 0)
            {
                // The last walk's warning is the reason.
                var reason = Info.Warnings.Count > 0 ? Info.Warnings[Info.Warnings.Count - 1] : new CloudWarning(null, -1, "");
                throw PointCloudException.Wanted(FailureCode.Truncated, Info.Path, reason.ByteOffset, "points",
                    NumberText.Of(Info.PointsClaimed), "0: " + reason.Text);
            }
            Info.PointsReadable = points;
            AreKnown = true;
        }

        public E57Section SectionOf(int block)
        {
            if ((uint)block >= (uint)Known(m_blockCount))
                throw new ArgumentOutOfRangeException(nameof(block), block, "the source has " + m_blockCount + " blocks");
            int low = 0, high = m_sections.Count;
            while (high - low > 1)
            {
                int middle = (low + high) / 2;
                if (m_sections[middle].FirstBlock <= block)
                    low = middle;
                else
                    high = middle;
            }
            return m_sections[low];
        }

        public int PointsOf(int block)
        {
            var section = SectionOf(block);
            return (int)Math.Min(section.BlockPoints, section.Records - (long)(block - section.FirstBlock) * section.BlockPoints);
        }

        public void Warn(BlockRange range, DecodeResult result, in E57Anomalies anomalies)
        {
            bool isNew = range.First == 0 && range.Count == PointsOf(range.Block) && m_reportedBlocks.Add(range.Block);
            if (result.Error != E57Error.None)
                Warn("points are left out: " + E57Error.Text(result.Error), result.ErrorOffset,
                    isNew ? range.Count - result.Points : 0);
            if (anomalies.Invalid > 0)
            {
                Info.PointsMarkedInvalid += isNew ? anomalies.Invalid : 0;
                Warn("points that their scan marks as invalid are left out", -1, isNew ? anomalies.Invalid : 0);
            }
            if (anomalies.Damaged > 0)
                Warn("the checksum of page " + anomalies.FirstDamagedPage + " is wrong (" + anomalies.DamagedPages +
                    " pages of this block are damaged): points that lie in them are left out",
                    anomalies.FirstDamagedPage * E57Pages.PageBytes, isNew ? anomalies.Damaged : 0);
            if (anomalies.Clamped > 0)
                Warn("integers above the maximum of their field: the maximum was taken", -1, isNew ? anomalies.Clamped : 0);
        }

        void AddWithoutBits(E57Section section)
        {
            section.Records = (long)Math.Min(section.Scan.RecordsClaimed, MaxRecordsWithoutBits);
            if (section.Scan.RecordsClaimed > MaxRecordsWithoutBits)
                Info.Warn(-1, section.Scan.Label + ": its records take no bytes, all being equal: " + MaxRecordsWithoutBits +
                    " of the " + NumberText.Of(section.Scan.RecordsClaimed) + " claimed are given");
        }

        // Ends a scan before the first block whose fields lie too far apart.
        void LimitPages(E57Section section)
        {
            var firstPages = new long[section.EndOfStream.Length];
            var endPages = new long[section.EndOfStream.Length];
            for (long first = 0; first < section.Records; first += section.BlockPoints)
            {
                int ranges = section.PagesOf(first, Math.Min(first + section.BlockPoints, section.Records), null, firstPages,
                    endPages);
                long pages = 0;
                for (int i = 0; i < ranges; i++)
                    pages += endPages[i] - firstPages[i];
                if (pages > MaxBlockPages)
                {
                    Info.Warn(firstPages[0] * E57Pages.PageBytes, section.Scan.Label + ": wanted " +
                        NumberText.Of(section.Records) +
                        " points, got " + NumberText.Of(first) + ": " + E57Error.Text(E57Error.TooWide));
                    section.Records = first;
                    return;
                }
                m_maxPages = (int)Math.Max(m_maxPages, pages);
            }
        }

        void Warn(string text, long offset, long count)
        {
            string key = text.Length > 24 ? text.Substring(0, 24) : text;
            if (!m_warnings.TryGetValue(key, out var known))
                m_warnings.Add(key, known = (text, new RunningWarning()));
            known.Warning.Add(Info, count, offset, sum => sum == "0" ? known.Text : known.Text + " (" + sum + " so far)");
        }

        T Known<T>(T value) => AreKnown ? value : throw new InvalidOperationException("IndexBlocks comes first");
    }
}
