namespace FastPoints.Laz
{
    /// <summary>The layers of colour and near infrared. HPC#. In version 3 a point whose scanner channel changes to one that came
    /// before is predicted from, and remembered as, the last colour of the channel that it leaves.</summary>
    static unsafe class ColorLayer
    {
        public const int RgbContextBytes = RgbItem.StateBytes;

        const int InfraredUsedOffset = 64;
        const int InfraredByteOffset = InfraredUsedOffset + SymbolModel.Bytes4;
        public const int InfraredContextBytes = InfraredByteOffset + 2 * SymbolModel.Bytes256;

        public static void StartInfraredContext(byte* memory, ushort last)
        {
            *(ushort*)memory = last;
            SymbolModel.Initialize(memory + InfraredUsedOffset, 4);
            SymbolModel.Initialize(memory + InfraredByteOffset, 256);
            SymbolModel.Initialize(memory + InfraredByteOffset + SymbolModel.Bytes256, 256);
        }

        public static int DecodeRgb(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            int current = layer->Current;
            byte* memory = contexts + (long)current * RgbContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                int context = PointContext.ContextIndexOf(pointContexts[done], layer->FollowsChannel);
                ushort* last = ((RgbItem*)memory)->Last;
                if (context != current)
                {
                    current = context;
                    memory = contexts + (long)current * RgbContextBytes;
                    bool isNew = layer->TryAddContext(current);
                    if (isNew)
                        RgbItem.Start((RgbItem*)memory, (byte*)last);
                    if (isNew || layer->FollowsChannel != 0)
                        last = ((RgbItem*)memory)->Last;
                }
                RgbItem.Decode(memory, last, field, ref value, ref length, ref next);
                if (next > end)
                    break;
                field += stride;
            }
            layer->SaveState(current, value, length, next);
            return done;
        }

        public static int DecodeInfrared(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride,
            int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            int current = layer->Current;
            byte* memory = contexts + (long)current * InfraredContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                int context = PointContext.ContextIndexOf(pointContexts[done], layer->FollowsChannel);
                ushort* last = (ushort*)memory;
                if (context != current)
                {
                    current = context;
                    memory = contexts + (long)current * InfraredContextBytes;
                    bool isNew = layer->TryAddContext(current);
                    if (isNew)
                        StartInfraredContext(memory, *last);
                    if (isNew || layer->FollowsChannel != 0)
                        last = (ushort*)memory;
                }
                uint used = SymbolModel.Decode(memory + InfraredUsedOffset, 4, ref value, ref length, ref next);
                int low = *last & 255, high = *last >> 8;
                if ((used & 1) != 0)
                    low = low + (int)SymbolModel.Decode(memory + InfraredByteOffset, 256, ref value, ref length, ref next) & 255;
                if ((used & 2) != 0)
                    high = high + (int)SymbolModel.Decode(memory + InfraredByteOffset + SymbolModel.Bytes256, 256,
                        ref value, ref length, ref next) & 255;
                if (next > end)
                    break;
                *last = (ushort)(high << 8 | low);
                *(ushort*)field = *last;
                field += stride;
            }
            layer->SaveState(current, value, length, next);
            return done;
        }

        public static void EncodeRgb(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint low = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            int current = layer->Current;
            byte* memory = contexts + (long)current * RgbContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                int context = PointContext.ContextIndexOf(pointContexts[i], layer->FollowsChannel);
                ushort* last = ((RgbItem*)memory)->Last;
                if (context != current)
                {
                    current = context;
                    memory = contexts + (long)current * RgbContextBytes;
                    bool isNew = layer->TryAddContext(current);
                    if (isNew)
                        RgbItem.Start((RgbItem*)memory, (byte*)last);
                    if (isNew || layer->FollowsChannel != 0)
                        last = ((RgbItem*)memory)->Last;
                }
                RgbItem.Encode(memory, last, field, ref low, ref length, ref next);
            }
            layer->SaveState(current, low, length, next);
        }

        public static void EncodeInfrared(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride,
            int count)
        {
            uint low = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            int current = layer->Current;
            byte* memory = contexts + (long)current * InfraredContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                int context = PointContext.ContextIndexOf(pointContexts[i], layer->FollowsChannel);
                byte* last = memory;
                if (context != current)
                {
                    current = context;
                    memory = contexts + (long)current * InfraredContextBytes;
                    bool isNew = layer->TryAddContext(current);
                    if (isNew)
                        StartInfraredContext(memory, *(ushort*)last);
                    if (isNew || layer->FollowsChannel != 0)
                        last = memory;
                }
                uint used = (field[0] != last[0] ? 1u : 0) | (field[1] != last[1] ? 2u : 0);
                SymbolModel.Encode(memory + InfraredUsedOffset, 4, used, ref low, ref length, ref next);
                for (int b = 0; b < 2; b++)
                {
                    if ((used >> b & 1) != 0)
                        SymbolModel.Encode(memory + InfraredByteOffset + b * SymbolModel.Bytes256, 256,
                            (uint)(field[b] - last[b] & 255), ref low, ref length, ref next);
                    last[b] = field[b];
                }
            }
            layer->SaveState(current, low, length, next);
        }
    }
}
