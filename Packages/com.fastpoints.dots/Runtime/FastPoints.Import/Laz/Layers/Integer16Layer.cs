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
        const int IntegerOffset = 64;
        public const int ContextBytes = IntegerOffset + 64 + MaxContexts * SymbolModel.Bytes17 + 16 * SymbolModel.Bytes256;

        int m_last;
        fixed ushort m_lastOfReturnKind[8];

        public static void StartContext(byte* memory, ushort field)
        {
            var context = (Integer16Layer*)memory;
            context->m_last = field;
            for (int i = 0; i < 8; i++)
                context->m_lastOfReturnKind[i] = field;
            IntegerModel.Initialize(memory + IntegerOffset, 16, MaxContexts);
        }

        public static int Decode(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            var kind = layer->Kind;
            uint changedBit = kind == LazLayerKind.ScanAngle ? PointContext.AngleChangedBit : PointContext.SourceChangedBit;
            int current = layer->Current;
            byte* memory = contexts + (long)current * ContextBytes;
            int done = 0;
            for (; done < count; done++)
            {
                uint point = pointContexts[done];
                int context = (int)(point & PointContext.ChannelMask);
                if (context != current)
                {
                    int last = ((Integer16Layer*)memory)->m_last;
                    current = context;
                    memory = contexts + (long)current * ContextBytes;
                    if (layer->TryAddContext(current))
                        StartContext(memory, (ushort)last);
                }

                if (kind == LazLayerKind.Intensity)
                {
                    int returnKind = PointContext.ReturnKind(point);
                    ushort* last = ((Integer16Layer*)memory)->m_lastOfReturnKind
                        + (returnKind * 2 + (int)(point >> PointContext.TimeShift & 1));
                    *last = (ushort)(*last
                        + IntegerModel.Decode(memory + IntegerOffset, 16, MaxContexts, returnKind, ref value, ref length,
                            ref next));
                    ((Integer16Layer*)memory)->m_last = *last;
                }
                else if ((point & changedBit) != 0)
                {
                    int timeChanged = kind == LazLayerKind.ScanAngle ? (int)(point >> PointContext.TimeShift & 1) : 0;
                    ((Integer16Layer*)memory)->m_last = (ushort)(((Integer16Layer*)memory)->m_last
                        + IntegerModel.Decode(memory + IntegerOffset, 16, MaxContexts, timeChanged, ref value, ref length,
                            ref next));
                }
                if (next > end)
                    break;
                *(ushort*)field = (ushort)((Integer16Layer*)memory)->m_last;
                field += stride;
            }
            layer->SaveState(current, value, length, next);
            return done;
        }

        public static void Encode(LayerState* layer, byte* contexts, uint* pointContexts, byte* field, int stride, int count)
        {
            uint low = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            bool isIntensity = layer->Kind == LazLayerKind.Intensity, isAngle = layer->Kind == LazLayerKind.ScanAngle;
            uint changedBit = isAngle ? PointContext.AngleChangedBit : PointContext.SourceChangedBit;
            int current = layer->Current;
            byte* memory = contexts + (long)current * ContextBytes;
            for (int i = 0; i < count; i++, field += stride)
            {
                uint point = pointContexts[i];
                int timeChanged = (int)(point >> PointContext.TimeShift & 1);
                if ((int)(point & PointContext.ChannelMask) != current)
                {
                    int last = ((Integer16Layer*)memory)->m_last;
                    current = (int)(point & PointContext.ChannelMask);
                    memory = contexts + (long)current * ContextBytes;
                    if (layer->TryAddContext(current))
                        StartContext(memory, (ushort)last);
                }
                if (isIntensity)
                {
                    int returnKind = PointContext.ReturnKind(point);
                    ushort* last = ((Integer16Layer*)memory)->m_lastOfReturnKind + (returnKind * 2 + timeChanged);
                    IntegerModel.Encode(memory + IntegerOffset, 16, MaxContexts, returnKind, *(ushort*)field - *last, out _,
                        ref low, ref length, ref next);
                    *last = *(ushort*)field;
                }
                else if ((point & changedBit) != 0)
                {
                    IntegerModel.Encode(memory + IntegerOffset, 16, MaxContexts, isAngle ? timeChanged : 0,
                        *(ushort*)field - ((Integer16Layer*)memory)->m_last, out _, ref low, ref length, ref next);
                }
                ((Integer16Layer*)memory)->m_last = *(ushort*)field;
            }
            layer->SaveState(current, low, length, next);
        }
    }
}
