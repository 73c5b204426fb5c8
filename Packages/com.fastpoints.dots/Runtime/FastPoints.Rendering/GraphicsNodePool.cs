using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>A pool in graphics memory: a buffer for each bank, which shaders read in place. A compute shader copies into
    /// it.</summary>
    public sealed unsafe class GraphicsNodePool : NodePool
    {
        /// <summary>Half a bank is empty on average: clouds of a million points and more take at most 10 bytes a point.</summary>
        public const int DefaultBankBytes = 8 << 20;
        const int MaxUploadBytes = 64 << 20; // Capacity of staging, independent of the limit of a frame.
        const int VertexBuffers = 2; // A bank and ListBuffer.

        readonly StagingRing m_upload;
        readonly List<GraphicsBuffer> m_buffers = new List<GraphicsBuffer>();
        long m_frame;
        bool m_isDrawn;

        /// <summary>The limit is that of the banks; upload buffers come on top. No node may be larger than a bank.</summary>
        public GraphicsNodePool(ComputeShader copyPages, long limitBytes, int bankBytes = DefaultBankBytes)
            : base(limitBytes, (int)math.min(bankBytes, math.min(MaxBankBytes, SystemInfo.maxGraphicsBufferSize)))
        {
            m_upload = new StagingRing(copyPages);
        }

        /// <summary>Why this device can neither keep nor draw points; null if it can.</summary>
        public static string UnsupportedReason =>
            !SystemInfo.supportsComputeShaders ? SystemInfo.graphicsDeviceType + " has no compute shaders here"
            : SystemInfo.maxComputeBufferInputsVertex < VertexBuffers
                ? SystemInfo.graphicsDeviceType + " gives vertex shaders fewer than two storage buffers here" : null;

        /// <summary>The bank's raw buffer; null if the bank does not exist.</summary>
        public GraphicsBuffer BufferOf(int bank) => m_buffers[bank];

        /// <summary>Counts only frames that drew a picture: without one, the GPU need not have run the uploads.</summary>
        public override void BeginFrame()
        {
            m_frame += m_isDrawn ? 1 : 0;
            m_isDrawn = false;
        }

        internal void BeginPicture() => m_isDrawn = true;

        public override bool TryBeginUpload(int maxBytes) =>
            m_upload.TryBegin(m_frame, PagesFor(math.clamp(maxBytes, PageBytes, MaxUploadBytes)));

        public override byte* ReserveForUpload(PoolRange range, long bytes) => m_upload.Reserve(range);

        public override void EndUpload() => m_upload.End(m_buffers, m_frame);

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
}
