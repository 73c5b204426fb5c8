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
        internal virtual DecoderState KeepState(DecoderState reused) => throw new NotSupportedException();

        /// <summary>Starts reading a range that follows directly on the one whose state was kept: nothing is decoded
        /// twice.</summary>
        /// <param name="from">Stays the caller's; null where nothing was kept.</param>
        internal virtual void Begin(BlockRange range, DecoderState from) => throw new NotSupportedException();

        /// <summary>Waits for the decoding if need be (poll <c>Decoded.IsCompleted</c> not to), and closes the range.</summary>
        /// <exception cref="Base.PointCloudException">The read or the decoding failed.</exception>
        public abstract void Complete();

        /// <summary>Cancels what is in flight, waits for it, frees the memory. May run twice.</summary>
        public abstract void Dispose();
    }

    /// <summary>Some consecutive points of one of a source's natural blocks.</summary>
    public readonly struct BlockRange
    {
        public readonly int Block;

        /// <summary>First point, counted from the block's start.</summary>
        public readonly int First;

        public readonly int Count;

        public BlockRange(int block, int first, int count)
        {
            Block = block;
            First = first;
            Count = count;
        }
    }

    /// <summary>How the decoding of one range ended. Written by the decoding job, turned into an exception on the main
    /// thread.</summary>
    public struct DecodeResult
    {
        /// <summary>Points in the batch; fewer than asked for where the input broke off.</summary>
        public int Points;

        /// <summary>0, or what went wrong: a code of the reader's own.</summary>
        public int Error;

        /// <summary>Byte in the file at which it went wrong.</summary>
        public long ErrorOffset;
    }

    /// <summary>Where the decoding of a block stands, to go on from without its beginning: see <see cref="BlockRead.KeepState"/>.
    /// Any slot of the same reader and the same attributes may go on from it. Whoever asked for it
    /// disposes of it.</summary>
    internal abstract class DecoderState : IDisposable
    {
        /// <summary>Memory that it takes.</summary>
        public abstract long Bytes { get; }

        public abstract void Dispose();
    }
}
