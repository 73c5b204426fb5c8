using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Text
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
                var skipping = PlyPlan.Skipping(header.Elements[i]);
                elements[i] = new PlyWalkElement
                {
                    Count = header.Elements[i].Count,
                    FixedBytes = header.Elements[i].FixedBytes,
                    FirstStep = steps.Count,
                    Steps = skipping.Count,
                    IsIndexed = i == header.VertexIndex,
                };
                steps.AddRange(skipping);
            }
            m_read = new NativeFileRead(Math.Min(WindowBytes, ply.Info.FileBytes), Allocator.Persistent);
            m_elements = new NativeArray<PlyWalkElement>(elements, Allocator.Persistent);
            m_steps = new NativeArray<PlyStep>(steps.ToArray(), Allocator.Persistent);
            m_state = new NativeReference<PlyWalkState>(new PlyWalkState { Position = header.DataOffset }, Allocator.Persistent);
            m_blocks = new NativeList<SegmentBlock>(16, Allocator.Persistent);
        }

        public PlyWalkState State => m_state.Value;

        public SegmentBlock[] TakeBlocks() => m_blocks.AsArray().ToArray();

        // Closes the previous window, whose handle must be complete, and starts the next. False at the end. While the next one
        // is fetched from a server, true with a default handle, and nothing starts.
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
            if (!m_read.TryFetch(m_ply.Handle.Path, offset, bytes))
                return true;
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

    // Steps through elements with lists as far as the window reaches, reading only the lists' counts, and records a
    // block for every MaxBlockPoints points or MaxBlockBytes.
    [BurstCompile]
    unsafe struct WalkPlyElementsJob : IJob
    {
        public const int MaxBlockPoints = 65536;
        public const int MaxBlockBytes = 1 << 20;

        // A block is as long as its last vertex makes it; longer lists count as damage.
        public const int MaxRecordBytes = 16 << 20;

        [ReadOnly] public NativeArray<byte> Input;
        [ReadOnly] public NativeArray<PlyWalkElement> Elements;
        [ReadOnly] public NativeArray<PlyStep> Steps;
        public long InputOffset;
        public int InputBytes;
        public long FileBytes;
        public bool IsBigEndian;

        public NativeReference<PlyWalkState> State;
        public NativeList<SegmentBlock> Blocks;

        public void Execute()
        {
            var state = State.Value;
            while (!state.IsDone)
            {
                if (state.Element == Elements.Length)
                {
                    state.IsDone = true;
                    break;
                }
                var element = Elements[state.Element];
                bool isSkipped = element.FixedBytes >= 0 ? SkipFixed(ref state, element) : SkipLists(ref state, element);
                if (!isSkipped)
                    break;
                if (element.IsIndexed)
                    CloseBlock(ref state, state.Position);
                state.Element++;
                state.Instance = 0;
                state.Step = 0;
            }
            State.Value = state;
        }

        bool SkipFixed(ref PlyWalkState state, in PlyWalkElement element)
        {
            if (element.FixedBytes == 0 || element.Count == 0)
                return true;
            if (element.Count > (ulong)((FileBytes - state.Position) / element.FixedBytes))
                return Fail(ref state, PlyError.Truncated, FileBytes);
            state.Position += (long)element.Count * element.FixedBytes;
            return true;
        }

        // False if the walk needs other bytes or is over.
        bool SkipLists(ref PlyWalkState state, in PlyWalkElement element)
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            while (state.Instance < element.Count)
            {
                if (state.Step == 0)
                {
                    state.InstanceStart = state.Position;
                    if (element.IsIndexed && state.BlockPoints == 0)
                        state.BlockStart = state.Position;
                }
                for (; state.Step < element.Steps; state.Step++)
                {
                    var step = Steps[element.FirstStep + state.Step];
                    long next = state.Position + step.Bytes;
                    if (next > FileBytes)
                        return Fail(ref state, PlyError.Truncated, state.InstanceStart);
                    if (step.Kind == PlyStepKind.List)
                    {
                        long at = state.Position - InputOffset;
                        if (at < 0 || at + step.Bytes > InputBytes)
                            return false;
                        ulong count = PlyBytes.Load(input + at, step.Bytes, IsBigEndian);
                        if (PlyBytes.IsNegative(count, step.Type))
                            return Fail(ref state, PlyError.BadListLength, state.Position);
                        if (count > (ulong)((FileBytes - next) / step.ItemBytes))
                            return Fail(ref state, PlyError.Truncated, state.InstanceStart);
                        next += (long)count * step.ItemBytes;
                        if (element.IsIndexed && next - state.InstanceStart > MaxRecordBytes)
                            return Fail(ref state, PlyError.RecordTooLong, state.InstanceStart);
                    }
                    state.Position = next;
                }
                state.Step = 0;
                state.Instance++;
                if (element.IsIndexed)
                {
                    state.BlockPoints++;
                    if (state.BlockPoints == MaxBlockPoints || state.Position - state.BlockStart >= MaxBlockBytes)
                        CloseBlock(ref state, state.Position);
                }
            }
            return true;
        }

        void CloseBlock(ref PlyWalkState state, long end)
        {
            if (state.BlockPoints == 0)
                return;
            Blocks.Add(new SegmentBlock
            {
                OffsetBytes = state.BlockStart,
                Bytes = (int)(end - state.BlockStart),
                FirstPoint = state.PointsInBlocks,
                Points = state.BlockPoints,
            });
            state.PointsInBlocks += state.BlockPoints;
            state.BlockPoints = 0;
        }

        bool Fail(ref PlyWalkState state, int error, long offset)
        {
            CloseBlock(ref state, state.InstanceStart);
            state.Error = error;
            state.ErrorOffset = offset;
            state.IsDone = true;
            return false;
        }
    }

    struct PlyWalkElement
    {
        public ulong Count;
        public int FixedBytes;
        public int FirstStep;
        public int Steps;
        public bool IsIndexed;
    }

    // The walk can stop at any step and continue there.
    struct PlyWalkState
    {
        // Offset of the next step. It may be beyond what was read: lists are skipped.
        public long Position;
        public int Element;
        public ulong Instance;
        public int Step;
        public long InstanceStart;
        public long BlockStart;
        public int BlockPoints;
        public long PointsInBlocks;
        public int Error;
        public long ErrorOffset;
        public bool IsDone;
    }

    // Reads either byte order; Unity runs on little-endian machines only. HPC#.
    static class PlyBytes
    {
        // An integer of 1, 2, 4 or 8 bytes as its bits, without extending its sign.
        public static unsafe ulong Load(byte* p, int bytes, bool isBigEndian)
        {
            ulong value = 0;
            for (int i = 0; i < bytes; i++)
                value |= (ulong)p[i] << 8 * (isBigEndian ? bytes - 1 - i : i);
            return value;
        }

        public static bool IsNegative(ulong bits, AttributeType type) =>
            type.IsSigned() && !type.IsFloat() && (bits >> 8 * type.SizeOf() - 1 & 1) != 0;
    }
}
