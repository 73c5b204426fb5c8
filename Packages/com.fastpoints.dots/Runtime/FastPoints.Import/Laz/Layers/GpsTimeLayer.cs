using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>The layer of GPS time: coded only where the first layer says that it changes. HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    unsafe struct GpsTimeLayer
    {
        const int ItemAt = 64;
        public const int ContextBytes = ItemAt + GpsTimeItem.StateBytes;

        long m_last;

        public static void StartContext(byte* memory, long time)
        {
            ((GpsTimeLayer*)memory)->m_last = time;
            GpsTimeItem.Start((GpsTimeItem*)(memory + ItemAt), time, true);
        }

        public static int Decode(LayerState* layer, byte* contexts, uint* points, byte* field, int stride, int count)
        {
            int channel = layer->Current;
            byte* memory = contexts + (long)channel * ContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                uint point = points[done];
                int context = (int)(point & PointContext.ChannelMask);
                if (context != channel)
                {
                    long last = ((GpsTimeLayer*)memory)->m_last;
                    channel = context;
                    memory = contexts + (long)channel * ContextBytes;
                    if (layer->TryAddContext(channel))
                        StartContext(memory, last);
                }
                if ((point & PointContext.TimeChangedBit) != 0)
                {
                    ((GpsTimeLayer*)memory)->m_last = GpsTimeItem.Decode((GpsTimeItem*)(memory + ItemAt), &layer->Stream);
                    if (layer->Stream.IsBeyondEnd)
                        break;
                }
                *(long*)field = ((GpsTimeLayer*)memory)->m_last;
                field += stride;
            }
            layer->Current = channel;
            return done;
        }

        public static void Encode(LayerState* layer, byte* contexts, uint* points, byte* field, int stride, int count)
        {
            int channel = layer->Current;
            byte* memory = contexts + (long)channel * ContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                uint point = points[i];
                if ((int)(point & PointContext.ChannelMask) != channel)
                {
                    long last = ((GpsTimeLayer*)memory)->m_last;
                    channel = (int)(point & PointContext.ChannelMask);
                    memory = contexts + (long)channel * ContextBytes;
                    if (layer->TryAddContext(channel))
                        StartContext(memory, last);
                }
                if ((point & PointContext.TimeChangedBit) != 0)
                    GpsTimeItem.Encode((GpsTimeItem*)(memory + ItemAt), &layer->Stream, *(long*)field);
                ((GpsTimeLayer*)memory)->m_last = *(long*)field;
            }
            layer->Current = channel;
        }
    }
}
