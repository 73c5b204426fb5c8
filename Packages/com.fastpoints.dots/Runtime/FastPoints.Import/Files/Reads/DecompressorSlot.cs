using System;
using System.Runtime.InteropServices;

namespace FastPoints.Files
{
    /// <summary>A decompressor that jobs can find by a number.</summary>
    sealed class DecompressorSlot : IDisposable
    {
        GCHandle m_handle;

        public DecompressorSlot(StreamDecompressor decompressor)
        {
            Decompressor = decompressor;
            m_handle = GCHandle.Alloc(this);
        }

        public StreamDecompressor Decompressor { get; }

        /// <summary>What the decompressor threw, or null.</summary>
        public Exception Failure { get; set; }

        public long Handle => (long)GCHandle.ToIntPtr(m_handle);

        /// <summary>The jobs that use it must be complete.</summary>
        public void Dispose()
        {
            if (!m_handle.IsAllocated)
                return;
            m_handle.Free();
            Decompressor.Dispose();
        }
    }
}
