using System;
using FastPoints.Laz;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sources
{
    abstract class NodeRead : OwningBlockRead
    {
        protected NodeRead(NodeReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            Reader = reader;
            OwnFile(0, allocator);
        }

        protected NodeReader Reader { get; }

        protected abstract JobHandle Schedule(BlockRange range, in NodeBlock block);

        protected abstract void Report(DecodeResult result);

        protected int BytesRead { get; private set; }

        // padding: bytes after the data that jobs may read or write.
        protected JobHandle BeginRead(BlockRange range, int padding = 0)
        {
            var piece = Reader.PieceOf(range);
            if (piece.LengthBytes < 0)
                piece.LengthBytes = FileRead.FetchedLength(piece.Path);
            BytesRead = (int)piece.LengthBytes;
            // The largest node is not known in advance: the buffer grows when one is found.
            FileRead.Reserve(piece.LengthBytes + padding);
            return DependencyOf(Reader.BeginRead(FileRead, piece));
        }

        protected sealed override JobHandle Schedule(BlockRange range)
        {
            var block = Reader.Block(range.Block);
            bool isPastEnd = block.FirstInNode > 0 && block.FirstInNode + range.First >= Reader.EndOfNode(range.Block);
            return isPastEnd ? default : Schedule(range, block);
        }

        protected sealed override void Warn(DecodeResult result)
        {
            if (result.Error != 0 && result.Points < Range.Count)
                Reader.MarkEndOfNode(Range.Block, Reader.Block(Range.Block).FirstInNode + Range.First + result.Points);
            Report(result);
        }
    }

    // Nodes that are LAS or LAZ files: the file is read whole, then a chain of slices decodes it to the cloud's grid as far as
    // the range goes.
    sealed class LasNodeRead : NodeRead
    {
        readonly LasTemplate m_template;
        readonly bool m_isPotree;
        readonly LasFileDecoder m_decoder;

        // isPotree: offsets are rounded, and the points of nodes are counted by their files.
        public LasNodeRead(NodeReader reader, LasTemplate template, bool isPotree, PointSchema wanted, int capacity,
            Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_template = template;
            m_isPotree = isPotree;
            try
            {
                m_decoder = Own(new LasFileDecoder(template, Points, isPotree, allocator));
            }
            catch (ArgumentException)
            {
                Dispose();
                throw;
            }
        }

        protected override JobHandle Schedule(BlockRange range, in NodeBlock block)
        {
            var read = BeginRead(range, RangeCoder.PaddingBytes);
            return m_decoder.Schedule(FileRead.Buffer, BytesRead, block.FirstInNode + range.First, range.Count, Result, read);
        }

        protected override void Report(DecodeResult result)
        {
            var header = m_template.Las.Header;
            string got = "wanted " + Range.Count + " points, got " + result.Points;
            long inFile = m_decoder.PointsInFile, inNode = Reader.Block(Range.Block).NodePoints;
            if (result.Error == LazError.NotAChunk)
                Reader.WarnBroken(Range.Block, "its file is not what the other nodes' are: its points are left out",
                    "wanted " + (m_template.Laz == null ? "LAS" : "LAZ") + " of point format " + header.PointFormat
                        + " in records of " + header.RecordBytes + " bytes, with the items of the others", 0);
            else if (result.Error == LazError.OffGrid)
                Reader.WarnBroken(Range.Block, "its positions do not lie on the " + (m_isPotree ? "cloud's" : "root's")
                        + " grid: they are left out from there",
                    "wanted scale and offset that are whole steps of the grid, and places within 32 bits; " + got,
                    result.ErrorOffset);
            else if (result.Error != LazError.None)
                Reader.WarnBroken(Range.Block, "its file breaks off", got, result.ErrorOffset);
            else if (!m_isPotree && inFile != inNode)
                Reader.WarnBroken(Range.Block, "its file has another number of points than the hierarchy claims",
                    inFile + " in the file, " + inNode + " claimed", -1);
        }
    }
}
