using System;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Reading
{
    // Burst does not compile it, since the decompressor is managed code. It is still a job, so that later jobs can depend on it
    // and the main thread never waits for it (a Task allows neither).
    unsafe struct DecompressJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input;
        public int InputBytes;

        [WriteOnly] public NativeArray<byte> Output;
        public int Wanted;
        public bool IsFirst;

        // A GCHandle of a DecompressorHandle: jobs hold no references.
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
                bool isValid = slot.Decompressor.Decode(input, output, out int consumed, out int written);
                state.Consumed += consumed;
                state.IsBroken = !isValid || written < Wanted;
            }
            catch (Exception e)
            {
                // An exception that left a job would end as a line in Unity's log, with points that were never decoded.
                slot.Failure = e;
                state.IsBroken = true;
            }
        }
    }

    struct DecompressState
    {
        public int Consumed;

        // The stream broke off, or its decompressor failed.
        public bool IsBroken;
    }
}
