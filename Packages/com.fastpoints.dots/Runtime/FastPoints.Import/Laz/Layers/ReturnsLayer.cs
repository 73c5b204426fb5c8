using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Laz
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

        const int ChangedOffset = 640;
        const int ChannelOffset = ChangedOffset + 8 * SymbolModel.Bytes128;
        const int ReturnStepOffset = ChannelOffset + SymbolModel.Bytes4;
        const int NumberOfReturnsOffset = ReturnStepOffset + SymbolModel.Bytes13;
        const int ReturnNumberOffset = NumberOfReturnsOffset + 16 * SymbolModel.Bytes16;
        const int XOffset = ReturnNumberOffset + 16 * SymbolModel.Bytes16;
        const int YOffset = XOffset + 64 + XContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;
        public const int ContextBytes = YOffset + 64 + YContexts * SymbolModel.Bytes33 + 31 * SymbolModel.Bytes256;

        int m_x;
        int m_y;
        int m_returns; // The record's byte: number of returns * 16 + return number.
        int m_timeChanged; // Whether the last point's GPS time differed from the one before it.

        int m_numberOfReturnsMade;
        int m_returnNumberMade;
        fixed int m_medianX[Medians * Median5.Ints];
        fixed int m_medianY[Medians * Median5.Ints];

        public static void StartContext(byte* memory, int x, int y, int returns)
        {
            var context = (ReturnsLayer*)memory;
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
                SymbolModel.Initialize(memory + ChangedOffset + i * SymbolModel.Bytes128, 128);
            SymbolModel.Initialize((SymbolModel*)(memory + ChannelOffset), ChannelSymbols, 4);
            SymbolModel.Initialize(memory + ReturnStepOffset, ReturnStepSymbols);
            IntegerModel.Initialize(memory + XOffset, 32, XContexts);
            IntegerModel.Initialize(memory + YOffset, 32, YContexts);
        }

        /// <param name="returnContexts">256 entries of <see cref="ReturnContexts.WriteExtended"/>.</param>
        /// <param name="pointContexts">Gets a <see cref="PointContext"/> a point.</param>
        /// <param name="flags">Bits 0-3 and 6-7 of the record's flag byte, until the flags' layer overwrites them.</param>
        public static int Decode(LayerState* layer, byte* contexts, ushort* returnContexts, uint* pointContexts, int flags,
            byte* record, int stride, int count)
        {
            uint value = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            byte* end = layer->Stream.End;
            int channel = layer->Current;
            byte* memory = contexts + (long)channel * ContextBytes;
            var context = (ReturnsLayer*)memory;
            int done = 0;
            for (; done < count; done++)
            {
                int returns = context->m_returns;
                int lastKind = returnContexts[returns] >> ReturnContexts.ExtendedLastReturnKindShift;
                uint changed = SymbolModel.Decode(memory + ChangedOffset
                    + (lastKind + context->m_timeChanged * 4) * SymbolModel.Bytes128, 128, ref value, ref length, ref next);
                if ((changed & ChannelChangedBit) != 0)
                {
                    uint step = SymbolModel.Decode(memory + ChannelOffset, 4, ref value, ref length, ref next);
                    channel = (int)((uint)channel + step + 1) & 3;
                    memory = contexts + (long)channel * ContextBytes;
                    if (layer->TryAddContext(channel))
                        StartContext(memory, context->m_x, context->m_y, context->m_returns);
                    context = (ReturnsLayer*)memory;
                    returns = context->m_returns;
                }

                int timeChanged = (int)(changed / TimeChangedBit & 1);
                if ((changed & 7) != 0)
                {
                    int lastReturns = returns;
                    if ((changed & ReturnsChangedBit) != 0)
                    {
                        byte* model = ModelOf(memory + NumberOfReturnsOffset, &context->m_numberOfReturnsMade, returns >> 4);
                        returns = (int)SymbolModel.Decode(model, 16, ref value, ref length, ref next) << 4 | returns & 15;
                    }
                    uint step = changed & 3;
                    if (step == 3)
                    {
                        if (timeChanged != 0)
                        {
                            byte* model = ModelOf(memory + ReturnNumberOffset, &context->m_returnNumberMade, lastReturns & 15);
                            returns = returns & 0xF0 | (int)SymbolModel.Decode(model, 16, ref value, ref length, ref next);
                        }
                        else
                        {
                            int more = (int)SymbolModel.Decode(memory + ReturnStepOffset, ReturnStepSymbols,
                                ref value, ref length, ref next) + 2;
                            returns = returns & 0xF0 | returns + more & 15;
                        }
                    }
                    else if (step != 0)
                        returns = returns & 0xF0 | returns + (step == 1 ? 1 : 15) & 15;
                    context->m_returns = returns;
                }
                context->m_timeChanged = timeChanged;

                int ofReturns = returnContexts[returns];
                int isSingle = ofReturns >> ReturnContexts.ExtendedSingleShift & 1;
                int median = ((ofReturns & ReturnContexts.ExtendedMapMask) * 2 + timeChanged) * Median5.Ints;
                int* medianX = context->m_medianX + median;
                int* medianY = context->m_medianY + median;

                int xDifference = Median5.Get(medianX)
                    + IntegerModel.Decode(memory + XOffset, 32, XContexts, isSingle, out int kx, ref value, ref length, ref next);
                context->m_x += xDifference;
                Median5.Add(medianX, xDifference);

                int yContext = isSingle + (kx < 20 ? kx & ~1 : 20);
                int yDifference = Median5.Get(medianY)
                    + IntegerModel.Decode(memory + YOffset, 32, YContexts, yContext, out int ky, ref value, ref length, ref next);
                context->m_y += yDifference;
                Median5.Add(medianY, yDifference);
                if (next > end)
                    break;

                pointContexts[done] = Describe(changed, channel, ofReturns, isSingle, (kx + ky) >> 1);
                *(int*)record = context->m_x;
                *(int*)(record + 4) = context->m_y;
                record[14] = (byte)returns;
                record[15] = (byte)(flags | channel << 4);
                record += stride;
            }
            layer->SaveState(channel, value, length, next);
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

        /// <summary>Codes points and leaves their contexts.</summary>
        /// <param name="lasts">For each channel the last record's first 30 bytes, each in 32.</param>
        public static void Encode(LayerState* layer, byte* contexts, ushort* returnContexts, uint* pointContexts, byte* lasts,
            byte* record, int stride, int count)
        {
            uint low = layer->Stream.Value, length = layer->Stream.Length;
            byte* next = layer->Stream.Next;
            int channel = layer->Current;
            byte* memory = contexts + (long)channel * ContextBytes;
            var context = (ReturnsLayer*)memory;
            for (int i = 0; i < count; i++, record += stride)
            {
                byte* changedModel = memory + ChangedOffset + ((returnContexts[context->m_returns]
                    >> ReturnContexts.ExtendedLastReturnKindShift) + context->m_timeChanged * 4) * SymbolModel.Bytes128;
                byte* channelModel = memory + ChannelOffset;
                int to = record[15] >> 4 & 3, from = channel;
                if (to != from)
                {
                    byte* last = lasts + 32 * channel;
                    channel = to;
                    memory = contexts + (long)channel * ContextBytes;
                    if (layer->TryAddContext(channel))
                    {
                        StartContext(memory, context->m_x, context->m_y, context->m_returns);
                        UnsafeUtility.MemCpy(lasts + 32 * channel, last, 30);
                    }
                    context = (ReturnsLayer*)memory;
                }
                byte* before = lasts + 32 * channel;
                int returns = record[14], step = (returns & 15) - (context->m_returns & 15) & 15;
                uint timeChanged = *(long*)(record + 22) != *(long*)(before + 22) ? 1u : 0;
                uint changed = (to != from ? ChannelChangedBit : 0) | timeChanged * TimeChangedBit
                    | (*(ushort*)(record + 20) != *(ushort*)(before + 20) ? SourceChangedBit : 0)
                    | (*(ushort*)(record + 18) != *(ushort*)(before + 18) ? AngleChangedBit : 0)
                    | (returns >> 4 != context->m_returns >> 4 ? ReturnsChangedBit : 0)
                    | (step == 0 ? 0u : step == 1 ? 1u : step == 15 ? 2u : 3u);
                SymbolModel.Encode(changedModel, 128, changed, ref low, ref length, ref next);
                if (to != from)
                    SymbolModel.Encode(channelModel, 4, (uint)(to - from - 1 & 3), ref low, ref length, ref next);
                if ((changed & ReturnsChangedBit) != 0)
                    SymbolModel.Encode(ModelOf(memory + NumberOfReturnsOffset, &context->m_numberOfReturnsMade,
                        context->m_returns >> 4), 16, (uint)returns >> 4, ref low, ref length, ref next);
                if ((changed & 3) == 3 && timeChanged != 0)
                    SymbolModel.Encode(ModelOf(memory + ReturnNumberOffset, &context->m_returnNumberMade, context->m_returns
                        & 15), 16, (uint)returns & 15, ref low, ref length, ref next);
                else if ((changed & 3) == 3)
                    SymbolModel.Encode(memory + ReturnStepOffset, ReturnStepSymbols, (uint)step - 2, ref low, ref length,
                        ref next);
                context->m_returns = returns;
                context->m_timeChanged = (int)timeChanged;
                UnsafeUtility.MemCpy(before, record, 30);

                int ofReturns = returnContexts[returns], isSingle = ofReturns >> ReturnContexts.ExtendedSingleShift & 1;
                int median = ((ofReturns & ReturnContexts.ExtendedMapMask) * 2 + (int)timeChanged) * Median5.Ints;
                int dx = *(int*)record - context->m_x, dy = *(int*)(record + 4) - context->m_y;
                IntegerModel.Encode(memory + XOffset, 32, XContexts, isSingle, dx - Median5.Get(context->m_medianX + median),
                    out int kx, ref low, ref length, ref next);
                Median5.Add(context->m_medianX + median, dx);
                IntegerModel.Encode(memory + YOffset, 32, YContexts, isSingle + (kx < 20 ? kx & ~1 : 20),
                    dy - Median5.Get(context->m_medianY + median), out int ky, ref low, ref length, ref next);
                Median5.Add(context->m_medianY + median, dy);
                context->m_x = *(int*)record;
                context->m_y = *(int*)(record + 4);
                pointContexts[i] = Describe(changed, channel, ofReturns, isSingle, (kx + ky) >> 1);
            }
            layer->SaveState(channel, low, length, next);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static uint Describe(uint changed, int channel, int ofReturns, int isSingle, int k) =>
            (uint)channel | changed / ChannelChangedBit * PointContext.ChannelChangedBit
                | (changed / TimeChangedBit & 1) << PointContext.TimeShift
                | (changed & AngleChangedBit) * (PointContext.AngleChangedBit / AngleChangedBit)
                | (changed & SourceChangedBit) * (PointContext.SourceChangedBit / SourceChangedBit)
                | (uint)(ofReturns >> ReturnContexts.ExtendedReturnKindShift & ReturnContexts.ExtendedReturnKindMask)
                    << PointContext.ReturnKindShift
                | (uint)(ofReturns >> ReturnContexts.ExtendedLevelShift & 7) << PointContext.LevelShift
                | (uint)(isSingle + (k < 18 ? k & ~1 : 18)) << PointContext.ZShift;
    }
}
