using System.Runtime.InteropServices;

namespace FastPoints.Files
{
    /// <summary>The first layer of POINT14: scanner channel, return counts, X and Y, and which of the other attributes change.
    /// HPC#.</summary>
    [StructLayout(LayoutKind.Sequential)]
    unsafe struct ReturnsLayer
    {
        const int Medians = 12;
        const int XContexts = 2;
        const int YContexts = 22;
        const int ChannelSymbols = 3;
        const int ReturnStepSymbols = 13;

        const uint ChannelChangedBit = 64;
        const uint SourceChangedBit = 32;
        const uint TimeChangedBit = 16;
        const uint AngleChangedBit = 8;
        const uint ReturnsChangedBit = 4;

        const int ChangedAt = 640;
        const int ChannelAt = ChangedAt + 8 * SymbolModel.Bytes128;
        const int ReturnStepAt = ChannelAt + SymbolModel.Bytes4;
        const int NumberOfReturnsAt = ReturnStepAt + SymbolModel.Bytes13;
        const int ReturnNumberAt = NumberOfReturnsAt + 16 * SymbolModel.Bytes16;
        const int XAt = ReturnNumberAt + 16 * SymbolModel.Bytes16;
        const int YAt = XAt + 64 + XContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;
        public const int ContextBytes = YAt + 64 + YContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;

        int m_x;
        int m_y;

        /// <summary>The record's byte: number of returns * 16 + return number.</summary>
        int m_returns;

        /// <summary>Whether the last point's GPS time differed from the one before it.</summary>
        int m_timeChanged;

        int m_numberOfReturnsMade;
        int m_returnNumberMade;
        fixed int m_medianX[Medians * Median5.Ints];
        fixed int m_medianY[Medians * Median5.Ints];

        public static void StartContext(byte* place, int x, int y, int returns)
        {
            var context = (ReturnsLayer*)place;
            context->m_x = x;
            context->m_y = y;
            context->m_returns = returns;
            context->m_timeChanged = 0;
            context->m_numberOfReturnsMade = 0;
            context->m_returnNumberMade = 0;
            for (int i = 0; i < Medians; i++)
            {
                Median5.Initialize(context->m_medianX + i * Median5.Ints);
                Median5.Initialize(context->m_medianY + i * Median5.Ints);
            }
            for (int i = 0; i < 8; i++)
                SymbolModel.Initialize(place + ChangedAt + i * SymbolModel.Bytes128, 128);
            SymbolModel.Initialize((SymbolModel*)(place + ChannelAt), ChannelSymbols, 4);
            SymbolModel.Initialize(place + ReturnStepAt, ReturnStepSymbols);
            IntegerModel.Initialize(place + XAt, 32, XContexts);
            IntegerModel.Initialize(place + YAt, 32, YContexts);
        }

