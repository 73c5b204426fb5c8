using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Nodes
{
    /// <summary>The records of one chunk in arrival order: a list of pages with a fixed number of records, so that lists grow,
    /// are joined and returned without moving a record. Pages come from a <see cref="RecordPagePool"/>. Blittable; one job at a
    /// time may change a list.</summary>
    internal unsafe struct RecordPages
    {
        /// <summary>Records of one page.</summary>
        public const int RecordsPerPage = 1 << 11;

        /// <summary>The header of a page; its records follow it in memory.</summary>
        public struct Page
        {
            public Page* Next;
            public int Count;
        }

        const int HeaderBytes = 64;

        [NativeDisableUnsafePtrRestriction] public Page* First;
        [NativeDisableUnsafePtrRestriction] public Page* Last;
        public long Count;

        /// <summary>Pages in the list, of which the last few may not be full.</summary>
        public int PageCount;

        /// <summary>Bytes of a page in memory.</summary>
        public static long PageBytes(int strideBytes) => HeaderBytes + ((long)RecordsPerPage * strideBytes + 63 & ~63L);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static byte* RecordsOf(Page* page) => (byte*)page + HeaderBytes;

        /// <summary>Appends a page, with the records that it holds.</summary>
        public void AddPage(Page* page)
        {
            page->Next = null;
            if (Last == null)
                First = page;
            else
                Last->Next = page;
            Last = page;
            PageCount++;
            Count += page->Count;
        }

        /// <summary>Takes over all pages of another list, which is empty afterwards.</summary>
        public void Join(ref RecordPages other)
        {
            if (other.First == null)
                return;
            if (First == null)
                First = other.First;
            else
                Last->Next = other.First;
            Last = other.Last;
            Count += other.Count;
            PageCount += other.PageCount;
            other = default;
        }

        /// <summary>Cuts off the list's first pages.</summary>
        public RecordPages Cut(int pages)
        {
            if (pages <= 0)
                return default;
            var head = this;
            if (pages >= PageCount)
            {
                this = default;
                return head;
            }
            head.Count = 0;
            head.PageCount = pages;
            head.Last = First;
            for (int i = 1; i < pages; i++)
            {
                head.Count += head.Last->Count;
                head.Last = head.Last->Next;
            }
            head.Count += head.Last->Count;
            First = head.Last->Next;
            head.Last->Next = null;
            PageCount -= pages;
            Count -= head.Count;
            return head;
        }

        /// <summary>Cuts off all pages except a last one that has room.</summary>
        public RecordPages CutFull() => Cut(Last != null && Last->Count < RecordsPerPage ? PageCount - 1 : PageCount);
    }

    /// <summary>Full pages of one chunk that no longer fit in memory. Blittable.</summary>
    internal struct DetachedRecordPages
    {
        public int Chunk;
        public RecordPages Pages;
    }
}
