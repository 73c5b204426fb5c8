using System;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>Makes nodes of a source whose files do not hold them packed, one at a time: a read, then jobs that decode and
    /// pack, in memory that is reused. Main thread; only Dispose waits.</summary>
    public abstract class NodeTranscoder : IDisposable
    {
        /// <summary>The handle of what was begun last.</summary>
        public abstract JobHandle Done { get; }

        /// <summary>Bytes read from files for the node that was made last.</summary>
        public abstract long BytesRead { get; }

        /// <summary>One after the other with space at the end, valid until the next node begins.</summary>
        public abstract NativeArray<byte> Planes { get; }

        /// <summary>Begins a node; the one before must have ended.</summary>
        public abstract void Begin(in HierarchyPage page, int node);

        // For remote sources, once a frame: schedules when the bytes have arrived; true when Done covers the node's jobs.
        internal virtual bool TryScheduleDecode() => true;

        // Drops the fetch in flight; jobs that were scheduled still run.
        internal virtual void Cancel() { }

        internal abstract TranscodeResult End(out StreamFailure failure);

        // What the node that was made last has, if it is not what its page says.
        internal virtual void CorrectCounts(ref int blocks, ref int points) { }

        /// <summary>Ends a node whose work is done, or throws a <see cref="PointCloudException"/>.</summary>
        public void EndOrThrow()
        {
            var outcome = End(out var failure);
            if (outcome != TranscodeResult.Done)
                throw new PointCloudException(
                    outcome == TranscodeResult.Damaged ? FailureCode.BadInput : FailureCode.ReadFailed, failure.Path,
                    failure.OffsetBytes, failure.What);
        }

        /// <param name="plane">Index among the planes that it makes.</param>
        public abstract long LengthOf(int plane);

        /// <summary>One of Planes, by its index among those that it makes.</summary>
        public NativeArray<byte> PlaneOf(int plane)
        {
            long start = 0;
            for (int p = 0; p < plane; p++)
                start += LengthOf(p);
            return Planes.GetSubArray((int)start, (int)LengthOf(plane));
        }

        /// <summary>Cancels unfinished work and awaits it.</summary>
        public abstract void Dispose();
    }

    internal enum TranscodeResult : byte
    {
        Done,
        Damaged, // The node's bytes are wrong or missing.
        Unreadable, // The file, which also holds other nodes, cannot be read.
    }

    /// <summary>Something that could not be shown after all retries.</summary>
    public readonly struct StreamFailure
    {
        public readonly string Path;

        /// <summary>Offset in the file; -1 for the whole file.</summary>
        public readonly long OffsetBytes;
        public readonly string What;

        public StreamFailure(string path, long offsetBytes, string what) =>
            (Path, OffsetBytes, What) = (SourcePath.WithoutQuery(path), offsetBytes, what);

        public override string ToString() => Path + (OffsetBytes >= 0 ? " at " + NumberText.Of(OffsetBytes) : "") + ": " + What;
    }
}
