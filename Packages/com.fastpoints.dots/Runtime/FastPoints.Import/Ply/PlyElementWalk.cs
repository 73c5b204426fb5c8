using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Ply
{
    // Walks up to the vertices of a binary file, and through these if they have lists: one window of the file at a time, each as
    // one job. Windows that lie within a list or an element of fixed length are not read at all.
    sealed class PlyElementWalk : IDisposable
    {
        const int WindowBytes = 4 << 20;

        readonly PlyFile m_ply;
        readonly NativeFileRead m_read;
        NativeArray<PlyWalkElement> m_elements;
        NativeArray<PlyStep> m_steps;
        NativeReference<PlyWalkState> m_state;
        NativeList<SegmentBlock> m_blocks;
        JobHandle m_walked;

        // isIndexing: the vertices are walked, too, and gathered into blocks.
        public PlyElementWalk(PlyFile ply, bool isIndexing)
        {
            m_ply = ply;
            var header = ply.Header;
            int count = header.VertexIndex + (isIndexing ? 1 : 0);
            var elements = new PlyWalkElement[count];
            var steps = new List<PlyStep>();
            for (int i = 0; i < count; i++)
            {
                var passing = PlyPlan.Passing(header.Elements[i]);
                elements[i] = new PlyWalkElement
                {
                    Count = header.Elements[i].Count,
                    FixedBytes = header.Elements[i].FixedBytes,
                    FirstStep = steps.Count,
                    Steps = passing.Count,
                    IsIndexed = i == header.VertexIndex,
                };
                steps.AddRange(passing);
            }
            m_read = new NativeFileRead(Math.Min(WindowBytes, ply.Info.FileBytes), Allocator.Persistent);
            m_elements = new NativeArray<PlyWalkElement>(elements, Allocator.Persistent);
            m_steps = new NativeArray<PlyStep>(steps.ToArray(), Allocator.Persistent);
            m_state = new NativeReference<PlyWalkState>(new PlyWalkState { Position = header.DataOffset }, Allocator.Persistent);
            m_blocks = new NativeList<SegmentBlock>(16, Allocator.Persistent);
        }

        // Not while a job is in flight, like TakeBlocks.
        public PlyWalkState State => m_state.Value;

        public SegmentBlock[] TakeBlocks() => m_blocks.AsArray().ToArray();

        // Closes the previous window, whose handle must be complete, and starts the next. False at the end.
        public bool Next(out JobHandle handle)
        {
            m_walked.Complete();
            m_read.End();
            var state = m_state.Value;
            handle = default;
            if (state.IsDone)
                return false;
            long offset = Math.Min(state.Position, m_ply.Info.FileBytes);
            int bytes = (int)Math.Min(WindowBytes, m_ply.Info.FileBytes - offset);
            var read = m_read.Begin(m_ply.Handle, offset, bytes);
            m_walked = new WalkPlyElementsJob
            {
                Input = m_read.Buffer,
                Elements = m_elements,
                Steps = m_steps,
                InputOffset = offset,
                InputBytes = bytes,
                FileBytes = m_ply.Info.FileBytes,
                IsBigEndian = m_ply.IsBigEndian,
                State = m_state,
                Blocks = m_blocks,
            }.Schedule(read);
            handle = m_walked;
            return true;
        }

        public void Dispose()
        {
            m_walked.Complete();
            m_read.Dispose();
            m_elements.Dispose();
            m_steps.Dispose();
            m_state.Dispose();
            m_blocks.Dispose();
        }
    }
}
