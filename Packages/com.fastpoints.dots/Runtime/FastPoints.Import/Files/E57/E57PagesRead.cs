using System;
using FastPoints.Base;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Reads some extents of a file together into native memory, checks them and removes checksums; at most one such
    /// read is in flight.</summary>
    sealed unsafe class E57PagesRead : IDisposable
    {
        /// <summary>Bytes behind the content that jobs may load and not use.</summary>
        const int PaddingBytes = 16;

        readonly E57Reader m_reader;
        NativeArray<byte> m_buffer;
        NativeArray<byte> m_isDamaged;
        NativeArray<E57Extent> m_extents;
        NativeArray<ReadCommand> m_commands;
        ReadHandle m_handle;
        bool m_isReading;

        public E57PagesRead(E57Reader reader, int pages, int extents, Allocator allocator)
        {
            m_reader = reader;
            m_buffer = new NativeArray<byte>(checked(pages * E57Pages.PageBytes + PaddingBytes), allocator,
                NativeArrayOptions.UninitializedMemory);
            m_isDamaged = new NativeArray<byte>(Math.Max(1, pages), allocator);
            m_extents = new NativeArray<E57Extent>(Math.Max(1, extents), allocator);
            m_commands = new NativeArray<ReadCommand>(Math.Max(1, extents), allocator);
            PageCapacity = pages;
        }

        public int PageCapacity { get; }

        /// <summary>Content, valid after the handle that <see cref="Begin"/> gives.</summary>
        public NativeArray<byte> Buffer => m_buffer;

        public NativeArray<byte> IsDamaged => m_isDamaged;

        /// <summary>The extents that <see cref="Add"/> has set, in the file's order.</summary>
        public NativeArray<E57Extent> Extents => m_extents;

        public int ExtentCount { get; private set; }

        public int Pages { get; private set; }

        public void Clear()
        {
            ExtentCount = 0;
            Pages = 0;
        }

        /// <summary>Adds pages behind the earlier ones; fewer than requested if the file or the buffer ends.</summary>
        /// <returns>Whether any were added.</returns>
        public bool Add(long firstPage, int pages)
        {
            pages = (int)Math.Min(Math.Min(pages, PageCapacity - Pages), m_reader.FilePages - firstPage);
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
            byte* buffer = (byte*)m_buffer.GetUnsafePtr();
            for (int i = 0; i < ExtentCount; i++)
                m_commands[i] = new ReadCommand
                {
                    Buffer = buffer + (long)m_extents[i].BufferPage * E57Pages.PageBytes,
                    Offset = m_extents[i].FirstPage * E57Pages.PageBytes,
                    Size = (long)m_extents[i].Pages * E57Pages.PageBytes,
                };
            m_handle = AsyncReadManager.Read(m_reader.File, new ReadCommandArray
            {
                ReadCommands = (ReadCommand*)m_commands.GetUnsafePtr(),
                CommandCount = ExtentCount,
            });
            m_isReading = true;
            return CheckE57PagesJob.Schedule(m_reader.CrcTable, m_buffer, m_isDamaged, Pages, m_handle.JobHandle);
        }

        /// <summary>Closes a read after which all jobs are finished.</summary>
        /// <exception cref="PointCloudException">It failed, or the file has become shorter since it was opened.</exception>
        public void End()
        {
            if (!m_isReading)
                return;
            m_isReading = false;
            m_handle.JobHandle.Complete();
            var status = m_handle.Status;
            m_handle.Dispose();
            if (status != ReadStatus.Complete)
                throw new PointCloudException(FailureCode.ReadFailed, m_reader.Info.Path,
                    m_extents[0].FirstPage * E57Pages.PageBytes,
                    "the file could not be read, or has become shorter since it was opened");
        }

        /// <summary>Jobs that use the buffer must be complete.</summary>
        public void Dispose()
        {
            if (!m_buffer.IsCreated)
                return;
            if (m_isReading)
            {
                m_isReading = false;
                m_handle.Cancel();
                m_handle.JobHandle.Complete();
                m_handle.Dispose();
            }
            m_buffer.Dispose();
            m_isDamaged.Dispose();
            m_extents.Dispose();
            m_commands.Dispose();
        }
    }

    /// <summary>Consecutive pages of a file, and where a buffer holds them.</summary>
    struct E57Extent
    {
        public long FirstPage;
        public int Pages;

        /// <summary>The index of its first page in the buffer.</summary>
        public int BufferPage;

        public long LogicalStart => FirstPage * E57Pages.DataBytes;

        public long LogicalEnd => (FirstPage + Pages) * E57Pages.DataBytes;

        /// <summary>Added to a logical offset to give the offset in the buffer's content, once the checksums are
        /// removed.</summary>
        public long ToBuffer => ((long)BufferPage - FirstPage) * E57Pages.DataBytes;
    }
}
