using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.E57
{
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

        // In bytes of content, as XmlBytes.
        public long XmlLogicalOffset;

        public int XmlBytes;

        public static E57Header Read(FileSource source, SourceInfo info)
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
