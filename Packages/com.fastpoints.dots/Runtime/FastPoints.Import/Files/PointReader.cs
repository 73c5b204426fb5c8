using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>
    /// An open source of points: what it says of itself, and its natural blocks (LAZ chunks, COPC and Potree nodes, runs of a
    /// fixed-stride file), any of which can be read in any order, several at once.
    /// </summary>
    /// <remarks>
    /// All members belong to the main thread; any may open a reader (<see cref="PointReaders"/>). Reading happens through <see
    /// cref="BlockRead"/> slots: the reader makes as many as the caller wants in flight, and memory is what these slots hold,
    /// whatever the file's size. Dispose the slots before the reader.
    /// </remarks>
    public abstract class PointReader : IDisposable
    {
        public SourceInfo Info { get; protected set; }

        /// <summary>
        /// Whether the blocks and their point counts are known from the header. If not, <see cref="FindBlocks"/> comes before
        /// anything that follows.
        /// </summary>
        public virtual bool BlocksAreKnown => true;

        /// <summary>Jobs that <see cref="FindBlocks"/> has under way at once, at most; 0 for as many as keep all workers
        /// busy.</summary>
        public int MostJobs { get; set; }

        /// <summary>
        /// Work (for a pump) that finds the blocks by looking through the file once: line starts of an ascii file, a lost chunk
        /// table.
        /// </summary>
        public virtual IEnumerator<Work> FindBlocks()
        {
            yield break;
        }

        /// <summary>Whether <see cref="FindPrefixes()"/> has something to read long before <see cref="FindBlocks"/>
        /// has.</summary>
        public virtual bool HasPrefixes => false;

        /// <summary>Work (for a pump) of bounded time that finds what can be read without looking through the file: afterwards
        /// the blocks are these, although <see cref="BlocksAreKnown"/> is false, until <see cref="FindBlocks"/> takes all in
        /// their place, when there are no slots.</summary>
        public virtual IEnumerator<Work> FindPrefixes() => FindBlocks();

        /// <summary>Whether what <see cref="FindPrefixes()"/> finds lies all over the source, each point as likely as any
        /// other, and not in its beginning.</summary>
        public virtual bool PrefixesAreSpread => false;

        /// <summary>Where they are spread, how many places there are to look at.</summary>
        public virtual int MaxPrefixes => 0;

        /// <summary>As <see cref="FindPrefixes()"/>, until so many places were looked at; called again for more. The blocks
        /// come in an order of which every beginning is spread over the source, and those found before keep their
        /// numbers.</summary>
        public virtual IEnumerator<Work> FindPrefixes(int places) => FindPrefixes();

        /// <summary>Points of the whole source, after <see cref="FindPrefixes()"/>.</summary>
        public virtual PointEstimate EstimatedPoints => new PointEstimate(Info.PointsClaimed, 0);

        /// <summary>The octree that the source brings along, or null. Its blocks come level by level within each page of the
        /// hierarchy; <see cref="FindBlocks"/> reads all pages.</summary>
        internal virtual SourceTree Tree => null;

        /// <summary>Work (for a pump) that reads the pages of <see cref="Tree"/> that its first levels take, and no more:
        /// afterwards the blocks of these levels can be read although <see cref="BlocksAreKnown"/> is false.</summary>
        public IEnumerator<Work> FindLevels(int levels) => FindBelow(default, levels);

        /// <summary>The same for one node and what is below it. Never opens or reads a file on the main thread.</summary>
        /// <param name="node">Its <see cref="SourceNode.Key"/>.</param>
        /// <param name="levels">Of the tree, counted from its root.</param>
        public virtual IEnumerator<Work> FindBelow(int4 node, int levels) => FindBlocks();

        /// <summary>Whether <see cref="FindBelow"/> has nothing to read.</summary>
        public virtual bool IsKnownBelow(int4 node, int levels) => BlocksAreKnown;

        public abstract int BlockCount { get; }

        /// <summary>Points of the largest block: the capacity of a slot.</summary>
        public abstract int MaxPointsPerBlock { get; }

        /// <summary>Index, over the whole source, of a block's first point.</summary>
        public abstract long FirstPointOfBlock(int block);

        public abstract int PointsInBlock(int block);

        /// <summary>Grows from block to block as they lie in the source, in whatever order they were found.</summary>
        public virtual long PlaceOfBlock(int block) => block;

        /// <summary>Where a block lies, for messages.</summary>
        /// <param name="byteOffset">At which it begins; -1 where that is not known.</param>
        public virtual string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = -1;
            return Info.Path;
        }

        /// <summary>Bytes of the file that a range takes to read (an estimate where the format gives none).</summary>
        public abstract long BytesOfRange(BlockRange range);

        /// <summary>Whether a range costs what it holds, wherever it lies in its block. Otherwise only prefixes are
        /// cheap.</summary>
        public virtual bool HasFixedStride => false;

        /// <summary>Points of all blocks together.</summary>
        public long PointCount => BlockCount == 0 ? 0 : FirstPointOfBlock(BlockCount - 1) + PointsInBlock(BlockCount - 1);

        /// <summary>A reusable slot that decodes these attributes (a selection of <see cref="SourceInfo.Schema"/>) and leaves the
        /// others out.</summary>
        /// <param name="wanted">The batch's columns; each must be in the source's schema.</param>
        /// <param name="capacity">Points of the largest range that will be asked of the slot.</param>
        /// <param name="allocator">Of the slot's memory.</param>
        public abstract BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator);

        /// <summary>Gives the file's handle back, where that is possible, and keeps all that was found; the next slot takes it
        /// again. There are no slots at this time.</summary>
        public virtual void CloseFile()
        {
        }

        /// <summary>Whether <see cref="CreateRunRead"/> is there: sources of a fixed stride have it.</summary>
        public virtual bool HasRunReads => false;

        /// <summary>A reusable slot that brings scattered runs into places of <paramref name="target"/>.</summary>
        /// <param name="target">Its schema is a selection of <see cref="SourceInfo.Schema"/>.</param>
        /// <param name="maxRuns">Runs of one request.</param>
        /// <param name="maxBytes">Bytes of the file in one request, at least those of the longest run.</param>
        public virtual RunRead CreateRunRead(PointBatch target, int maxRuns, int maxBytes, Allocator allocator) =>
            throw new NotSupportedException();

        public void Dispose()
        {
            CloseFile();
            DisposeUnread();
        }

        /// <summary>Disposes a reader of which no slot was made and no work was begun, on any thread, as it may be opened on any:
        /// it has no handle of the file yet, and these belong to the main thread.</summary>
        public virtual void DisposeUnread()
        {
        }
    }

    /// <summary>How many points there are, as far as a sample tells.</summary>
    public readonly struct PointEstimate
    {
        public readonly double Points;

        /// <summary>0 where they were counted, or the source says so.</summary>
        public readonly double StandardError;

        public PointEstimate(double points, double standardError)
        {
            Points = points;
            StandardError = standardError;
        }
    }
}
