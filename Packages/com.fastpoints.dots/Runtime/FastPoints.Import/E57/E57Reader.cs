using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.E57
{
    // E57 (ASTM E2807-11): the points of all scans, one scan after the other, moved to where their poses put them. A
    // walk over packet headers finds where records lie (IndexBlocks). Points that a scan marks as invalid are left out
    // and counted, points in a page with a wrong checksum with a warning. Images are named, not read.
    internal sealed class E57Reader : PointReader
    {
        const int MaxReportedScans = 20;

        readonly E57Blocks m_blocks;

        E57Reader(E57Blocks blocks)
        {
            Info = blocks.Info;
            m_blocks = blocks;
        }

        public static E57Reader Open(string path)
        {
            using var source = RandomAccessFile.Open(path);
            return Open(source);
        }

        public static E57Reader Open(RandomAccessFile source)
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
                E57SourceInfo.AddFile(root, info);
                var sections = ReadScans(root, source, crc, info);
                var scans = sections.ConvertAll(section => section.Scan);
                var schema = new E57Schema(scans);
                info.Schema = schema.Schema;
                info.Transform = schema.Transform;
                info.Scanners = schema.Scanners;
                E57SourceInfo.AddSchema(schema, scans, info);
                return new E57Reader(new E57Blocks(new E57File(info, crc), info, schema, sections));
            }
            catch
            {
                crc.Dispose();
                throw;
            }
        }

        public override bool BlocksAreKnown => m_blocks.AreKnown;
        public override bool HasCheapRanges => true; // To within a few thousand records and a packet or two.

        public override int BlockCount => m_blocks.Count;
        public override int MaxPointsPerBlock => m_blocks.MaxPoints;

        public override long FirstPointOfBlock(int block)
        {
            var section = m_blocks.SectionOf(block);
            return section.FirstPoint + (long)(block - section.FirstBlock) * section.BlockPoints;
        }

        public override int PointsInBlock(int block) => m_blocks.PointsOf(block);

        // Estimates by the range's share of its scan's section: packets also hold fields that are not wanted.
        public override long BytesOfRange(BlockRange range)
        {
            var section = m_blocks.SectionOf(range.Block);
            return (long)((section.End - section.DataStart) * (range.Count / (double)Math.Max(1, section.Records)));
        }

        public override IEnumerator<JobStep> IndexBlocks() => m_blocks.Find();

        internal override void ListPieces(BlockRange range, List<FilePiece> pieces)
        {
            var section = m_blocks.SectionOf(range.Block);
            long first = (long)(range.Block - section.FirstBlock) * section.BlockPoints + range.First;
            var firstPages = new long[E57Scan.MaxFields];
            var endPages = new long[E57Scan.MaxFields];
            int count = section.PagesOf(first, first + range.Count, null, firstPages, endPages);
            for (int i = 0; i < count; i++)
                pieces.Add(new FilePiece
                {
                    Path = Info.Path,
                    OffsetBytes = firstPages[i] * E57Pages.PageBytes,
                    LengthBytes = (endPages[i] - firstPages[i]) * E57Pages.PageBytes,
                });
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new E57BlockRead(this, m_blocks, wanted, capacity, allocator);

        public override void CloseFile() => m_blocks.File.Handle.Close();

        public override void DisposeUnread() => m_blocks.File.Crc.Dispose();

        static List<E57Section> ReadScans(E57Node root, RandomAccessFile source, Crc32C crc, SourceInfo info)
        {
            var sections = new List<E57Section>();
            var data = root.Child("data3D");
            PointCloudException first = null;
            int count = data?.Children.Count ?? 0, leftOut = 0;
            for (int i = 0; i < count; i++)
            {
                var scan = E57Scan.Read(data.Children[i], i, out string problem, out string comment);
                info.PointsClaimed = Sum(info.PointsClaimed, scan.RecordsClaimed);
                if (comment != null)
                    info.Warn(-1, scan.Label + ": " + comment);
                long offset = -1;
                E57Section section = null;
                if (problem == null)
                    section = E57Section.Read(scan, source, crc, info, out problem, out offset);
                E57SourceInfo.AddScan(data.Children[i], scan, info);
                if (problem == null)
                {
                    section.Index = sections.Count;
                    sections.Add(section);
                    continue;
                }
                first = first ?? new PointCloudException(FailureCode.BadInput, info.Path, offset, scan.Label + ": " + problem);
                leftOut++;
                if (leftOut <= MaxReportedScans)
                    info.Warn(offset, scan.Label + " is left out: " + problem);
            }
            if (leftOut > MaxReportedScans)
                info.Warn(-1, NumberText.Of(leftOut) + " of " + NumberText.Of(count) + " scans are left out");
            if (sections.Count == 0 && first != null)
                throw first;
            return sections;
        }

        static ulong Sum(ulong a, ulong b) => a > ulong.MaxValue - b ? ulong.MaxValue : a + b;
    }

    // The 48 bytes at the start of a file (ASTM E2807, table 1).
    sealed class E57Header
    {
        public const int Bytes = 48;

        static class At
        {
            public const int MajorVersion = 8;
            public const int MinorVersion = 12;
            public const int FileLength = 16;
            public const int XmlOffset = 24;
            public const int XmlLength = 32;
            public const int PageSize = 40;
        }

        public uint MajorVersion;
        public uint MinorVersion;
        public long XmlLogicalOffset; // In bytes of content, as XmlBytes.

        public int XmlBytes;

        public static E57Header Read(RandomAccessFile source, SourceInfo info)
        {
            var fields = source.Read(0, Bytes, "the E57 header");
            var header = new E57Header
            {
                MajorVersion = fields.UInt32(At.MajorVersion, "major version"),
                MinorVersion = fields.UInt32(At.MinorVersion, "minor version"),
            };
            if (header.MajorVersion != 1)
                info.Warn(At.MajorVersion, "major version: wanted 1, got " + header.MajorVersion + "; read as 1");
            ulong pageSize = fields.UInt64(At.PageSize, "page size");
            if (pageSize != E57Pages.PageBytes)
                throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, At.PageSize, "page size", E57Pages.PageBytes,
                    pageSize);
            ulong claimedLength = fields.UInt64(At.FileLength, "length of the file");
            if (claimedLength != (ulong)source.Length)
                info.Warn(At.FileLength, "length of the file: the header says " + claimedLength + ", it has " + source.Length);
            if (source.Length % E57Pages.PageBytes != 0)
                info.Warn(source.Length / E57Pages.PageBytes * E57Pages.PageBytes,
                    "the last page is not whole: what it holds is left out");

            ulong offset = fields.UInt64(At.XmlOffset, "offset of the XML section");
            ulong length = fields.UInt64(At.XmlLength, "length of the XML section");
            if (offset < Bytes || offset % E57Pages.PageBytes >= E57Pages.DataBytes)
                throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, At.XmlOffset, "offset of the XML section",
                    "a byte behind the header, and of no checksum", offset);
            if (offset >= (ulong)source.Length)
                throw PointCloudException.Wanted(FailureCode.Truncated, source.Path, At.XmlOffset, "offset of the XML section",
                    "a byte of the file, which ends at " + source.Length, offset);
            if (length == 0 || length > E57XmlTree.MaxBytes)
                throw PointCloudException.Wanted(FailureCode.BadInput, source.Path, At.XmlLength, "length of the XML section",
                    "1 to " + E57XmlTree.MaxBytes + " bytes", length);
            header.XmlLogicalOffset = E57Pages.ToLogical((long)offset);
            header.XmlBytes = (int)length;
            return header;
        }
    }
}
