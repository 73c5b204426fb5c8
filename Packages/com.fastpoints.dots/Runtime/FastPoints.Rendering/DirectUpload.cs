using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>Uploads nodes where there are no compute shaders: the engine copies each node once more.</summary>
    internal sealed unsafe class DirectUpload : PoolUpload
    {
        const int WordsPerPage = NodePool.PageBytes / sizeof(uint);

        NativeArray<uint> m_words;
        NativeList<PoolRange> m_runs;
        int m_pageCount;

        public DirectUpload(int pages)
        {
            m_words = new NativeArray<uint>(pages * WordsPerPage, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            m_runs = new NativeList<PoolRange>(256, Allocator.Persistent);
        }

        public override long AllocatedBytes => (long)m_words.Length * sizeof(uint);

        public override bool TryBegin(long frame)
        {
            m_runs.Clear();
            m_pageCount = 0;
            return true;
        }

        public override byte* Take(PoolRange run)
        {
            if ((m_pageCount + run.PageCount) * WordsPerPage > m_words.Length)
            {
                if (m_pageCount > 0)
                    return null;
                m_words.Dispose();
                m_words = new NativeArray<uint>(run.PageCount * WordsPerPage, Allocator.Persistent,
                    NativeArrayOptions.UninitializedMemory);
            }
            m_runs.Add(run);
            byte* at = (byte*)m_words.GetUnsafePtr() + (long)m_pageCount * NodePool.PageBytes;
            m_pageCount += run.PageCount;
            return at;
        }

        public override void End(List<GraphicsBuffer> banks, long frame)
        {
            int from = 0;
            for (int i = 0; i < m_runs.Length; i++)
            {
                var run = m_runs[i];
                int words = run.PageCount * WordsPerPage;
                banks[run.Bank].SetData(m_words, from, run.FirstPage * WordsPerPage, words);
                from += words;
            }
        }

        public override void Dispose()
        {
            if (!m_runs.IsCreated)
                return;
            m_words.Dispose();
            m_runs.Dispose();
        }
    }
}
