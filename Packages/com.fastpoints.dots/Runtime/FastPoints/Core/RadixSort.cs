using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints
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
            var from = new Records { Keys = keys, Payload = payload };
            var to = new Records { Keys = keyScratch, Payload = payloadScratch };
            for (int digit = 0; digit < MaxDigits; digit++)
            {
                int shift = digit * DigitBits;
                if ((varying >> shift & (DigitValues - 1)) == 0)
                    continue;
                CountDigits(from.Keys, count, shift, start);
                if (payload != null)
                    Scatter(from, to, count, shift, start);
                else
                    Scatter(from.Keys, to.Keys, count, shift, start);
                (from, to) = (to, from);
            }
            if (from.Keys == keys)
                return;
            UnsafeUtility.MemCpy(keys, from.Keys, (long)count * sizeof(ulong));
            if (payload != null)
                UnsafeUtility.MemCpy(payload, from.Payload, (long)count * sizeof(uint));
        }

        struct Records
        {
            public ulong* Keys;
            public uint* Payload;
        }

        static void CountDigits(ulong* keys, int count, int shift, int* start)
        {
            UnsafeUtility.MemClear(start, DigitValues * sizeof(int));
            for (int i = 0; i < count; i++)
                start[keys[i] >> shift & (DigitValues - 1)]++;
            int sum = 0;
            for (int value = 0; value < DigitValues; value++)
            {
                int keysWithDigit = start[value];
                start[value] = sum;
                sum += keysWithDigit;
            }
        }

        static void Scatter(Records from, Records to, int count, int shift, int* start)
        {
            ulong* keysFrom = from.Keys, keysTo = to.Keys;
            uint* payloadFrom = from.Payload, payloadTo = to.Payload;
            for (int i = 0; i < count; i++)
            {
                ulong key = keysFrom[i];
                int at = start[key >> shift & (DigitValues - 1)]++;
                keysTo[at] = key;
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
