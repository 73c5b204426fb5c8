namespace FastPoints.Cli.Settings;

/// <summary>Integer options in the usual spellings of large numbers: 2000000, 2,000,000, 2e6, 2M, 500k.</summary>
public static class Counts
{
    const double Largest = 1L << 53;

    public static Option<long> Of(string name, string description, long fallback, string helpName = "N", long min = 1) =>
        new(name)
        {
            HelpName = helpName,
            Description = description,
            DefaultValueFactory = _ => fallback,
            CustomParser = result => Parse(result, min),
        };

    public static Option<long?> Optional(string name, string description, string helpName = "N", long min = 1) => new(name)
    {
        HelpName = helpName,
        Description = description,
        CustomParser = result => Parse(result, min),
    };

    public static int ToInt(long count) => (int)Math.Min(int.MaxValue, count);

    static long Parse(ArgumentResult result, long min)
    {
        string text = result.Tokens[^1].Value;
        if (TryParse(text, out long count) && count >= min)
            return count;
        string? name = (result.Parent as OptionResult)?.Option.Name;
        result.AddError(string.Create(CultureInfo.InvariantCulture,
            $"{name}: wanted a whole number from {min} (such as 500k, 2M or 1e6), got {text}"));
        return min;
    }

    public static bool TryParse(string text, out long count)
    {
        double unit = text.Length == 0 ? 0 : text[^1] switch { 'k' or 'K' => 1e3, 'M' => 1e6, 'G' => 1e9, _ => 1 };
        string digits = unit == 1 ? text : text[..^1];
        bool isNumber = double.TryParse(digits, NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent
            | NumberStyles.AllowThousands | NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out double value);
        value *= unit;
        bool isCount = isNumber && Math.Abs(value) <= Largest && value == Math.Floor(value);
        count = isCount ? (long)value : 0;
        return isCount;
    }
}
