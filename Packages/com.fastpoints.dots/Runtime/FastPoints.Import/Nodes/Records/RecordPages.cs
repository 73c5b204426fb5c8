using System.Runtime.CompilerServices;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>The records of one chunk in arrival order: a list of pages with a fixed number of records, so that lists grow,
    /// are joined and returned without moving a record. Pages come from a <see cref="RecordPagePool"/>. Blittable; one job at a
    /// time may change a list.</summary>
    internal unsafe struct RecordPages
    {
        public const int RecordsPerPage = 1 << 11;

        /// <summary>The header of a page; its records follow it in memory.</summary>
        public struct Page
        {
            public Page* Next;
            public int Count;

            public int BlockBytes; // Of the packed block that has taken the place of its records.
        }

        const int HeaderBytes = 64;

        [NativeDisableUnsafePtrRestriction] public Page* First;
        [NativeDisableUnsafePtrRestriction] public Page* Last;
        public long RecordCount;
        public int PageCount; // Pages in the list, of which the last few may not be full.

        /// <summary>With a word that unpacking may read beyond a block.</summary>
        public static long PageBytes(int strideBytes) =>
            HeaderBytes + ((long)RecordsPerPage * strideBytes + sizeof(uint) + 63 & ~63L);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static byte* RecordsOf(Page* page) => (byte*)page + HeaderBytes;

        public void AddPage(Page* page)
        {
            page->Next = null;
            if (Last == null)
                First = page;
            else
                Last->Next = page;
            Last = page;
            PageCount++;
            RecordCount += page->Count;
        }

        public void Join(ref RecordPages other)
        {
            if (other.First == null)
                return;
            if (First == null)
                First = other.First;
            else
                Last->Next = other.First;
            Last = other.Last;
            RecordCount += other.RecordCount;
            PageCount += other.PageCount;
            other = default;
        }

        public RecordPages DetachFirst(int pages)
        {
            if (pages <= 0)
                return default;
            var head = this;
            if (pages >= PageCount)
            {
                this = default;
                return head;
            }
            head.RecordCount = 0;
            head.PageCount = pages;
            head.Last = First;
            for (int i = 1; i < pages; i++)
            {
                head.RecordCount += head.Last->Count;
                head.Last = head.Last->Next;
            }
            head.RecordCount += head.Last->Count;
            First = head.Last->Next;
            head.Last->Next = null;
            PageCount -= pages;
            RecordCount -= head.RecordCount;
            return head;
        }

        public RecordPages DetachFull() => DetachFirst(Last != null && Last->Count < RecordsPerPage ? PageCount - 1 : PageCount);
    }

    /// <summary>Full pages of one chunk that no longer fit in memory. Blittable.</summary>
    internal struct DetachedRecordPages
    {
        public int Chunk;
        public RecordPages Pages;
    }

    /// <summary>The memory of record pages: slabs that are reused and freed all at once. Resident memory is thus the
    /// peak in use, whatever the allocator below does with many small blocks. Blittable; one job at a time may use
    /// it.</summary>
    internal unsafe struct RecordPagePool
    {
        struct Slab
        {
            public Slab* Next;
        }

        // Slabs are large enough to be returned to the system; untouched parts take no memory.
        const long SlabBytes = 36L << 20;
        const int HeaderBytes = 64;
        const int MinSlabPages = 4;

        RecordPages.Page* m_free;
        Slab* m_slabs;
        byte* m_next;
        int m_pagesLeft;
        readonly int m_pagesPerSlab;

        /// <param name="expectedPages">The expected number of pages: small clouds take small slabs.</param>
        public RecordPagePool(int strideBytes, long expectedPages)
        {
            m_free = null;
            m_slabs = null;
            m_next = null;
            m_pagesLeft = 0;
            StrideBytes = strideBytes;
            long max = SlabBytes / RecordPages.PageBytes(strideBytes);
            m_pagesPerSlab = (int)(expectedPages > max ? max : expectedPages < MinSlabPages ? MinSlabPages : expectedPages);
            PagesInUse = 0;
            SlabCount = 0;
        }

        /// <summary>The pool itself, not a copy: all holders of the reference share it.</summary>
        public static ref RecordPagePool Of(NativeReference<RecordPagePool> pool) => ref *pool.GetUnsafePtr();

        public int StrideBytes { get; }

        public int SlabCount { get; private set; }

        public long PagesInUse { get; private set; }

        public RecordPages.Page* Take()
        {
            var page = m_free;
            if (page != null)
                m_free = page->Next;
            else
                page = TakeNew();
            page->Next = null;
            page->Count = 0;
            PagesInUse++;
            return page;
        }

        public void Append(ref RecordPages pages, byte* records, int count)
        {
            while (count > 0)
            {
                if (pages.Last == null || pages.Last->Count == RecordPages.RecordsPerPage)
                    pages.AddPage(Take());
                var page = pages.Last;
                int taken = math.min(count, RecordPages.RecordsPerPage - page->Count);
                UnsafeUtility.MemCpy(RecordPages.RecordsOf(page) + (long)page->Count * StrideBytes, records,
                    (long)taken * StrideBytes);
                page->Count += taken;
                pages.RecordCount += taken;
                records += (long)taken * StrideBytes;
                count -= taken;
            }
        }

        public void Return(ref RecordPages pages)
        {
            if (pages.First != null)
            {
                pages.Last->Next = m_free;
                m_free = pages.First;
                PagesInUse -= pages.PageCount;
            }
            pages = default;
        }

        public void Return(RecordPages.Page* page)
        {
            page->Next = m_free;
            m_free = page;
            PagesInUse--;
        }

        public void FreeAll()
        {
            while (FreeSlab()) { }
        }

        /// <summary>A part of <see cref="FreeAll"/>, which takes milliseconds; repeat it until it returns false.</summary>
        /// <returns>Whether there was anything to free.</returns>
        public bool FreeSlab()
        {
            m_free = null;
            m_pagesLeft = 0;
            PagesInUse = 0;
            var slab = m_slabs;
            if (slab == null)
                return false;
            m_slabs = slab->Next;
            SlabCount--;
            UnsafeUtility.Free(slab, Allocator.Persistent);
            return true;
        }

        RecordPages.Page* TakeNew()
        {
            long pageBytes = RecordPages.PageBytes(StrideBytes);
            if (m_pagesLeft == 0)
            {
                var slab = (Slab*)UnsafeUtility.Malloc(HeaderBytes + m_pagesPerSlab * pageBytes, HeaderBytes,
                    Allocator.Persistent);
                slab->Next = m_slabs;
                SlabCount++;
                m_slabs = slab;
                m_next = (byte*)slab + HeaderBytes;
                m_pagesLeft = m_pagesPerSlab;
            }
            var page = (RecordPages.Page*)m_next;
            m_next += pageBytes;
            m_pagesLeft--;
            return page;
        }
    }

    /// <summary>Frees one slab of a pool whose pages are no longer used.</summary>
    [BurstCompile]
    internal struct FreeSlabJob : IJob
    {
        public NativeReference<RecordPagePool> Pool;

        public void Execute() => RecordPagePool.Of(Pool).FreeSlab();
    }
}
