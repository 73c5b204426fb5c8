using FastPoints.Las;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Laz
{
    // A slice of a whole LAZ or LAS file in memory, header included: for octrees that keep each node in a file of its own. Chunk
    // after chunk from the file's start, so that the chunk table is not needed.
    [BurstCompile]
    unsafe struct DecodeLasFileJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input; // With PaddingBytes of RangeCoder behind it.

        public int InputBytes;

        // Of the columns: a file with another scale or offset is rescaled to it if that is exact.
        public PositionTransform Transform;
        public bool RoundsOffset; // An offset that is not whole steps from the grid's is rounded to the nearest that is.

        // The LASzip VLR's list of items, from their number on, as it must be; none for LAS.
        [ReadOnly] public NativeArray<byte> Items;
        public NativeArray<byte> Decoder; // A PointwiseChunk or LayeredChunk, configured; anything for LAS.

        public NativeArray<byte> BatchRecords;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        public NativeArray<byte> Columns;
        public NativeReference<LasFileState> State;
        public NativeReference<DecodeResult> Result;
        public LazCompressor Compressor;
        public int PointFormat;
        public int RecordBytes;
        public int BatchPoints;

        // Counted from the file's start; 0 starts the file.
        public long First;
        public int Count;
        public long Skip; // Points before the range, decoded because the others depend on them.

        bool IsUncompressed => Compressor == LazCompressor.None;

        bool IsLayered => Compressor == LazCompressor.LayeredChunked;

        public void Execute()
        {
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            var result = First == 0 ? default : Result.Value;
            var state = First == 0 ? default : State.Value;
            if (First == 0 && !ReadHeader(input, ref state))
                result.Error = LazError.NotAChunk;
            else if (First == 0 && !LasRescaling.TryMake(input, Transform, RoundsOffset, out state.Rescaling))
                result.Error = LazError.OffGrid;
            int done = 0;
            while (done < Count && result.Error == LazError.None)
            {
                if (state.ChunkDone == state.ChunkPoints && !StartChunk(input, ref state))
                {
                    Stop(ref result, state.ChunkOffset);
                    break;
                }
                long left = state.ChunkPoints - state.ChunkDone;
                int wanted = Count - done < BatchPoints ? Count - done : BatchPoints;
                wanted = left < wanted ? (int)left : wanted;
                int got = Decode(input, state, wanted);
                int rescaled = state.Rescaling.IsSame ? got : Rescale(state.Rescaling, got);
                CopyTile(First + done, rescaled, ref result);
                if (rescaled < got)
                {
                    result.Error = LazError.OffGrid;
                    result.ErrorOffset = state.ChunkOffset;
                    break;
                }
                done += got;
                state.ChunkDone += got;
                if (got < wanted)
                {
                    Stop(ref result, state.ChunkOffset);
                    if (!IsLayered && !IsUncompressed)
                        result.Points = result.Points > Pointwise->UncertainPoints ? result.Points - Pointwise->UncertainPoints
                            : 0;
                }
                else if (state.ChunkDone == state.ChunkPoints)
                    state.ChunkOffset = IsUncompressed ? state.End : IsLayered ? state.ChunkEnd
                        : state.ChunkOffset + Pointwise->InputOffset;
            }
            State.Value = state;
            Result.Value = result;
        }

        LayeredChunk* Layered => (LayeredChunk*)Decoder.GetUnsafePtr();

        PointwiseChunk* Pointwise => (PointwiseChunk*)Decoder.GetUnsafePtr();

        int Decode(byte* input, in LasFileState state, int count)
        {
            byte* chunk = input + state.ChunkOffset;
            byte* batch = (byte*)BatchRecords.GetUnsafePtr();
            if (IsUncompressed)
            {
                long left = (state.End - state.ChunkOffset) / RecordBytes - state.ChunkDone;
                count = left < count ? (int)left : count;
                UnsafeUtility.MemCpy(batch, chunk + state.ChunkDone * RecordBytes, (long)count * RecordBytes);
                return count;
            }
            return IsLayered ? LayeredChunk.Decode(Layered, chunk, batch, count)
                : PointwiseChunk.Decode(Pointwise, chunk, state.End - state.ChunkOffset, batch, count);
        }

        // The number of points before the first that does not fit into 32 bits of the columns' grid.
        int Rescale(in LasRescaling rescaling, int count)
        {
            byte* record = (byte*)BatchRecords.GetUnsafePtr();
            for (int i = 0; i < count; i++, record += RecordBytes)
                if (!rescaling.TryRescale((int*)record))
                    return i;
            return count;
        }

        void CopyTile(long first, int count, ref DecodeResult result)
        {
            int skipped = Skip > first ? (int)(Skip - first < count ? Skip - first : count) : 0;
            if (count <= skipped)
                return;
            PointRecords.ToColumns((byte*)BatchRecords.GetUnsafePtr() + (long)skipped * RecordBytes, RecordBytes, count - skipped,
                Copies, (byte*)Columns.GetUnsafePtr(), (int)(first + skipped - Skip));
            result.Points = (int)(first + count - Skip);
        }

        static void Stop(ref DecodeResult result, long offset)
        {
            result.Error = LazError.Truncated;
            result.ErrorOffset = offset;
        }

        bool StartChunk(byte* input, ref LasFileState state)
        {
            long room = state.End - state.ChunkOffset;
            if (room < RecordBytes)
                return false;
            state.ChunkDone = 0;
            state.ChunkPoints = state.PointsOfChunks > 0 ? state.PointsOfChunks : state.PointsInFile;
            if (IsUncompressed)
                return state.ChunkPoints > 0;
            if (!IsLayered)
            {
                PointwiseChunk.Start(Pointwise);
                return state.ChunkPoints > 0;
            }
            byte* chunk = input + state.ChunkOffset;
            LayeredChunk.Start(Layered, chunk, room, true, state.ChunkPoints);
            long bytes = LayeredChunk.BytesOf(Layered, chunk, room, out long points);
            if (points > 0)
                state.ChunkPoints = points;
            state.ChunkEnd = state.ChunkOffset + bytes;
            return bytes > 0 && state.ChunkPoints > 0;
        }

        bool ReadHeader(byte* input, ref LasFileState state)
        {
            if (InputBytes < LasHeader.MinBytes || input[0] != 'L' || input[1] != 'A' || input[2] != 'S' || input[3] != 'F')
                return false;
            const int CompressionBits = 0xC0;
            if ((input[LasHeader.At.PointFormat] & ~CompressionBits) != PointFormat
                || (input[LasHeader.At.PointFormat] & CompressionBits) == 0 != IsUncompressed
                || *(ushort*)(input + LasHeader.At.RecordBytes) != RecordBytes)
                return false;
            long headerBytes = *(ushort*)(input + LasHeader.At.HeaderBytes);
            state.PointsInFile = *(uint*)(input + LasHeader.At.LegacyCount);
            if (state.PointsInFile == 0 && headerBytes >= LasHeader.At.ByReturn && InputBytes >= LasHeader.At.ByReturn)
                state.PointsInFile = *(long*)(input + LasHeader.At.Count64);
            if (IsUncompressed)
            {
                state.ChunkOffset = *(uint*)(input + LasHeader.At.PointsOffset);
                state.End = InputBytes;
                return true;
            }
            state.ChunkOffset = *(uint*)(input + LasHeader.At.PointsOffset)
                + (long)(Compressor == LazCompressor.Pointwise ? 0 : LazChunkTable.TableOffsetSize);
            state.End = EndOfChunks(input, state.ChunkOffset);
            return ReadVlrs(input, headerBytes > LasHeader.MinBytes ? headerBytes : LasHeader.MinBytes, ref state);
        }

        // The chunk table's offset, if there is one: it ends the last chunk, whatever a count claims.
        long EndOfChunks(byte* input, long firstChunk)
        {
            if (Compressor == LazCompressor.Pointwise || firstChunk > InputBytes)
                return InputBytes;
            long table = *(long*)(input + firstChunk - LazChunkTable.TableOffsetSize);
            return table > firstChunk && table <= InputBytes ? table : InputBytes;
        }

        bool ReadVlrs(byte* input, long at, ref LasFileState state)
        {
            const int UserId = 2, LastOfUserId = UserId + 13;
            long end = state.ChunkOffset < InputBytes ? state.ChunkOffset : InputBytes;
            for (uint i = *(uint*)(input + LasHeader.At.VlrCount); i > 0 && at + LasVlr.HeaderBytes <= end; i--)
            {
                byte* vlr = input + at;
                long bytes = *(ushort*)(vlr + 20);
                byte* data = vlr + LasVlr.HeaderBytes;
                at += LasVlr.HeaderBytes + bytes;
                // "laszip encoded" is the only user id that begins and ends so and has this record id.
                bool isLaszip = *(ushort*)(vlr + 18) == LazFormat.RecordId && vlr[UserId] == 'l' && vlr[LastOfUserId] == 'd';
                if (!isLaszip || at > end || bytes < LazFormat.ItemCountOffset + Items.Length)
                    continue;
                uint chunkPoints = *(uint*)(data + 12);
                state.PointsOfChunks = Compressor == LazCompressor.Pointwise || chunkPoints == LazFormat.VariableChunkPoints
                    ? 0 : chunkPoints;
                return *(ushort*)data == (int)Compressor && *(ushort*)(data + 2) == 0
                    && UnsafeUtility.MemCmp(data + LazFormat.ItemCountOffset, Items.GetUnsafeReadOnlyPtr(), Items.Length) == 0;
            }
            return false;
        }
    }

    struct LasFileState
    {
        public long PointsInFile;
        public long PointsOfChunks; // Of every chunk except the last; 0 if chunks say so themselves.

        public long ChunkOffset;
        public long ChunkEnd; // Known in advance for layered chunks only.

        // Of the current chunk, and those that are done; both 0 before a chunk is started.
        public long ChunkPoints;
        public long ChunkDone;
        public long End;
        public LasRescaling Rescaling;
    }

    // To another scale and offset: exactly, to the nearest whole number of steps if allowed, or not at all.
    unsafe struct LasRescaling
    {
        public bool IsSame;

        Axis m_x;
        Axis m_y;
        Axis m_z;

        struct Axis
        {
            public long Factor;
            public long Shift;

            public readonly bool TryRescale(ref int value)
            {
                // This stays below 2^28 * 2^31 + 2^59, so it cannot overflow.
                long rescaled = value * Factor + Shift;
                if (rescaled != (int)rescaled)
                    return false;
                value = (int)rescaled;
                return true;
            }
        }

        // False if the file's steps are not whole steps of the grid. roundsOffset: if steps are the same, offsets are rounded to
        // the nearest that lie whole steps apart.
        public static bool TryMake(byte* header, in PositionTransform grid, bool roundsOffset, out LasRescaling rescaling)
        {
            double* scale = (double*)(header + LasHeader.At.Scale), offset = (double*)(header + LasHeader.At.Offset);
            rescaling = default;
            // Nodes that are all alike are read whatever their scale is, even zero or NaN.
            rescaling.IsSame = AreSame(scale, offset, grid);
            return rescaling.IsSame || TryMake(scale[0], offset[0], grid.Scale.x, grid.Offset.x, roundsOffset, out rescaling.m_x)
                && TryMake(scale[1], offset[1], grid.Scale.y, grid.Offset.y, roundsOffset, out rescaling.m_y)
                && TryMake(scale[2], offset[2], grid.Scale.z, grid.Offset.z, roundsOffset, out rescaling.m_z);
        }

        // False if a position does not fit into 32 bits on the grid: it is left half-converted.
        public readonly bool TryRescale(int* position) =>
            m_x.TryRescale(ref position[0]) && m_y.TryRescale(ref position[1]) && m_z.TryRescale(ref position[2]);

        static bool AreSame(double* scale, double* offset, in PositionTransform grid)
        {
            for (int axis = 0; axis < 3; axis++)
                if (math.aslong(scale[axis]) != math.aslong(grid.Scale[axis])
                    || math.aslong(offset[axis]) != math.aslong(grid.Offset[axis]))
                    return false;
            return true;
        }

        static bool TryMake(double scale, double offset, double step, double origin, bool roundsOffset, out Axis axis)
        {
            axis = default;
            if (roundsOffset)
            {
                double shift = (offset - origin) / step;
                bool isNear = math.abs(scale - step) <= 1e-9 * math.abs(step) && math.abs(shift) <= int.MaxValue;
                axis = new Axis { Factor = 1, Shift = isNear ? (long)math.round(shift) : 0 };
                return isNear;
            }
            bool isRescaled = CommonGrid.TryRescale(scale, offset, step, origin, out var rescaled);
            axis = new Axis { Factor = rescaled.Factor, Shift = rescaled.Shift };
            return isRescaled && rescaled.Loss == 0 && axis.Factor != 0;
        }
    }
}
