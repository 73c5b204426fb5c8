using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Laz
{
    /// <summary>Decodes one slice of a chunk: the points after those of the previous slice, first into a tile of records, then to
    /// the wanted columns. A chain of these decodes a range.</summary>
    [BurstCompile]
    unsafe struct DecodeLazJob : IJob
    {
        /// <summary>The chunk's bytes, or those of its wanted layers; with <see cref="RangeCode.PaddingBytes"/> behind
        /// them.</summary>
        [ReadOnly] public NativeArray<byte> Input;

        /// <summary>One value: bytes of the input that are there.</summary>
        [ReadOnly] public NativeArray<long> InputBytes;

        /// <summary>A <see cref="PointwiseChunk"/> or <see cref="LayeredChunk"/>, configured.</summary>
        public NativeArray<byte> State;

        /// <summary>Records of a tile.</summary>
        public NativeArray<byte> Tile;

        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;

        public int RecordBytes;
        public int TilePoints;
        public bool IsLayered;
        public bool HasAllLayers;

        /// <summary>First slice of a range: the state is started, unless it continues from a checkpoint.</summary>
        public bool IsFirst;
        public bool IsContinued;

        /// <summary>First point of the slice, counted from where the state started.</summary>
        public int First;
        public int Count;

        /// <summary>Points before the range, which are decoded because the others depend on them, but not kept.</summary>
        public int Skip;

        /// <summary>Points to decode from the state's start, including <see cref="Skip"/>.</summary>
        public int Total;

        /// <summary>The most points that the input of layers holds.</summary>
        public long InputPoints;

        /// <summary>Points of the whole chunk, as its listing claims.</summary>
        public long ChunkPoints;
        public long ChunkBytes;

        /// <summary>Offset of the input in the file.</summary>
        public long FileOffset;

        /// <summary>Whether the range takes the chunk to its end, so that the stream must end with it.</summary>
        public bool IsToEnd;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* state = (byte*)State.GetUnsafePtr();
            byte* tile = (byte*)Tile.GetUnsafePtr();
            long inputBytes = InputBytes[0];
            var result = IsFirst ? default : Result.Value;
            if (IsFirst && IsLayered && !IsContinued)
            {
                LayeredChunk.Start((LayeredChunk*)state, input, inputBytes, HasAllLayers, InputPoints);
                if (!LayeredChunk.IsPlausible((LayeredChunk*)state, input, inputBytes, ChunkPoints, ChunkBytes))
                {
                    result.Error = LazError.NoChunk;
                    result.ErrorOffset = FileOffset;
                }
            }
            else if (IsFirst && !IsContinued)
                PointwiseChunk.Start((PointwiseChunk*)state);

            int done = 0;
            while (done < Count && result.Error == LazError.None)
            {
                int wanted = Count - done < TilePoints ? Count - done : TilePoints;
                int got = IsLayered
                    ? LayeredChunk.Decode((LayeredChunk*)state, input, tile, wanted)
                    : PointwiseChunk.Decode((PointwiseChunk*)state, input, inputBytes, tile, wanted);
                int first = First + done;
                int skipped = Skip > first ? (Skip - first < got ? Skip - first : got) : 0;
                if (got > skipped)
                {
                    PointRecords.ToColumns(tile + (long)skipped * RecordBytes, RecordBytes, got - skipped,
                        (FieldCopy*)Copies.GetUnsafeReadOnlyPtr(), Copies.Length, (byte*)Columns.GetUnsafePtr(),
                        first + skipped - Skip);
                    result.Points = first + got - Skip;
                }
                done += got;
                if (got < wanted)
                {
                    result.Error = LazError.Short;
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

        /// <summary>Checks, after all points, whether the stream ends there.</summary>
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
                result.Error = LazError.Short;
                DropUncertain(chunk, ref result);
            }
        }

        /// <summary>Drops points that the stream's end does not confirm: a decoder makes some of no bytes.</summary>
        static void DropUncertain(PointwiseChunk* chunk, ref DecodeResult result)
        {
            int kept = result.Points - chunk->UncertainPoints;
            result.Points = kept > 0 ? kept : 0;
        }
    }

    /// <summary>The values of <see cref="DecodeResult.Error"/> from decoding jobs.</summary>
    static class LazError
    {
        public const int None = 0;

        /// <summary>The input, or one of its layers, ended before the requested points.</summary>
        public const int Short = 1;

        /// <summary>All points were decoded, but the stream does not end where its chunk does: some of them are noise.</summary>
        public const int EndMismatch = 2;

        /// <summary>All points were decoded, and the stream has more bytes: the file claims too few, or some are noise.</summary>
        public const int TrailingBytes = 4;

        /// <summary>There is no chunk here: neither its count nor its length matches the claims.</summary>
        public const int NoChunk = 3;

        /// <summary>A file's positions do not lie on the required grid.</summary>
        public const int OffGrid = 5;
    }
}
