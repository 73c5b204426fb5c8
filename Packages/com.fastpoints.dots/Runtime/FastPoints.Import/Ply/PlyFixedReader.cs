using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Ply
{
    // Vertices without lists. If an element before them has lists, finding their first byte takes a walk through that element.
    sealed class PlyFixedReader : RecordReader
    {
        readonly PlyFile m_ply;

        public PlyFixedReader(PlyFile ply) : base(ply.Info, ply.Handle, ply.Vertex.FixedBytes)
        {
            m_ply = ply;
            var header = ply.Header;
            long offset = header.DataOffset;
            for (int i = 0; i < header.VertexIndex; i++)
            {
                if (header.Elements[i].HasLists)
                    return;
                offset = header.Elements[i].EndOfFixed(offset, Info.FileBytes);
            }
            StartAt(offset, null);
        }

        public override IEnumerator<JobStep> FindBlocks()
        {
            if (BlocksAreKnown)
                yield break;
            using var walk = new PlyElementWalk(m_ply, false);
            while (walk.Next(out var handle))
                yield return handle;
            var end = walk.State;
            if (end.Error != PlyError.None)
                StartAt(Info.FileBytes + 1, "an element before them: " + PlyError.Text(end.Error));
            else
                StartAt(end.Position, null);
        }

        void StartAt(long offset, string reason)
        {
            int recordBytes = m_ply.Vertex.FixedBytes;
            long room = Math.Max(0, Info.FileBytes - offset) / recordBytes;
            long points = m_ply.Vertex.Count < (ulong)room ? (long)m_ply.Vertex.Count : room;
            m_ply.SetPointCount(points, Info.FileBytes,
                reason ?? "the file ends before (" + recordBytes + " bytes each, from byte " + offset + ")");
            SetRecords(m_ply.RecordFields(), offset, m_ply.IsBigEndian, points);
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
    }
}
