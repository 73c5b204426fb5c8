using System;
using System.Collections.Generic;
using Unity.Collections;

namespace FastPoints.Streaming
{
    /// <summary>
    /// The memory that nodes are drawn from: banks of one size, made when they are needed and given back when they are empty, cut
    /// into pages. Never takes more than its limit. Where the memory is (here, on a graphics card) is the derived class's.
    /// </summary>
    public abstract unsafe class NodePool : IDisposable
    {
        /// <summary>Bytes of a page: a node's last one is half empty, which is 1 % of a node of 50 KB.</summary>
        public const int PageBytes = 1024;

        /// <summary>Storage buffers of a graphics card are sure up to here.</summary>
        public const int LargestBankBytes = 1 << 27;

        readonly List<RangeAllocator> m_banks = new List<RangeAllocator>();
        readonly int m_pagesPerBank;
        long m_limitBytes;

        /// <param name="bankBytes">No node may be larger.</param>
        protected NodePool(long limitBytes, int bankBytes)
        {
            if (bankBytes < PageBytes || bankBytes > LargestBankBytes)
                throw new ArgumentOutOfRangeException(nameof(bankBytes), bankBytes, "wanted " + PageBytes + " to " + LargestBankBytes);
            m_pagesPerBank = bankBytes / PageBytes;
            LimitBytes = limitBytes;
        }

        public int BankBytes => m_pagesPerBank * PageBytes;

        /// <summary>Whole banks up to here. Where it falls, what lies in banks beyond <see cref="BankLimit"/> has to be given
        /// back.</summary>
        public long LimitBytes
        {
            get => m_limitBytes;
            set => m_limitBytes = value >= 0 ? value
                : throw new ArgumentOutOfRangeException(nameof(value), value, "wanted at least 0");
        }

        public int BankLimit => (int)Math.Min(int.MaxValue / 2, m_limitBytes / BankBytes);

        /// <summary>Bytes of all banks there are.</summary>
        public long AllocatedBytes { get; private set; }

        /// <summary>Bytes of the pages in use.</summary>
        public long UsedBytes { get; private set; }

        public static int PagesFor(long bytes) => (int)((bytes + PageBytes - 1) / PageBytes);

        /// <returns>Whether there was room. A new bank is made where none has.</returns>
        public bool TryTake(long bytes, out PoolRange run)
        {
            int pages = PagesFor(bytes), limit = BankLimit;
            run = new PoolRange { PageCount = pages };
            int unmade = -1;
            for (int bank = 0; bank < m_banks.Count && bank < limit; bank++)
            {
                if (!m_banks[bank].IsCreated)
                {
                    unmade = unmade < 0 ? bank : unmade;
                    continue;
                }
                if (TryTake(bank, ref run))
                    return true;
            }
            if (unmade < 0 && m_banks.Count < limit)
            {
                unmade = m_banks.Count;
                m_banks.Add(default);
            }
            if (unmade >= 0 && pages <= m_pagesPerBank)
            {
                CreateBank(unmade);
                m_banks[unmade] = new RangeAllocator(m_pagesPerBank, Allocator.Persistent);
                AllocatedBytes += BankBytes;
                return TryTake(unmade, ref run);
            }
            run = default;
            return false;
        }

        /// <summary>Takes a run back, and frees its bank where that is empty and beyond the limit.</summary>
        public void Give(PoolRange run)
        {
            var heap = m_banks[run.Bank];
            heap.Give(run.FirstPage);
            m_banks[run.Bank] = heap;
            UsedBytes -= (long)run.PageCount * PageBytes;
            if (heap.UsedSlots == 0 && run.Bank >= BankLimit)
                Free(run.Bank);
        }

        /// <summary>Keeps as much of a run as so many bytes need, and takes the rest back.</summary>
        /// <returns>Whether the run is long enough.</returns>
        public bool TryShorten(ref PoolRange run, long bytes)
        {
            int pages = PagesFor(bytes);
            if (pages > run.PageCount)
                return false;
            var heap = m_banks[run.Bank];
            heap.Shorten(run.FirstPage, pages);
            m_banks[run.Bank] = heap;
            UsedBytes -= (long)(run.PageCount - pages) * PageBytes;
            run.PageCount = pages;
            return true;
        }

        /// <summary>Frees banks that nothing lies in and that are beyond the limit.</summary>
        public void FreeEmptyBanks()
        {
            for (int bank = BankLimit; bank < m_banks.Count; bank++)
                if (m_banks[bank].IsCreated && m_banks[bank].UsedSlots == 0)
                    Free(bank);
        }

        /// <summary>Once a frame, before all else.</summary>
        public virtual void BeginFrame()
        {
        }

        /// <summary>Begins the one upload that may be under way, if there is memory to write to. It takes one node at
        /// least.</summary>
        public virtual bool TryBeginUpload() => true;

        /// <summary>Where the upload's job writes what is to lie in a run: front to back, and never reads. Null where the upload
        /// has no more room.</summary>
        /// <param name="bytes">A multiple of 16.</param>
        public abstract byte* AddressForUpload(PoolRange run, long bytes);

        /// <summary>The upload's job is complete: from now on its nodes can be drawn.</summary>
        public virtual void EndUpload()
        {
        }

        public virtual void Dispose()
        {
            for (int bank = 0; bank < m_banks.Count; bank++)
                if (m_banks[bank].IsCreated)
                    Free(bank);
        }

        /// <summary>What is wrong with the books, or null.</summary>
        public string FindProblem()
        {
            long used = 0;
            for (int bank = 0; bank < m_banks.Count; bank++)
            {
                if (!m_banks[bank].IsCreated)
                    continue;
                used += (long)m_banks[bank].UsedSlots * PageBytes;
                if (m_banks[bank].FindProblem() is string problem)
                    return "bank " + bank + ": " + problem;
            }
            return used == UsedBytes ? null : "counted " + used + " bytes in use, wanted " + UsedBytes;
        }

        protected abstract void CreateBank(int bank);

        protected abstract void DisposeBank(int bank);

        bool TryTake(int bank, ref PoolRange run)
        {
            var heap = m_banks[bank];
            run.Bank = bank;
            run.FirstPage = heap.Take(run.PageCount);
            m_banks[bank] = heap;
            if (run.FirstPage < 0)
                return false;
            UsedBytes += (long)run.PageCount * PageBytes;
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

    /// <summary>A piece of a <see cref="NodePool"/>: pages that follow one another in one bank.</summary>
    public struct PoolRange
    {
        public int Bank;
        public int FirstPage;
        public int PageCount;

        public bool IsNone => PageCount == 0;
    }
}
