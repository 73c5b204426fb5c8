using Unity.Burst.Intrinsics;
using Unity.Mathematics;

namespace FastPoints.Build
{
    internal struct PointStatistics
    {
        public long Count;
        public long LeftOut; // Number of points without a finite position on the grid.
        public Grid3 Min;
        public Grid3 Max;

        public ulong Checksum;
        public double MaxRoundingSteps; // Largest distance of a float position from its grid position, in steps.

        public static PointStatistics None => new PointStatistics
        {
            Min = Grid3.MaxValue,
            Max = Grid3.MinValue,
        };

        public void Include(in PointStatistics other)
        {
            Count += other.Count;
            LeftOut += other.LeftOut;
            Min = Grid3.Min(Min, other.Min);
            Max = Grid3.Max(Max, other.Max);
            Checksum += other.Checksum;
            MaxRoundingSteps = MaxRoundingSteps > other.MaxRoundingSteps ? MaxRoundingSteps : other.MaxRoundingSteps;
        }
    }

    internal struct AttributeStatistics
    {
        const int VectorBytes = 32;

        public ulong OrderedMin;
        public ulong OrderedMax;
        public ulong Or; // The bitwise or of all values: trailing zeros give a power of two that divides all of them.
        public uint Modulo257OrOfUInt16; // 0 if every value is a multiple of 257: eight bits twice.

        public static AttributeStatistics None => new AttributeStatistics { OrderedMin = ulong.MaxValue };

        public bool IsEmpty => OrderedMin > OrderedMax;

        public static unsafe AttributeStatistics Of(byte* values, AttributeType type, int count)
        {
            int size = type.SizeOf();
            if (type == AttributeType.UInt16 || type == AttributeType.UInt8)
                return OfUnsigned(values, size, count);
            var result = None;
            for (int i = 0; i < count; i++, values += size)
            {
                ulong ordered = Store.OrderedBits.Load(values, type);
                result.OrderedMin = math.min(result.OrderedMin, ordered);
                result.OrderedMax = math.max(result.OrderedMax, ordered);
                result.Or |= ordered;
            }
            return result;
        }

        /// <summary>The same for one or two bytes, the usual types. Only two-byte values, often colours, are tested for 8-bit
        /// content.</summary>
        static unsafe AttributeStatistics OfUnsigned(byte* values, int size, int count)
        {
            var result = None;
            int bytes = count * size, at = 0;
            if (X86.Avx2.IsAvx2Supported && bytes >= VectorBytes)
            {
                v256 low = X86.Avx.mm256_set1_epi32(-1), high = X86.Avx.mm256_set1_epi32(0);
                v256 or = high, notDoubled = high;
                for (; at + VectorBytes <= bytes; at += VectorBytes)
                {
                    var v = X86.Avx.mm256_loadu_si256(values + at);
                    low = size == 1 ? X86.Avx2.mm256_min_epu8(low, v) : X86.Avx2.mm256_min_epu16(low, v);
                    high = size == 1 ? X86.Avx2.mm256_max_epu8(high, v) : X86.Avx2.mm256_max_epu16(high, v);
                    or = X86.Avx2.mm256_or_si256(or, v);
                    var difference = X86.Avx2.mm256_xor_si256(v, X86.Avx2.mm256_srli_epi16(v, 8));
                    notDoubled = X86.Avx2.mm256_or_si256(notDoubled, difference);
                }
                byte* found = stackalloc byte[4 * VectorBytes];
                X86.Avx.mm256_storeu_si256(found, low);
                X86.Avx.mm256_storeu_si256(found + VectorBytes, high);
                X86.Avx.mm256_storeu_si256(found + 2 * VectorBytes, or);
                X86.Avx.mm256_storeu_si256(found + 3 * VectorBytes, notDoubled);
                for (int lane = 0; lane < VectorBytes; lane += size)
                {
                    result.OrderedMin = math.min(result.OrderedMin, Load(found + lane, size));
                    result.OrderedMax = math.max(result.OrderedMax, Load(found + VectorBytes + lane, size));
                    result.Or |= Load(found + 2 * VectorBytes + lane, size);
                    result.Modulo257OrOfUInt16 |= found[3 * VectorBytes + lane];
                }
            }
            for (; at < bytes; at += size)
            {
                uint value = Load(values + at, size);
                result.OrderedMin = math.min(result.OrderedMin, value);
                result.OrderedMax = math.max(result.OrderedMax, value);
                result.Or |= value;
                result.Modulo257OrOfUInt16 |= (value >> 8 ^ value) & 0xFF;
            }
            result.Modulo257OrOfUInt16 = size == 1 ? 0 : result.Modulo257OrOfUInt16;
            return result;
        }

        static unsafe uint Load(byte* value, int size) => size == 1 ? *value : (uint)*(ushort*)value;

        public void Include(in AttributeStatistics other)
        {
            OrderedMin = OrderedMin < other.OrderedMin ? OrderedMin : other.OrderedMin;
            OrderedMax = OrderedMax > other.OrderedMax ? OrderedMax : other.OrderedMax;
            Or |= other.Or;
            Modulo257OrOfUInt16 |= other.Modulo257OrOfUInt16;
        }
    }
}
