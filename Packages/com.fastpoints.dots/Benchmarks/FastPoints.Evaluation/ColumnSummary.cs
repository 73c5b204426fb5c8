using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    internal struct ColumnSummary
    {
        const ulong SignBit = 0x8000000000000000UL;

        public AttributeType Type;
        public long Finite;
        public long NonFiniteCount; // Number of values that are infinite or NaN: they count in the sum, but not in the range.
        public ulong Sum; // Sum modulo 2^64: of sign-extended integers; for floats, of their bits, extended by zeros.

        ulong m_minOrdered;
        ulong m_maxOrdered;

        public static ColumnSummary EmptyOf(AttributeType type) =>
            new ColumnSummary { Type = type, m_minOrdered = ulong.MaxValue };

        /// <summary>The smallest finite stored value; 0 if there is none. Exact except for 64-bit integers beyond 2^53.</summary>
        public double Min => Finite == 0 ? 0 : ToDouble(m_minOrdered);

        public double Max => Finite == 0 ? 0 : ToDouble(m_maxOrdered);
        public string MinText => Finite == 0 ? null : ToText(m_minOrdered); // The same with all digits; null if there is none.

        public string MaxText => Finite == 0 ? null : ToText(m_maxOrdered);

        public void Include(in ColumnSummary other)
        {
            Finite += other.Finite;
            NonFiniteCount += other.NonFiniteCount;
            Sum += other.Sum;
            m_minOrdered = math.min(m_minOrdered, other.m_minOrdered);
            m_maxOrdered = math.max(m_maxOrdered, other.m_maxOrdered);
        }

        public unsafe void IncludeColumn(byte* column, int count)
        {
            int bytes = Type.SizeOf();
            if (count > 0 && bytes <= 4 && !Type.IsFloat())
                IncludeIntegers(column, bytes, count, Type.IsSigned() ? 1u << 8 * bytes - 1 : 0);
            else
                IncludeWide(column, count);
        }

        /// <param name="bias">Added to the values, so that they order as unsigned ones.</param>
        unsafe void IncludeIntegers(byte* column, int bytes, int count, uint bias)
        {
            ulong sum = 0;
            uint min = uint.MaxValue, max = 0;
            if (bytes == 1)
                IncludeBytes(column, count, (byte)bias, ref sum, ref min, ref max);
            else if (bytes == 2)
                for (int i = 0; i < count; i++)
                {
                    uint value = ((ushort*)column)[i] ^ bias;
                    sum += value;
                    min = value < min ? value : min;
                    max = value > max ? value : max;
                }
            else
                for (int i = 0; i < count; i++)
                {
                    uint value = ((uint*)column)[i] ^ bias;
                    sum += value;
                    min = value < min ? value : min;
                    max = value > max ? value : max;
                }
            Sum += sum - (ulong)count * bias;
            m_minOrdered = math.min(m_minOrdered, min + SignBit - bias);
            m_maxOrdered = math.max(m_maxOrdered, max + SignBit - bias);
            Finite += count;
        }

        static unsafe void IncludeBytes(byte* column, int count, byte bias, ref ulong sum, ref uint min, ref uint max)
        {
            ulong last = 0, sumOfLast = 0;
            int i = 0;
            for (; i + 8 <= count; i += 8)
            {
                ulong word = *(ulong*)(column + i);
                if (i == 0 || word != last)
                {
                    last = word;
                    sumOfLast = 0;
                    for (int k = 0; k < 8; k++)
                        Include((byte)(word >> 8 * k ^ bias), ref sumOfLast, ref min, ref max);
                }
                sum += sumOfLast;
            }
            for (; i < count; i++)
                Include((byte)(column[i] ^ bias), ref sum, ref min, ref max);
        }

        static void Include(uint value, ref ulong sum, ref uint min, ref uint max)
        {
            sum += value;
            min = value < min ? value : min;
            max = value > max ? value : max;
        }

        unsafe void IncludeWide(byte* column, int count)
        {
            const int BatchLength = ColumnValues.BatchLength;
            ulong* bits = stackalloc ulong[BatchLength];
            double* values = stackalloc double[BatchLength];
            bool isFloat = Type.IsFloat();
            ulong flip = Type == AttributeType.UInt64 ? 0 : SignBit;
            for (int done = 0; done < count; done += BatchLength)
            {
                int length = math.min(BatchLength, count - done);
                ColumnValues.ToBits(column, Type, done, length, bits);
                if (isFloat)
                    ColumnValues.ToDoubles(column, Type, done, length, values);
                IncludeRange(bits, values, length, isFloat, flip);
            }
        }

        unsafe void IncludeRange(ulong* bits, double* values, int count, bool isFloat, ulong flip)
        {
            ulong min = m_minOrdered, max = m_maxOrdered, sum = 0;
            int finite = 0;
            for (int i = 0; i < count; i++)
            {
                sum += bits[i];
                if (isFloat && values[i] - values[i] != 0)
                    continue;
                finite++;
                ulong ordered = isFloat ? ColumnValues.OrderedBits(values[i]) : bits[i] ^ flip;
                min = ordered < min ? ordered : min;
                max = ordered > max ? ordered : max;
            }
            m_minOrdered = min;
            m_maxOrdered = max;
            Sum += sum;
            Finite += finite;
            NonFiniteCount += count - finite;
        }

        double ToDouble(ulong ordered)
        {
            if (Type.IsFloat())
                return ColumnValues.FromOrderedBits(ordered);
            return Type == AttributeType.UInt64 ? ordered : (double)(long)(ordered ^ SignBit);
        }

        string ToText(ulong ordered)
        {
            if (Type == AttributeType.Float32)
                return NumberText.Of((float)ColumnValues.FromOrderedBits(ordered));
            if (Type == AttributeType.Float64)
                return NumberText.Of(ColumnValues.FromOrderedBits(ordered));
            return Type == AttributeType.UInt64 ? NumberText.Of(ordered) : NumberText.Of((long)(ordered ^ SignBit));
        }
    }
}
