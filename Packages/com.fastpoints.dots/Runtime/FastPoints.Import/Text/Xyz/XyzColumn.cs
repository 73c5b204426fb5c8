using System;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Text
{
    // What some rows show about one column.
    struct XyzColumn
    {
        public double Min;
        public double Max;

        // Without an exponent or a point.
        public bool IsInteger;

        // Whole numbers, however they are printed: some write colours as 117.0.
        public bool IsWhole => Decimals == 0;

        // The most digits behind the point: as printed, and without zeros at the end.
        public int DecimalsPrinted;
        public int Decimals;

        // The most of a value, from the first that is not zero to the last.
        public int Digits;

        public static XyzColumn Empty => new XyzColumn
        {
            Min = double.PositiveInfinity,
            Max = double.NegativeInfinity,
            IsInteger = true,
        };

        public double MaxMagnitude => Min <= Max ? math.max(math.abs(Min), math.abs(Max)) : 0;

        public bool IsWithin(double min, double max) => Min >= min && Max <= max;

        public void Include(in DecimalDigits number, double value)
        {
            Min = Math.Min(Min, value);
            Max = Math.Max(Max, value);
            IsInteger &= number.Exponent == 0;
            DecimalsPrinted = Math.Max(DecimalsPrinted, -number.Exponent);
            ulong mantissa = number.Mantissa;
            int exponent = number.Exponent, digits = 0;
            for (; mantissa != 0 && mantissa % 10 == 0; exponent++)
                mantissa /= 10;
            if (mantissa != 0)
                Decimals = Math.Max(Decimals, -exponent);
            for (; mantissa != 0; mantissa /= 10)
                digits++;
            Digits = Math.Max(Digits, digits);
        }

        // The narrowest usual type for the values: wider than these rows need if a few more may need it.
        public AttributeType TypeOf(string attribute)
        {
            bool isColor = attribute == AttributeNames.Red || attribute == AttributeNames.Green ||
                attribute == AttributeNames.Blue || attribute == AttributeNames.Alpha || attribute == AttributeNames.NearInfrared;
            if (!IsInteger && !(isColor && IsWhole && MaxMagnitude > 1))
                return Digits <= 7 ? AttributeType.Float32 : AttributeType.Float64;
            bool isByte = isColor || attribute == AttributeNames.Classification || attribute == AttributeNames.ReturnNumber ||
                attribute == AttributeNames.NumberOfReturns || attribute == AttributeNames.UserData;
            if (isByte && IsWithin(0, byte.MaxValue))
                return AttributeType.UInt8;
            if ((isByte || attribute == AttributeNames.Intensity || attribute == AttributeNames.PointSourceId) &&
                IsWithin(0, ushort.MaxValue))
                return AttributeType.UInt16;
            if (attribute == AttributeNames.Intensity && IsWithin(short.MinValue, short.MaxValue))
                return AttributeType.Int16;
            return IsWithin(int.MinValue / 2, int.MaxValue / 2) ? AttributeType.Int32
                : Digits <= 18 ? AttributeType.Int64 : AttributeType.Float64;
        }
    }
}
