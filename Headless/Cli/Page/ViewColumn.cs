namespace FastPoints.Cli.Page;

/// <summary>One attribute in a page's 3D view, with the values of the file: the browser finds colours for them.</summary>
sealed class ViewColumn
{
    const int MaxCategories = 32, MaxNames = 256;
    const double OutlierShare = 0.01;
    const double ScanAngleStep = 0.006; // Of LAS's int16 scan angles, in degrees.

    public required string Name { get; init; }

    public bool IsChannel { get; private init; }

    public double Low { get; private set; } // Of an amount: what its colours span.
    public double High { get; private set; }

    public double[] CategoryValues { get; private set; } = []; // Of a category; otherwise empty.

    /// <summary>The one value that all points have; NaN where there are several.</summary>
    public double Constant { get; private init; } = double.NaN;

    public bool IsConstant => !double.IsNaN(Constant);

    public static List<ViewColumn> Of(IReadOnlyList<ViewPoints> sets, DisplayRanges ranges)
    {
        var columns = new List<ViewColumn>();
        foreach (string name in sets[^1].Attributes.Keys)
        {
            // One more than a category may have is enough to know: listing all values would take much memory.
            double[] distinct = sets.SelectMany(s => Shown(name, s)).Where(double.IsFinite).Distinct().Take(MaxNames + 1)
                .Order().ToArray();
            bool isChannel = name is AttributeNames.Red or AttributeNames.Green or AttributeNames.Blue
                && ranges.Color != ColorDepth.None;
            var column = new ViewColumn
            {
                Name = name,
                IsChannel = isChannel,
                Constant = distinct.Length == 1 && !isChannel && sets.All(s => s.Attributes[name].All(double.IsFinite))
                    ? distinct[0] : double.NaN,
            };
            bool isCategory = name is AttributeNames.Classification or AttributeNames.PointSourceId ? distinct.Length <= MaxNames
                : name is not AttributeNames.Intensity and not AttributeNames.ScanAngle && distinct.Length <= MaxCategories;
            if (isCategory && distinct.Length > 1 && distinct.All(v => v == Math.Floor(v)))
                column.CategoryValues = distinct;
            else if (distinct.Length > 0)
                column.SetRange(Shown(name, sets[^1]), ranges);
            columns.Add(column);
        }
        return columns;
    }

    static double ScaleOf(string name, ViewValues values) =>
        name == AttributeNames.ScanAngle && values.Type == AttributeType.Int16 && values.Scale == 1 ? ScanAngleStep
            : values.Scale;

    static IEnumerable<double> Shown(string name, ViewPoints points)
    {
        var values = points.Attributes[name];
        double factor = ScaleOf(name, values) / values.Scale;
        return factor == 1 ? values : values.Select(v => v * factor);
    }

    void SetRange(IEnumerable<double> values, DisplayRanges ranges)
    {
        double[] sorted = values.Where(double.IsFinite).Order().ToArray();
        if (sorted.Length == 0)
            return;
        int outliers = (int)(sorted.Length * OutlierShare);
        (Low, High) = Name == AttributeNames.Intensity && ranges.IntensityVaries ? (ranges.IntensityLow, ranges.IntensityHigh)
            : (sorted[outliers], sorted[sorted.Length - 1 - outliers]);
        if (!(High > Low))
            (Low, High) = (sorted[0], sorted[^1]);
    }

    public static string NameOf(string attribute, double value)
    {
        string number = value.ToString(Math.Abs(value) < 1e15 ? "0.######" : "0.####e0", CultureInfo.InvariantCulture);
        return attribute == AttributeNames.Classification && ClassNames.Of((int)value) is { } name ? number + " " + name : number;
    }

    public void Write(Utf8JsonWriter json, ViewPoints points)
    {
        var values = points.Attributes[Name];
        json.WriteStartObject();
        json.WriteString("name", Name);
        values.WriteType(json, ScaleOf(Name, values));
        json.WriteString("kind", IsChannel ? "channel" : IsConstant ? "constant"
            : CategoryValues.Length > 0 ? "category" : "amount");
        if (IsConstant)
            json.WriteString("value", NameOf(Name, Constant));
        else if (CategoryValues.Length > 0)
            WriteCategories(json, values);
        else if (!IsChannel)
        {
            json.WriteNumber("low", Low);
            json.WriteNumber("high", High);
            json.WriteString("ramp", Name == AttributeNames.Intensity ? "gray" : "viridis");
            json.WriteString("unit", Name switch
            {
                AttributeNames.ScanAngle => "°",
                AttributeNames.GpsTime => "s",
                _ => "",
            });
        }
        json.WriteEndObject();
    }

    void WriteCategories(Utf8JsonWriter json, ViewValues values)
    {
        var mode = Name switch
        {
            AttributeNames.Classification => ColorMode.Classification,
            AttributeNames.ReturnNumber or AttributeNames.NumberOfReturns => ColorMode.ReturnNumber,
            _ => ColorMode.PointSource,
        };
        using var palette = Palettes.Create(mode, Allocator.Persistent);
        var counts = values.CountBy(v => v).ToDictionary();
        json.WriteObjects("categories", CategoryValues, value =>
        {
            json.WriteNumber("value", value);
            json.WriteString("name", NameOf(Name, value));
            json.WriteString("color", Hex(palette[(int)Math.Clamp(value, 0, 65535) % Palettes.Length]));
            json.WriteNumber("count", counts.GetValueOrDefault(value));
        });
    }

    public static string Hex(uint color) => $"{color & 255:x2}{color >> 8 & 255:x2}{color >> 16 & 255:x2}";
}
