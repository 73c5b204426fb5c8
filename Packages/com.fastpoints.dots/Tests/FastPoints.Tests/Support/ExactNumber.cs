using System;
using System.Globalization;
using System.Numerics;
using Unity.Mathematics;

namespace FastPoints.Tests
{
    /// <summary>Compares texts with numbers in whole numbers of any size, since the parsers of run times differ: Mono's is not
    /// exact.</summary>
    public static class ExactNumber
    {
        public static bool IsNearest(string text, double value)
        {
            ulong bits = math.asulong(value);
            return IsNearest(text, bits >> 63 != 0, (int)(bits >> 52) & 0x7FF, bits & 0xFFFFFFFFFFFFF, 52, 0x7FF);
        }

        public static bool IsNearest(string text, float value)
        {
            uint bits = math.asuint(value);
            return IsNearest(text, bits >> 31 != 0, (int)(bits >> 23) & 0xFF, bits & 0x7FFFFF, 23, 0xFF);
        }

        static bool IsNearest(string text, bool isNegative, int biased, ulong fraction, int fractionBits, int infinite)
        {
            if (text.StartsWith("-", StringComparison.Ordinal) != isNegative || biased == infinite && fraction != 0)
                return false;
            int e = text.IndexOfAny(new[] { 'e', 'E' });
            string digits = (e < 0 ? text : text.Substring(0, e)).TrimStart('-', '+');
            int point = digits.IndexOf('.'), power = point < 0 ? 0 : point + 1 - digits.Length;
            if (e >= 0)
                power += int.Parse(text.Substring(e + 1), CultureInfo.InvariantCulture);
            BigInteger number = BigInteger.Parse(digits.Replace(".", ""), CultureInfo.InvariantCulture);
            if (number.IsZero)
                return biased == 0 && fraction == 0;
            // Beyond these no type has numbers.
            int size = digits.Length + power;
            if (size > 400 || power < -2000)
                return size > 400 ? biased == infinite : biased == 0 && fraction == 0;

            ulong mantissa = biased == 0 ? fraction : fraction | 1ul << fractionBits;
            int exponent = 1 - infinite / 2 - fractionBits + math.max(biased, 1) - 1 - 2;
            BigInteger low = new BigInteger(mantissa) * 4 - (fraction == 0 && biased > 1 ? 1 : 2);
            BigInteger high = new BigInteger(mantissa) * 4 + 2;
            // Divisors of one side multiply the other.
            BigInteger left = number * BigInteger.Pow(10, math.max(power, 0)) * BigInteger.Pow(2, math.max(-exponent, 0));
            BigInteger right = BigInteger.Pow(10, math.max(-power, 0)) * BigInteger.Pow(2, math.max(exponent, 0));
            int afterLow = left.CompareTo(low * right), beforeHigh = (high * right).CompareTo(left);
            bool hasEnds = (mantissa & 1) == 0;
            return (hasEnds ? afterLow >= 0 : afterLow > 0) &&
                (biased == infinite || (hasEnds ? beforeHigh >= 0 : beforeHigh > 0));
        }
    }
}
