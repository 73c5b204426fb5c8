using System.Globalization;
using System.Numerics;
using Unity.Mathematics;

namespace FastPoints
{
    // Writes numbers as the same text on every runtime: the fewest digits that read back as the same number, and of these the
    // nearest to it. It calculates with whole numbers alone. .NET's own text has these digits, too, but one too few for some
    // powers of two (2^-25). Mono, which Unity's editor runs, writes up to 17 ("848935.20000000007") and reads many long texts
    // one unit in the last place too low. After Steele and White, "How to print floating-point numbers accurately", 1990; this
    // is slow and plain, since files have few numbers.
    internal static class NumberText
    {
        public static string Of(long value) => value.ToString(CultureInfo.InvariantCulture);

        public static string Of(ulong value) => value.ToString(CultureInfo.InvariantCulture);

        public static string Of(double value)
        {
            ulong bits = math.asulong(value);
            return Of(bits >> 63 != 0, (int)(bits >> 52) & 0x7FF, bits & 0xFFFFFFFFFFFFF, 52, -1074, 17);
        }

        public static string Of(float value)
        {
            uint bits = math.asuint(value);
            return Of(bits >> 31 != 0, (int)(bits >> 23) & 0xFF, bits & 0x7FFFFF, 23, -149, 9);
        }

        public static string Of(double3 values) => Of(values.x) + ", " + Of(values.y) + ", " + Of(values.z);

        // Parses what AsciiNumber does, without blanks around it; infinite beyond the doubles.
        public static unsafe bool TryRead(string text, out double value)
        {
            var bytes = new byte[text.Length + 1];
            for (int i = 0; i < text.Length; i++)
                bytes[i] = text[i] > ' ' && text[i] <= '~' ? (byte)text[i] : (byte)'?';
            bytes[text.Length] = (byte)'\n';
            fixed (byte* start = bytes)
            {
                byte* end = start;
                return AsciiNumber.TryDouble(ref end, out value) && end == start + text.Length;
            }
        }

        static string Of(bool isNegative, int biased, ulong fraction, int fractionBits, int minExponent, int maxPlainDigits)
        {
            if (biased == (fractionBits == 52 ? 0x7FF : 0xFF))
                return fraction != 0 ? "NaN" : isNegative ? "-Infinity" : "Infinity";
            string sign = isNegative ? "-" : "";
            if (biased == 0 && fraction == 0)
                return sign + "0";
            ulong mantissa = biased == 0 ? fraction : fraction | 1ul << fractionBits;
            // Below a power of two the numbers lie twice as close.
            bool isCloseBelow = fraction == 0 && biased > 1;
            ulong digits = Shortest(mantissa, minExponent + math.max(biased, 1) - 1, isCloseBelow, out int power);
            return sign + Write(digits.ToString(CultureInfo.InvariantCulture), power, maxPlainDigits);
        }

        // The fewest digits that read back as mantissa * 2^exponent: digits * 10^power.
        static ulong Shortest(ulong mantissa, int exponent, bool isCloseBelow, out int power)
        {
            // In quarters of the mantissa's unit, the number and the ends of its rounding interval are whole.
            BigInteger number = new BigInteger(mantissa) * 4, unit = BigInteger.One;
            BigInteger low = number - (isCloseBelow ? 1 : 2), high = number + 2;
            int shift = exponent - 2;
            if (shift < 0)
            {
                unit <<= -shift;
            }
            else
            {
                number <<= shift;
                low <<= shift;
                high <<= shift;
            }
            // The ends themselves are rounded to even mantissas.
            bool hasEnds = (mantissa & 1) == 0;
            int bits = 64 - math.lzcnt(mantissa) + exponent;
            // 1233 / 4096 approximates the logarithm of two; the first power is above the number.
            for (power = (bits * 1233 >> 12) + 1; ; power--)
            {
                BigInteger ten = BigInteger.Pow(10, math.abs(power));
                BigInteger step = power > 0 ? unit * ten : unit, scale = power < 0 ? ten : BigInteger.One;
                BigInteger below = BigInteger.DivRem(number * scale, step, out var rest);
                int half = (rest * 2).CompareTo(step);
                bool isUp = half > 0 || half == 0 && !below.IsEven;
                for (int i = 0; i < 2; i++, isUp = !isUp)
                {
                    BigInteger digits = isUp ? below + 1 : below, at = digits * step;
                    int afterLow = at.CompareTo(low * scale), beforeHigh = (high * scale).CompareTo(at);
                    if (hasEnds ? afterLow >= 0 && beforeHigh >= 0 : afterLow > 0 && beforeHigh > 0)
                        return (ulong)digits;
                }
            }
        }

        // Like .NET: with an exponent of at least two digits instead of many zeros.
        static string Write(string digits, int power, int maxPlainDigits)
        {
            int whole = digits.Length + power;
            if (whole > maxPlainDigits || whole < -3)
            {
                int exponent = whole - 1;
                return digits.Substring(0, 1) + (digits.Length > 1 ? "." + digits.Substring(1) : "") +
                    (exponent < 0 ? "E-" : "E+") + math.abs(exponent).ToString("00", CultureInfo.InvariantCulture);
            }
            if (power >= 0)
                return digits + new string('0', power);
            return whole > 0 ? digits.Substring(0, whole) + "." + digits.Substring(whole)
                : "0." + new string('0', -whole) + digits;
        }
    }
}
