using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>A pool in the memory of the graphics card: a buffer for each bank, which shaders draw from as it lies there.
    /// Uploads go through mapped staging buffers and are copied into their pages by a compute shader.</summary>
    public sealed unsafe class GraphicsNodePool : NodePool
    {
        /// <summary>On average half a bank lies empty: no more than 10 bytes are taken for a point from a million points
        /// on.</summary>
        public const int DefaultBankBytes = 8 << 20;

        readonly PoolUpload m_upload;
        readonly List<GraphicsBuffer> m_buffers = new List<GraphicsBuffer>();
        long m_frame;

        /// <param name="copyPages">The package's CopyPages.compute; null, or where there is no compute: the engine copies
        /// nodes.</param>
        /// <param name="limitBytes">Of the banks; what uploads go through (<see cref="UploadBytes"/>) comes to that.</param>
        /// <param name="bankBytes">No node may be larger.</param>
        /// <param name="bytesPerUpload">What one frame uploads, usually.</param>
        public GraphicsNodePool(ComputeShader copyPages, long limitBytes, int bankBytes = DefaultBankBytes, int bytesPerUpload = 4 << 20)
            : base(limitBytes, (int)math.min(bankBytes, math.min(LargestBankBytes, SystemInfo.maxGraphicsBufferSize)))
        {
            int pages = PagesFor(bytesPerUpload);
            bool hasCompute = copyPages != null && SystemInfo.supportsComputeShaders;
            m_upload = hasCompute ? new StagingRing(copyPages, pages) : (PoolUpload)new DirectUpload(pages);
        }

        public int BankCount => m_buffers.Count;

        /// <summary>Of the buffers that uploads go through.</summary>
        public long UploadBytes => m_upload.AllocatedBytes;

        /// <summary>Raw; null where a bank is not there.</summary>
        public GraphicsBuffer BufferOf(int bank) => m_buffers[bank];

        public override void BeginFrame() => m_frame++;

        public override bool TryBeginUpload() => m_upload.TryBegin(m_frame);

        public override byte* AddressForUpload(PoolRange run, long bytes) => m_upload.Take(run);

        public override void EndUpload() => m_upload.End(this, m_frame);

        public override void Dispose()
        {
            base.Dispose();
            m_upload.Dispose();
        }

        protected override void CreateBank(int bank)
        {
            while (m_buffers.Count <= bank)
                m_buffers.Add(null);
            m_buffers[bank] = new GraphicsBuffer(GraphicsBuffer.Target.Raw, BankBytes / sizeof(uint), sizeof(uint));
        }

        protected override void DisposeBank(int bank)
        {
            m_buffers[bank].Dispose();
            m_buffers[bank] = null;
        }
    }

    /// <summary>How nodes get from jobs into a <see cref="GraphicsNodePool"/>: one upload at a time. Main thread.</summary>
    internal abstract unsafe class PoolUpload : IDisposable
    {
        /// <summary>Of its own memory.</summary>
        public abstract long AllocatedBytes { get; }

        /// <returns>Whether there is memory to write to in this frame.</returns>
        public abstract bool TryBegin(long frame);

        /// <summary>Room for one more node, or null. The first always has room.</summary>
        public abstract byte* Take(PoolRange run);

        /// <summary>All is written: what is drawn from now on finds it in the pool.</summary>
        public abstract void End(GraphicsNodePool pool, long frame);

        public abstract void Dispose();
    }
}
