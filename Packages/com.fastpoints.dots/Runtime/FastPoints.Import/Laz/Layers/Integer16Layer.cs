using System.Runtime.InteropServices;

namespace FastPoints.Laz
{
    /// <summary>The layers of intensity, scan angle and point source: 16 bits a point. Intensity is coded for every point,
    /// predicted by the last one of the same kind of return; the others only where the first layer says that they change.
    /// HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    unsafe struct Integer16Layer
    {
        const int MaxContexts = 4;
        const int IntegerAt = 64;
        public const int ContextBytes = IntegerAt + 64 + MaxContexts * SymbolModel.Bytes17 + 16 * SymbolModel.Bytes256;

        int m_last;
        fixed ushort m_lastOfReturnKind[8];

        public static void StartContext(byte* memory, ushort field)
        {
            var context = (Integer16Layer*)memory;
            context->m_last = field;
            for (int i = 0; i < 8; i++)
                context->m_lastOfReturnKind[i] = field;
            IntegerModel.Initialize(memory + IntegerAt, 16, MaxContexts);
        }

        public static int Decode(LayerState* layer, byte* contexts, uint* points, byte* field, int stride, int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            var kind = layer->Kind;
            uint changedBit = kind == LazLayerKind.ScanAngle ? PointContext.AngleChangedBit : PointContext.SourceChangedBit;
            int channel = layer->Current;
            byte* memory = contexts + (long)channel * ContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                uint point = points[done];
                int context = (int)(point & PointContext.ChannelMask);
                if (context != channel)
                {
                    int last = ((Integer16Layer*)memory)->m_last;
                    channel = context;
                    memory = contexts + (long)channel * ContextBytes;
                    if (layer->TryAddContext(channel))
                        StartContext(memory, (ushort)last);
                }

                if (kind == LazLayerKind.Intensity)
                {
                    int returnKind = PointContext.ReturnKind(point);
                    ushort* last = ((Integer16Layer*)memory)->m_lastOfReturnKind
                        + (returnKind * 2 + (int)(point >> PointContext.TimeShift & 1));
                    *last = (ushort)(*last
                        + IntegerModel.Decode(memory + IntegerAt, 16, MaxContexts, returnKind, ref value, ref length, ref next));
                    ((Integer16Layer*)memory)->m_last = *last;
                }
                else if ((point & changedBit) != 0)
                {
                    int ofTime = kind == LazLayerKind.ScanAngle ? (int)(point >> PointContext.TimeShift & 1) : 0;
                    ((Integer16Layer*)memory)->m_last = (ushort)(((Integer16Layer*)memory)->m_last
                        + IntegerModel.Decode(memory + IntegerAt, 16, MaxContexts, ofTime, ref value, ref length, ref next));
                }
                if (next > end)
                    break;
                *(ushort*)field = (ushort)((Integer16Layer*)memory)->m_last;
                field += stride;
            }
            layer->SaveState(channel, value, length, next);
            return done;
        }

        public static void Encode(LayerState* layer, byte* contexts, uint* points, byte* field, int stride, int count)
        {
            uint low = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            bool isIntensity = layer->Kind == LazLayerKind.Intensity, isAngle = layer->Kind == LazLayerKind.ScanAngle;
            uint changedBit = isAngle ? PointContext.AngleChangedBit : PointContext.SourceChangedBit;
            int channel = layer->Current;
            byte* memory = contexts + (long)channel * ContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                uint point = points[i];
                int ofTime = (int)(point >> PointContext.TimeShift & 1);
                if ((int)(point & PointContext.ChannelMask) != channel)
                {
                    int left = ((Integer16Layer*)memory)->m_last;
                    channel = (int)(point & PointContext.ChannelMask);
                    memory = contexts + (long)channel * ContextBytes;
                    if (layer->TryAddContext(channel))
                        StartContext(memory, (ushort)left);
                }
                if (isIntensity)
                {
                    int returnKind = PointContext.ReturnKind(point);
                    ushort* last = ((Integer16Layer*)memory)->m_lastOfReturnKind + (returnKind * 2 + ofTime);
                    IntegerModel.Encode(memory + IntegerAt, 16, MaxContexts, returnKind, *(ushort*)field - *last, out _, ref low,
                        ref length, ref next);
                    *last = *(ushort*)field;
                }
                else if ((point & changedBit) != 0)
                {
                    IntegerModel.Encode(memory + IntegerAt, 16, MaxContexts, isAngle ? ofTime : 0,
                        *(ushort*)field - ((Integer16Layer*)memory)->m_last, out _, ref low, ref length, ref next);
                }
                ((Integer16Layer*)memory)->m_last = *(ushort*)field;
            }
            layer->SaveState(channel, low, length, next);
        }
    }
}
