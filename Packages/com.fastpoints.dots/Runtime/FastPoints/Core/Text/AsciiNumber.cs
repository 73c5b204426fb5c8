using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints
{
    /// <summary>Parses the numbers of a text file. HPC#. Every result is the nearest value of its type (ties to even), as the
    /// usual parsers give.</summary>
    /// <remarks>The text must end in a byte up to 0x20 (a blank or a line end) that may be read: callers put one behind their
    /// buffer. A number ends there; anything else after it makes the text invalid. Accepted besides digits, point and
    /// exponent: nan and inf as C libraries write them (inf, infinity, nan, nan(...), 1.#INF, 1.#IND, 1.#QNAN; any case, any
    /// sign). Hexadecimal is not accepted. On failure the pointer stays at the number's start.</remarks>
    internal static unsafe class AsciiNumber
    {
        const int MaxExactDigits = 19;

        /// <summary>Doubles hold these exactly, so one multiplication or division by them is rounded once (Clinger
        /// 1990).</summary>
        static readonly double[] s_exactPowersOfTen =
        {
            1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
            1e21, 1e22,
        };

        const int MaxExactPower = 22;
        const ulong MaxExactMantissa = 1ul << 53;
        const int MaxExponent = 1 << 20; // Exponents in the text beyond this make no difference.

        enum Kind
        {
            None,
            Finite,
            Infinite,
            NotANumber,
        }

        /// <summary>The digits as they stand in the text.</summary>
        /// <returns>False if there is no number, or one that is not finite.</returns>
        public static bool TryDecimal(ref byte* p, out DecimalDigits number)
        {
            byte* start = p;
            if (Scan(ref p, out number) == Kind.Finite)
                return true;
            p = start;
            return false;
        }

        /// <summary>Skips a number of any size, or a word for one that is not finite.</summary>
        public static bool TrySkip(ref byte* p) => Scan(ref p, out _) != Kind.None;

        public static bool TryDouble(ref byte* p, out double value)
        {
            var kind = Scan(ref p, out var number);
            if (kind == Kind.Finite)
            {
                value = ToDouble(number);
                return true;
            }
            value = kind == Kind.Infinite ? number.IsNegative ? double.NegativeInfinity : double.PositiveInfinity : double.NaN;
            return kind != Kind.None;
        }

        public static bool TryFloat(ref byte* p, out float value)
        {
            var kind = Scan(ref p, out var number);
            if (kind == Kind.Finite)
            {
                if (HasExactDouble(number))
                {
                    double near = NearestDouble(number);
                    // Rounding twice errs only where the first result lies half-way between two floats, and below the normal
                    // floats, where they lie further apart.
                    bool isHalfWay = (math.asulong(near) & 0x1FFFFFFF) == 0x10000000;
                    if (!isHalfWay && (near >= 1.1754943508222875e-38 || near == 0))
                    {
                        value = (float)(number.IsNegative ? -near : near);
                        return true;
                    }
                }
                uint bits = DecimalRounding.ToFloatBits(number);
                value = math.asfloat(number.IsNegative ? bits | 0x80000000 : bits);
                return true;
            }
            value = kind == Kind.Infinite ? number.IsNegative ? float.NegativeInfinity : float.PositiveInfinity : float.NaN;
            return kind != Kind.None;
        }

        /// <summary>Reads an integer as sign and magnitude. Fractions are dropped, magnitudes beyond 64 bits are clamped, nan is
        /// 0.</summary>
        /// <param name="isExact">Whether the text is exactly this integer.</param>
        public static bool TryInteger(ref byte* p, out ulong magnitude, out bool isNegative, out bool isExact)
        {
            byte* q = p;
            isNegative = *q == '-';
            if (isNegative || *q == '+')
                q++;
            byte* firstDigit = q;
            ulong value = 0;
            uint digit;
            while ((digit = (uint)(*q - '0')) <= 9)
            {
                value = value * 10 + digit;
                q++;
            }
            if (*q <= ' ' && q != firstDigit && q - firstDigit <= MaxExactDigits)
            {
                p = q;
                magnitude = value;
                isExact = true;
                return true;
            }
            return TryLongInteger(ref p, out magnitude, out isExact);
        }

        static bool TryLongInteger(ref byte* p, out ulong magnitude, out bool isExact)
        {
            magnitude = 0;
            isExact = false;
            byte* start = p;
            var kind = Scan(ref p, out var number);
            if (kind == Kind.Infinite)
                magnitude = ulong.MaxValue;
            if (kind != Kind.Finite)
                return kind != Kind.None;
            if (number.IsTruncated && TryAllDigits(start, p, out magnitude, out isExact))
                return true;
            ulong whole = number.Mantissa;
            isExact = !number.IsTruncated;
            for (int e = number.Exponent; e < 0 && whole != 0; e++)
            {
                isExact &= whole % 10 == 0;
                whole /= 10;
            }
            for (int e = number.Exponent; e > 0 && whole != 0; e--)
            {
                if (whole > ulong.MaxValue / 10)
                {
                    isExact = false;
                    whole = ulong.MaxValue;
                    break;
                }
                whole *= 10;
            }
            magnitude = whole;
            return true;
        }

        /// <summary>Integers from 10^19 to 2^64 - 1 have a digit more than the scan's mantissa.</summary>
        /// <returns>Whether the text consists of digits and at most a fraction, without an exponent.</returns>
        static bool TryAllDigits(byte* p, byte* end, out ulong value, out bool isExact)
        {
            value = 0;
            isExact = true;
            if (*p == '-' || *p == '+')
                p++;
            uint digit;
            for (; (digit = (uint)(*p - '0')) <= 9; p++)
            {
                isExact &= value <= (ulong.MaxValue - digit) / 10;
                value = isExact ? value * 10 + digit : ulong.MaxValue;
            }
            if (p == end)
                return true;
            isExact = false;
            for (p++; p < end; p++)
                if (*p < '0' || *p > '9')
                    return false;
            return true;
        }

        static double ToDouble(in DecimalDigits number)
        {
            double value = HasExactDouble(number) ? NearestDouble(number) : math.asdouble(DecimalRounding.ToDoubleBits(number));
            return number.IsNegative ? -value : value;
        }

        static bool HasExactDouble(in DecimalDigits number) =>
            number.Mantissa <= MaxExactMantissa && (uint)(number.Exponent + MaxExactPower) <= 2 * MaxExactPower &&
            !number.IsTruncated;

        static double NearestDouble(in DecimalDigits number) =>
            number.Exponent < 0
                ? number.Mantissa / s_exactPowersOfTen[-number.Exponent]
                : number.Mantissa * s_exactPowersOfTen[number.Exponent];

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static Kind Scan(ref byte* text, out DecimalDigits number)
        {
            number = default;
            byte* p = text;
            number.IsNegative = *p == '-';
            if (number.IsNegative || *p == '+')
                p++;
            byte* start = p;
            ulong mantissa = 0;
            uint digit;
            while ((digit = (uint)(*p - '0')) <= 9)
            {
                mantissa = mantissa * 10 + digit;
                p++;
            }
            int digits = (int)(p - start);
            int exponent = 0;
            if (*p == '.')
            {
                byte* point = p++;
                while ((digit = (uint)(*p - '0')) <= 9)
                {
                    mantissa = mantissa * 10 + digit;
                    p++;
                }
                exponent = (int)(point + 1 - p);
                digits -= exponent;
            }
            if (digits == 0)
                return Word(ref text, start);
            number.Mantissa = mantissa;
            number.Exponent = exponent;
            if (digits > MaxExactDigits)
                TakeFirstDigits(start, p, ref number);
            if (*p > ' ')
            {
                if (*p == '#')
                    return Word(ref text, p + 1);
                if (!TryExponent(ref p, out int scale))
                    return Kind.None;
                number.Exponent += scale;
            }
            text = p;
            return Kind.Finite;
        }

        /// <summary>Takes the first 19 digits if there are more than the mantissa holds; leading zeros do not count.</summary>
        static void TakeFirstDigits(byte* p, byte* end, ref DecimalDigits number)
        {
            while (p < end && (*p == '0' || *p == '.'))
                p++;
            number.FirstDigit = p;
            number.EndOfDigits = end;
            ulong mantissa = 0;
            int digits = 0;
            for (; p < end; p++)
            {
                if (*p == '.')
                    continue;
                if (digits++ < MaxExactDigits)
                    mantissa = mantissa * 10 + (uint)(*p - '0');
            }
            number.Mantissa = mantissa;
            number.IsTruncated = digits > MaxExactDigits;
            if (number.IsTruncated)
                number.Exponent += digits - MaxExactDigits;
        }

        /// <summary>Reads what follows a number's digits: an exponent and the end of the text.</summary>
        static bool TryExponent(ref byte* p, out int exponent)
        {
            exponent = 0;
            byte* q = p;
            if ((*q | 0x20) != 'e')
                return false;
            q++;
            bool isNegative = *q == '-';
            if (isNegative || *q == '+')
                q++;
            byte* firstDigit = q;
            uint digit;
            while ((digit = (uint)(*q - '0')) <= 9)
            {
                exponent = math.min(exponent * 10 + (int)digit, MaxExponent);
                q++;
            }
            if (q == firstDigit || *q > ' ')
                return false;
            if (isNegative)
                exponent = -exponent;
            p = q;
            return true;
        }

        static Kind Word(ref byte* text, byte* p)
        {
            var kind = Kind.None;
            uint letters = Letters(p);
            if (letters == ('i' << 16 | 'n' << 8 | 'f'))
                kind = Kind.Infinite;
            else if (letters == ('n' << 16 | 'a' << 8 | 'n') || letters == ('i' << 16 | 'n' << 8 | 'd') ||
                     letters == ('q' << 16 | 'n' << 8 | 'a') || letters == ('s' << 16 | 'n' << 8 | 'a'))
                kind = Kind.NotANumber;
            if (kind != Kind.None)
            {
                while (*p > ' ')
                    p++;
                text = p;
            }
            return kind;
        }

        /// <summary>The next three bytes in lower case; 0 if the text ends before them.</summary>
        static uint Letters(byte* p)
        {
            uint letters = 0;
            for (int i = 0; i < 3; i++)
            {
                if (p[i] <= ' ')
                    return 0;
                letters = letters << 8 | (uint)(p[i] | 0x20);
            }
            return letters;
        }
    }
}
