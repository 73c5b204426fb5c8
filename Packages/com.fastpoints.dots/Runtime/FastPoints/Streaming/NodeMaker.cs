using System;

namespace FastPoints.Streaming
{
    /// <summary>
    /// Makes nodes of a source in whose files they do not lie packed, one at a time: a read, then jobs that decode and pack, in
    /// memory that is used again from node to node. Main thread; only <see cref="Dispose"/> waits.
    /// </summary>
    public abstract unsafe class NodeMaker : IDisposable
    {
        /// <summary>Whether what was begun last has come to its end.</summary>
        public abstract bool IsDone { get; }

        /// <summary>Of files, of the node that was made last.</summary>
        public abstract long BytesRead { get; }

        /// <summary>The planes of <see cref="NodeSource.Planes"/>, one behind the other, until the next node begins.</summary>
        public abstract byte* Planes { get; }

        /// <summary>Begins with a node; the one before has ended.</summary>
        public abstract void Begin(in HierarchyPage page, int node);

        /// <summary>Ends what is done.</summary>
        /// <param name="failure">What is wrong, where the outcome is not <see cref="MakeOutcome.Made"/>.</param>
        public abstract MakeOutcome End(out StreamFailure failure);

        /// <param name="plane">Counted among those that are streamed.</param>
        public abstract long LengthOf(int plane);

        /// <summary>Calls off what is under way, and awaits it.</summary>
        public abstract void Dispose();
    }
}
