using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Laz
{
    struct LazWalkStep
    {
        public int Points;
        public long Bytes;

        // The input does not hold the next point.
        public bool IsStopped;

        // Points that the stream's end does not confirm, when it stopped.
        public int UncertainPoints;
    }

    // Only to find their end.
    [BurstCompile]
    unsafe struct WalkLazJob : IJob
    {
        // The input from where the state's stream has been consumed up to, with PaddingBytes of RangeCode behind InputEnd.
        [ReadOnly] public NativeArray<byte> Input;

        public NativeArray<byte> State;
        public NativeArray<byte> Tile;
        public NativeReference<LazWalkStep> Result;
        public int InputStart;
        public int InputEnd;

        // The input continues behind its end, so that no point may be decoded that might not be complete.
        public bool HasMore;

        public int TilePoints;
        public int Points;
        public long MaxBytesOfFirst;
        public long MaxBytesOfPoint;
        public bool IsStart;

        public void Execute()
        {
            var chunk = (PointwiseChunk*)State.GetUnsafePtr();
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr() + InputStart;
            byte* tile = (byte*)Tile.GetUnsafePtr();
            long inputBytes = InputEnd - InputStart;
            if (IsStart)
                PointwiseChunk.Start(chunk);
            PointwiseChunk.Rebase(chunk);
            var step = default(LazWalkStep);
            while (step.Points < Points && !step.IsStopped)
            {
                long wanted = Points - step.Points < TilePoints ? Points - step.Points : TilePoints;
                if (HasMore)
                {
                    long safe = (inputBytes - step.Bytes - MaxBytesOfFirst) / MaxBytesOfPoint;
                    if (safe <= 0)
                        break;
                    wanted = wanted < safe ? wanted : safe;
                }
                int got = PointwiseChunk.Decode(chunk, input, inputBytes, tile, (int)wanted);
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
