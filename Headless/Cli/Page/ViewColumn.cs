namespace FastPoints.Cli.Page;

/// <summary>One attribute in a page's 3D view: a byte a point, as an amount within a range or one of some values, or three for
/// colours.</summary>
sealed class ViewColumn
{
    const int MaxCategories = 32, MaxNames = 256;
    const double OutlierShare = 0.01;

    Func<ViewPoints, ViewValues>[] m_planes = [];
    Func<double, double> m_toByte = v => v;

    public required string Name { get; init; }
    public double Low { get; private set; }
    public double High { get; private set; }

    /// <summary>Of a category; otherwise empty.</summary>
    public double[] Values { get; private set; } = [];

    public bool IsRgb => m_planes.Length == 3;

    public static List<ViewColumn> Of(IReadOnlyList<ViewPoints> sets, DisplayRanges ranges)
    {
        string[] rgb = [AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue];
        var columns = new List<ViewColumn>();
        if (ranges.Color != ColorDepth.None)
            columns.Add(new ViewColumn
            {
                Name = "Colour",
                m_planes = rgb.Select(name => (Func<ViewPoints, ViewValues>)(s => s.Attributes[name])).ToArray(),
                m_toByte = ranges.Color switch
                {
                    ColorDepth.Unit => v => v * 255 + 0.5,
                    ColorDepth.Bits16 => v => v / 256,
                    _ => v => v,
                },
            });
        foreach (string name in sets[^1].Attributes.Keys.Except(rgb))
        {
            // One more than a category may have is enough to know: listing all values would take much memory.
            double[] distinct = sets.SelectMany(s => s.Attributes[name]).Where(double.IsFinite).Distinct().Take(MaxNames + 1)
                .Order().ToArray();
            if (distinct.Length < 2)
                continue;
            var column = new ViewColumn { Name = name, m_planes = [s => s.Attributes[name]] };
            bool isCategory = name is AttributeNames.Classification or AttributeNames.PointSourceId ? distinct.Length <= MaxNames
                : name != AttributeNames.Intensity && distinct.Length <= MaxCategories;
            if (isCategory && distinct.All(v => v == Math.Floor(v)))
                column.SetValues(distinct);
            else
                column.SetRange(sets[^1].Attributes[name], ranges);
            columns.Add(column);
        }
        return columns;
    }

    void SetValues(double[] values)
    {
        Values = values;
        m_toByte = v => Math.Max(0, Array.BinarySearch(values, v));
    }

    void SetRange(ViewValues values, DisplayRanges ranges)
    {
        double[] sorted = values.Where(double.IsFinite).Order().ToArray();
        int outliers = (int)(sorted.Length * OutlierShare);
        (Low, High) = Name == AttributeNames.Intensity && ranges.IntensityVaries ? (ranges.IntensityLow, ranges.IntensityHigh)
            : (sorted[outliers], sorted[sorted.Length - 1 - outliers]);
        if (!(High > Low))
            (Low, High) = (sorted[0], sorted[^1]);
        double low = Low, perStep = 255 / (High - Low);
        m_toByte = v => (v - low) * perStep + 0.5;
    }

    public IEnumerable<byte[]> Planes(ViewPoints points, int[] kept) => m_planes.Select(plane =>
    {
        var values = plane(points);
        return kept.Select(i => (byte)Math.Clamp(double.IsFinite(values[i]) ? m_toByte(values[i]) : 0, 0, 255)).ToArray();
    });

    public static string NameOf(string attribute, double value)
    {
        string number = value.ToString(Math.Abs(value) < 1e15 ? "0.######" : "0.####e0", CultureInfo.InvariantCulture);
        return attribute == AttributeNames.Classification && ClassNames.Of((int)value) is { } name ? number + " " + name : number;
    }

    public void Write(Utf8JsonWriter json, ViewPoints points)
    {
        json.WriteStartObject();
        json.WriteString("name", Name);
        json.WriteNumber("planes", m_planes.Length);
        json.WriteString("kind", IsRgb ? "rgb" : Values.Length > 0 ? "category" : "amount");
        if (Values.Length > 0)
        {
            var mode = Name switch
            {
                AttributeNames.Classification => ColorMode.Classification,
                AttributeNames.ReturnNumber or AttributeNames.NumberOfReturns => ColorMode.ReturnNumber,
                _ => ColorMode.PointSource,
            };
            using var palette = Palettes.Create(mode, Allocator.Persistent);
            var counts = points.Attributes[Name].CountBy(v => v).ToDictionary();
            json.WriteStartArray("names");
            foreach (double value in Values)
                json.WriteStringValue(NameOf(Name, value));
            json.WriteEndArray();
            json.WriteStartArray("colors");
            foreach (double value in Values)
                json.WriteStringValue(Hex(palette[(int)Math.Clamp(value, 0, 65535) % Palettes.Length]));
            json.WriteEndArray();
            json.WriteStartArray("counts");
            foreach (double value in Values)
                json.WriteNumberValue(counts.GetValueOrDefault(value));
            json.WriteEndArray();
        }
        else if (!IsRgb)
        {
            json.WriteNumber("low", Low);
            json.WriteNumber("high", High);
            json.WriteString("ramp", Name == AttributeNames.Intensity ? "gray" : "viridis");
        }
        json.WriteEndObject();
    }

    public static string Hex(uint color) => $"{color & 255:x2}{color >> 8 & 255:x2}{color >> 16 & 255:x2}";
}
