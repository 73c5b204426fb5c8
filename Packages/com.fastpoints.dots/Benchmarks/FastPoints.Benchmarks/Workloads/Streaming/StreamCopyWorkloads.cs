using System;
using System.IO;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>The bound of uploads: pieces of a node's size are copied on one thread, from memory that no cache
    /// holds.</summary>
    public unsafe struct StreamMemoryCopyWorkload : IWorkload
    {
        const int PieceBytes = 64 << 10;

        NativeArray<byte> m_from, m_to;

        public string Name => "stream memory copy";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            // What position and colour of the points take, about.
            int bytes = (int)Math.Max(PieceBytes, Math.Min(1 << 30, context.Points * 7L)) / PieceBytes * PieceBytes;
            m_from = new NativeArray<byte>(bytes, Allocator.Persistent);
            m_to = new NativeArray<byte>(bytes, Allocator.Persistent);
            Run();
        }

        public WorkloadResult Run()
        {
            var from = (byte*)m_from.GetUnsafeReadOnlyPtr();
            var to = (byte*)m_to.GetUnsafePtr();
            for (int at = 0; at < m_from.Length; at += PieceBytes)
                UnsafeUtility.MemCpy(to + at, from + at, PieceBytes);
            return new WorkloadResult { Bytes = m_from.Length };
        }

        public void Dispose()
        {
            if (!m_from.IsCreated)
                return;
            m_from.Dispose();
            m_to.Dispose();
        }
    }

    /// <summary>The part of uploads outside our code: the same files read in pieces of a megabyte and copied once, on one
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
