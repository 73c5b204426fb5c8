using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Streaming
{
    /// <summary>The memory that nodes are drawn from: banks of one size, cut into pages, which are allocated when needed and
    /// freed when empty, within a limit. Derived classes decide where the memory lies.</summary>
    public abstract unsafe class NodePool : IDisposable
    {
        /// <summary>Bytes of a page. A node's last page is half empty on average, which is 1 % of a node of 50 KB.</summary>
        public const int PageBytes = 1024;

        /// <summary>Every GPU supports storage buffers of this size.</summary>
        public const int MaxBankBytes = 1 << 27;

        RangeAllocator[] m_banks = Array.Empty<RangeAllocator>();
        readonly int m_pagesPerBank;
        long m_limitBytes;

        /// <param name="bankBytes">Size of a bank; no node may be larger.</param>
        protected NodePool(long limitBytes, int bankBytes)
        {
            if (bankBytes < PageBytes || bankBytes > MaxBankBytes)
                throw new ArgumentOutOfRangeException(nameof(bankBytes), bankBytes,
                    "wanted " + PageBytes + " to " + MaxBankBytes);
            m_pagesPerBank = bankBytes / PageBytes;
            LimitBytes = limitBytes;
        }

        public int BankBytes => m_pagesPerBank * PageBytes;

        /// <summary>Banks are whole. After lowering it, nodes in banks beyond BankLimit must be released.</summary>
        public long LimitBytes
        {
            get => m_limitBytes;
            set => m_limitBytes = value >= 0 ? value
                : throw new ArgumentOutOfRangeException(nameof(value), value, "wanted at least 0");
        }

        public int BankLimit => (int)Math.Min(int.MaxValue / 2, m_limitBytes / BankBytes);

        /// <summary>Bytes of all allocated banks.</summary>
        public long AllocatedBytes { get; private set; }

        /// <summary>Bytes of the pages in use.</summary>
        public long UsedBytes { get; private set; }

        public static int PagesFor(long bytes) => (int)((bytes + PageBytes - 1) / PageBytes);

        /// <returns>Whether there was room. A new bank is made if none has room.</returns>
        public bool TryAllocate(long bytes, out PoolRange range)
        {
            int pages = PagesFor(bytes), limit = BankLimit;
            range = new PoolRange { PageCount = pages };
            int unallocated = -1;
            for (int bank = 0; bank < m_banks.Length && bank < limit; bank++)
            {
                if (!m_banks[bank].IsCreated)
                {
                    unallocated = unallocated < 0 ? bank : unallocated;
                    continue;
                }
                if (TryAllocate(bank, ref range))
                    return true;
            }
            if (unallocated < 0 && m_banks.Length < limit)
            {
                unallocated = m_banks.Length;
                Array.Resize(ref m_banks, Math.Min(limit, Math.Max(16, 2 * unallocated)));
            }
            if (unallocated >= 0 && pages <= m_pagesPerBank)
            {
                CreateBank(unallocated);
                m_banks[unallocated] = new RangeAllocator(m_pagesPerBank, Allocator.Persistent);
                AllocatedBytes += BankBytes;
                return TryAllocate(unallocated, ref range);
            }
            range = default;
            return false;
        }

        /// <summary>Takes a range back, and frees its bank if that is empty and beyond the limit.</summary>
        public void Release(PoolRange range)
        {
            ref var heap = ref m_banks[range.Bank];
            heap.Free(range.FirstPage);
            UsedBytes -= (long)range.PageCount * PageBytes;
            if (heap.UsedLength == 0 && range.Bank >= BankLimit)
                Free(range.Bank);
        }

        /// <summary>Keeps as much of a range as these bytes need. Returns whether it is long enough.</summary>
        public bool TryShorten(ref PoolRange range, long bytes)
        {
            int pages = PagesFor(bytes);
            if (pages > range.PageCount)
                return false;
            m_banks[range.Bank].Shorten(range.FirstPage, pages);
            UsedBytes -= (long)(range.PageCount - pages) * PageBytes;
            range.PageCount = pages;
            return true;
        }

        /// <summary>Frees empty banks from one on: by default, those beyond the limit.</summary>
        public void FreeEmptyBanks(int first = -1)
        {
            for (int bank = first < 0 ? BankLimit : first; bank < m_banks.Length; bank++)
                if (m_banks[bank].IsCreated && m_banks[bank].UsedLength == 0)
                    Free(bank);
        }

        /// <summary>Called once a frame, before everything else.</summary>
        public virtual void BeginFrame() { }

        /// <summary>Begins the one upload that may be in flight, of at least one node, if there is memory.</summary>
        /// <param name="maxBytes">The most that it is to take.</param>
        public virtual bool TryBeginUpload(int maxBytes) => true;

        /// <summary>Where the upload's job writes a range, of a multiple of 16 bytes, front to back without reading. Null if
        /// there is no room.</summary>
        public abstract byte* ReserveForUpload(PoolRange range, long bytes);

        /// <summary>Ends the upload after its job is complete: its nodes can be drawn from now on.</summary>
        public virtual void EndUpload() { }

        public virtual void Dispose()
        {
            for (int bank = 0; bank < m_banks.Length; bank++)
                if (m_banks[bank].IsCreated)
                    Free(bank);
        }

        /// <summary>Describes an inconsistency in the bookkeeping, or returns null.</summary>
        public string FindProblem()
        {
            long used = 0;
            for (int bank = 0; bank < m_banks.Length; bank++)
            {
                if (!m_banks[bank].IsCreated)
                    continue;
                used += (long)m_banks[bank].UsedLength * PageBytes;
                if (m_banks[bank].FindProblem() is string problem)
                    return "bank " + bank + ": " + problem;
            }
            return used == UsedBytes ? null : "counted " + used + " bytes in use, wanted " + UsedBytes;
        }

        protected abstract void CreateBank(int bank);

        protected abstract void DisposeBank(int bank);

        bool TryAllocate(int bank, ref PoolRange range)
        {
            range.Bank = bank;
            range.FirstPage = m_banks[bank].Allocate(range.PageCount);
            if (range.FirstPage < 0)
                return false;
            UsedBytes += (long)range.PageCount * PageBytes;
            return true;
        }

        void Free(int bank)
        {
            m_banks[bank].Dispose();
            m_banks[bank] = default;
            AllocatedBytes -= BankBytes;
            DisposeBank(bank);
        }
    }

    /// <summary>Consecutive pages in one bank of a <see cref="NodePool"/>.</summary>
    public struct PoolRange
    {
        public int Bank;
        public int FirstPage;
        public int PageCount;

        public bool IsNone => PageCount == 0;
    }

    /// <summary>A pool in ordinary memory, for software pictures.</summary>
    public sealed unsafe class MemoryNodePool : NodePool
    {
        readonly List<NativeArray<byte>> m_memory = new List<NativeArray<byte>>();

        public MemoryNodePool(long limitBytes, int bankBytes = 16 << 20) : base(limitBytes, bankBytes) { }

        /// <summary>The address of a range's bytes.</summary>
        public byte* AddressOf(PoolRange range) =>
            (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(m_memory[range.Bank]) +
            (long)range.FirstPage * PageBytes;

        public override byte* ReserveForUpload(PoolRange range, long bytes) => AddressOf(range);

        protected override void CreateBank(int bank)
        {
            while (m_memory.Count <= bank)
                m_memory.Add(default);
            m_memory[bank] = new NativeArray<byte>(BankBytes, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
        }

        protected override void DisposeBank(int bank)
        {
            m_memory[bank].Dispose();
            m_memory[bank] = default;
        }
    }
}
