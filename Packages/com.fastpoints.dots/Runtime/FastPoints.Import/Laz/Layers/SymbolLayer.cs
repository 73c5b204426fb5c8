using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>The layers of classification, flags and user data: a symbol a point, in up to 64 contexts by the last one.
    /// HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    unsafe struct SymbolLayer
    {
        const int FlagSymbols = 64;
        const int ModelsOffset = 64;
        public const int ContextBytes = ModelsOffset + 64 * SymbolModel.Bytes256;

        int m_last;
        ulong m_made;

        public static void StartContext(byte* memory, LazLayerKind kind, byte field)
        {
            var context = (SymbolLayer*)memory;
            context->m_last = kind == LazLayerKind.Flags ? ToSymbol(field) : field;
            context->m_made = 0;
        }

        /// <summary>The flag byte without the channel: bits 0-3 and 6-7 as bits 0-5.</summary>
        static int ToSymbol(byte flags) => flags & 15 | flags >> 6 << 4;

        public static int Decode(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            var kind = layer->Kind;
            int current = layer->Current;
            byte* memory = contexts + (long)current * ContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                uint point = pointContexts[done];
                int context = (int)(point & PointContext.ChannelMask);
                int last = ((SymbolLayer*)memory)->m_last;
                if (context != current)
                {
                    current = context;
                    memory = contexts + (long)current * ContextBytes;
                    if (layer->TryAddContext(current))
                        *(SymbolLayer*)memory = new SymbolLayer { m_last = last };
                }
                byte* model = ModelOf((SymbolLayer*)memory, kind, point);
                int symbol = (int)SymbolModel.Decode(model, 256, ref value, ref length, ref next);
                if (next > end)
                    break;
                ((SymbolLayer*)memory)->m_last = symbol;
                *field = kind == LazLayerKind.Flags ? (byte)(symbol & 15 | symbol >> 4 << 6 | *field & 0x30) : (byte)symbol;
                field += stride;
            }
            layer->SaveState(current, value, length, next);
            return done;
        }

        public static void Encode(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint low = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            var kind = layer->Kind;
            int current = layer->Current;
            byte* memory = contexts + (long)current * ContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                uint point = pointContexts[i];
                if ((int)(point & PointContext.ChannelMask) != current)
                {
                    int left = ((SymbolLayer*)memory)->m_last;
                    current = (int)(point & PointContext.ChannelMask);
                    memory = contexts + (long)current * ContextBytes;
                    if (layer->TryAddContext(current))
                        *(SymbolLayer*)memory = new SymbolLayer { m_last = left };
                }
                byte* model = ModelOf((SymbolLayer*)memory, kind, point);
                int symbol = kind == LazLayerKind.Flags ? ToSymbol(*field) : *field;
                SymbolModel.Encode(model, 256, (uint)symbol, ref low, ref length, ref next);
                ((SymbolLayer*)memory)->m_last = symbol;
            }
            layer->SaveState(current, low, length, next);
        }

        /// <summary>The model by the last symbol, made on first use.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static byte* ModelOf(SymbolLayer* context, LazLayerKind kind, uint point)
        {
            int index = context->m_last;
            if (kind == LazLayerKind.Classification)
                index = (index & 31) << 1 | (PointContext.ReturnKind(point) == 3 ? 1 : 0);
            else if (kind == LazLayerKind.UserData)
                index >>= 2;
            byte* model = (byte*)context + ModelsOffset + index * SymbolModel.Bytes256;
            if ((context->m_made >> index & 1) == 0)
            {
                context->m_made |= 1ul << index;
                SymbolModel.Initialize((SymbolModel*)model, kind == LazLayerKind.Flags ? FlagSymbols : 256, 256);
            }
            return model;
        }
    }
}
