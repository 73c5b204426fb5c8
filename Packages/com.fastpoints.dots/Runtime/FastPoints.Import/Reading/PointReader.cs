using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Import;
using FastPoints.Las;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Reading
{
    /// <summary>An open source of points: its description, and its natural blocks (LAZ chunks, COPC and Potree nodes, ranges of a
    /// fixed-stride file), which can be read in any order, several at once.</summary>
    /// <remarks>All members belong to the main thread, but any thread may open a reader (<see cref="PointReaders"/>). Reading
    /// happens through <see cref="BlockRead"/> slots: the reader makes as many as the caller wants in flight, and these slots
    /// hold all of its memory, whatever the file's size. Dispose the slots before the reader.</remarks>
    public abstract class PointReader : IDisposable
    {
        public SourceInfo Info { get; protected set; }

        /// <summary>Whether the blocks and their point counts are known from the header. If not, call <see cref="FindBlocks"/>
        /// before using any of the following members.</summary>
        public virtual bool BlocksAreKnown => true;

        /// <summary>The most jobs that <see cref="FindBlocks"/> has in flight; 0 for as many as keep all workers busy.</summary>
        public int MaxJobs { get; set; }

        /// <summary>Coroutine that finds the blocks in one pass over the file: line starts of an ascii file, a lost chunk
        /// table.</summary>
        public virtual IEnumerator<JobStep> FindBlocks()
        {
            yield break;
        }

        /// <summary>Whether <see cref="FindPrefixes()"/> finds something to read long before <see cref="FindBlocks"/>
        /// does.</summary>
        public virtual bool HasPrefixes => false;

        /// <summary>Coroutine, of bounded time, that finds what can be read without a pass over the file. Afterwards these
        /// are the blocks, although <see cref="BlocksAreKnown"/> is false, until <see cref="FindBlocks"/> replaces them with all
        /// blocks while there are no slots.</summary>
        public virtual IEnumerator<JobStep> FindPrefixes() => FindBlocks();

        /// <summary>Whether <see cref="FindPrefixes()"/> finds points spread over the whole source, each as likely as any other,
        /// instead of its beginning.</summary>
        public virtual bool PrefixesAreSpread => false;

        /// <summary>If they are spread, the number of places to examine.</summary>
        public virtual int MaxPrefixes => 0;

        /// <summary>Like <see cref="FindPrefixes()"/>, up to a number of examined places; call it again for more. The blocks come
        /// in an order of which every beginning is spread over the source, and earlier ones keep their numbers.</summary>
        public virtual IEnumerator<JobStep> FindPrefixes(int places) => FindPrefixes();

        /// <summary>Points of the whole source, after <see cref="FindPrefixes()"/>.</summary>
        internal virtual PointEstimate EstimatedPoints => new PointEstimate(Info.PointsClaimed, 0);

        internal virtual SourceTree Tree => null;

        /// <summary>Coroutine that reads only those pages of <see cref="Tree"/> that its first levels need: afterwards the
        /// blocks of these levels can be read although <see cref="BlocksAreKnown"/> is false.</summary>
        public IEnumerator<JobStep> FindLevels(int levels) => FindBelow(default, levels);

        /// <summary>The same for one node and what is below it. Never opens or reads a file on the main thread.</summary>
        /// <param name="node">Its <see cref="SourceNode.Key"/>.</param>
        /// <param name="levels">Levels of the tree, counted from its root.</param>
        public virtual IEnumerator<JobStep> FindBelow(int4 node, int levels) => FindBlocks();

        /// <summary>Whether <see cref="FindBelow"/> has nothing to read.</summary>
        public virtual bool IsKnownBelow(int4 node, int levels) => BlocksAreKnown;

        /// <summary>What a LAS or LAZ file has beside its points; null for other sources.</summary>
        internal virtual LasFile Las => null;

        public abstract int BlockCount { get; }

        /// <summary>Points of the largest block, which is the capacity of a slot.</summary>
        public abstract int MaxPointsPerBlock { get; }

        /// <summary>Index of a block's first point in the whole source.</summary>
        public abstract long FirstPointOfBlock(int block);

        public abstract int PointsInBlock(int block);

        /// <summary>Grows from block to block in the order of the source, in whatever order they were found.</summary>
        public virtual long PlaceOfBlock(int block) => block;

        /// <summary>The location of a block, for messages.</summary>
        /// <param name="byteOffset">The byte at which it begins; -1 if unknown.</param>
        public virtual string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = -1;
            return Info.Path;
        }

        /// <summary>Bytes of the file that reading a range takes (an estimate if the format does not say).</summary>
        public abstract long BytesOfRange(BlockRange range);

        /// <summary>Whether a range costs what it holds, wherever it lies in its block. Otherwise only prefixes are
        /// cheap.</summary>
        public virtual bool HasFixedStride => false;

        /// <summary>Points of all blocks together.</summary>
        public long PointCount => BlockCount == 0 ? 0 : FirstPointOfBlock(BlockCount - 1) + PointsInBlock(BlockCount - 1);

        /// <summary>Creates a reusable slot that decodes these attributes (a selection of <see cref="SourceInfo.Schema"/>) and no
        /// others.</summary>
        /// <param name="wanted">The batch's columns; each must be in the source's schema.</param>
        /// <param name="capacity">Points of the largest range that the slot will read.</param>
        /// <param name="allocator">The allocator of the slot's memory.</param>
        public abstract BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator);

        /// <summary>Bytes that a slot takes beside its columns and what it reads of the file.</summary>
        internal virtual long DecoderBytes => 0;

        /// <summary>Closes the file's handle if possible, and keeps everything that was found; the next slot opens it again.
        /// There must be no slots at this time.</summary>
        public virtual void CloseFile() { }

        /// <summary>Whether <see cref="CreateRunRead"/> is available: sources of a fixed stride have it.</summary>
        public virtual bool HasRunReads => false;

        /// <summary>Creates a reusable slot that reads scattered runs into places of <paramref name="target"/>.</summary>
        /// <param name="target">Its schema is a selection of <see cref="SourceInfo.Schema"/>.</param>
        /// <param name="maxRuns">The most runs in one request.</param>
        /// <param name="maxBytes">The most bytes of the file in one request, at least those of the longest run.</param>
        internal virtual RunRead CreateRunRead(PointBatch target, int maxRuns, int maxBytes, Allocator allocator) =>
            throw new NotSupportedException();

        /// <summary>Coroutine: reads ranges of points, in the file's order, into a batch, one behind the other. Of sources
        /// that have run reads.</summary>
        /// <param name="first">The first of the ranges that is read.</param>
        /// <param name="then">Schedules jobs that need all ranges, behind those that are given; they are complete in the
        /// end.</param>
        internal IEnumerator<JobStep> ReadRuns(IReadOnlyList<BlockRange> ranges, int first, int count, PointBatch target,
            Func<JobHandle, JobHandle> then)
        {
            const int Slots = 8, RunsPerRequest = 256, BytesPerRequest = 2 << 20;
            var runs = new NativeArray<PointRun>(count, Allocator.Persistent);
            var reads = new RunRead[Slots];
            var ring = new SlotRing(Slots);
            var behind = default(JobHandle);
            try
            {
                int place = 0, longest = 1;
                for (int i = 0; i < count; i++)
                {
                    var range = ranges[first + i];
                    long from = FirstPointOfBlock(range.Block) + range.First;
                    runs[i] = new PointRun { First = from, Step = 1, Count = range.Count, Place = place };
                    place += range.Count;
                    longest = Math.Max(longest, range.Count);
                }
                if (count == 0)
                    behind = then(default);
                for (int next = 0; next < count || !ring.IsEmpty;)
                {
                    if (next == count || ring.IsFull)
                    {
                        yield return reads[ring.Oldest].Decoded;
                        reads[ring.End()].Complete();
                        continue;
                    }
                    int slot = ring.Begin();
                    reads[slot] ??= CreateRunRead(target, RunsPerRequest,
                        Math.Max(BytesPerRequest, longest * Info.RecordBytes), Allocator.Persistent);
                    next += reads[slot].Begin(runs, next, RunsPerRequest, 0);
                    behind = JobHandle.CombineDependencies(behind, reads[slot].Decoded);
                    if (next == count)
                        behind = then(behind);
                    JobHandle.ScheduleBatchedJobs();
                    // The coroutine checks its budget.
                    yield return default;
                }
                yield return behind;
            }
            finally
            {
                behind.Complete();
                foreach (var read in reads)
                    read?.Dispose();
                runs.Dispose();
            }
        }

        public void Dispose()
        {
            CloseFile();
            DisposeUnread();
        }

        /// <summary>Disposes a reader without slots or work on any thread, as it may be opened on any: it has no file handle yet,
        /// and these belong to the main thread.</summary>
        public virtual void DisposeUnread() { }
    }

    /// <summary>The number of points, as far as a sample shows.</summary>
    internal readonly struct PointEstimate
    {
        public readonly double Points;

        /// <summary>0 if they were counted, or the source says so.</summary>
        public readonly double StandardError;

        public PointEstimate(double points, double standardError)
        {
            Points = points;
            StandardError = standardError;
        }
    }
}
