using System;
using FastPoints.Streaming;

namespace FastPoints.Rendering
{
    /// <summary>How nodes get from jobs into a <see cref="GraphicsNodePool"/>: one upload at a time. Main thread.</summary>
    public abstract unsafe class PoolUpload : IDisposable
    {
        /// <summary>Of its own memory.</summary>
        public abstract long AllocatedBytes { get; }

        /// <returns>Whether there is memory to write to in this frame.</returns>
        public abstract bool TryBegin(long frame);

        /// <summary>Room for one more node, or null. The first always has room.</summary>
        public abstract byte* Take(PoolRun run);

        /// <summary>All is written: what is drawn from now on finds it in the pool.</summary>
        public abstract void End(GraphicsNodePool pool, long frame);

        public abstract void Dispose();
    }
}
