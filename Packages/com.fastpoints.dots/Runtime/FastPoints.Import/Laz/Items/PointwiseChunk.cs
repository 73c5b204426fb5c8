using System.Runtime.InteropServices;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Laz
{
    /// <summary>The coder of pointwise compressed chunks (point formats 0 to 5): the first point as it is, then one range-coded
    /// stream in which the items of each point follow each other. HPC#.</summary>
    /// <remarks>All state is this struct and what lies behind it in one segment of native memory without pointers: a chunk is
    /// decoded in slices of any number of points, and a copy of the bytes is a checkpoint.</remarks>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct PointwiseChunk
    {
        public const int MaxItems = 8;

        RangeStream m_stream;
        int m_pointsDone;
        int m_itemCount;
        int m_recordBytes;
        int m_isStopped;
        int m_pointsAtFirstEnd; // Points decoded when the stream could first have ended where the input does, and last; 0 before.
        int m_pointsAtLastEnd;
        fixed int m_type[MaxItems];
        fixed int m_version[MaxItems];
        fixed int m_bytes[MaxItems];
        fixed int m_recordOffset[MaxItems];
        fixed int m_stateOffset[MaxItems];

        public long InputOffset => m_stream.Offset;

        public bool IsAtEnd => m_pointsDone > 0 && m_pointsAtLastEnd == m_pointsDone;

        /// <summary>Number of the last decoded points behind the first place where the stream can have ended: if there are fewer
        /// points than claimed, these may not exist. They took no byte, and less than eight bits together.</summary>
        public int UncertainPoints => m_pointsAtFirstEnd == 0 ? 0 : m_pointsDone - m_pointsAtFirstEnd;

        public static long StateBytes(LazItem[] items)
        {
            long end = FirstStateOffset;
            foreach (var item in items)
                end += StateBytes(item);
            return end;
        }

        static int FirstStateOffset => (UnsafeUtility.SizeOf<PointwiseChunk>() + 63) / 64 * 64;

        static long StateBytes(LazItem item)
        {
            long bytes;
            switch (item.Type)
            {
                case LazItemType.Point10:
                    bytes = item.Version == 1 ? Point10ItemV1.StateBytes : Point10Item.StateBytes;
                    break;
                case LazItemType.GpsTime11:
                    bytes = item.Version == 1 ? GpsTimeItemV1.StateBytes : GpsTimeItem.StateBytes;
                    break;
                case LazItemType.Rgb12:
                    bytes = item.Version == 1 ? RgbItemV1.StateBytes : RgbItem.StateBytes;
                    break;
                case LazItemType.WavePacket13:
                    bytes = WavePacketItem.StateBytes;
                    break;
                default:
                    bytes = item.Version == 1 ? ExtraBytesItem.StateBytesV1(item.Bytes) : ExtraBytesItem.StateBytes(item.Bytes);
                    break;
            }
            return (bytes + 63) / 64 * 64;
        }

        /// <summary>Bytes of input that <paramref name="points"/> points of a chunk take at most: 15 bits a modelled symbol, and
        /// the raw bits.</summary>
        public static long MaxInputBytes(LazItem[] items, int recordBytes, long points)
        {
            long perPoint = 0;
            foreach (var item in items)
            {
                switch (item.Type)
                {
                    case LazItemType.Point10:
                        perPoint += 44;
                        break;
                    case LazItemType.GpsTime11:
                        perPoint += 24;
                        break;
                    case LazItemType.Rgb12:
                        perPoint += item.Version == 1 ? 28 : 14;
                        break;
                    case LazItemType.WavePacket13:
                        perPoint += 50;
                        break;
                    default:
                        perPoint += item.Bytes * (item.Version == 1 ? 4 : 2);
                        break;
                }
            }
            return recordBytes + 4 + perPoint * points;
        }

        /// <summary>Lays the items out in a state of <see cref="StateBytes(LazItem[])"/> bytes, aligned to 16.</summary>
        public static void Configure(PointwiseChunk* chunk, LazItem[] items, int recordBytes)
        {
            *chunk = default;
            chunk->m_itemCount = items.Length;
            chunk->m_recordBytes = recordBytes;
            long end = FirstStateOffset;
            for (int i = 0; i < items.Length; i++)
            {
                chunk->m_type[i] = (int)items[i].Type;
                chunk->m_version[i] = items[i].Version;
                chunk->m_bytes[i] = items[i].Bytes;
                chunk->m_recordOffset[i] = items[i].RecordOffset;
                chunk->m_stateOffset[i] = (int)end;
                end += StateBytes(items[i]);
            }
        }

        public static void Start(PointwiseChunk* chunk)
        {
            chunk->m_pointsDone = 0;
            chunk->m_isStopped = 0;
            chunk->m_pointsAtFirstEnd = 0;
            chunk->m_pointsAtLastEnd = 0;
            chunk->m_stream = default;
        }

        // The next input begins where the stream is.
        public static void Rebase(PointwiseChunk* chunk) => chunk->m_stream.Offset = 0;

        // Fewer points than count only where the input does not hold them. Behind the input lie PaddingBytes of RangeCoder.
        public static int Decode(PointwiseChunk* chunk, byte* input, long inputBytes, byte* records, int count)
        {
            if (chunk->m_isStopped != 0 || count <= 0)
                return 0;
            int recordBytes = chunk->m_recordBytes;
            int done = 0;
            if (chunk->m_pointsDone == 0)
            {
                if (inputBytes < recordBytes)
                {
                    chunk->m_isStopped = 1;
                    return 0;
                }
                UnsafeUtility.MemCpy(records, input, recordBytes);
                StartItems(chunk, records);
                chunk->m_stream.Start(input + recordBytes, input + inputBytes);
                records += recordBytes;
                done = 1;
                RecordEnd(chunk, input, done);
            }
            else
            {
                chunk->m_stream.Resume(input, input + inputBytes);
            }

            while (done < count)
            {
                DecodePoint(chunk, records);
                if (chunk->m_stream.IsAtEnd)
                {
                    if (chunk->m_stream.IsBeyondEnd)
                    {
                        chunk->m_isStopped = 1;
                        break;
                    }
                    RecordEnd(chunk, input, done + 1);
                }
                records += recordBytes;
                done++;
            }
            chunk->m_stream.Suspend(input);
            chunk->m_pointsDone += done;
            return done;
        }

        static void RecordEnd(PointwiseChunk* chunk, byte* input, int done)
        {
            if (!chunk->m_stream.CanEnd(input))
                return;
            chunk->m_pointsAtLastEnd = chunk->m_pointsDone + done;
            if (chunk->m_pointsAtFirstEnd == 0)
                chunk->m_pointsAtFirstEnd = chunk->m_pointsAtLastEnd;
        }

        static void StartItems(PointwiseChunk* chunk, byte* record)
        {
            for (int i = 0; i < chunk->m_itemCount; i++)
            {
                byte* state = (byte*)chunk + chunk->m_stateOffset[i];
                byte* field = record + chunk->m_recordOffset[i];
                int bytes = chunk->m_bytes[i];
                bool isV1 = chunk->m_version[i] == 1;
                switch ((LazItemType)chunk->m_type[i])
                {
                    case LazItemType.Point10:
                        if (isV1)
                            Point10ItemV1.Start((Point10ItemV1*)state, field);
                        else
                            Point10Item.Start((Point10Item*)state, field);
                        break;
                    case LazItemType.GpsTime11:
                        if (isV1)
                            GpsTimeItemV1.Start((GpsTimeItemV1*)state, *(long*)field);
                        else
                            GpsTimeItem.Start((GpsTimeItem*)state, *(long*)field, false);
                        break;
                    case LazItemType.Rgb12:
                        if (isV1)
                            RgbItemV1.Start((RgbItemV1*)state, field);
                        else
                            RgbItem.Start((RgbItem*)state, field);
                        break;
                    case LazItemType.WavePacket13:
                        WavePacketItem.Start((WavePacketItem*)state, field);
                        break;
                    default:
                        if (isV1)
                            ExtraBytesItem.StartV1(state, bytes, field);
                        else
                            ExtraBytesItem.Start(state, bytes, field);
                        break;
                }
            }
        }

        static void DecodePoint(PointwiseChunk* chunk, byte* record)
        {
            RangeStream* stream = &chunk->m_stream;
            for (int i = 0; i < chunk->m_itemCount; i++)
            {
                byte* state = (byte*)chunk + chunk->m_stateOffset[i];
                byte* field = record + chunk->m_recordOffset[i];
                bool isV1 = chunk->m_version[i] == 1;
                switch ((LazItemType)chunk->m_type[i])
                {
                    case LazItemType.Point10:
                        if (isV1)
                            Point10ItemV1.Decode((Point10ItemV1*)state, stream, field);
                        else
                            Point10Item.Decode((Point10Item*)state, stream, field);
                        break;
                    case LazItemType.GpsTime11:
                        *(long*)field = isV1
                            ? GpsTimeItemV1.Decode((GpsTimeItemV1*)state, stream)
                            : GpsTimeItem.Decode((GpsTimeItem*)state, stream);
                        break;
                    case LazItemType.Rgb12:
                        if (isV1)
                            RgbItemV1.Decode((RgbItemV1*)state, stream, field);
                        else
                            RgbItem.Decode((RgbItem*)state, stream, field);
                        break;
                    case LazItemType.WavePacket13:
                        WavePacketItem.Decode((WavePacketItem*)state, ((WavePacketItem*)state)->Last, stream, field);
                        break;
                    default:
                        if (isV1)
                            ExtraBytesItem.DecodeV1(state, chunk->m_bytes[i], stream, field);
                        else
                            ExtraBytesItem.Decode(state, chunk->m_bytes[i], stream, field);
                        break;
                }
            }
        }

        /// <summary>Begins to write a chunk of records: the first as it is.</summary>
        /// <param name="output">Has room for <see cref="MaxInputBytes"/> and <see cref="RangeCoder.PaddingBytes"/>.</param>
        public static void StartWriting(PointwiseChunk* chunk, byte* record, byte* output)
        {
            UnsafeUtility.MemCpy(output, record, chunk->m_recordBytes);
            StartItems(chunk, record);
            chunk->m_stream.StartWriting(output + chunk->m_recordBytes);
            chunk->m_stream.Suspend(output);
        }

        public static void Encode(PointwiseChunk* chunk, byte* records, int count, byte* output)
        {
            RangeStream* stream = &chunk->m_stream;
            stream->Resume(output, null);
            for (int point = 0; point < count; point++, records += chunk->m_recordBytes)
                for (int i = 0; i < chunk->m_itemCount; i++)
                {
                    byte* state = (byte*)chunk + chunk->m_stateOffset[i];
                    byte* field = records + chunk->m_recordOffset[i];
                    switch ((LazItemType)chunk->m_type[i])
                    {
                        case LazItemType.Point10:
                            Point10Item.Encode((Point10Item*)state, stream, field);
                            break;
                        case LazItemType.GpsTime11:
                            GpsTimeItem.Encode((GpsTimeItem*)state, stream, *(long*)field);
                            break;
                        case LazItemType.Rgb12:
                            RgbItem.Encode((RgbItem*)state, stream, field);
                            break;
                        case LazItemType.WavePacket13:
                            WavePacketItem.Encode((WavePacketItem*)state, ((WavePacketItem*)state)->Last, stream, field);
                            break;
                        default:
                            ExtraBytesItem.Encode(state, chunk->m_bytes[i], stream, field);
                            break;
                    }
                }
            stream->Suspend(output);
        }

        public static long EndWriting(PointwiseChunk* chunk, byte* output)
        {
            var stream = chunk->m_stream;
            stream.Resume(output, null);
            RangeCoder.EndEncoding(stream.Value, stream.Length, ref stream.Next);
            return stream.Next - output;
        }
    }
}
