using System;
using System.Collections.Generic;
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

        internal JobHandle Dependency { get; set; } // Slots further ahead then occupy no more workers.

        // What the range that begins next needs of remote files. The slot owns it from then on.
        internal RemoteFetch Fetched { get; set; }

        internal RemoteFetch TakeFetched()
        {
            var fetched = Fetched;
            Fetched = null;
            return fetched;
        }

        /// <summary>Starts reading; the slot must be idle. Main thread only; returns at once.</summary>
        public abstract void Begin(BlockRange range);

        /// <summary>Requests <see cref="KeepState"/>, before the first range. False if the format has no state to continue from,
        /// or the cost of a range depends only on its own points.</summary>
        public virtual bool TryEnableStates() => false;

        // After the last completed range, which must have been complete. The memory of a state in "reused" may be taken.
        internal virtual DecoderState KeepState(DecoderState reused) => throw new NotSupportedException();

        // Directly after the range whose state was kept (null if none was): no point is decoded twice. The caller owns the state.
        internal virtual void Begin(BlockRange range, DecoderState from) => throw new NotSupportedException();

        /// <summary>Waits for the decoding if necessary (poll <c>Decoded.IsCompleted</c> to avoid that), and closes the
        /// range.</summary>
        /// <exception cref="PointCloudException">The read or the decoding failed.</exception>
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
        internal ulong ActualHash; // The actual hash, if another was expected.
    }

    // Decoding continues from it in any slot with the same reader and attributes. Who requested it disposes it.
    internal abstract class DecoderState : IDisposable
    {
        public abstract long Bytes { get; }

        public abstract void Dispose();
    }

    abstract class OwningBlockRead : BlockRead
    {
        readonly PointReader m_reader;
        readonly List<IDisposable> m_owned = new List<IDisposable>();
        NativeReference<DecodeResult> m_result;
        bool m_isDisposed;

        protected OwningBlockRead(PointReader reader, PointSchema wanted, int capacity, Allocator allocator)
        {
            foreach (var attribute in wanted)
            {
                int index = reader.Info.Schema.IndexOf(attribute.Name);
                if (index < 0 || reader.Info.Schema[index].Type != attribute.Type)
                    throw new ArgumentException("the source has no attribute " + attribute, nameof(wanted));
            }
            m_reader = reader;
            Points = Own(new PointBatch(wanted, capacity, allocator));
            Result = m_result = Own(new NativeReference<DecodeResult>(allocator));
        }

        protected bool IsBusy { get; private set; }

        // The range is not empty.
        protected abstract JobHandle Schedule(BlockRange range);

        protected JobHandle DependencyOf(JobHandle read) =>
            Dependency.Equals(default) ? read : JobHandle.CombineDependencies(read, Dependency);

        protected virtual void EndRead() => FileRead.End();

        protected virtual void Warn(DecodeResult result) { }

        protected virtual void Cancel() { }

        // Ends and frees what is not owned. Also called if the constructor failed half-way.
        protected virtual void DisposeMore() { }

        protected NativeFileRead FileRead { get; private set; } // The slot's read, if there is only one.

        protected NativeFileRead OwnFile(long capacityBytes, Allocator allocator, int segments = 1) =>
            FileRead = Own(new NativeFileRead(capacityBytes, allocator, segments));

        // Freed with the slot, in reverse order.
        protected T Own<T>(T memory) where T : IDisposable
        {
            m_owned.Add(memory);
            return memory;
        }

        protected NativeArray<T> OwnArray<T>(int length, Allocator allocator,
            NativeArrayOptions options = NativeArrayOptions.UninitializedMemory) where T : unmanaged =>
            Own(new NativeArray<T>(length, allocator, options));

        public sealed override void Begin(BlockRange range)
        {
            if (IsBusy)
                throw new InvalidOperationException(SlotRing.InFlight);
            if (range.Block < 0 || range.Block >= m_reader.BlockCount)
                throw new ArgumentOutOfRangeException(nameof(range), range.Block, "no such block");
            int points = m_reader.PointsInBlock(range.Block);
            if (range.First < 0 || range.Count < 0 || range.First > points - range.Count || range.Count > Points.Capacity)
                throw new ArgumentOutOfRangeException(nameof(range), "wanted points " + range.First + " + " + range.Count +
                    " of " + points + ", capacity " + Points.Capacity);
            Range = range;
            FirstPoint = m_reader.FirstPointOfBlock(range.Block) + range.First;
            Points.Count = 0;
            m_result.Value = default;
            Result = m_result;
            if (FileRead != null)
                FileRead.Fetched = TakeFetched();
            Decoded = range.Count == 0 ? default : Schedule(range);
            IsBusy = true;
        }

        public sealed override void Complete()
        {
            if (!IsBusy)
                throw new InvalidOperationException(SlotRing.NotInFlight);
            IsBusy = false;
            Decoded.Complete();
            if (Range.Count == 0)
                return;
            EndRead();
            Points.Count = Math.Min(Result.Value.Points, Range.Count);
            Warn(Result.Value);
        }

        public sealed override void Dispose()
        {
            if (m_isDisposed)
                return;
            m_isDisposed = true;
            Fetched?.Dispose();
            if (IsBusy)
                Cancel();
            IsBusy = false;
            Decoded.Complete();
            DisposeMore();
            for (int i = m_owned.Count - 1; i >= 0; i--)
                m_owned[i].Dispose();
        }
    }
}