        /// <param name="returnContexts">256 entries of <see cref="ReturnContexts.WriteExtended"/>.</param>
        /// <param name="points">Gets a <see cref="PointContext"/> a point.</param>
        /// <param name="flags">Bits 0-3 and 6-7 of the record's flag byte, until the flags' layer overwrites them.</param>
        public static int Decode(LayerState* layer, byte* contexts, ushort* returnContexts, uint* points, int flags,
            byte* record, int stride, int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            int channel = layer->Current;
            byte* place = contexts + (long)channel * ContextBytes;
            var context = (ReturnsLayer*)place;
            int done = 0;
            for (; done < count; done++)
            {
                int returns = context->m_returns;
                int lastPlace = returnContexts[returns] >> ReturnContexts.ExtendedLastPlaceShift;
                uint changed = SymbolModel.Decode(place + ChangedAt
                    + (lastPlace + context->m_timeChanged * 4) * SymbolModel.Bytes128, 128, ref value, ref length, ref next);
                uint point = 0;
                if ((changed & ChannelChangedBit) != 0)
                {
                    uint step = SymbolModel.Decode(place + ChannelAt, 4, ref value, ref length, ref next);
                    channel = (int)((uint)channel + step + 1) & 3;
                    place = contexts + (long)channel * ContextBytes;
                    if ((layer->Made >> channel & 1) == 0)
                    {
                        layer->Made |= 1 << channel;
                        StartContext(place, context->m_x, context->m_y, context->m_returns);
                    }
                    context = (ReturnsLayer*)place;
                    returns = context->m_returns;
                    point = PointContext.ChannelChangedBit;
                }

                int timeChanged = (int)(changed / TimeChangedBit & 1);
                if ((changed & 7) != 0)
                {
                    int lastReturns = returns;
                    if ((changed & ReturnsChangedBit) != 0)
                    {
                        byte* model = ModelOf(place + NumberOfReturnsAt, &context->m_numberOfReturnsMade, returns >> 4);
                        returns = (int)SymbolModel.Decode(model, 16, ref value, ref length, ref next) << 4 | returns & 15;
                    }
                    uint step = changed & 3;
                    if (step == 3)
                    {
                        if (timeChanged != 0)
                        {
                            byte* model = ModelOf(place + ReturnNumberAt, &context->m_returnNumberMade, lastReturns & 15);
                            returns = returns & 0xF0 | (int)SymbolModel.Decode(model, 16, ref value, ref length, ref next);
                        }
                        else
                        {
                            int more = (int)SymbolModel.Decode(place + ReturnStepAt, ReturnStepSymbols,
                                ref value, ref length, ref next) + 2;
                            returns = returns & 0xF0 | returns + more & 15;
                        }
                    }
                    else if (step != 0)
                    {
                        returns = returns & 0xF0 | returns + (step == 1 ? 1 : 15) & 15;
                    }
                    context->m_returns = returns;
                }
                context->m_timeChanged = timeChanged;

                int ofReturns = returnContexts[returns];
                int isSingle = ofReturns >> ReturnContexts.ExtendedSingleShift & 1;
                int median = ((ofReturns & ReturnContexts.ExtendedMapMask) * 2 + timeChanged) * Median5.Ints;
                int* medianX = context->m_medianX + median;
                int* medianY = context->m_medianY + median;

                int xDifference = Median5.Get(medianX)
                    + IntegerModel.Decode(place + XAt, 32, XContexts, isSingle, out int kx, ref value, ref length, ref next);
                context->m_x += xDifference;
                Median5.Add(medianX, xDifference);

                int yContext = isSingle + (kx < 20 ? kx & ~1 : 20);
                int yDifference = Median5.Get(medianY)
                    + IntegerModel.Decode(place + YAt, 32, YContexts, yContext, out int ky, ref value, ref length, ref next);
                context->m_y += yDifference;
                Median5.Add(medianY, yDifference);
                if (next > end)
                    break;

                int k = (kx + ky) >> 1;
                int zContext = isSingle + (k < 18 ? k & ~1 : 18);
                points[done] = point | (uint)channel | (uint)timeChanged << PointContext.TimeShift
                    | (changed & AngleChangedBit) * (PointContext.AngleChangedBit / AngleChangedBit)
                    | (changed & SourceChangedBit) * (PointContext.SourceChangedBit / SourceChangedBit)
                    | (uint)(ofReturns >> ReturnContexts.ExtendedPlaceShift & ReturnContexts.ExtendedPlaceMask)
                        << PointContext.PlaceShift
                    | (uint)(ofReturns >> ReturnContexts.ExtendedLevelShift & 7) << PointContext.LevelShift
                    | (uint)zContext << PointContext.ZShift;
                *(int*)record = context->m_x;
                *(int*)(record + 4) = context->m_y;
                record[14] = (byte)returns;
                record[15] = (byte)(flags | channel << 4);
                record += stride;
            }
            layer->Current = channel;
            layer->Stream.Value = value;
            layer->Stream.Length = length;
            layer->Stream.Next = next;
            return done;
        }

        static byte* ModelOf(byte* models, int* made, int last)
        {
            byte* model = models + last * SymbolModel.Bytes16;
            if ((*made >> last & 1) == 0)
            {
                *made |= 1 << last;
                SymbolModel.Initialize(model, 16);
            }
            return model;
        }
    }
}
