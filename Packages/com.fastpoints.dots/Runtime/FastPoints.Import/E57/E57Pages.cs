using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

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

        // Counts whole pages only.
        public static long LogicalLength(long fileBytes) => fileBytes / PageBytes * DataBytes;

        // damagedPage: the first page whose checksum is wrong, or -1.
        public static byte[] Read(RandomAccessFile source, Crc32C crc, long logical, int count, string field,
            out long damagedPage)
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

    // CRC-32C (Castagnoli, reflected polynomial 0x82F63B78, RFC 3720 B.4), eight bytes a step: Kounavis and Berry, "A systematic
    // approach to building high performance software-based CRC generators", 2005. Jobs share the tables.
    internal sealed unsafe class Crc32C : IDisposable
    {
        const uint Polynomial = 0x82F63B78;
        const int Tables = 8;

        NativeArray<uint> m_tables;

        public Crc32C(Allocator allocator)
        {
            m_tables = new NativeArray<uint>(Tables * 256, allocator);
            for (uint i = 0; i < 256; i++)
            {
                uint crc = i;
                for (int bit = 0; bit < 8; bit++)
                    crc = crc >> 1 ^ ((crc & 1) != 0 ? Polynomial : 0);
                m_tables[(int)i] = crc;
            }
            for (int i = 256; i < Tables * 256; i++)
                m_tables[i] = m_tables[i - 256] >> 8 ^ m_tables[(int)(m_tables[i - 256] & 255)];
        }

        public NativeArray<uint> Table => m_tables;

        public uint Of(byte[] bytes, int first, int count)
        {
            fixed (byte* p = bytes)
                return Compute((uint*)m_tables.GetUnsafeReadOnlyPtr(), p + first, count);
        }

        public static uint Compute(uint* tables, byte* bytes, int count)
        {
            uint crc = uint.MaxValue;
            int i = 0;
            for (; i + 8 <= count; i += 8)
            {
                ulong eight = *(ulong*)(bytes + i) ^ crc;
                crc = tables[7 * 256 + (byte)eight] ^ tables[6 * 256 + (byte)(eight >> 8)] ^
                    tables[5 * 256 + (byte)(eight >> 16)] ^ tables[4 * 256 + (byte)(eight >> 24)] ^
                    tables[3 * 256 + (byte)(eight >> 32)] ^ tables[2 * 256 + (byte)(eight >> 40)] ^
                    tables[256 + (byte)(eight >> 48)] ^ tables[eight >> 56];
            }
            for (; i < count; i++)
                crc = crc >> 8 ^ tables[(byte)(crc ^ bytes[i])];
            return ~crc;
        }

        public void Dispose()
        {
            if (m_tables.IsCreated)
                m_tables.Dispose();
        }
    }

    // A chain of these turns a buffer of pages into one of content: it moves content over the checksums of earlier pages.
    [BurstCompile]
    unsafe struct CheckE57PagesJob : IJob
    {
        public const int SlicePages = 1024; // About 1 ms.

        [ReadOnly] public NativeArray<uint> CrcTable;
        public NativeArray<byte> Buffer;

        // For each page, 1 if its checksum is wrong.
        public NativeArray<byte> IsDamaged;
        public int FirstPage;
        public int Pages;

        public void Execute()
        {
            var table = (uint*)CrcTable.GetUnsafeReadOnlyPtr();
            byte* buffer = (byte*)Buffer.GetUnsafePtr();
            for (int page = FirstPage; page < FirstPage + Pages; page++)
            {
                byte* p = buffer + (long)page * E57Pages.PageBytes;
                byte* sum = p + E57Pages.DataBytes;
                uint wanted = (uint)(sum[0] << 24 | sum[1] << 16 | sum[2] << 8 | sum[3]);
                IsDamaged[page] = (byte)(Crc32C.Compute(table, p, E57Pages.DataBytes) == wanted ? 0 : 1);
                if (page > 0)
                    UnsafeUtility.MemMove(buffer + (long)page * E57Pages.DataBytes, p, E57Pages.DataBytes);
            }
        }

        public static JobHandle Schedule(NativeArray<uint> crcTable, NativeArray<byte> buffer, NativeArray<byte> isDamaged,
            int pages, JobHandle read)
        {
            for (int first = 0; first < pages; first += SlicePages)
                read = new CheckE57PagesJob
                {
                    CrcTable = crcTable,
                    Buffer = buffer,
                    IsDamaged = isDamaged,
                    FirstPage = first,
                    Pages = System.Math.Min(SlicePages, pages - first),
                }.Schedule(read);
            return read;
        }
    }

    // Several extents of a file, checked and without checksums; at most one such read is in flight.
    sealed unsafe class E57PagesRead : IDisposable
    {
        readonly E57File m_file;
        readonly NativeFileRead m_read;
        NativeArray<byte> m_isDamaged;
        NativeArray<E57Extent> m_extents;

        public E57PagesRead(E57File file, int pages, int extents, Allocator allocator)
        {
            m_file = file;
            m_read = new NativeFileRead((long)pages * E57Pages.PageBytes, allocator, extents);
            m_isDamaged = new NativeArray<byte>(Math.Max(1, pages), allocator);
            m_extents = new NativeArray<E57Extent>(Math.Max(1, extents), allocator);
            PageCapacity = pages;
        }

        public int PageCapacity { get; }
        public NativeArray<byte> Buffer => m_read.Buffer;
        public NativeArray<byte> IsDamaged => m_isDamaged;
        public NativeArray<E57Extent> Extents => m_extents;
        public int ExtentCount { get; private set; }
        public int Pages { get; private set; }

        public void Clear()
        {
            ExtentCount = 0;
            Pages = 0;
        }

        // Fewer pages than requested if the file or the buffer ends; false if none.
        public bool Add(long firstPage, int pages)
        {
            pages = (int)Math.Min(Math.Min(pages, PageCapacity - Pages), m_file.Pages - firstPage);
            if (pages <= 0 || ExtentCount == m_extents.Length)
                return false;
            m_extents[ExtentCount] = new E57Extent { FirstPage = firstPage, Pages = pages, BufferPage = Pages };
            ExtentCount++;
            Pages += pages;
            return true;
        }

        public RemoteFetch Fetched { set => m_read.Fetched = value; }

        // Of a remote file it begins the requests. Returns whether Begin may be called.
        public bool TryFetch()
        {
            if (!m_file.Handle.IsRemote)
                return true;
            SetCommands();
            return m_read.TryFetch(m_file.Handle.Path, ExtentCount);
        }

        public JobHandle Begin()
        {
            if (Pages == 0)
                return default;
            SetCommands();
            var read = m_read.Begin(m_file.Handle, ExtentCount);
            return CheckE57PagesJob.Schedule(m_file.Crc.Table, Buffer, m_isDamaged, Pages, read);
        }

        void SetCommands()
        {
            byte* buffer = (byte*)Buffer.GetUnsafePtr();
            var commands = m_read.Commands;
            for (int i = 0; i < ExtentCount; i++)
                commands[i] = new ReadCommand
                {
                    Buffer = buffer + (long)m_extents[i].BufferPage * E57Pages.PageBytes,
                    Offset = m_extents[i].FirstPage * E57Pages.PageBytes,
                    Size = (long)m_extents[i].Pages * E57Pages.PageBytes,
                };
        }

        public void End() => m_read.End();

        public void Dispose()
        {
            if (!m_extents.IsCreated)
                return;
            m_read.Dispose();
            m_isDamaged.Dispose();
            m_extents.Dispose();
        }
    }

    sealed class E57File
    {
        public readonly SourceHandle Handle;
        public readonly long Pages;
        public readonly Crc32C Crc;

        public E57File(SourceInfo info, Crc32C crc)
        {
            Handle = new SourceHandle(info.Path);
            Pages = info.FileBytes / E57Pages.PageBytes;
            Crc = crc;
        }
    }

    struct E57Extent
    {
        public long FirstPage;
        public int Pages;
        public int BufferPage;

        public long LogicalStart => FirstPage * E57Pages.DataBytes;
        public long LogicalEnd => (FirstPage + Pages) * E57Pages.DataBytes;

        // Added to a logical offset it gives the offset in the buffer's content.
        public long ToBuffer => ((long)BufferPage - FirstPage) * E57Pages.DataBytes;
    }
}
