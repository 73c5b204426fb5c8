namespace FastPoints.Cli.Output;

public static class NumberFormat
{
    public static string Count(long value) => value.ToString("N0", CultureInfo.InvariantCulture);

    /// <summary>1 node, 2 nodes.</summary>
    public static string Count(long value, string what) => Count(value) + " " + what + (value == 1 ? "" : "s");

    public static string Count(ulong value) => value.ToString("N0", CultureInfo.InvariantCulture);

    public static string Bytes(double bytes)
    {
        string[] units = ["bytes", "kB", "MB", "GB", "TB"];
        int unit = 0;
        for (; bytes >= 999.5 && unit < units.Length - 1; unit++)
            bytes /= 1000;
        return bytes.ToString(unit == 0 ? "0" : bytes < 10 ? "0.00" : bytes < 100 ? "0.0" : "0", CultureInfo.InvariantCulture)
            + " " + units[unit];
    }

    /// <summary>12.3 M, 45.0 k, 678.</summary>
    public static string Short(double value)
    {
        string[] units = ["", " k", " M", " G"];
        int unit = 0;
        for (; value >= 999.5 && unit < units.Length - 1; unit++)
            value /= 1000;
        return value.ToString(unit == 0 || value >= 100 ? "0" : value < 10 ? "0.00" : "0.0", CultureInfo.InvariantCulture)
            + units[unit];
    }

    public static string Seconds(double seconds) =>
        seconds.ToString(seconds < 10 ? "0.000" : "0.0", CultureInfo.InvariantCulture) + " s";

    /// <summary>Time left: 12 s, 3 min, 2 h 5 min.</summary>
    public static string Duration(double seconds)
    {
        if (double.IsInfinity(seconds) || seconds > 1e7)
            return "?";
        long whole = (long)Math.Ceiling(seconds);
        if (whole < 100)
            return whole + " s";
        long minutes = (whole + 30) / 60;
        return minutes < 100 ? minutes + " min" : minutes / 60 + " h " + minutes % 60 + " min";
    }

    public static string Box(BoundsGeo box) => box.IsEmpty ? "unknown bounds" : "(" + Value(box.Min.x) + ", " + Value(box.Min.y)
        + ", " + Value(box.Min.z) + ") to (" + Value(box.Max.x) + ", " + Value(box.Max.y) + ", " + Value(box.Max.z) + ")";

    public static string Coordinate(double value, double step)
    {
        int decimals = step > 0 && step < 1 ? Math.Min(12, (int)Math.Ceiling(-Math.Log10(step) - 1e-9)) : 3;
        return value.ToString("N" + decimals, CultureInfo.InvariantCulture);
    }

    /// <summary>Four digits: more of a measurement is noise.</summary>
    public static string FourDigits(double value) => value == 0 ? "0"
        : Math.Abs(value) is >= 1e-4 and < 1e6
            ? Math.Round(value, Math.Clamp(3 - (int)Math.Floor(Math.Log10(Math.Abs(value))), 0, 15))
                .ToString(CultureInfo.InvariantCulture)
            : value.ToString("0.###e0", CultureInfo.InvariantCulture);

    /// <param name="metresPerUnit">NaN for degrees, whose lengths are metres; 0 if it is not known.</param>
    public static string Unit(double metresPerUnit) => double.IsNaN(metresPerUnit) || metresPerUnit == 1 ? "m"
        : metresPerUnit == 0 ? "units" : Math.Abs(metresPerUnit - 0.3048) < 1e-5 ? "ft"
        : "units of " + Value(metresPerUnit) + " m";

    public static string Value(double value) => value.ToString("0.######", CultureInfo.InvariantCulture);
}
