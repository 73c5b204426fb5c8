using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.IO.LowLevel.Unsafe;

namespace FastPoints.Files
{
    /// <summary>Reads E57 (ASTM E2807-11): the points of all scans, one scan behind the other, moved to where their poses put
    /// them. Blocks are runs of up to 32,768 records; points that a scan marks as invalid are left out and counted.</summary>
    /// <remarks>Where in the packets a record lies takes a walk over their headers (<see cref="FindBlocks"/>). Every page that is
    /// read is checked against its checksum: points in a damaged one are left out with a warning. Images are named, not
    /// read.</remarks>
    internal sealed class E57Reader : PointReader
    {
        /// <summary>The most pages of a block's fields: it bounds a slot's memory, whatever a file claims.</summary>
        const int MostBlockPages = 24 << 10;

        /// <summary>Records that take no bytes at all prove nothing about their number.</summary>
        const ulong MostRecordsWithoutBits = 65536;

        const int MostScansTold = 20;

        readonly Crc32C m_crc;
        FileHandle m_file;
        readonly E57Schema m_schema;
        readonly List<E57Section> m_sections;
        readonly HashSet<int> m_toldBlocks = new HashSet<int>();
        readonly Dictionary<string, int> m_warnings = new Dictionary<string, int>();
        readonly Dictionary<string, long> m_counts = new Dictionary<string, long>();
        bool m_isOpen;
        bool m_areBlocksKnown;
        int m_blockCount;
        int m_maxPoints;
        int m_maxPages = 1;

        E57Reader(SourceInfo info, E57Schema schema, List<E57Section> sections, Crc32C crc)
        {
            Info = info;
            m_schema = schema;
            m_sections = sections;
            m_crc = crc;
            FilePages = info.FileBytes / E57Pages.PageBytes;
            foreach (var section in sections)
                HasVectors |= schema.HasVectorPositions || E57Schema.HasVectorNormals(section.Scan);
            m_areBlocksKnown = info.PointsClaimed == 0;
        }

        /// <inheritdoc cref="Open(FileSource)"/>
        public static E57Reader Open(string path)
        {
            using (var source = FileSource.Open(path))
                return Open(source);
        }

        /// <summary>Opens an E57 file: its header, its XML section and the headers of its scans' sections are read.</summary>
        /// <exception cref="PointCloudException">The header or the XML section is invalid, or none of the file's scans can be
        /// read.</exception>
        public static E57Reader Open(FileSource source)
        {
            var info = new SourceInfo { Path = source.Path, FileBytes = source.Length, Format = "E57" };
            var crc = new Crc32C(Allocator.Persistent);
            try
            {
                var header = E57Header.Read(source, info);
                info.Version = header.MajorVersion + "." + header.MinorVersion;
                byte[] xml = E57Pages.Read(source, crc, header.XmlLogicalOffset, header.XmlBytes, "the XML section",
                    out long damagedPage);
                if (damagedPage >= 0)
                    throw new PointCloudException(FailureCode.BadInput, source.Path, damagedPage * E57Pages.PageBytes,
                        "the checksum of page " + NumberText.Of(damagedPage)
                            + " is wrong, which holds a part of the XML section");
                var root = E57XmlTree.Parse(xml, source.Path, E57Pages.ToPhysical(header.XmlLogicalOffset));
                if (root.Name != "e57Root")
                    throw PointCloudException.Wanted(FailureCode.BadInput, source.Path,
                        E57Pages.ToPhysical(header.XmlLogicalOffset), "root of the XML section", "e57Root",
                        E57Text.OneLine(root.Name));
                E57Facts.AddFile(root, info);
                var sections = ReadScans(root, source, crc, info);
                var scans = sections.ConvertAll(section => section.Scan);
                var schema = new E57Schema(scans);
                info.Schema = schema.Schema;
                info.Transform = schema.Transform;
                E57Facts.AddSchema(schema, scans, info);
                return new E57Reader(info, schema, sections, crc);
            }
            catch
            {
                crc.Dispose();
                throw;
            }
        }

