using System;
using FastPoints.Points;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>A slot for nodes that are LAZ files: the file is read whole, then a chain of slices decodes it as far as the
    /// range goes.</summary>
    sealed unsafe class EptLazRead : EptRead
    {
        /// <summary>About 4 ms of decoding on one core.</summary>
        const int SlicePoints = 16384;

        const int MaxTileBytes = 64 << 10;

        readonly LazFormat m_format;
        readonly int m_tilePoints;
        NativeArray<byte> m_items;
        NativeArray<byte> m_decoder;
        NativeArray<byte> m_tile;
        NativeArray<LasFieldCopy> m_copies;
        NativeReference<LazFileState> m_state;

        public EptLazRead(EptReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_format = reader.Laz;
            m_tilePoints = Math.Max(1, Math.Min(LayeredChunk.TilePoints, MaxTileBytes / m_format.RecordBytes));
            try
            {
                m_copies = new NativeArray<LasFieldCopy>(LasCopyPlan.Make(reader.Las.Layout, Points), allocator);
                ConfigureDecoder(wanted, allocator);
            }
            catch (ArgumentException)
            {
                Dispose();
                throw;
            }
            m_items = new NativeArray<byte>(m_format.ItemBytesOfVlr(), allocator);
            m_tile = new NativeArray<byte>(m_tilePoints * m_format.RecordBytes, allocator, NativeArrayOptions.UninitializedMemory);
            m_state = new NativeReference<LazFileState>(allocator);
        }

        void ConfigureDecoder(PointSchema wanted, Allocator allocator)
        {
            if (!m_format.IsLayered)
            {
                m_decoder = new NativeArray<byte>((int)PointwiseChunk.StateBytes(m_format.Items), allocator,
                    NativeArrayOptions.UninitializedMemory);
                PointwiseChunk.Configure((PointwiseChunk*)m_decoder.GetUnsafePtr(), m_format.Items, m_format.RecordBytes);
                return;
            }
            var isWanted = LazLayerChoice.Make(m_format.Layers, Reader.Las.Layout, wanted);
            long bytes = LayeredChunk.StateBytes(m_format.Layers, isWanted, m_format.RecordBytes);
            m_decoder = new NativeArray<byte>((int)bytes, allocator, NativeArrayOptions.UninitializedMemory);
            LayeredChunk.Configure((LayeredChunk*)m_decoder.GetUnsafePtr(), m_format.Layers, isWanted, m_format.RecordBytes);
        }

        protected override JobHandle Schedule(BlockRange range, in EptBlock block)
        {
            var decoded = BeginRead(block, 0, (int)block.FileBytes, RangeCode.PaddingBytes);
            var header = Reader.Las.Header;
            var decode = new DecodeLazFileJob
            {
                Input = Input,
                InputBytes = (int)block.FileBytes,
                Transform = new PositionTransform { Scale = header.Scale, Offset = header.Offset },
                Items = m_items,
                Decoder = m_decoder,
                Tile = m_tile,
                Copies = m_copies,
                Columns = Points.Bytes,
                State = m_state,
                Result = Result,
                Compressor = m_format.Compressor,
                PointFormat = Reader.Las.Header.PointFormat,
                RecordBytes = m_format.RecordBytes,
                TilePoints = m_tilePoints,
                Skip = block.FirstInNode + range.First,
            };
            long total = decode.Skip + range.Count;
            for (; decode.First < total; decode.First += SlicePoints)
            {
                decode.Count = (int)Math.Min(SlicePoints, total - decode.First);
                decoded = decode.Schedule(decoded);
            }
            return decoded;
        }

        protected override void Tell(DecodeResult result)
        {
            if (result.Error == LazError.NoChunk)
                Reader.TellBroken(Range.Block, "its file is not what the other nodes' are: its points are left out",
                    "wanted LAZ of point format " + Reader.Las.Header.PointFormat + " with the items of the root", 0);
            else if (result.Error == LazError.OffGrid)
                Reader.TellBroken(Range.Block, "its positions do not lie on the root's grid: they are left out from there",
                    "wanted scale and offset that are whole steps of the root's, and places within 32 bits; read "
                    + result.Points + " points of " + Range.Count, result.ErrorOffset);
            else if (result.Error != LazError.None)
                Reader.TellBroken(Range.Block, "its file breaks off", "wanted " + Range.Count + " points, got " + result.Points,
                    result.ErrorOffset);
            else if (Range.Count > 0 && m_state.Value.PointsInFile != Reader.Block(Range.Block).NodePoints)
                Reader.TellBroken(Range.Block, "its file has another number of points than the hierarchy claims",
                    m_state.Value.PointsInFile + " in the file, " + Reader.Block(Range.Block).NodePoints + " claimed", -1);
        }

        protected override void DisposeTables()
        {
            Dispose(ref m_items);
            Dispose(ref m_decoder);
            Dispose(ref m_tile);
            if (m_copies.IsCreated)
                m_copies.Dispose();
            if (m_state.IsCreated)
                m_state.Dispose();
        }

        static void Dispose(ref NativeArray<byte> array)
        {
            if (array.IsCreated)
                array.Dispose();
        }
    }
}
