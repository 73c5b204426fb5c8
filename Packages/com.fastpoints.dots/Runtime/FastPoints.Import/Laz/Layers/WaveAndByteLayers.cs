namespace FastPoints.Laz
{
    /// <summary>The layers of wave packets, and of each extra byte. HPC#. In version 3 a change of channel predicts from
    /// the channel that is left: see <see cref="ColorLayer"/>.</summary>
    static unsafe class WaveAndByteLayers
    {
        public const int WaveContextBytes = (WavePacketItem.StateBytes + 63) / 64 * 64;

        const int ByteModelOffset = 64;
        public const int ByteContextBytes = ByteModelOffset + SymbolModel.Bytes256;

        public static void StartByteContext(byte* memory, byte last)
        {
            *memory = last;
            SymbolModel.Initialize(memory + ByteModelOffset, 256);
        }

        public static int DecodeWaves(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            int current = layer->Current;
            byte* memory = contexts + (long)current * WaveContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                int context = PointContext.ContextIndexOf(pointContexts[done], layer->FollowsChannel);
                byte* last = ((WavePacketItem*)memory)->Last;
                if (context != current)
                {
                    current = context;
                    memory = contexts + (long)current * WaveContextBytes;
                    bool isNew = layer->TryAddContext(current);
                    if (isNew)
                        // The item's first byte, the descriptor, is not predicted: only the 28 behind it count.
                        WavePacketItem.Start((WavePacketItem*)memory, last - 1);
                    if (isNew || layer->FollowsChannel != 0)
                        last = ((WavePacketItem*)memory)->Last;
                }
                WavePacketItem.Decode((WavePacketItem*)memory, last, &layer->Stream, field);
                if (layer->Stream.IsBeyondEnd)
                    break;
                field += stride;
            }
            layer->Current = current;
            return done;
        }

        public static int DecodeBytes(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            int current = layer->Current;
            byte* memory = contexts + (long)current * ByteContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                int context = PointContext.ContextIndexOf(pointContexts[done], layer->FollowsChannel);
                byte* last = memory;
                if (context != current)
                {
                    current = context;
                    memory = contexts + (long)current * ByteContextBytes;
                    bool isNew = layer->TryAddContext(current);
                    if (isNew)
                        StartByteContext(memory, *last);
                    if (isNew || layer->FollowsChannel != 0)
                        last = memory;
                }
                *last += (byte)SymbolModel.Decode(memory + ByteModelOffset, 256, ref value, ref length, ref next);
                if (next > end)
                    break;
                *field = *last;
                field += stride;
            }
            layer->SaveState(current, value, length, next);
            return done;
        }

        public static void EncodeWaves(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            int current = layer->Current;
            byte* memory = contexts + (long)current * WaveContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                int context = PointContext.ContextIndexOf(pointContexts[i], layer->FollowsChannel);
                byte* last = ((WavePacketItem*)memory)->Last;
                if (context != current)
                {
                    current = context;
                    memory = contexts + (long)current * WaveContextBytes;
                    bool isNew = layer->TryAddContext(current);
                    if (isNew)
                        WavePacketItem.Start((WavePacketItem*)memory, last - 1);
                    if (isNew || layer->FollowsChannel != 0)
                        last = ((WavePacketItem*)memory)->Last;
                }
                WavePacketItem.Encode((WavePacketItem*)memory, last, &layer->Stream, field);
            }
            layer->Current = current;
        }

        public static void EncodeBytes(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint low = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            int current = layer->Current;
            byte* memory = contexts + (long)current * ByteContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                int context = PointContext.ContextIndexOf(pointContexts[i], layer->FollowsChannel);
                byte* last = memory;
                if (context != current)
                {
                    current = context;
                    memory = contexts + (long)current * ByteContextBytes;
                    bool isNew = layer->TryAddContext(current);
                    if (isNew)
                        StartByteContext(memory, *last);
                    if (isNew || layer->FollowsChannel != 0)
                        last = memory;
                }
                SymbolModel.Encode(memory + ByteModelOffset, 256, (uint)(*field - *last & 255), ref low, ref length, ref next);
                *last = *field;
            }
            layer->SaveState(current, low, length, next);
        }
    }
}