        public override bool BlocksAreKnown => m_areBlocksKnown;

        /// <summary>Fixed within a few thousand records and a packet or two.</summary>
        public override bool HasFixedStride => true;

        public override int BlockCount => Known(m_blockCount);

        public override int MaxPointsPerBlock => Known(m_maxPoints);

        internal long FilePages { get; }

        internal ref readonly FileHandle File => ref m_file;

        internal NativeArray<uint> CrcTable => m_crc.Table;

        /// <summary>Whether any scan's positions or normals pass through rows of doubles.</summary>
        internal bool HasVectors { get; }

        /// <summary>The most pages of a range within one block.</summary>
        internal int MaxBlockPages => m_maxPages;

        public override long FirstPointOfBlock(int block)
        {
            var section = SectionOf(block);
            return section.FirstPoint + (long)(block - section.FirstBlock) * section.BlockPoints;
        }

        public override int PointsInBlock(int block)
        {
            var section = SectionOf(block);
            return (int)Math.Min(section.BlockPoints, section.Records - (long)(block - section.FirstBlock) * section.BlockPoints);
        }

        /// <summary>Estimates by the range's share of its scan's section: packets also hold fields that are not wanted.</summary>
        public override long BytesOfRange(BlockRange range)
        {
            var section = SectionOf(range.Block);
            return (long)((section.End - section.DataStart) * (range.Count / (double)Math.Max(1, section.Records)));
        }

        public override IEnumerator<Work> FindBlocks()
        {
            if (m_areBlocksKnown)
                yield break;
            OpenFile();
            long points = 0;
            foreach (var section in m_sections)
            {
                if (section.Scan.RecordsClaimed > 0 && section.Scan.RecordBits == 0)
                {
                    TakeWithoutBits(section);
                }
                else if (section.Scan.RecordsClaimed > 0)
                {
                    using (var walk = new E57Walk(this, section))
                        yield return Work.Of(walk.Run());
                    LimitPages(section);
                }
                section.FirstBlock = m_blockCount;
                section.FirstPoint = points;
                m_blockCount += section.BlockCount;
                points += section.Records;
                m_maxPoints = (int)Math.Max(m_maxPoints, Math.Min(section.BlockPoints, section.Records));
            }
            if (points == 0)
                throw PointCloudException.Wanted(FailureCode.Truncated, Info.Path, -1, "points",
                    NumberText.Of(Info.PointsClaimed), 0);
            Info.PointsReadable = points;
            m_areBlocksKnown = true;
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            Known(0);
            OpenFile();
            return new E57BlockRead(this, wanted, capacity, allocator);
        }

        internal List<E57FieldRead> ReadsOf(E57Section section, PointBatch batch) =>
            m_schema.ReadsOf(section.Index, batch);

        internal E57Section SectionOf(int block)
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

        /// <summary>Reports what a range contained besides points, once for each block.</summary>
        internal void Warn(BlockRange range, DecodeResult result, in E57Anomalies anomalies)
        {
            bool isNew = range.First == 0 && range.Count == PointsInBlock(range.Block) && m_toldBlocks.Add(range.Block);
            if (result.Error != E57Error.None)
                Warn("points are left out: " + E57Error.Text(result.Error), result.ErrorOffset,
                    isNew ? range.Count - result.Points : 0);
            if (anomalies.Invalid > 0)
                Warn("points that their scan marks as invalid are left out", -1, isNew ? anomalies.Invalid : 0);
            if (anomalies.Damaged > 0)
                Warn("the checksum of page " + anomalies.FirstDamagedPage + " is wrong (" + anomalies.DamagedPages +
                    " pages of this block are damaged): points that lie in them are left out",
                    anomalies.FirstDamagedPage * E57Pages.PageBytes, isNew ? anomalies.Damaged : 0);
            if (anomalies.Misfits > 0)
                Warn("integers above the maximum of their field: the maximum was taken", -1, isNew ? anomalies.Misfits : 0);
        }

