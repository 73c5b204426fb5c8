using System;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.E57
{
    // Some extents of a file together, checked and without checksums; at most one such read is in flight.
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

        // In the file's order.
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

        public JobHandle Begin()
        {
            if (Pages == 0)
                return default;
            byte* buffer = (byte*)Buffer.GetUnsafePtr();
            var commands = m_read.Commands;
            for (int i = 0; i < ExtentCount; i++)
                commands[i] = new ReadCommand
                {
                    Buffer = buffer + (long)m_extents[i].BufferPage * E57Pages.PageBytes,
                    Offset = m_extents[i].FirstPage * E57Pages.PageBytes,
                    Size = (long)m_extents[i].Pages * E57Pages.PageBytes,
                };
            var read = m_read.Begin(m_file.Handle, ExtentCount);
            return CheckE57PagesJob.Schedule(m_file.Crc.Table, Buffer, m_isDamaged, Pages, read);
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
