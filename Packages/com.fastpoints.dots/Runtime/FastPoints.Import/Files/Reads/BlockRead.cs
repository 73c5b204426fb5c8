using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>
    /// One slot of a reader: at most one range in flight. <see cref="Begin"/> starts the read and schedules the decoding behind
    /// it; jobs of the caller may depend on <see cref="Decoded"/>; <see cref="Complete"/> ends it on the main thread.
    /// </summary>
    /// <remarks>A slot's memory is its reader's business; it is reused from range to range without allocation.</remarks>
    public abstract class BlockRead : IDisposable
    {
        /// <summary>The decoded columns. <c>Count</c> is set by <see cref="Complete"/>; jobs use <see cref="Result"/>.</summary>
        public PointBatch Points { get; protected set; }

        /// <summary>What the decoding job says: readable by jobs that depend on <see cref="Decoded"/>.</summary>
        public NativeReference<DecodeResult> Result { get; protected set; }

        /// <summary>The range in flight or last completed.</summary>
        public BlockRange Range { get; protected set; }

        /// <summary>Index, over the whole source, of the range's first point.</summary>
        public long FirstPoint { get; protected set; }

        /// <summary>Finished when the columns are there.</summary>
        public JobHandle Decoded { get; protected set; }

        /// <summary>Starts reading; the slot must be idle. Main thread only; returns at once.</summary>
        public abstract void Begin(BlockRange range);

        /// <summary>Asks for <see cref="KeepState"/>, before the first range. False where the format has no state to go on from,
        /// or any range costs only what it holds.</summary>
        public virtual bool TryKeepStates() => false;

        /// <summary>Where the decoding stands behind the range that was completed last, all of which was there: for the next
        /// range of its block.</summary>
        /// <param name="reused">One that is not needed any more, whose memory it may take; or null.</param>
        public virtual DecoderState KeepState(DecoderState reused) => throw new NotSupportedException();

        /// <summary>Starts reading a range that follows directly on the one whose state was kept: nothing is decoded
        /// twice.</summary>
        /// <param name="from">Stays the caller's; null where nothing was kept.</param>
        public virtual void Begin(BlockRange range, DecoderState from) => throw new NotSupportedException();

        /// <summary>Waits for the decoding if need be (poll <c>Decoded.IsCompleted</c> not to), and closes the range.</summary>
        /// <exception cref="Base.PointCloudException">The read or the decoding failed.</exception>
        public abstract void Complete();

        /// <summary>Cancels what is in flight, waits for it, frees the memory. May run twice.</summary>
        public abstract void Dispose();
    }
}