        public override void CloseFile()
        {
            if (!m_isOpen)
                return;
            m_isOpen = false;
            m_file.Close().Complete();
        }

        public override void DisposeUnread() => m_crc.Dispose();

        void OpenFile()
        {
            if (m_isOpen)
                return;
            m_file = AsyncReadManager.OpenFileAsync(Path.GetFullPath(Info.Path));
            m_isOpen = true;
        }

        static List<E57Section> ReadScans(E57Node root, FileSource source, Crc32C crc, SourceInfo info)
        {
            var sections = new List<E57Section>();
            var data = root.Child("data3D");
            PointCloudException first = null;
            int count = data?.Children.Count ?? 0, leftOut = 0;
            for (int i = 0; i < count; i++)
            {
                var scan = E57Scan.Read(data.Children[i], i, out string problem, out string remark);
                info.PointsClaimed = Sum(info.PointsClaimed, scan.RecordsClaimed);
                if (remark != null)
                    info.Warn(-1, scan.Label + ": " + remark);
                long offset = -1;
                E57Section section = null;
                if (problem == null)
                    section = E57Section.Read(scan, source, crc, info, out problem, out offset);
                E57Facts.AddScan(data.Children[i], scan, info);
                if (problem == null)
                {
                    section.Index = sections.Count;
                    sections.Add(section);
                    continue;
                }
                first = first ?? new PointCloudException(FailureCode.BadInput, info.Path, offset, scan.Label + ": " + problem);
                leftOut++;
                if (leftOut <= MostScansTold)
                    info.Warn(offset, scan.Label + " is left out: " + problem);
            }
            if (leftOut > MostScansTold)
                info.Warn(-1, NumberText.Of(leftOut) + " of " + NumberText.Of(count) + " scans are left out");
            if (sections.Count == 0 && first != null)
                throw first;
            return sections;
        }

        static ulong Sum(ulong a, ulong b) => a > ulong.MaxValue - b ? ulong.MaxValue : a + b;

        void TakeWithoutBits(E57Section section)
        {
            section.Records = (long)Math.Min(section.Scan.RecordsClaimed, MostRecordsWithoutBits);
            if (section.Scan.RecordsClaimed > MostRecordsWithoutBits)
                Info.Warn(-1, section.Scan.Label + ": its records take no bytes, all being equal: " + MostRecordsWithoutBits +
                    " of the " + NumberText.Of(section.Scan.RecordsClaimed) + " claimed are given");
        }

        /// <summary>Ends a scan before the first block whose fields lie too far apart.</summary>
        void LimitPages(E57Section section)
        {
            var firstPages = new long[section.EndOfStream.Length];
            var endPages = new long[section.EndOfStream.Length];
            for (long first = 0; first < section.Records; first += section.BlockPoints)
            {
                int runs = section.PagesOf(first, Math.Min(first + section.BlockPoints, section.Records), null, firstPages,
                    endPages);
                long pages = 0;
                for (int i = 0; i < runs; i++)
                    pages += endPages[i] - firstPages[i];
                if (pages > MostBlockPages)
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
            if (!m_warnings.TryGetValue(key, out int index))
            {
                index = Info.Warnings.Count;
                m_warnings.Add(key, index);
                m_counts.Add(key, 0);
                Info.Warn(offset, text);
            }
            if (count == 0)
                return;
            m_counts[key] += count;
            var first = Info.Warnings[index];
            int mark = first.Text.LastIndexOf(" (", StringComparison.Ordinal);
            string start = mark >= 0 && first.Text.EndsWith(" so far)", StringComparison.Ordinal)
                ? first.Text.Substring(0, mark) : first.Text;
            Info.Warnings[index] = new CloudWarning(first.Path, first.ByteOffset, start + " (" + NumberText.Of(m_counts[key]) +
                " so far)");
        }

        T Known<T>(T value) => m_areBlocksKnown ? value : throw new InvalidOperationException("FindBlocks comes first");
    }
}
