using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Reading
{
    abstract class SlotRead : BlockRead
    {
        readonly PointReader m_reader;
        readonly List<IDisposable> m_owned = new List<IDisposable>();
        NativeReference<DecodeResult> m_result;
        bool m_isBusy;
        bool m_isDisposed;

        protected SlotRead(PointReader reader, PointSchema wanted, int capacity, Allocator allocator)
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

        protected bool IsBusy => m_isBusy;

        // The range is not empty.
        protected abstract JobHandle Schedule(BlockRange range);

        protected JobHandle DependencyOf(JobHandle read) =>
            Dependency.Equals(default) ? read : JobHandle.CombineDependencies(read, Dependency);

        protected virtual void EndRead() => File.End();

        protected virtual void Warn(DecodeResult result) { }

        protected virtual void Cancel() { }

        // What ends or frees besides what is owned. Also runs where the constructor failed half-way.
        protected virtual void DisposeMore() { }

        // The slot's read, if there is only one.
        protected NativeFileRead File { get; private set; }

        protected NativeFileRead OwnFile(long capacityBytes, Allocator allocator, int segments = 1) =>
            File = Own(new NativeFileRead(capacityBytes, allocator, segments));

        // Freed with the slot, what came last first.
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
            if (m_isBusy)
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
            Decoded = range.Count == 0 ? default : Schedule(range);
            m_isBusy = true;
        }

        public sealed override void Complete()
        {
            if (!m_isBusy)
                throw new InvalidOperationException(SlotRing.NotInFlight);
            m_isBusy = false;
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
            if (m_isBusy)
                Cancel();
            m_isBusy = false;
            Decoded.Complete();
            DisposeMore();
            for (int i = m_owned.Count - 1; i >= 0; i--)
                m_owned[i].Dispose();
        }
    }
}
