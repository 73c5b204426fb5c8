using System;
using System.Collections.Generic;
using Unity.Collections;

namespace FastPoints.Reading
{
    /// <summary>An open source of points: its description, and its natural blocks (LAZ chunks, COPC and Potree nodes, ranges of a
    /// fixed-stride file), which can be read in any order, several at once.</summary>
    /// <remarks>All members belong to the main thread, but any thread may open a reader (<c>PointReaders</c>). Reading
    /// happens through <see cref="BlockRead"/> slots: the reader makes as many as the caller wants in flight, and these slots
    /// hold all of its memory, whatever the file's size. Dispose the slots before the reader.</remarks>
    public abstract class PointReader : IDisposable
    {
        public SourceInfo Info { get; protected set; }

        /// <summary>Whether the blocks and their point counts are known from the header. If not, call <see cref="IndexBlocks"/>
        /// before using any of the following members.</summary>
        public virtual bool BlocksAreKnown => true;

        /// <summary>The most jobs that <see cref="IndexBlocks"/> has in flight; 0 for as many as keep all workers busy.</summary>
        public int MaxIndexingJobs { get; set; }

        /// <summary>Coroutine that finds the blocks in one pass over the file: line starts of an ascii file, a lost chunk
        /// table.</summary>
        public virtual IEnumerator<JobStep> IndexBlocks()
        {
            yield break;
        }

        internal virtual PointReader Unfiltered => this; // The reader that this one filters, or this one.
        internal virtual ulong FilterHash => 0; // Hash of its filter; 0 without one.

        // The octree that the source contains, or null. Its blocks come level by level within each page of the hierarchy.
        internal virtual SourceTree Tree => null;

        public abstract int BlockCount { get; }

        /// <summary>Points of the largest block, which is the capacity of a slot.</summary>
        public abstract int MaxPointsPerBlock { get; }

        /// <summary>Index of a block's first point in the whole source.</summary>
        public abstract long FirstPointOfBlock(int block);

        public abstract int PointsInBlock(int block);

        /// <summary>Grows from block to block in the order of the source, in whatever order they were found.</summary>
        public virtual long OrderOfBlock(int block) => block;

        /// <summary>The location of a block, for messages.</summary>
        /// <param name="byteOffset">The byte at which it begins; -1 if unknown.</param>
        public virtual string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = -1;
            return Info.Path;
        }

        /// <summary>Bytes of the file that reading a range takes (an estimate if the format does not say).</summary>
        public abstract long BytesOfRange(BlockRange range);

        // Whether its bytes come from a web server: then they are fetched before a slot's Begin, which would wait otherwise.
        internal virtual bool IsRemote => SourcePath.IsRemote(Info.Path);

        // Of a large remote file each range costs a request: samples then have few and long ones.
        internal bool TakesFewRanges => IsRemote && Info.FileBytes > RemoteFile.MaxSmallFileBytes;

        // Adds what reading a range takes of remote files; a piece of negative length is its whole file.
        internal virtual void ListPieces(BlockRange range, List<FilePiece> pieces) { }

        internal RemoteFetch Fetch(BlockRange range, int rank)
        {
            var pieces = new List<FilePiece>();
            ListPieces(range, pieces);
            return new RemoteFetch(pieces, rank);
        }

        // The ranges from first to before end, fetched in advance; null for local files.
        internal FetchWindow WindowOf(int first, int end, Func<int, BlockRange> rangeOf) =>
            IsRemote ? new FetchWindow(first, end, (n, pieces) => ListPieces(rangeOf(n), pieces)) : null;

        /// <summary>Whether a range anywhere in its block costs what it holds. Otherwise only prefixes are cheap.</summary>
        public virtual bool HasCheapRanges => false;

        /// <summary>Points of all blocks together.</summary>
        public long PointCount => BlockCount == 0 ? 0 : FirstPointOfBlock(BlockCount - 1) + PointsInBlock(BlockCount - 1);

        /// <summary>Creates a reusable slot that decodes these attributes (a selection of <see cref="SourceInfo.Schema"/>) and no
        /// others.</summary>
        /// <param name="wanted">The batch's columns; each must be in the source's schema.</param>
        /// <param name="capacity">Points of the largest range that the slot will read.</param>
        /// <param name="allocator">The allocator of the slot's memory.</param>
        public abstract BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator);
        internal virtual long DecoderBytes => 0; // Bytes that a slot takes beside its columns and what it reads of the file.

        /// <summary>Closes the file's handle if possible, and keeps everything that was found; the next slot opens it again.
        /// There must be no slots at this time.</summary>
        public virtual void CloseFile() { }

        public void Dispose()
        {
            CloseFile();
            DisposeUnread();
        }

        /// <summary>Disposes a reader without slots or work on any thread, as it may be opened on any: it has no file handle yet,
        /// and these belong to the main thread.</summary>
        public virtual void DisposeUnread() { }

        // The reader, once the rest of its opening is done; one that fails is disposed.
        internal static T Opened<T>(T reader, Action<T> rest) where T : PointReader
        {
            try
            {
                rest(reader);
                return reader;
            }
            catch
            {
                reader.DisposeUnread();
                throw;
            }
        }
    }

    // Points can be read long before IndexBlocks has ended.
    internal interface IPrefixSource
    {
        bool HasPrefixes { get; }

        // Coroutine, of bounded time: without a pass over the file, of text at this many positions. What it finds are the blocks,
        // although BlocksAreKnown is false, until IndexBlocks replaces them while there are no slots. If it is called again for
        // more positions, earlier blocks keep their numbers.
        IEnumerator<JobStep> FindPrefixes(int count);

        PointEstimate EstimatedPoints { get; }
    }

    internal readonly struct PointEstimate
    {
        public readonly double Points;
        public readonly double StandardError; // 0 if they were counted, or the source says so.

        public PointEstimate(double points, double standardError)
        {
            Points = points;
            StandardError = standardError;
        }
    }
}
