using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;
using Unity.Collections;

namespace FastPoints.Files
{
    /// <summary>An ascii PLY file: a vertex is a line. Lines end in LF, CR or CR LF, and blank lines do not count. Vertices over
    /// several lines, or several in one line, are not supported (nor are they by the usual readers).</summary>
    /// <remarks>A block is a stretch of <see cref="MaxBlockBytes"/> with the lines that start in it, found by counting lines
    /// once. A range reads its whole block; decoding stops at the range's end.</remarks>
    sealed class PlyAsciiReader : PlyReader
    {
        public const int MaxBlockBytes = 1 << 20;

        /// <summary>The last line may extend this many bytes behind its block.</summary>
        public const int MaxLineBytes = 64 << 10;

        readonly bool m_hasVerticesAlone;
        PlyBlock[] m_blocks;
        int m_maxPoints;
        bool m_areAllFound;
        AsciiStretches m_stretches;

        public PlyAsciiReader(PlyHeader header, SourceInfo info)
            : base(header, info)
        {
            m_hasVerticesAlone = true;
            for (int i = 0; i < header.Elements.Count; i++)
            {
                if (i == header.VertexIndex || header.Elements[i].Properties.Count == 0 || header.Elements[i].Count == 0)
                    continue;
                m_hasVerticesAlone = false;
                if (i < header.VertexIndex)
                    RowsBefore = Sum(RowsBefore, header.Elements[i].Count);
            }
            if (Vertex.Count == 0)
            {
                Take(Array.Empty<PlyBlock>());
                m_areAllFound = true;
            }
        }

        public override bool BlocksAreKnown => m_areAllFound;

        /// <summary>Whether vertices all over the file can be found by jumping: not if there are faces as well, whose lines look
        /// alike.</summary>
        public override bool HasPrefixes => !m_areAllFound && m_hasVerticesAlone
            && Info.FileBytes - Header.DataOffset >= AsciiStretches.LeastBytes;

        public override bool PrefixesAreSpread => true;
        public override int MaxPrefixes => AsciiStretches.Count;
        public override int BlockCount => Found().Length;
        public override int MaxPointsPerBlock => Found().Length == 0 ? 0 : m_maxPoints;

        /// <summary>Lines before the first vertex's.</summary>
        internal ulong RowsBefore { get; }

        /// <summary>Lines up to the last vertex's, as claimed.</summary>
        internal ulong RowsEnd => Sum(RowsBefore, Vertex.Count);

        public override long FirstPointOfBlock(int block) => Found()[block].FirstPoint;

        public override int PointsInBlock(int block) => Found()[block].Points;

        public override long PlaceOfBlock(int block) => Found()[block].OffsetBytes;

        public override long BytesOfRange(BlockRange range) => range.Count == 0 ? 0 : Found()[range.Block].Bytes;

        public override IEnumerator<Work> FindPrefixes() => FindPrefixes(AsciiStretches.Count);

        public override IEnumerator<Work> FindPrefixes(int places)
        {
            m_stretches ??= new AsciiStretches(Info.Path, File, Info.FileBytes, Header.DataOffset);
            yield return Work.Of(m_stretches.Find(places));
            Take(m_stretches.Blocks);
        }

        public override IEnumerator<Work> FindBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using (var scan = new AsciiRowScan(this, File, Header.DataOffset, MaxBlockBytes, RowsBefore, RowsEnd))
            {
                while (scan.Next(out var handle))
                    yield return handle;
                SettlePoints(scan.Points, Info.FileBytes, "the file ends before");
                Take(scan.TakeBlocks());
                m_areAllFound = true;
                ForgetBroken();
            }
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            Found();
            return new PlyAsciiRead(this, wanted, capacity, allocator);
        }

        internal PlyBlock Block(int block) => m_blocks[block];

        internal List<PlyStep> Steps(PointBatch batch) => PlyPlan.Decoding(Vertex, Names, batch);

        void Take(PlyBlock[] blocks)
        {
            m_blocks = blocks;
            m_maxPoints = 0;
            Info.PointsReadable = 0;
            foreach (var block in blocks)
            {
                m_maxPoints = Math.Max(m_maxPoints, block.Points);
                Info.PointsReadable += block.Points;
            }
        }

        PlyBlock[] Found() => m_blocks ?? throw new InvalidOperationException("FindBlocks comes first");

        static ulong Sum(ulong a, ulong b) => a <= ulong.MaxValue - b ? a + b : ulong.MaxValue;
    }
}
