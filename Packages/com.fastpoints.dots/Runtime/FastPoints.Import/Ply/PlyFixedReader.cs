using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Ply
{
    // Vertices without lists. If an element before them has lists, finding their first byte takes a walk through that element.
    sealed class PlyFixedReader : PointReader
    {
        const int MaxBlockPoints = 32768;

        // Records of many properties come in shorter blocks, so that a slot's memory stays small.
        const int MaxBlockBytes = 4 << 20;

        readonly PlyFile m_ply;
        readonly int m_recordBytes;
        readonly int m_blockPoints;
        FixedRecords m_records;
        long m_points = -1;

        public PlyFixedReader(PlyFile ply)
        {
            Info = ply.Info;
            m_ply = ply;
            m_recordBytes = ply.Vertex.FixedBytes;
            var header = ply.Header;
            m_blockPoints = Math.Max(1, Math.Min(MaxBlockPoints, MaxBlockBytes / m_recordBytes));
            long offset = header.DataOffset;
            for (int i = 0; i < header.VertexIndex; i++)
            {
                if (header.Elements[i].HasLists)
                    return;
                offset = header.Elements[i].EndOfFixed(offset, Info.FileBytes);
            }
            StartAt(offset, null);
        }

        public override bool BlocksAreKnown => m_points >= 0;
        public override bool HasFixedStride => true;
        public override bool HasRunReads => true;
        public override int MaxPointsPerBlock => (int)Math.Min(m_blockPoints, Found());
        public override int BlockCount => (int)((Found() + m_blockPoints - 1) / m_blockPoints);

        public override long FirstPointOfBlock(int block) => (long)block * m_blockPoints;

        public override int PointsInBlock(int block) => (int)Math.Min(m_blockPoints, Found() - FirstPointOfBlock(block));

        public override long BytesOfRange(BlockRange range) => (long)range.Count * m_recordBytes;

        public override IEnumerator<JobStep> FindBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using var walk = new PlyElementWalk(m_ply, false);
            while (walk.Next(out var handle))
                yield return handle;
            var end = walk.State;
            StartAt(end.Error != PlyError.None ? Info.FileBytes + 1 : end.Position,
                end.Error != PlyError.None ? "an element before them: " + PlyError.Text(end.Error) : null);
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            Found();
            return new RecordRead(this, m_records, wanted, capacity, allocator);
        }

        internal override RunRead CreateRunRead(PointBatch target, int maxRuns, int maxBytes, Allocator allocator)
        {
            Found();
            return new RunRead(m_records, target, maxRuns, maxBytes, allocator);
        }

        public override void CloseFile() => m_ply.Handle.Close();

        void StartAt(long offset, string reason)
        {
            long room = Math.Max(0, Info.FileBytes - offset) / m_recordBytes;
            long points = m_ply.Vertex.Count < (ulong)room ? (long)m_ply.Vertex.Count : room;
            m_ply.SetPointCount(points, Info.FileBytes,
                reason ?? "the file ends before (" + m_recordBytes + " bytes each, from " +
                "byte " + offset + ")");
            m_records = new FixedRecords(m_ply.Handle, m_ply.RecordFields(), offset, m_recordBytes, m_ply.IsBigEndian);
            m_points = points;
            WarnTrailingBytes(offset);
        }

        void WarnTrailingBytes(long offset)
        {
            for (int i = m_ply.Header.VertexIndex; i < m_ply.Header.Elements.Count; i++)
            {
                if (m_ply.Header.Elements[i].HasLists)
                    return;
                offset = m_ply.Header.Elements[i].EndOfFixed(offset, Info.FileBytes);
            }
            if (offset < Info.FileBytes)
                Info.Warn(offset, (Info.FileBytes - offset) + " bytes behind the last element: they are left out");
        }

        long Found() => m_points >= 0 ? m_points : throw new InvalidOperationException("FindBlocks comes first");
    }
}
