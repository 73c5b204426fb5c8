using System;
using System.Collections.Generic;
using FastPoints.Streaming;
using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>Moves nodes from jobs into the banks of a pool on the card, one upload at a time. Main thread.</summary>
    internal abstract unsafe class PoolUpload : IDisposable
    {
        /// <summary>Bytes of its own memory.</summary>
        public abstract long AllocatedBytes { get; }

        /// <returns>Whether this frame has memory to write to.</returns>
        public abstract bool TryBegin(long frame);

        /// <summary>Room for one more node, or null. The first always has room.</summary>
        public abstract byte* Take(PoolRange run);

        /// <summary>Ends the upload after everything is written: later draws find it in the pool.</summary>
        /// <param name="banks">The pool's buffers.</param>
        public abstract void End(List<GraphicsBuffer> banks, long frame);

        public abstract void Dispose();
    }
}
