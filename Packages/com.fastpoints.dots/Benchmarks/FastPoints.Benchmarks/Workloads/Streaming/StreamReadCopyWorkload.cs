using System.IO;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>What of uploads is not ours: the same files read in pieces of a megabyte and copied once, on one
    /// thread.</summary>
    public sealed unsafe class StreamReadCopyWorkload : IWorkload
    {
        string[] m_files;
        byte[] m_piece;
        NativeArray<byte> m_to;

        public string Name => "stream read and copy";
        public string LimitName => "stream memory copy";

        public void Prepare(WorkloadContext context)
        {
            m_files = Directory.GetFiles(TerrainBenchmarkFile.MakeConverted(context), "*.bin", SearchOption.AllDirectories);
            m_piece = new byte[1 << 20];
            long bytes = 0;
            foreach (string file in m_files)
                bytes += new FileInfo(file).Length;
            m_to = new NativeArray<byte>(checked((int)bytes), Allocator.Persistent);
            Run();
        }

        public WorkloadResult Run()
        {
            long at = 0;
            foreach (string file in m_files)
            {
                using var stream = new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.Read, 1);
                for (int got; (got = stream.Read(m_piece, 0, m_piece.Length)) > 0; at += got)
                    fixed (byte* from = m_piece)
                        UnsafeUtility.MemCpy((byte*)m_to.GetUnsafePtr() + at, from, got);
            }
            return new WorkloadResult { Bytes = at };
        }

        public void Dispose()
        {
            if (m_to.IsCreated)
                m_to.Dispose();
        }
    }
}
