using System;
using System.Buffers;
using System.IO.Compression;
using System.Runtime.InteropServices;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Reading
{
    /// <summary>Decompressors for general compression of points. Before it opens a source, a project may register one
    /// that the framework lacks, or a faster one.</summary>
    /// <remarks>The framework decodes Brotli in .NET, in Unity's editor and in players of both scripting backends: Mono ships the
    /// native decoder since .NET Standard 2.1 (on Android since the fix of UUM-73753, in all 6000.x), IL2CPP links it in. If it
    /// is missing, a read fails and names <see cref="Brotli"/>. .NET Standard 2.1 has no zstandard decoder.</remarks>
    internal static class Decompressors
    {
        public static Func<StreamDecompressor> Brotli { get; set; } = () => new BrotliStreamDecompressor();

        public static Func<StreamDecompressor> Zstandard { get; set; } // EPT of data type zstandard; null for none.
    }

    // Streams of one kind, one after the other and piece by piece. Jobs call it on any thread, but only one at a time.
    internal abstract class StreamDecompressor : IDisposable
    {
        public abstract void Start();

        // False if the stream is broken. Consumed input is not passed again; the output is filled unless the stream has
        // ended or is broken.
        public abstract bool Decode(ReadOnlySpan<byte> input, Span<byte> output, out int consumed, out int written);

        public abstract void Dispose();
    }

    // RFC 7932, with the framework's own decoder, which allocates nothing once it has started.
    internal sealed class BrotliStreamDecompressor : StreamDecompressor
    {
        BrotliDecoder m_decoder;

        public override void Start()
        {
            m_decoder.Dispose();
            m_decoder = default;
        }

        public override bool Decode(ReadOnlySpan<byte> input, Span<byte> output, out int consumed, out int written)
        {
            consumed = written = 0;
            while (written < output.Length)
            {
                var status = m_decoder.Decompress(input.Slice(consumed), output.Slice(written), out int taken, out int made);
                consumed += taken;
                written += made;
                if (status == OperationStatus.InvalidData)
                    return false;
                if (status != OperationStatus.DestinationTooSmall || taken == 0 && made == 0)
                    break;
            }
            return true;
        }

        public override void Dispose() => m_decoder.Dispose();
    }

    sealed class DecompressorHandle : IDisposable
    {
        GCHandle m_handle;

        public DecompressorHandle(StreamDecompressor decompressor)
        {
            Decompressor = decompressor;
            m_handle = GCHandle.Alloc(this);
        }

        public StreamDecompressor Decompressor { get; }
        public Exception Failure { get; set; }
        public long Handle => (long)GCHandle.ToIntPtr(m_handle);

        public void Dispose()
        {
            if (!m_handle.IsAllocated)
                return;
            m_handle.Free();
            Decompressor.Dispose();
        }
    }

    // Burst does not compile it, since the decompressor is managed code. It is still a job, so that later jobs can depend on it
    // and the main thread never waits for it (a Task allows neither).
    unsafe struct DecompressJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Input;
        public int InputBytes;
        [WriteOnly] public NativeArray<byte> Output;
        public int Wanted;
        public bool IsFirst;
        public long Handle; // A GCHandle of a DecompressorHandle: jobs hold no references.

        public NativeReference<DecompressState> State;

        public void Execute()
        {
            var slot = (DecompressorHandle)GCHandle.FromIntPtr((IntPtr)Handle).Target;
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
                // An exception that left a job would only be logged by Unity, and the points never decoded.
                slot.Failure = e;
                state.IsBroken = true;
            }
        }
    }

    struct DecompressState
    {
        public int Consumed;
        public bool IsBroken;
    }
}
