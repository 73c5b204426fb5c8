using System;
using FastPoints.Las;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Laz
{
    // One chunk at a time, in short jobs, in memory that is reused.
    internal sealed unsafe class LazChunkWriter : IDisposable
    {
        readonly LazChunkFormat m_chunkFormat;
        readonly NativeArray<LazLayer> m_layers;
        NativeArray<byte> m_state;
        NativeArray<byte> m_output;
        NativeReference<long> m_bytes = new NativeReference<long>(Allocator.Persistent);

        public LazChunkWriter(LazChunkFormat format)
        {
            m_chunkFormat = format;
            m_layers = new NativeArray<LazLayer>(format.Layers, Allocator.Persistent);
            m_state = new NativeArray<byte>((int)format.StateBytes, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            m_output = new NativeArray<byte>((int)format.MaxBytes, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            if (!format.IsLayered)
                PointwiseChunk.Configure((PointwiseChunk*)m_state.GetUnsafePtr(), format.Items, format.RecordBytes);
        }

        public NativeArray<byte> Chunk => m_output.GetSubArray(0, (int)m_bytes.Value);

        public JobHandle Schedule(NativeArray<byte> records, int points)
        {
            var job = new EncodeLazJob
            {
                Records = records,
                Layers = m_layers,
                IsLayered = m_chunkFormat.IsLayered,
                RecordBytes = m_chunkFormat.RecordBytes,
                Points = points,
                State = m_state,
                Output = m_output,
                Bytes = m_bytes,
            };
            var done = default(JobHandle);
            long all = m_chunkFormat.IsLayered ? m_chunkFormat.Layers.Length * LayeredWriter.CostOfLayer(points) : points;
            int slice = m_chunkFormat.IsLayered ? EncodeLazJob.LayerPointsPerSlice : EncodeLazJob.PointsPerSlice;
            for (long first = 0; first < all; first += slice)
            {
                job.First = (int)first;
                job.Count = (int)Math.Min(slice, all - first);
                done = job.Schedule(done);
            }
            return done;
        }

        public void Dispose()
        {
            if (!m_state.IsCreated)
                return;
            m_layers.Dispose();
            m_state.Dispose();
            m_output.Dispose();
            m_bytes.Dispose();
        }
    }

    internal sealed class LazChunkFormat
    {
        // LASzip's usual size, and the most memory of a chunk's output.
        const int DefaultPoints = 50000;
        const long MaxOutputBytes = 32 << 20;

        public readonly LazItem[] Items;
        public readonly LazLayer[] Layers;
        public readonly int RecordBytes;
        public readonly int ChunkPoints;

        // chunkPoints: the most of a chunk; 0 for LASzip's usual number, or fewer where records are long.
        public static LazChunkFormat Of(int pointFormat, int recordBytes, int chunkPoints = 0) => new LazChunkFormat(
            LazItems.Of(pointFormat, pointFormat >= LasPointFormat.FirstExtended ? 3 : 2,
                recordBytes - LasPointFormat.Of(pointFormat).RecordBytes), recordBytes, chunkPoints);

        public LazChunkFormat(LazItem[] items, int recordBytes, int chunkPoints = 0)
        {
            if (items[0].Version == 1)
                throw new ArgumentException("items as LASzip 1.x wrote them are read alone");
            RecordBytes = recordBytes;
            IsLayered = items[0].IsLayered;
            Items = items;
            Layers = IsLayered ? LazLayer.Of(Items) : Array.Empty<LazLayer>();
            ChunkPoints = chunkPoints > 0 ? chunkPoints
                : (int)Math.Max(1, Math.Min(DefaultPoints, MaxOutputBytes * 1000 / MaxBytesOf(1000)));
        }

        public bool IsLayered { get; }
        public long StateBytes => IsLayered ? LayeredWriter.StateBytes(Layers, ChunkPoints) : PointwiseChunk.StateBytes(Items);
        public long MaxBytes => MaxBytesOf(ChunkPoints) + RangeCoder.PaddingBytes;

        long MaxBytesOf(int points) => IsLayered ? LazLayer.MaxInputBytes(Layers, RecordBytes, points)
            : PointwiseChunk.MaxInputBytes(Items, RecordBytes, points);
    }

    [BurstCompile]
    internal unsafe struct EncodeLazJob : IJob
    {
        // Of pointwise chunks; of layered ones, points times layers: 2 to 3 ms on one core.
        public const int PointsPerSlice = 4096, LayerPointsPerSlice = 32768;

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
