using FastPoints.E57;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>The checksums of an E57 file's pages, from memory, on one core. Its points are pages.</summary>
    public unsafe struct Crc32CWorkload : IWorkload
    {
        const int PageBytes = 1020, Pages = 65536;

        Crc32C m_crc;
        NativeArray<byte> m_bytes;

        public string Name => "e57 checksums";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_crc = new Crc32C(Allocator.Persistent);
            m_bytes = new NativeArray<byte>(Pages * PageBytes, Allocator.Persistent);
            var random = new Unity.Mathematics.Random(context.Seed);
            for (int i = 0; i < m_bytes.Length; i++)
                m_bytes[i] = (byte)random.NextUInt();
            Run();
        }

        public WorkloadResult Run()
        {
            var tables = (uint*)m_crc.Table.GetUnsafeReadOnlyPtr();
            var bytes = (byte*)m_bytes.GetUnsafeReadOnlyPtr();
            uint all = 0;
            for (int page = 0; page < Pages; page++)
                all ^= Crc32C.Compute(tables, bytes + (long)page * PageBytes, PageBytes);
            // Never so: the loop must not be left out for want of a use.
            return new WorkloadResult { Points = Pages, Bytes = all == 0 ? 0 : m_bytes.Length };
        }

        public void Dispose()
        {
            m_bytes.Dispose();
            m_crc.Dispose();
        }
    }
}
