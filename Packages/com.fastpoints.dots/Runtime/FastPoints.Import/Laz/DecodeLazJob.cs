using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Laz
{
    // The points after those of the previous slice of a chunk, first into a batch of records, then to the wanted columns.
    [BurstCompile]
    unsafe struct DecodeLazJob : IJob
    {
        // The chunk's bytes, or those of its wanted layers; with PaddingBytes of RangeCoder behind them.
        [ReadOnly] public NativeArray<byte> Input;

        [ReadOnly] public NativeArray<long> InputBytes;
        public NativeArray<byte> State; // A PointwiseChunk or LayeredChunk, configured.

        public NativeArray<byte> BatchRecords;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;
        public int RecordBytes;
        public int BatchPoints;
        public bool IsLayered;
        public bool HasAllLayers;

        // The state is started, unless it continues from a checkpoint.
        public bool IsFirst;
        public bool IsContinued;

        // Counted from where the state started, like Total.
        public int First;
        public int Count;
        public int Skip; // Points before the range, decoded because the others depend on them.

        public int Total;
        public long InputPoints; // At most, of the input of layers.

        public long ChunkPoints;
        public long ChunkBytes;
        public long FileOffset;
        public bool IsToEnd; // The range takes the chunk to its end, so that the stream must end with it.

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* state = (byte*)State.GetUnsafePtr();
            byte* batch = (byte*)BatchRecords.GetUnsafePtr();
            long inputBytes = InputBytes[0];
            var result = IsFirst ? default : Result.Value;
            if (IsFirst && IsLayered && !IsContinued)
            {
                LayeredChunk.Start((LayeredChunk*)state, input, inputBytes, HasAllLayers, InputPoints);
                if (!LayeredChunk.IsPlausible((LayeredChunk*)state, input, inputBytes, ChunkPoints, ChunkBytes))
                {
                    result.Error = LazError.NotAChunk;
                    result.ErrorOffset = FileOffset;
                }
            }
            else if (IsFirst && !IsContinued)
                PointwiseChunk.Start((PointwiseChunk*)state);

            int done = 0;
            while (done < Count && result.Error == LazError.None)
            {
                int wanted = Count - done < BatchPoints ? Count - done : BatchPoints;
                int got = IsLayered
                    ? LayeredChunk.Decode((LayeredChunk*)state, input, batch, wanted)
                    : PointwiseChunk.Decode((PointwiseChunk*)state, input, inputBytes, batch, wanted);
                int first = First + done;
                int skipped = Skip > first ? (Skip - first < got ? Skip - first : got) : 0;
                if (got > skipped)
                {
                    PointRecords.ToColumns(batch + (long)skipped * RecordBytes, RecordBytes, got - skipped, Copies,
                        (byte*)Columns.GetUnsafePtr(), first + skipped - Skip);
                    result.Points = first + got - Skip;
                }
                done += got;
                if (got < wanted)
                {
                    result.Error = LazError.Truncated;
                    // Layers are packed in the input: only the chunk knows where a byte of them lies in the file.
                    result.ErrorOffset = FileOffset + (IsLayered ? 0 : ((PointwiseChunk*)state)->InputOffset);
                    if (!IsLayered)
                        DropUncertain((PointwiseChunk*)state, ref result);
                }
            }
            if (IsToEnd && !IsLayered && result.Error == LazError.None && First + Count == Total)
                CheckEnd((PointwiseChunk*)state, inputBytes, ref result);
            Result.Value = result;
        }

        void CheckEnd(PointwiseChunk* chunk, long inputBytes, ref DecodeResult result)
        {
            if (chunk->IsAtEnd)
                return;
            result.ErrorOffset = FileOffset + chunk->InputOffset;
            result.Error = LazError.EndMismatch;
            if (chunk->InputOffset < inputBytes)
                result.Error = LazError.TrailingBytes;
            else if (chunk->UncertainPoints > 0)
            {
                result.Error = LazError.Truncated;
                DropUncertain(chunk, ref result);
            }
        }

        // A decoder makes some points of no bytes: those that the stream's end does not confirm.
        static void DropUncertain(PointwiseChunk* chunk, ref DecodeResult result)
        {
            int kept = result.Points - chunk->UncertainPoints;
            result.Points = kept > 0 ? kept : 0;
        }
    }

    static class LazError
    {
        public const int None = 0;
        public const int Truncated = 1; // The input, or one of its layers, ended before the requested points.

        // All points were decoded, but the stream does not end where its chunk does: some of them are noise.
        public const int EndMismatch = 2;

        // All points were decoded, and the stream has more bytes: the file claims too few, or some are noise.
        public const int TrailingBytes = 3;
        public const int NotAChunk = 4; // Neither its count nor its length matches the claims.
        public const int OffGrid = 5; // A file's positions do not lie on the required grid.
    }
}
