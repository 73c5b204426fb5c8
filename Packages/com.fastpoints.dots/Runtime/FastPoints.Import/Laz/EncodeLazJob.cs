using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Laz
{
    [BurstCompile]
    internal unsafe struct EncodeLazJob : IJob
    {
        // Points of a slice, and points of layers: 2 to 3 ms on one core.
        public const int SlicePoints = 4096, LayerPoints = 32768;

        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<LazLayer> Layers;
        public bool IsLayered;
        public int RecordBytes;
        public int Points;
        public NativeArray<byte> State;
        public NativeArray<byte> Output;
        public NativeReference<long> Bytes;
        public int First;
        public int Count;

        public void Execute()
        {
            byte* records = (byte*)Records.GetUnsafeReadOnlyPtr(), output = (byte*)Output.GetUnsafePtr();
            if (IsLayered)
            {
                var writer = (LayeredWriter*)State.GetUnsafePtr();
                if (First == 0)
                    LayeredWriter.Start(writer, Layers.Length, RecordBytes, records, Points, output);
                Bytes.Value = LayeredWriter.Encode(writer, (LazLayer*)Layers.GetUnsafeReadOnlyPtr(), records, Points, output,
                    Count);
                return;
            }
            var chunk = (PointwiseChunk*)State.GetUnsafePtr();
            int first = First;
            if (first == 0)
            {
                PointwiseChunk.StartWriting(chunk, records, output);
                first = 1;
            }
            PointwiseChunk.Encode(chunk, records + (long)first * RecordBytes, First + Count - first, output);
            if (First + Count == Points)
                Bytes.Value = PointwiseChunk.EndWriting(chunk, output);
        }
    }
}
