using System.Runtime.InteropServices;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Laz
{
    /// <summary>The encoder of layered chunks, of items of version 3: one layer after another, each over all points, so that only
    /// one needs memory. HPC#.</summary>
    /// <remarks>All state is this struct and what lies behind it: a <see cref="PointContext"/> for each point, then the contexts
    /// of the layer that is written.</remarks>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct LayeredWriter
    {
        int m_layerCount;
        int m_recordBytes;
        int m_layer;
        int m_done;
        long m_end;
        long m_contextsOffset;
        fixed ushort m_returnContexts[256];
        fixed byte m_lastRecordOfChannel[4 * 32];
        LayerState m_state;

        static int PointContextsOffset => (UnsafeUtility.SizeOf<LayeredWriter>() + 63) / 64 * 64;

        static long ContextsOffset(int points) => (PointContextsOffset + 4L * points + 63) / 64 * 64;

        public static long StateBytes(LazLayer[] layers, int points)
        {
            long max = 0;
            foreach (var layer in layers)
            {
                long bytes = 4L * LayeredChunk.ContextBytes(layer.Kind);
                max = max > bytes ? max : bytes;
            }
            return ContextsOffset(points) + max;
        }

        /// <summary>Begins a chunk: the first point as it is, the number of points, and room for the layers' sizes.</summary>
        /// <param name="output">Has room for <see cref="LazLayer.MaxInputBytes"/> and
        /// <see cref="RangeCoder.PaddingBytes"/>.</param>
        public static void Start(LayeredWriter* writer, int layerCount, int recordBytes, byte* records, int points, byte* output)
        {
            *writer = default;
            writer->m_layerCount = layerCount;
            writer->m_recordBytes = recordBytes;
            writer->m_done = -1;
            writer->m_contextsOffset = ContextsOffset(points);
            ReturnContexts.WriteExtended(writer->m_returnContexts);
            UnsafeUtility.MemCpy(writer->m_lastRecordOfChannel + 32 * (records[15] >> 4 & 3), records, 30);
            UnsafeUtility.MemCpy(output, records, recordBytes);
            *(uint*)(output + recordBytes) = (uint)points;
            writer->m_end = LazLayer.ChunkHeaderBytes(recordBytes, layerCount);
        }

        /// <summary>What a layer takes at most of the budgets given to Encode.</summary>
        public static long CostOfLayer(int points) => points + 1 + CostOfSearch(points);

        // To see that nothing changes in a layer costs a sixteenth of coding it.
        static int CostOfSearch(int points) => 1 + points / 16;

        /// <summary>Continues for a budget: one for each point of each layer, and for searches.</summary>
        /// <returns>Bytes of the whole chunk, once it is; 0 before.</returns>
        public static long Encode(LayeredWriter* writer, LazLayer* layers, byte* records, int points, byte* output, int budget)
        {
            int coded = points - 1;
            while (writer->m_layer < writer->m_layerCount && budget > 0)
            {
                var layer = layers[writer->m_layer];
                if (writer->m_done < 0)
                {
                    budget -= CostOfSearch(coded);
                    if (writer->m_layer > 1 && !IsChanged(layer, records, writer->m_recordBytes, points))
                    {
                        End(writer, output, writer->m_end);
                        continue;
                    }
                    Begin(writer, layer, records, output);
                }
                int some = coded - writer->m_done;
                some = some < budget ? some : budget > 0 ? budget : 1;
                some = some < coded - writer->m_done ? some : coded - writer->m_done;
                writer->m_state.Stream.Resume(output, null);
                Encode(writer, records + (long)(1 + writer->m_done) * writer->m_recordBytes, some);
                writer->m_state.Stream.Suspend(output);
                writer->m_done += some;
                budget -= some;
                if (writer->m_done < coded)
                    continue;
                var stream = writer->m_state.Stream;
                stream.Resume(output, null);
                RangeCoder.EndEncoding(stream.Value, stream.Length, ref stream.Next);
                End(writer, output, stream.Next - output);
            }
            return writer->m_layer == writer->m_layerCount ? writer->m_end : 0;
        }

        static void Begin(LayeredWriter* writer, LazLayer layer, byte* records, byte* output)
        {
            int channel = records[15] >> 4 & 3;
            writer->m_done = 0;
            writer->m_state = new LayerState
            {
                Kind = layer.Kind,
                RecordOffset = layer.RecordOffset,
                FollowsChannel = layer.FollowsChannel ? 1 : 0,
                UsedContexts = 1 << channel,
                Current = channel,
            };
            writer->m_state.Stream.StartWriting(output + writer->m_end);
            writer->m_state.Stream.Suspend(output);
            byte* contexts = (byte*)writer + writer->m_contextsOffset;
            LayeredChunk.StartContext(layer.Kind, contexts + (long)channel * LayeredChunk.ContextBytes(layer.Kind),
                records + layer.RecordOffset);
        }

        // Where the layer begins, if nothing changes in it.
        static void End(LayeredWriter* writer, byte* output, long end)
        {
            *(uint*)(output + writer->m_recordBytes + 4 + 4 * writer->m_layer) = (uint)(end - writer->m_end);
            writer->m_end = end;
            writer->m_layer++;
            writer->m_done = -1;
        }

        static bool IsChanged(in LazLayer layer, byte* records, int recordBytes, int points)
        {
            byte* first = records + layer.RecordOffset;
            // The channel lies among the flags, and comes with the first layer.
            int mask = layer.Kind == LazLayerKind.Flags ? 0xCF : 0xFF;
            byte* field = first;
            for (int i = 1; i < points; i++)
            {
                field += recordBytes;
                for (int b = 0; b < layer.RecordBytes; b++)
                    if (((field[b] ^ first[b]) & mask) != 0)
                        return true;
            }
            return false;
        }

        static void Encode(LayeredWriter* writer, byte* records, int count)
        {
            LayerState* layer = &writer->m_state;
            byte* contexts = (byte*)writer + writer->m_contextsOffset;
            uint* pointContexts = (uint*)((byte*)writer + PointContextsOffset) + writer->m_done;
            byte* field = records + layer->RecordOffset;
            int stride = writer->m_recordBytes;
            switch (layer->Kind)
            {
                case LazLayerKind.ReturnsAndXY:
                    ReturnsLayer.Encode(layer, contexts, writer->m_returnContexts, pointContexts, writer->m_lastRecordOfChannel,
                        field, stride, count);
                    break;
                case LazLayerKind.Z:
                    ZLayer.Encode(layer, contexts, pointContexts, field, stride, count);
                    break;
                case LazLayerKind.Classification:
                case LazLayerKind.Flags:
                case LazLayerKind.UserData:
                    SymbolLayer.Encode(layer, contexts, pointContexts, field, stride, count);
                    break;
                case LazLayerKind.Intensity:
                case LazLayerKind.ScanAngle:
                case LazLayerKind.PointSource:
                    Integer16Layer.Encode(layer, contexts, pointContexts, field, stride, count);
                    break;
                case LazLayerKind.GpsTime:
                    GpsTimeLayer.Encode(layer, contexts, pointContexts, field, stride, count);
                    break;
                case LazLayerKind.Rgb:
                    ColorLayer.EncodeRgb(layer, contexts, pointContexts, field, stride, count);
                    break;
                case LazLayerKind.NearInfrared:
                    ColorLayer.EncodeInfrared(layer, contexts, pointContexts, field, stride, count);
                    break;
                case LazLayerKind.WavePacket:
                    WaveAndByteLayers.EncodeWaves(layer, contexts, pointContexts, field, stride, count);
                    break;
                default:
                    WaveAndByteLayers.EncodeBytes(layer, contexts, pointContexts, field, stride, count);
                    break;
            }
        }
    }
}
