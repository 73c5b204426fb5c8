using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Core
{
    // Sorts 64-bit keys, each with a 32-bit payload, in a stable order: least significant digit first, eight bits a digit, and
    // only the digits in which the keys differ. Time is linear in the count; scratch memory is as large as the input.
    internal static unsafe class RadixSort
    {
        const int DigitBits = 8;
        const int DigitValues = 1 << DigitBits;
        const int MaxDigits = 64 / DigitBits;

        // In place, ascending. Null payloads for keys alone.
        public static void Sort(ulong* keys, uint* payload, ulong* keyScratch, uint* payloadScratch, int count)
        {
            if (count < 2)
                return;
            ulong any = 0, all = ulong.MaxValue;
            for (int i = 0; i < count; i++)
            {
                any |= keys[i];
                all &= keys[i];
            }
            ulong varying = any ^ all;

            int* start = stackalloc int[DigitValues];
            ulong* from = keys;
            ulong* to = keyScratch;
            uint* payloadFrom = payload;
            uint* payloadTo = payloadScratch;
            for (int digit = 0; digit < MaxDigits; digit++)
            {
                int shift = digit * DigitBits;
                if ((varying >> shift & (DigitValues - 1)) == 0)
                    continue;
                CountDigits(from, count, shift, start);
                if (payload != null)
                    Scatter(from, payloadFrom, to, payloadTo, count, shift, start);
                else
                    Scatter(from, to, count, shift, start);

                ulong* swap = from;
                from = to;
                to = swap;
                uint* payloadSwap = payloadFrom;
                payloadFrom = payloadTo;
                payloadTo = payloadSwap;
            }
            if (from == keys)
                return;
            UnsafeUtility.MemCpy(keys, from, (long)count * sizeof(ulong));
            if (payload != null)
                UnsafeUtility.MemCpy(payload, payloadFrom, (long)count * sizeof(uint));
        }

        // Finds where each digit's values start in the sorted order.
        static void CountDigits(ulong* keys, int count, int shift, int* start)
        {
            UnsafeUtility.MemClear(start, DigitValues * sizeof(int));
            for (int i = 0; i < count; i++)
                start[keys[i] >> shift & (DigitValues - 1)]++;
            int sum = 0;
            for (int value = 0; value < DigitValues; value++)
            {
                int with = start[value];
                start[value] = sum;
                sum += with;
            }
        }

        static void Scatter(ulong* from, uint* payloadFrom, ulong* to, uint* payloadTo, int count, int shift, int* start)
        {
            for (int i = 0; i < count; i++)
            {
                ulong key = from[i];
                int at = start[key >> shift & (DigitValues - 1)]++;
                to[at] = key;
                payloadTo[at] = payloadFrom[i];
            }
        }

        static void Scatter(ulong* from, ulong* to, int count, int shift, int* start)
        {
            for (int i = 0; i < count; i++)
            {
                ulong key = from[i];
                to[start[key >> shift & (DigitValues - 1)]++] = key;
            }
        }
    }
}
