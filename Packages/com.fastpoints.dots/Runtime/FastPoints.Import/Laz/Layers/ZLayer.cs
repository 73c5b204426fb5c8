using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>The layer of Z: predicted by the last height at the same level of return. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    unsafe struct ZLayer
    {
        const int Contexts = 20;
        const int ZAt = 64;
        public const int ContextBytes = ZAt + 64 + Contexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;

        int m_last;
        fixed int m_lastOfLevel[8];

        public static void StartContext(byte* memory, int z)
        {
            var context = (ZLayer*)memory;
            context->m_last = z;
            for (int i = 0; i < 8; i++)
                context->m_lastOfLevel[i] = z;
            IntegerModel.Initialize(memory + ZAt, 32, Contexts);
        }

        public static int Decode(LayerState* layer, byte* contexts, uint* points, byte* field, int stride, int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            int channel = layer->Current;
            byte* memory = contexts + (long)channel * ContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                uint point = points[done];
                int context = (int)(point & PointContext.ChannelMask);
                if (context != channel)
                {
                    int z = ((ZLayer*)memory)->m_last;
                    channel = context;
                    memory = contexts + (long)channel * ContextBytes;
                    if (layer->TryAddContext(channel))
                        StartContext(memory, z);
                }
                int* last = ((ZLayer*)memory)->m_lastOfLevel + PointContext.Level(point);
                int added = *last + IntegerModel.Decode(memory + ZAt, 32, Contexts, (int)(point >> PointContext.ZShift),
                    ref value, ref length, ref next);
                if (next > end)
                    break;
                *last = added;
                ((ZLayer*)memory)->m_last = added;
                *(int*)field = added;
                field += stride;
            }
            layer->SaveState(channel, value, length, next);
            return done;
        }

        public static void Encode(LayerState* layer, byte* contexts, uint* points, byte* field, int stride, int count)
        {
            uint low = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            int channel = layer->Current;
            byte* memory = contexts + (long)channel * ContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                uint point = points[i];
                if ((int)(point & PointContext.ChannelMask) != channel)
                {
                    int z = ((ZLayer*)memory)->m_last;
                    channel = (int)(point & PointContext.ChannelMask);
                    memory = contexts + (long)channel * ContextBytes;
                    if (layer->TryAddContext(channel))
                        StartContext(memory, z);
                }
                int* last = ((ZLayer*)memory)->m_lastOfLevel + PointContext.Level(point);
                IntegerModel.Encode(memory + ZAt, 32, Contexts, (int)(point >> PointContext.ZShift), *(int*)field - *last, out _,
                    ref low, ref length, ref next);
                *last = ((ZLayer*)memory)->m_last = *(int*)field;
            }
            layer->SaveState(channel, low, length, next);
        }
    }
}
