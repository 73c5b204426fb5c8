using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>The layer of Z: predicted by the last height at the same level of return. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    unsafe struct ZLayer
    {
        const int ModelContexts = 20;
        const int ZOffset = 64;
        public const int ContextBytes = ZOffset + 64 + ModelContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;

        int m_last;
        fixed int m_lastOfLevel[8];

        public static void StartContext(byte* memory, int z)
        {
            var context = (ZLayer*)memory;
            context->m_last = z;
            for (int i = 0; i < 8; i++)
                context->m_lastOfLevel[i] = z;
            IntegerModel.Initialize(memory + ZOffset, 32, ModelContexts);
        }

        public static int Decode(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            int current = layer->Current;
            byte* memory = contexts + (long)current * ContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                uint point = pointContexts[done];
                int context = (int)(point & PointContext.ChannelMask);
                if (context != current)
                {
                    int z = ((ZLayer*)memory)->m_last;
                    current = context;
                    memory = contexts + (long)current * ContextBytes;
                    if (layer->TryAddContext(current))
                        StartContext(memory, z);
                }
                int* last = ((ZLayer*)memory)->m_lastOfLevel + PointContext.Level(point);
                int added = *last + IntegerModel.Decode(memory + ZOffset, 32, ModelContexts, (int)(point >> PointContext.ZShift),
                    ref value, ref length, ref next);
                if (next > end)
                    break;
                *last = added;
                ((ZLayer*)memory)->m_last = added;
                *(int*)field = added;
                field += stride;
            }
            layer->SaveState(current, value, length, next);
            return done;
        }

        public static void Encode(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint low = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            int current = layer->Current;
            byte* memory = contexts + (long)current * ContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                uint point = pointContexts[i];
                if ((int)(point & PointContext.ChannelMask) != current)
                {
                    int z = ((ZLayer*)memory)->m_last;
                    current = (int)(point & PointContext.ChannelMask);
                    memory = contexts + (long)current * ContextBytes;
                    if (layer->TryAddContext(current))
                        StartContext(memory, z);
                }
                int* last = ((ZLayer*)memory)->m_lastOfLevel + PointContext.Level(point);
                IntegerModel.Encode(memory + ZOffset, 32, ModelContexts, (int)(point >> PointContext.ZShift),
                    *(int*)field - *last, out _, ref low, ref length, ref next);
                *last = ((ZLayer*)memory)->m_last = *(int*)field;
            }
            layer->SaveState(current, low, length, next);
        }
    }
}
