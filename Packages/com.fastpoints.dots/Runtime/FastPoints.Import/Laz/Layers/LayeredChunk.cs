using System.Runtime.InteropServices;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Laz
{
    /// <summary>The decoder of layered chunks (point formats 6 to 10): the first point as it is, the number of points, each
    /// layer's size, then the layers, each a range-coded stream of its own. HPC#.</summary>
    /// <remarks>A batch of points is decoded layer by layer, not point by point: the first layer leaves a
    /// <see cref="PointContext"/> for each point, the others read these, and each keeps its stream in registers throughout.
    /// Layers that are not wanted are not touched (their bytes keep whatever the caller's records hold), nor need they be in the
    /// input. All state is this struct and what lies behind it, without pointers.</remarks>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct LayeredChunk
    {
        public const int BatchPoints = 512; // Points decoded at once: contexts and records of a batch stay in the nearest caches.

        int m_layerCount;
        int m_recordBytes;
        int m_pointsDone;
        int m_isStopped;
        uint m_pointsInChunk;
        int m_firstRecordOffset;
        fixed ushort m_returnContexts[256];
        fixed uint m_pointContexts[BatchPoints];

        static int LayersOffset => (UnsafeUtility.SizeOf<LayeredChunk>() + 63) / 64 * 64;

        static LayerState* Layers(LayeredChunk* chunk) => (LayerState*)((byte*)chunk + LayersOffset);

        static int FirstRecordOffset(int layerCount) =>
            (LayersOffset + layerCount * UnsafeUtility.SizeOf<LayerState>() + 63) / 64 * 64;

        internal static int ContextBytes(LazLayerKind kind) => kind switch
        {
            LazLayerKind.ReturnsAndXY => ReturnsLayer.ContextBytes,
            LazLayerKind.Z => ZLayer.ContextBytes,
            LazLayerKind.Classification or LazLayerKind.Flags or LazLayerKind.UserData => SymbolLayer.ContextBytes,
            LazLayerKind.Intensity or LazLayerKind.ScanAngle or LazLayerKind.PointSource => Integer16Layer.ContextBytes,
            LazLayerKind.GpsTime => GpsTimeLayer.ContextBytes,
            LazLayerKind.Rgb => ColorLayer.RgbContextBytes,
            LazLayerKind.NearInfrared => ColorLayer.InfraredContextBytes,
            LazLayerKind.WavePacket => WaveAndByteLayers.WaveContextBytes,
            _ => WaveAndByteLayers.ByteContextBytes,
        };

        public static long StateBytes(LazLayer[] layers, bool[] isWanted, int recordBytes)
        {
            long end = FirstRecordOffset(layers.Length) + (recordBytes + 63) / 64 * 64;
            for (int i = 0; i < layers.Length; i++)
                if (isWanted[i])
                    end += 4L * ContextBytes(layers[i].Kind);
            return end;
        }

        /// <summary>Lays the layers out in a state of <see cref="StateBytes"/> bytes, aligned to 16.</summary>
        /// <param name="isWanted">Whether each layer is wanted; the first must be, for its contexts.</param>
        public static void Configure(LayeredChunk* chunk, LazLayer[] layers, bool[] isWanted, int recordBytes)
        {
            *chunk = default;
            chunk->m_layerCount = layers.Length;
            chunk->m_recordBytes = recordBytes;
            chunk->m_firstRecordOffset = FirstRecordOffset(layers.Length);
            ReturnContexts.WriteExtended(chunk->m_returnContexts);
            long end = chunk->m_firstRecordOffset + (recordBytes + 63) / 64 * 64;
            for (int i = 0; i < layers.Length; i++)
            {
                LayerState* layer = Layers(chunk) + i;
                *layer = default;
                layer->Kind = layers[i].Kind;
                layer->RecordOffset = layers[i].RecordOffset;
                layer->RecordBytes = layers[i].RecordBytes;
                layer->MaxInputBytesPerPoint = layers[i].MaxInputBytesPerPoint;
                layer->FollowsChannel = layers[i].FollowsChannel ? 1 : 0;
                layer->IsWanted = isWanted[i] ? 1 : 0;
                layer->ContextsOffset = end;
                if (isWanted[i])
                    end += 4L * ContextBytes(layers[i].Kind);
            }
        }

        /// <summary>Whether what lies there can be the chunk that a table or a hierarchy says it is: its own count is the same,
        /// or its layers together are as long. If neither holds, it would decode to points that were never written.</summary>
        /// <param name="points">Of the chunk, as told.</param>
        /// <param name="bytes">Of the chunk, as told.</param>
        public static bool IsPlausible(LayeredChunk* chunk, byte* input, long inputBytes, long points, long bytes)
        {
            long end = BytesOf(chunk, input, inputBytes, out long pointsInChunk);
            return end == 0 || pointsInChunk == points || end == bytes;
        }

        /// <summary>Bytes of the chunk by its own header, and its points; 0 where the header is not all there.</summary>
        public static long BytesOf(LayeredChunk* chunk, byte* input, long inputBytes, out long points)
        {
            points = 0;
            long end = LazLayer.ChunkHeaderBytes(chunk->m_recordBytes, chunk->m_layerCount);
            if (inputBytes < end)
                return 0;
            points = *(uint*)(input + chunk->m_recordBytes);
            for (int i = 0; i < chunk->m_layerCount; i++)
                end += *(uint*)(input + chunk->m_recordBytes + 4 + 4 * i);
            return end;
        }

        /// <summary>Starts at a chunk's first byte.</summary>
        /// <param name="input">The chunk's header, then its layers. Behind <paramref name="inputBytes"/> there are
        /// <see cref="RangeCoder.PaddingBytes"/> more that may be read.</param>
        /// <param name="hasAllLayers">Whether all layers are there. Otherwise only the wanted ones follow each other, of each no
        /// more than <paramref name="points"/> points take.</param>
        /// <param name="points">Points that will be asked for.</param>
        public static void Start(LayeredChunk* chunk, byte* input, long inputBytes, bool hasAllLayers, long points)
        {
            int headerBytes = LazLayer.ChunkHeaderBytes(chunk->m_recordBytes, chunk->m_layerCount);
            chunk->m_pointsDone = 0;
            chunk->m_pointsInChunk = 0;
            chunk->m_isStopped = inputBytes < headerBytes ? 1 : 0;
            if (chunk->m_isStopped != 0)
                return;

            UnsafeUtility.MemCpy((byte*)chunk + chunk->m_firstRecordOffset, input, chunk->m_recordBytes);
            chunk->m_pointsInChunk = *(uint*)(input + chunk->m_recordBytes);
            byte* sizes = input + chunk->m_recordBytes + 4;
            long at = headerBytes;
            for (int i = 0; i < chunk->m_layerCount; i++)
            {
                LayerState* layer = Layers(chunk) + i;
                long bytes = *(uint*)(sizes + 4 * i);
                if (layer->IsWanted == 0 && !hasAllLayers)
                    continue;
                long there = bytes;
                long enough = LazLayer.StartBytes + layer->MaxInputBytesPerPoint * points;
                if (!hasAllLayers && there > enough)
                    there = enough;
                if (layer->IsWanted != 0)
                    StartLayer(chunk, layer, input, inputBytes, at, there);
                at += there;
            }
        }

        static void StartLayer(LayeredChunk* chunk, LayerState* layer, byte* input, long inputBytes, long at, long bytes)
        {
            layer->HasBytes = bytes > 0 ? 1 : 0;
            layer->Stream = default;
            layer->EndOffset = at + bytes < inputBytes ? at + bytes : inputBytes;
            if (bytes > 0 && at <= inputBytes)
            {
                layer->Stream.Start(input + at, input + layer->EndOffset);
                layer->Stream.Suspend(input);
            }
            else
            {
                // The chunk has the layer, the input does not: beyond its end from the start, so that no point is decoded.
                layer->Stream.Offset = layer->EndOffset + 1;
            }

            byte* first = (byte*)chunk + chunk->m_firstRecordOffset;
            int channel = first[15] >> 4 & 3;
            layer->UsedContexts = 1 << channel;
            layer->Current = channel;
            StartContext(layer->Kind, (byte*)chunk + layer->ContextsOffset + (long)channel * ContextBytes(layer->Kind),
                first + layer->RecordOffset);
        }

        internal static void StartContext(LazLayerKind kind, byte* memory, byte* field)
        {
            switch (kind)
            {
                case LazLayerKind.ReturnsAndXY:
                    ReturnsLayer.StartContext(memory, *(int*)field, *(int*)(field + 4), field[14]);
                    break;
                case LazLayerKind.Z:
                    ZLayer.StartContext(memory, *(int*)field);
                    break;
                case LazLayerKind.Classification:
                case LazLayerKind.Flags:
                case LazLayerKind.UserData:
                    SymbolLayer.StartContext(memory, kind, *field);
                    break;
                case LazLayerKind.Intensity:
                case LazLayerKind.ScanAngle:
                case LazLayerKind.PointSource:
                    Integer16Layer.StartContext(memory, *(ushort*)field);
                    break;
                case LazLayerKind.GpsTime:
                    GpsTimeLayer.StartContext(memory, *(long*)field);
                    break;
                case LazLayerKind.Rgb:
                    RgbItem.Start((RgbItem*)memory, field);
                    break;
                case LazLayerKind.NearInfrared:
                    ColorLayer.StartInfraredContext(memory, *(ushort*)field);
                    break;
                case LazLayerKind.WavePacket:
                    WavePacketItem.Start((WavePacketItem*)memory, field);
                    break;
                default:
                    WaveAndByteLayers.StartByteContext(memory, *field);
                    break;
            }
        }

        /// <summary>Decodes the chunk's next points into the wanted bytes of their records.</summary>
        /// <param name="count">At most <see cref="BatchPoints"/>.</param>
        /// <returns>Points decoded: fewer than <paramref name="count"/> only where the input does not hold them.</returns>
        public static int Decode(LayeredChunk* chunk, byte* input, byte* records, int count)
        {
            if (chunk->m_isStopped != 0 || count <= 0)
                return 0;
            int wanted = count;
            if (chunk->m_pointsInChunk != 0 && count > chunk->m_pointsInChunk - chunk->m_pointsDone)
                count = (int)(chunk->m_pointsInChunk - chunk->m_pointsDone);

            int recordBytes = chunk->m_recordBytes;
            int raw = 0;
            if (chunk->m_pointsDone == 0 && count > 0)
            {
                UnsafeUtility.MemCpy(records, (byte*)chunk + chunk->m_firstRecordOffset, recordBytes);
                raw = 1;
            }

            LayerState* layers = Layers(chunk);
            int coded = count - raw;
            for (int i = 0; i < chunk->m_layerCount && coded > 0; i++)
            {
                if (layers[i].IsWanted == 0)
                    continue;
                byte* batch = records + (long)raw * recordBytes;
                int done = coded;
                if (layers[i].HasBytes == 0 && i > 0)
                {
                    Repeat(chunk, layers + i, batch, coded);
                }
                else if (layers[i].Stream.Offset > layers[i].EndOffset)
                {
                    done = 0;
                }
                else
                {
                    layers[i].Stream.Resume(input, input + layers[i].EndOffset);
                    done = DecodeLayer(chunk, layers + i, batch, coded);
                    layers[i].Stream.Suspend(input);
                }
                coded = done;
            }
            int total = raw + coded;
            chunk->m_pointsDone += total;
            chunk->m_isStopped = total < wanted ? 1 : 0;
            return total;
        }

        static int DecodeLayer(LayeredChunk* chunk, LayerState* layer, byte* batch, int count)
        {
            byte* contexts = (byte*)chunk + layer->ContextsOffset;
            uint* pointContexts = chunk->m_pointContexts;
            byte* field = batch + layer->RecordOffset;
            int stride = chunk->m_recordBytes;
            switch (layer->Kind)
            {
                case LazLayerKind.ReturnsAndXY:
                    int flags = ((byte*)chunk + chunk->m_firstRecordOffset)[layer->RecordOffset + 15] & 0xCF;
                    return ReturnsLayer.Decode(layer, contexts, chunk->m_returnContexts, pointContexts, flags, field, stride,
                        count);
                case LazLayerKind.Z:
                    return ZLayer.Decode(layer, contexts, pointContexts, field, stride, count);
                case LazLayerKind.Classification:
                case LazLayerKind.Flags:
                case LazLayerKind.UserData:
                    return SymbolLayer.Decode(layer, contexts, pointContexts, field, stride, count);
                case LazLayerKind.Intensity:
                case LazLayerKind.ScanAngle:
                case LazLayerKind.PointSource:
                    return Integer16Layer.Decode(layer, contexts, pointContexts, field, stride, count);
                case LazLayerKind.GpsTime:
                    return GpsTimeLayer.Decode(layer, contexts, pointContexts, field, stride, count);
                case LazLayerKind.Rgb:
                    return ColorLayer.DecodeRgb(layer, contexts, pointContexts, field, stride, count);
                case LazLayerKind.NearInfrared:
                    return ColorLayer.DecodeInfrared(layer, contexts, pointContexts, field, stride, count);
                case LazLayerKind.WavePacket:
                    return WaveAndByteLayers.DecodeWaves(layer, contexts, pointContexts, field, stride, count);
                default:
                    return WaveAndByteLayers.DecodeBytes(layer, contexts, pointContexts, field, stride, count);
            }
        }

        /// <summary>A layer that nothing changes in: each point has what the first has. Flags have been written by the first
        /// layer, beside the channel.</summary>
        static void Repeat(LayeredChunk* chunk, LayerState* layer, byte* batch, int count)
        {
            if (layer->Kind == LazLayerKind.Flags)
                return;
            byte* first = (byte*)chunk + chunk->m_firstRecordOffset + layer->RecordOffset;
            byte* field = batch + layer->RecordOffset;
            for (int i = 0; i < count; i++)
            {
                UnsafeUtility.MemCpy(field, first, layer->RecordBytes);
                field += chunk->m_recordBytes;
            }
        }
    }
}
