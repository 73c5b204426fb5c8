using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.E57
{
    // A chain of these turns a buffer of pages into one of content: it moves content over the checksums of earlier pages.
    [BurstCompile]
    unsafe struct CheckE57PagesJob : IJob
    {
        // About 1 ms.
        public const int SlicePages = 1024;

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
}
