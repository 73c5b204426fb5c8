using System.Collections.Generic;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Streaming
{
    /// <summary>A pool in ordinary memory, for software pictures.</summary>
    public sealed unsafe class MemoryNodePool : NodePool
    {
        readonly List<NativeArray<byte>> m_memory = new List<NativeArray<byte>>();

        public MemoryNodePool(long limitBytes, int bankBytes = 16 << 20) : base(limitBytes, bankBytes) { }

        /// <summary>The address of a range's bytes.</summary>
        public byte* AddressOf(PoolRange run) =>
            (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(m_memory[run.Bank]) +
            (long)run.FirstPage * PageBytes;

        public override byte* AddressForUpload(PoolRange run, long bytes) => AddressOf(run);

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
