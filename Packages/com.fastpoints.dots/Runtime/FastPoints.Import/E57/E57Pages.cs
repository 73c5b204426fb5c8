using System;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.E57
{
    // The pages of a file (ASTM E2807, 5.2): 1,020 bytes of content and their CRC-32C. Offsets in headers are physical, bytes of
    // the file; lengths are logical, bytes of content.
    static class E57Pages
    {
        public const int PageBytes = 1024;
        public const int DataBytes = 1020;
        const int PagesPerRead = 256;

        public static long ToLogical(long physical) =>
            physical / PageBytes * DataBytes + Math.Min(physical % PageBytes, DataBytes);

        public static long ToPhysical(long logical) => logical / DataBytes * PageBytes + logical % DataBytes;

        // Not inside a checksum, and at a multiple of four.
        public static bool IsContentOffset(ulong physical) => physical % PageBytes < DataBytes && physical % 4 == 0;

        // Of whole pages only.
        public static long LogicalLength(long fileBytes) => fileBytes / PageBytes * DataBytes;

        // damagedPage: the first page whose checksum is wrong, or -1.
        public static byte[] Read(FileSource source, Crc32C crc, long logical, int count, string field, out long damagedPage)
        {
            damagedPage = -1;
            long firstPage = logical / DataBytes, endPage = (logical + count + DataBytes - 1) / DataBytes;
            if (count < 0 || logical < 0 || endPage > source.Length / PageBytes)
                throw PointCloudException.Wanted(FailureCode.Truncated, source.Path, ToPhysical(Math.Max(0, logical)), field,
                    count + " bytes", Math.Max(0, LogicalLength(source.Length) - logical) + " before the end of the file");
            byte[] content = new byte[count], pages = null;
            long firstOfPages = firstPage;
            int done = 0;
            for (long page = firstPage; page < endPage; page++)
            {
                if (pages == null || page == firstOfPages + PagesPerRead)
                {
                    firstOfPages = page;
                    pages = source.Read(page * PageBytes, (int)Math.Min(PagesPerRead, endPage - page) * PageBytes, field).Bytes;
                }
                int at = (int)(page - firstOfPages) * PageBytes;
                if (damagedPage < 0 && crc.Of(pages, at, DataBytes) != Checksum(pages, at + DataBytes))
                    damagedPage = page;
                int from = (int)(logical + done - page * DataBytes), length = Math.Min(DataBytes - from, count - done);
                Array.Copy(pages, at + from, content, done, length);
                done += length;
            }
            return content;
        }

        // The one big-endian number of the format.
        static uint Checksum(byte[] bytes, int at) =>
            (uint)(bytes[at] << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 | bytes[at + 3]);
    }
}
