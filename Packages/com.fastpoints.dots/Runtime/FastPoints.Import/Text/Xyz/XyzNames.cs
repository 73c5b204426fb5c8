using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Text
{
    struct XyzColumn
    {
        public double Min;
        public double Max;
        public bool IsPrintedAsInteger; // Without an exponent or a point.
        public bool IsWhole => Decimals == 0; // Whole numbers, however they are printed: some write colours as 117.0.

        // The most digits behind the point: as printed, and without zeros at the end.
        public int DecimalsPrinted;
        public int Decimals;
        public int Digits; // The most of a value, from the first that is not zero to the last.

        public static XyzColumn Empty => new XyzColumn
        {
            Min = double.PositiveInfinity,
            Max = double.NegativeInfinity,
            IsPrintedAsInteger = true,
        };

        public double MaxMagnitude => Min <= Max ? math.max(math.abs(Min), math.abs(Max)) : 0;

        public bool IsWithin(double min, double max) => Min >= min && Max <= max;

        public void Include(in DecimalDigits number, double value)
        {
            Min = Math.Min(Min, value);
            Max = Math.Max(Max, value);
            IsPrintedAsInteger &= number.Exponent == 0;
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
            if (!IsPrintedAsInteger && !(isColor && IsWhole && MaxMagnitude > 1))
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

    static class XyzNames
    {
        static readonly Dictionary<string, string> s_names = new Dictionary<string, string>(StringComparer.OrdinalIgnoreCase)
        {
            { "x", AttributeNames.X }, { "easting", AttributeNames.X }, { "east", AttributeNames.X },
            { "lon", AttributeNames.X }, { "longitude", AttributeNames.X },
            { "y", AttributeNames.Y }, { "northing", AttributeNames.Y }, { "north", AttributeNames.Y },
            { "lat", AttributeNames.Y }, { "latitude", AttributeNames.Y },
            { "z", AttributeNames.Z }, { "height", AttributeNames.Z }, { "elevation", AttributeNames.Z },
            { "h", AttributeNames.Z }, { "altitude", AttributeNames.Z },
            { "i", AttributeNames.Intensity }, { "intensity", AttributeNames.Intensity }, { "int", AttributeNames.Intensity },
            { "scalar_intensity", AttributeNames.Intensity }, { "reflectance", AttributeNames.Intensity },
            { "red", AttributeNames.Red }, { "green", AttributeNames.Green }, { "blue", AttributeNames.Blue },
            { "alpha", AttributeNames.Alpha },
            { "nx", AttributeNames.NormalX }, { "ny", AttributeNames.NormalY }, { "nz", AttributeNames.NormalZ },
            { "normal_x", AttributeNames.NormalX }, { "normal_y", AttributeNames.NormalY },
            { "normal_z", AttributeNames.NormalZ }, { "normalx", AttributeNames.NormalX },
            { "normaly", AttributeNames.NormalY }, { "normalz", AttributeNames.NormalZ },
        };

        static readonly string[] s_rgb = { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue };
        static readonly string[] s_normal = { AttributeNames.NormalX, AttributeNames.NormalY, AttributeNames.NormalZ };

        // Null for "-". Names that repeat get a number.
        public static string[] Of(IReadOnlyList<string> given, int columns)
        {
            var result = new string[columns];
            var taken = new HashSet<string>();
            bool hasRgb = Has(given, "r") && Has(given, "g") && Has(given, "b");
            for (int i = 0; i < columns && i < given.Count; i++)
            {
                string name = given[i].Trim();
                if (name == "-" || name.Length == 0)
                    continue;
                int color = hasRgb ? "rgb".IndexOf(name, StringComparison.OrdinalIgnoreCase) : -1;
                if (color >= 0)
                    name = s_rgb[color];
                else if ((s_names.TryGetValue(name, out string typical) || (typical = CommonNames.Of(name)) != null) &&
                    !taken.Contains(typical))
                    name = typical;
                string free = name;
                for (int n = 2; !taken.Add(free); n++)
                    free = name + "_" + n;
                result[i] = free;
            }
            return result;
        }

        public static bool HavePosition(string[] names) => Array.IndexOf(names, AttributeNames.X) >= 0 &&
            Array.IndexOf(names, AttributeNames.Y) >= 0 && Array.IndexOf(names, AttributeNames.Z) >= 0;

        // Whether X and Y are a longitude and a latitude by their names.
        public static bool AreDegrees(IReadOnlyList<string> given) =>
            (Has(given, "lat") || Has(given, "latitude")) && (Has(given, "lon") || Has(given, "longitude"));

        // x y z, and then by count and values: intensity, colour, normals, or columns without a name. unitVectorShares: for each
        // column, the share of sampled rows that have a vector of length 1 from there on.
        public static string[] Guess(XyzColumn[] columns, double[] unitVectorShares)
        {
            int count = columns.Length;
            var names = new string[count];
            names[0] = AttributeNames.X;
            names[1] = AttributeNames.Y;
            names[2] = AttributeNames.Z;
            bool hasIntensity = false, hasColor = false, hasNormal = false;
            for (int i = 3; i < count;)
            {
                int left = count - i;
                bool isNormal = !hasNormal && IsNormal(columns, unitVectorShares, i);
                bool isColor = !hasColor && IsColor(columns, i);
                // With four columns, the first is the intensity (PTS) if the other three fit, unless the last is an opacity.
                bool hasAlpha = left == 4 && isColor && columns[i + 3].IsWithin(byte.MaxValue, byte.MaxValue);
                bool intensityFirst = !hasIntensity && left % 3 == 1 && !hasAlpha &&
                    (!hasColor && IsColor(columns, i + 1) || !hasNormal && IsNormal(columns, unitVectorShares, i + 1));
                if (!intensityFirst && (isNormal || isColor))
                {
                    Array.Copy(isNormal ? s_normal : s_rgb, 0, names, i, 3);
                    hasNormal |= isNormal;
                    hasColor |= !isNormal;
                    i += 3;
                    if (hasAlpha)
                        names[i++] = AttributeNames.Alpha;
                    continue;
                }
                names[i] = hasIntensity ? "Column" + (i + 1) : AttributeNames.Intensity;
                hasIntensity = true;
                i++;
            }
            return names;
        }

        static bool Has(IReadOnlyList<string> names, string name)
        {
            foreach (string other in names)
                if (string.Equals(other.Trim(), name, StringComparison.OrdinalIgnoreCase))
                    return true;
            return false;
        }

        static bool IsNormal(XyzColumn[] columns, double[] unitVectorShares, int at) => at + 3 <= columns.Length &&
            unitVectorShares[at] > 0.9 && !(columns[at].IsPrintedAsInteger && columns[at + 1].IsPrintedAsInteger &&
            columns[at + 2].IsPrintedAsInteger);

        // Whole numbers of 8 or 16 bits, or shares of 1.
        static bool IsColor(XyzColumn[] columns, int at)
        {
            if (at + 3 > columns.Length)
                return false;
            bool areInteger = true, areShares = true;
            for (int i = at; i < at + 3; i++)
            {
                areInteger &= columns[i].IsWhole && columns[i].IsWithin(0, ushort.MaxValue);
                areShares &= !columns[i].IsPrintedAsInteger && columns[i].IsWithin(0, 1);
            }
            return areInteger || areShares;
        }
    }
}
