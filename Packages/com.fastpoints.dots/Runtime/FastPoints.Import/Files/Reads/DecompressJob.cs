using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>
    /// The next slice of a compressed stream into a buffer. Not compiled by Burst, since the decompressor is managed code; a job
    /// all the same, so that what follows can depend on it and nothing waits for it on the main thread (a Task could do neither).
    /// </summary>
    unsafe struct DecompressJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input;

        /// <summary>Bytes of the input that are there.</summary>
        public int InputBytes;

        [WriteOnly] public NativeArray<byte> Output;

        /// <summary>Bytes that the slice must give.</summary>
        public int Wanted;

        public bool IsFirst;

        /// <summary>A GCHandle of a <see cref="DecompressorHandle"/>: jobs hold no references.</summary>
        public long Slot;

        public NativeReference<DecompressState> State;

        public void Execute()
        {
            var slot = (DecompressorHandle)GCHandle.FromIntPtr((IntPtr)Slot).Target;
            var state = IsFirst ? default : State.Value;
            if (!state.IsBroken)
                Decode(slot, ref state);
            State.Value = state;
        }

        void Decode(DecompressorHandle slot, ref DecompressState state)
        {
            try
            {
                if (IsFirst)
                    slot.Decompressor.Start();
                byte* start = (byte*)Input.GetUnsafeReadOnlyPtr() + state.Consumed;
                var input = new ReadOnlySpan<byte>(start, InputBytes - state.Consumed);
                var output = new Span<byte>(Output.GetUnsafePtr(), Wanted);
                bool isSound = slot.Decompressor.Decode(input, output, out int consumed, out int written);
                state.Consumed += consumed;
                state.IsBroken = !isSound || written < Wanted;
            }
            catch (Exception e)
            {
                // An exception that left a job would end as a line in Unity's log, with points that were never decoded.
                slot.Failure = e;
                state.IsBroken = true;
            }
        }
    }

    /// <summary>How far a stream has been decoded, from slice to slice.</summary>
    struct DecompressState
    {
        /// <summary>Bytes of the input that are done with.</summary>
        public int Consumed;

        /// <summary>Whether the stream broke off, or its decompressor failed: nothing more comes of it.</summary>
        public bool IsBroken;
    }
}
