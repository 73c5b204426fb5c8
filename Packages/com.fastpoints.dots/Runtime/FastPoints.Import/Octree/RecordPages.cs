using System.Runtime.CompilerServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Octree
{
    /// <summary>
    /// The records of one chunk in arrival order: a list of pages of a fixed number of records, so that lists grow, are joined
    /// and are freed without moving a record. Blittable; one job at a time may change a list.
    /// </summary>
    public unsafe struct RecordPages
    {
        /// <summary>Records of one page; a power of two, so that a record's number splits into page and place.</summary>
        public const int RecordsPerPage = 1 << RecordsPerPageLog2;
        public const int RecordsPerPageLog2 = 11;

        /// <summary>Followed in memory by the records.</summary>
        public struct Page
        {
            public Page* Next;
            public int Count;
        }

        const int HeaderBytes = 64;

        [NativeDisableUnsafePtrRestriction] public Page* First;
        [NativeDisableUnsafePtrRestriction] public Page* Last;
        public long Count;

        /// <summary>Pages in the list, the last few perhaps not full.</summary>
        public int PageCount;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static byte* RecordsOf(Page* page) => (byte*)page + HeaderBytes;

        /// <summary>Appends copies of consecutive records.</summary>
        public void Append(byte* records, int count, int strideBytes)
        {
            while (count > 0)
            {
                var page = Last;
                if (page == null || page->Count == RecordsPerPage)
                    page = AddPage(strideBytes);
                int room = RecordsPerPage - page->Count;
                int taken = count < room ? count : room;
                UnsafeUtility.MemCpy(RecordsOf(page) + (long)page->Count * strideBytes, records, (long)taken * strideBytes);
                page->Count += taken;
                Count += taken;
                records += (long)taken * strideBytes;
                count -= taken;
            }
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

        /// <summary>Frees all pages.</summary>
        public void Free()
        {
            for (var page = First; page != null;)
            {
                var next = page->Next;
                UnsafeUtility.Free(page, Allocator.Persistent);
                page = next;
            }
            this = default;
        }

        Page* AddPage(int strideBytes)
        {
            var page = (Page*)UnsafeUtility.Malloc(HeaderBytes + (long)RecordsPerPage * strideBytes, HeaderBytes,
                Allocator.Persistent);
            page->Next = null;
            page->Count = 0;
            if (Last == null)
                First = page;
            else
                Last->Next = page;
            Last = page;
            PageCount++;
            return page;
        }
    }
}
