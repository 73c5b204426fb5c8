using System;
using FastPoints.Core;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Reading
{
    /// <summary>One slot of a reader: at most one range in flight. <see cref="Begin"/> starts the read and schedules the decoding
    /// behind it; jobs of the caller may depend on <see cref="Decoded"/>; <see cref="Complete"/> ends it on the main
    /// thread.</summary>
    /// <remarks>A slot's reader decides on its memory, which is reused from range to range without allocation.</remarks>
    public abstract class BlockRead : IDisposable
    {
        /// <summary>The decoded columns. <c>Count</c> is set by <see cref="Complete"/>; jobs use <see cref="Result"/>.</summary>
        public PointBatch Points { get; protected set; }

        /// <summary>The decoding job's result: jobs that depend on <see cref="Decoded"/> can read it.</summary>
        public NativeReference<DecodeResult> Result { get; protected set; }

        /// <summary>The range in flight or last completed.</summary>
        public BlockRange Range { get; protected set; }

        /// <summary>Index of the range's first point in the whole source.</summary>
        public long FirstPoint { get; protected set; }

        /// <summary>Completes when the columns are filled.</summary>
        public JobHandle Decoded { get; protected set; }

        // Slots that are ahead then keep no more workers busy.
        internal JobHandle Dependency { get; set; }

        /// <summary>Starts reading; the slot must be idle. Main thread only; returns at once.</summary>
        public abstract void Begin(BlockRange range);

        /// <summary>Requests <see cref="KeepState"/>, before the first range. False if the format has no state to continue from,
        /// or any range costs only what it holds.</summary>
        public virtual bool TryKeepStates() => false;

        // After the last completed range, which must have been complete. The memory of a state in "reused" may be taken.
        internal virtual DecoderState KeepState(DecoderState reused) => throw new NotSupportedException();

        // Directly after the range whose state was kept (null if none was): nothing is decoded twice. The caller owns the state.
        internal virtual void Begin(BlockRange range, DecoderState from) => throw new NotSupportedException();

        /// <summary>Waits for the decoding if necessary (poll <c>Decoded.IsCompleted</c> to avoid that), and closes the
        /// range.</summary>
        /// <exception cref="Base.PointCloudException">The read or the decoding failed.</exception>
        public abstract void Complete();

        /// <summary>Cancels what is in flight, waits for it and frees the memory. May be called twice.</summary>
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

    /// <summary>How the decoding of one range ended. The decoding job writes it; the main thread turns it into an
    /// exception.</summary>
    public struct DecodeResult
    {
        /// <summary>Points in the batch; fewer than requested if the input broke off.</summary>
        public int Points;

        /// <summary>0, or the error: a code of the reader's own.</summary>
        public int Error;

        /// <summary>Offset of the error in the file.</summary>
        public long ErrorOffset;
    }

    // Decoding continues from it in any slot with the same reader and attributes. Who requested it disposes it.
    internal abstract class DecoderState : IDisposable
    {
        public abstract long Bytes { get; }

        public abstract void Dispose();
    }
}
