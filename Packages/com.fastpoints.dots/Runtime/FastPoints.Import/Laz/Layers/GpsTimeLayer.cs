using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>The layer of GPS time: coded only where the first layer says that it changes. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    unsafe struct GpsTimeLayer
    {
        const int ItemOffset = 64;
        public const int ContextBytes = ItemOffset + GpsTimeItem.StateBytes;

        long m_last;

        public static void StartContext(byte* memory, long time)
        {
            ((GpsTimeLayer*)memory)->m_last = time;
            GpsTimeItem.Start((GpsTimeItem*)(memory + ItemOffset), time, true);
        }

        public static int Decode(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            int current = layer->Current;
            byte* memory = contexts + (long)current * ContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                uint point = pointContexts[done];
                int context = (int)(point & PointContext.ChannelMask);
                if (context != current)
                {
                    long last = ((GpsTimeLayer*)memory)->m_last;
                    current = context;
                    memory = contexts + (long)current * ContextBytes;
                    if (layer->TryAddContext(current))
                        StartContext(memory, last);
                }
                if ((point & PointContext.TimeChangedBit) != 0)
                {
                    ((GpsTimeLayer*)memory)->m_last = GpsTimeItem.Decode((GpsTimeItem*)(memory + ItemOffset), &layer->Stream);
                    if (layer->Stream.IsBeyondEnd)
                        break;
                }
                *(long*)field = ((GpsTimeLayer*)memory)->m_last;
                field += stride;
            }
            layer->Current = current;
            return done;
        }

        public static void Encode(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            int current = layer->Current;
            byte* memory = contexts + (long)current * ContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                uint point = pointContexts[i];
                if ((int)(point & PointContext.ChannelMask) != current)
                {
                    long last = ((GpsTimeLayer*)memory)->m_last;
                    current = (int)(point & PointContext.ChannelMask);
                    memory = contexts + (long)current * ContextBytes;
                    if (layer->TryAddContext(current))
                        StartContext(memory, last);
                }
                if ((point & PointContext.TimeChangedBit) != 0)
                    GpsTimeItem.Encode((GpsTimeItem*)(memory + ItemOffset), &layer->Stream, *(long*)field);
                ((GpsTimeLayer*)memory)->m_last = *(long*)field;
            }
            layer->Current = current;
        }
    }
}
