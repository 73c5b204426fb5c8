using System;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Laz
{
    // A pointwise chunk from a window of the file, a slice at a time, without keeping its points.
    sealed unsafe class LazWalkStream : IDisposable
    {
        const int MaxTilePoints = 512;
        const int MaxBatchBytes = 64 << 10;
        const int MinWindowBytes = 1 << 20;

        readonly SourceHandle m_file;
        readonly NativeFileRead m_read;
        readonly int m_batchPoints;
        readonly long m_maxBytesOfFirst;
        readonly long m_maxBytesOfPoint;
        readonly int m_windowBytes;
        NativeArray<byte> m_state;
        NativeArray<byte> m_batchRecords;
        NativeReference<LazWalkStep> m_step;
        JobHandle m_decode;
        long m_windowStart;
        long m_windowEnd;
        long m_inputEnd;

        public LazWalkStream(SourceHandle file, LazFormat format)
        {
            m_file = file;
            m_batchPoints = Math.Max(1, Math.Min(MaxTilePoints, MaxBatchBytes / format.RecordBytes));
            m_maxBytesOfFirst = PointwiseChunk.MaxInputBytes(format.Items, format.RecordBytes, 0);
            m_maxBytesOfPoint = PointwiseChunk.MaxInputBytes(format.Items, format.RecordBytes, 1) - m_maxBytesOfFirst;
            m_windowBytes = (int)Math.Max(MinWindowBytes, m_maxBytesOfFirst + m_batchPoints * m_maxBytesOfPoint);
            m_read = new NativeFileRead(m_windowBytes + RangeCoder.PaddingBytes, Allocator.Persistent);
            // The state starts as zeros, so that checkpoints leave out what no model has written.
            m_state = new NativeArray<byte>((int)PointwiseChunk.StateBytes(format.Items), Allocator.Persistent);
            PointwiseChunk.Configure((PointwiseChunk*)m_state.GetUnsafePtr(), format.Items, format.RecordBytes);
            m_batchRecords = new NativeArray<byte>(m_batchPoints * format.RecordBytes, Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            m_step = new NativeReference<LazWalkStep>(Allocator.Persistent);
        }

        public long PointsDone { get; private set; }
        public long FileOffset { get; private set; }

        public bool IsStopped { get; private set; } // The input does not hold the next point.

        // The window may not hold the next batch, and the file has more.
        public bool NeedsInput => FileOffset < m_windowStart || FileOffset > m_windowEnd
            || m_windowEnd < m_inputEnd && m_windowEnd - FileOffset < m_maxBytesOfFirst + m_batchPoints * m_maxBytesOfPoint;

        public void StartChunk(long offset, long end)
        {
            FileOffset = offset;
            m_inputEnd = end;
            // Bytes in the window beyond this chunk's end do not belong to it.
            m_windowEnd = Math.Min(m_windowEnd, end);
            PointsDone = 0;
            IsStopped = false;
        }

        long NextWindowEnd => Math.Min(m_inputEnd, FileOffset + m_windowBytes);

        // Whether BeginRead may be called.
        public bool TryFetch() => m_read.TryFetch(m_file.Path, FileOffset, NextWindowEnd - FileOffset);

        public JobHandle BeginRead()
        {
            m_windowStart = FileOffset;
            m_windowEnd = NextWindowEnd;
            return m_read.Begin(m_file, m_windowStart, (int)(m_windowEnd - m_windowStart));
        }

        public void EndRead() => m_read.End();

        public JobHandle Decode(int points)
        {
            m_decode = new WalkLazJob
            {
                Input = m_read.Buffer,
                State = m_state,
                BatchRecords = m_batchRecords,
                Result = m_step,
                InputStart = (int)(FileOffset - m_windowStart),
                InputEnd = (int)(m_windowEnd - m_windowStart),
                HasMore = m_windowEnd < m_inputEnd,
                BatchPoints = m_batchPoints,
                Points = points,
                MaxBytesOfFirst = m_maxBytesOfFirst,
                MaxBytesOfPoint = m_maxBytesOfPoint,
                IsStart = PointsDone == 0,
            }.Schedule(m_decode);
            return m_decode;
        }

        public void EndDecode()
        {
            m_decode.Complete();
            var step = m_step.Value;
            PointsDone += step.Points - step.UncertainPoints;
            FileOffset += step.Bytes;
            IsStopped = step.IsStopped;
        }

        public LazCheckpoint Checkpoint()
        {
            PointwiseChunk.Rebase((PointwiseChunk*)m_state.GetUnsafePtr());
            var checkpoint = new LazCheckpoint { Point = PointsDone, FileOffset = FileOffset };
            m_decode = checkpoint.Save(m_state, m_decode);
            return checkpoint;
        }

        public void Dispose()
        {
            m_decode.Complete();
            m_read.Dispose();
            m_state.Dispose();
            m_batchRecords.Dispose();
            m_step.Dispose();
        }
    }

    struct LazWalkStep
    {
        public int Points;
        public long Bytes;
        public bool IsStopped; // The input does not hold the next point.
        public int UncertainPoints; // Points that the stream's end does not confirm, when it stopped.
    }

    [BurstCompile]
    unsafe struct WalkLazJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input; // The window, with PaddingBytes of RangeCoder behind InputEnd.

        public NativeArray<byte> State;
        public NativeArray<byte> BatchRecords;
        public NativeReference<LazWalkStep> Result;
        // Up to here the state's stream has been consumed.
        public int InputStart;
        public int InputEnd;
        public bool HasMore; // The input goes on after this piece: stop before a point that may be incomplete.

        public int BatchPoints;
        public int Points;
        public long MaxBytesOfFirst;
        public long MaxBytesOfPoint;
        public bool IsStart;

        public void Execute()
        {
            var chunk = (PointwiseChunk*)State.GetUnsafePtr();
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr() + InputStart;
            byte* batch = (byte*)BatchRecords.GetUnsafePtr();
            long inputBytes = InputEnd - InputStart;
            if (IsStart)
                PointwiseChunk.Start(chunk);
            PointwiseChunk.Rebase(chunk);
            var step = default(LazWalkStep);
            while (step.Points < Points && !step.IsStopped)
            {
                long wanted = Points - step.Points < BatchPoints ? Points - step.Points : BatchPoints;
                if (HasMore)
                {
                    long safe = (inputBytes - step.Bytes - MaxBytesOfFirst) / MaxBytesOfPoint;
                    if (safe <= 0)
                        break;
                    wanted = wanted < safe ? wanted : safe;
                }
                int got = PointwiseChunk.Decode(chunk, input, inputBytes, batch, (int)wanted);
                step.Points += got;
                step.IsStopped = got < wanted;
                if (step.IsStopped)
                    step.UncertainPoints = chunk->UncertainPoints;
                else
                    step.Bytes = chunk->InputOffset;
            }
            Result.Value = step;
        }
    }
}
