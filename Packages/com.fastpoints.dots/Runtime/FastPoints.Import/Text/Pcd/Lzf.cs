using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Text
{
    // LZF as liblzf writes it: literals of up to 32 bytes, and copies of up to 264 bytes from at most WindowBytes back.
    static unsafe class Lzf
    {
        public const int WindowBytes = 8192;

        // The most bytes that one step writes, and reads.
        public const int MaxWritten = 264;
        public const int MaxRead = 33;

        // Bytes written; 0 if the input ends before, -1 if it is damaged. known: bytes before the output that may be copied from.
        public static int Step(byte* input, long inputBytes, byte* output, long known, out int read)
        {
            read = 0;
            if (inputBytes < 1)
                return 0;
            int control = *input;
            if (control < 32)
            {
                if (inputBytes < control + 2)
                    return 0;
                read = control + 2;
                UnsafeUtility.MemCpy(output, input + 1, control + 1);
                return control + 1;
            }
            int length = control >> 5, header = length == 7 ? 3 : 2;
            if (inputBytes < header)
                return 0;
            if (length == 7)
                length += input[1];
            int back = ((control & 31) << 8) + input[header - 1] + 1;
            if (back > known)
                return -1;
            read = header;
            // Byte by byte: a copy may reach into what it writes.
            for (int i = 0; i < length + 2; i++)
                output[i] = output[i - back];
            return length + 2;
        }
    }

    struct LzfCheckpoint
    {
        public long Input;
        public int Skip; // Decoded bytes before the wanted ones.
    }

    struct LzfWalk
    {
        public long Input;
        public long Output;
        public int Checkpoints;
        public bool IsBroken;
    }

    // Decodes a piece of a stream and keeps only its checkpoints: the offset, and the window before it.
    [BurstCompile]
    unsafe struct WalkLzfJob : IJob
    {
        public const int SliceBytes = 1 << 20; // Decoded at most by one job, so that it stays short.

        public const int BufferBytes = Lzf.WindowBytes + SliceBytes + Lzf.MaxWritten;

        [ReadOnly] public NativeArray<byte> Input;
        public int InputBytes;
        public long DecodedBytes;
        public NativeArray<byte> Buffer; // Begins with the window before the piece.

        // Offsets of decoded bytes that get checkpoints, ascending.
        [ReadOnly] public NativeArray<long> Offsets;
        [WriteOnly] public NativeArray<LzfCheckpoint> Checkpoints;
        [WriteOnly] public NativeArray<byte> Windows;
        public NativeReference<LzfWalk> State;

        public void Execute()
        {
            var state = State.Value;
            byte* input = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* buffer = (byte*)Buffer.GetUnsafePtr();
            byte* windows = (byte*)Windows.GetUnsafePtr();
            int done = 0, taken = 0;
            while (done < SliceBytes && state.Output < DecodedBytes)
            {
                byte* output = buffer + Lzf.WindowBytes + done;
                int written = Lzf.Step(input + taken, InputBytes - taken, output, state.Output, out int bytes);
                if (written <= 0 || written > DecodedBytes - state.Output)
                {
                    state.IsBroken = written != 0 || taken == 0;
                    break;
                }
                long after = state.Output + written;
                for (; state.Checkpoints < Offsets.Length && Offsets[state.Checkpoints] < after; state.Checkpoints++)
                {
                    Checkpoints[state.Checkpoints] = new LzfCheckpoint
                    {
                        Input = state.Input,
                        Skip = (int)(Offsets[state.Checkpoints] - state.Output),
                    };
                    UnsafeUtility.MemCpy(windows + (long)state.Checkpoints * Lzf.WindowBytes, output - Lzf.WindowBytes,
                        Lzf.WindowBytes);
                }
                state.Output = after;
                state.Input += bytes;
                done += written;
                taken += bytes;
            }
            UnsafeUtility.MemMove(buffer, buffer + done, Lzf.WindowBytes);
            State.Value = state;
        }
    }

    // Where a wanted field of a range lies in the slot's input. Blittable.
    struct LzfSegment
    {
        public int FirstByte;
        public int Bytes;
        public int Checkpoint;
        public int Skip;
        public int FieldBytes;
        public int FirstCopy;
        public int Copies;
    }

    [BurstCompile]
    unsafe struct DecodeLzfJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input;
        [ReadOnly] public NativeArray<LzfSegment> Segments;
        [ReadOnly] public NativeArray<FieldCopy> Copies;
        [ReadOnly] public NativeArray<byte> Windows;
        public NativeArray<byte> Buffer;
        public int First;
        public int Count;
        public NativeArray<byte> Columns;
        public NativeReference<DecodeResult> Result;

        public void Execute()
        {
            byte* buffer = (byte*)Buffer.GetUnsafePtr();
            byte* decoded = buffer + Lzf.WindowBytes;
            byte* windows = (byte*)Windows.GetUnsafeReadOnlyPtr();
            for (int i = 0; i < Segments.Length; i++)
            {
                var segment = Segments[i];
                UnsafeUtility.MemCpy(buffer, windows + (long)segment.Checkpoint * Lzf.WindowBytes, Lzf.WindowBytes);
                byte* input = (byte*)Input.GetUnsafeReadOnlyPtr() + segment.FirstByte;
                long wanted = segment.Skip + (long)(First + Count) * segment.FieldBytes;
                int taken = 0;
                for (long done = 0; done < wanted;)
                {
                    int written = Lzf.Step(input + taken, segment.Bytes - taken, decoded + done, Lzf.WindowBytes, out int bytes);
                    if (written <= 0)
                    {
                        Result.Value = new DecodeResult { Error = 1 };
                        return;
                    }
                    done += written;
                    taken += bytes;
                }
                PointRecords.ToColumns(decoded + segment.Skip + (long)First * segment.FieldBytes, segment.FieldBytes, Count,
                    new FieldCopies((FieldCopy*)Copies.GetUnsafeReadOnlyPtr() + segment.FirstCopy, segment.Copies),
                    (byte*)Columns.GetUnsafePtr());
            }
            Result.Value = new DecodeResult { Points = Count };
        }
    }
}
