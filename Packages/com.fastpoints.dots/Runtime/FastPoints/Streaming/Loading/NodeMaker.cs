using System;
using FastPoints.Base;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>
    /// Makes nodes of a source in whose files they do not lie packed, one at a time: a read, then jobs that decode and pack, in
    /// memory that is used again from node to node. Main thread; only <see cref="Dispose"/> waits.
    /// </summary>
    public abstract class NodeMaker : IDisposable
    {
        /// <summary>What was begun last.</summary>
        public abstract JobHandle Done { get; }

        /// <summary>Of files, of the node that was made last.</summary>
        public abstract long BytesRead { get; }

        /// <summary>The planes that it makes, one behind the other and room behind them, until the next node begins.</summary>
        public abstract NativeArray<byte> Planes { get; }

        /// <summary>Begins with a node; the one before has ended.</summary>
        public abstract void Begin(in HierarchyPage page, int node);

        /// <summary>Ends what is done.</summary>
        /// <param name="failure">What is wrong, where the outcome is not <see cref="MakeOutcome.Made"/>.</param>
        internal abstract MakeOutcome End(out StreamFailure failure);

        /// <summary>Ends what is done and was begun for somebody who cannot do without.</summary>
        /// <exception cref="PointCloudException">The outcome is not <see cref="MakeOutcome.Made"/>.</exception>
        public void EndOrThrow()
        {
            var outcome = End(out var failure);
            if (outcome != MakeOutcome.Made)
                throw new PointCloudException(
                    outcome == MakeOutcome.Damaged ? FailureCode.BadInput : FailureCode.ReadFailed, failure.Path,
                    failure.OffsetBytes, failure.What);
        }

        /// <param name="plane">Counted among those that it makes.</param>
        public abstract long LengthOf(int plane);

        /// <summary>One of <see cref="Planes"/>.</summary>
        /// <param name="plane">Counted among those that it makes.</param>
        public NativeArray<byte> PlaneOf(int plane)
        {
            long start = 0;
            for (int p = 0; p < plane; p++)
                start += LengthOf(p);
            return Planes.GetSubArray((int)start, (int)LengthOf(plane));
        }

        /// <summary>Calls off what is under way, and awaits it.</summary>
        public abstract void Dispose();
    }

    /// <summary>How the making of a node ended.</summary>
    internal enum MakeOutcome : byte
    {
        Made,
        /// <summary>The node's bytes are not what they should be, or are not there.</summary>
        Damaged,
        /// <summary>The file that holds other nodes too cannot be read.</summary>
        Unreadable,
    }
}
