using System;
using FastPoints.Las;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Laz
{
    // The first of several files of one format: the others are decoded by its header and items.
    sealed class LasTemplate
    {
        public readonly LasFile Las;
        public readonly LazFormat Laz; // Null for LAS.

        public LasTemplate(string path)
        {
            using var source = RandomAccessFile.Open(path);
            Las = LasFile.Read(source);
            Laz = Las.Header.IsCompressed ? LazFormat.Read(Las) : null;
            if (Laz != null && Laz.Compressor == LazCompressor.None)
                throw PointCloudException.Wanted(FailureCode.Unsupported, path, LasHeader.At.PointFormat, "LASzip compressor",
                    "1 to 3", 0);
        }
    }

    // Decodes whole LAS or LAZ files of one format from memory, one at a time: in a chain of slices as far as a range goes.
    sealed unsafe class LasFileDecoder : IDisposable
    {
        const int PointsPerSlice = 16384; // About 4 ms of decoding on one core.

        const int MaxBatchBytes = 64 << 10;

        readonly LasFile m_las;
        readonly LazFormat m_format;
        readonly PointBatch m_batch;
        readonly bool m_roundsOffset;
        readonly int m_batchPoints;
        NativeArray<byte> m_items;
        NativeArray<byte> m_decoder;
        NativeArray<byte> m_batchRecords;
        NativeArray<FieldCopy> m_copies;
        NativeReference<LasFileState> m_state;

        public LasFileDecoder(LasTemplate template, PointBatch batch, bool roundsOffset, Allocator allocator)
        {
            m_las = template.Las;
            m_format = template.Laz;
            m_batch = batch;
            m_roundsOffset = roundsOffset;
            int recordBytes = m_las.Header.RecordBytes;
            m_batchPoints = Math.Max(1, Math.Min(LayeredChunk.BatchPoints, MaxBatchBytes / recordBytes));
            m_copies = new NativeArray<FieldCopy>(FieldCopyPlan.Make(m_las.Layout.Fields, batch), allocator);
            bool isLayered = m_format != null && m_format.IsLayered;
            var isWanted = isLayered ? LazLayerChoice.Choose(m_format.Layers, m_las.Layout.Fields, batch.Schema) : null;
            m_decoder = m_format?.CreateDecoder(isWanted, allocator) ?? new NativeArray<byte>(1, allocator);
            m_items = new NativeArray<byte>(m_format != null ? LazItems.ToBytes(m_format.Items) : new byte[0], allocator);
            m_batchRecords = new NativeArray<byte>(m_batchPoints * recordBytes, allocator,
                NativeArrayOptions.UninitializedMemory);
            m_state = new NativeReference<LasFileState>(allocator);
        }

        public long PointsInFile => m_state.Value.PointsInFile;

        // input: the file with PaddingBytes of RangeCoder behind it, after inputDeps; first: counted from the file's start.
        public JobHandle Schedule(NativeArray<byte> input, int inputBytes, long first, int count,
            NativeReference<DecodeResult> result, JobHandle inputDeps)
        {
            var header = m_las.Header;
            var decode = new DecodeLasFileJob
            {
                Input = input,
                InputBytes = inputBytes,
                Transform = new PositionTransform { Scale = header.Scale, Offset = header.Offset },
                RoundsOffset = m_roundsOffset,
                Items = m_items,
                Decoder = m_decoder,
                BatchRecords = m_batchRecords,
                Copies = m_copies,
                Columns = m_batch.Bytes,
                State = m_state,
                Result = result,
                Compressor = m_format?.Compressor ?? LazCompressor.None,
                PointFormat = header.PointFormat,
                RecordBytes = header.RecordBytes,
                BatchPoints = m_batchPoints,
                Skip = first,
            };
            long total = first + count;
            for (; decode.First < total; decode.First += PointsPerSlice)
            {
                decode.Count = (int)Math.Min(PointsPerSlice, total - decode.First);
                inputDeps = decode.Schedule(inputDeps);
            }
            return inputDeps;
        }

        public void Dispose()
        {
            if (!m_state.IsCreated)
                return;
            m_items.Dispose();
            m_decoder.Dispose();
            m_batchRecords.Dispose();
            m_copies.Dispose();
            m_state.Dispose();
        }
    }
}
