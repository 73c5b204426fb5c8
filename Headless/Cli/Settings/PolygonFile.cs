namespace FastPoints.Cli.Settings;

/// <summary>Polygons with holes from GeoJSON, or from POLYGON or MULTIPOLYGON of WKT; what follows x and y of a vertex is
/// skipped.</summary>
sealed class PolygonFile
{
    const long MaxFileBytes = 256 << 20;

    readonly string m_text;
    readonly List<List<double2[]>> m_polygons = [];
    int m_at;

    PolygonFile(string text) => m_text = text;

    /// <exception cref="PointCloudException">The file cannot be read or is no polygon.</exception>
    public static FilterPolygons Read(string path)
    {
        try
        {
            if (new FileInfo(path).Length > MaxFileBytes)
                throw new FormatException("wanted at most " + MaxFileBytes + " bytes");
            return Parse(File.ReadAllText(path));
        }
        catch (Exception e) when (e is FormatException or IOException or UnauthorizedAccessException)
        {
            throw new PointCloudException(FailureCode.BadInput, path, -1, "no polygon: " + e.Message);
        }
    }

    /// <exception cref="FormatException">It is neither GeoJSON nor WKT with polygons.</exception>
    public static FilterPolygons Parse(string text)
    {
        var file = new PolygonFile(text.TrimStart('\uFEFF', ' ', '\t', '\r', '\n'));
        if (file.m_text.StartsWith('{'))
            file.ReadGeoJson();
        else
            file.ReadWkt();
        return FilterPolygons.Of(file.m_polygons);
    }

    void ReadGeoJson()
    {
        try
        {
            using var json = JsonDocument.Parse(m_text);
            AddGeoJson(json.RootElement);
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException or KeyNotFoundException)
        {
            throw new FormatException("no GeoJSON: " + e.Message);
        }
    }

    // As deep as JsonDocument lets text be.
    void AddGeoJson(JsonElement value)
    {
        switch (value.GetProperty("type").GetString())
        {
            case "FeatureCollection":
                foreach (var feature in value.GetProperty("features").EnumerateArray())
                    AddGeoJson(feature);
                break;
            case "GeometryCollection":
                foreach (var geometry in value.GetProperty("geometries").EnumerateArray())
                    AddGeoJson(geometry);
                break;
            case "Feature":
                if (value.TryGetProperty("geometry", out var of) && of.ValueKind != JsonValueKind.Null)
                    AddGeoJson(of);
                break;
            case "Polygon":
                AddRings(value.GetProperty("coordinates"));
                break;
            case "MultiPolygon":
                foreach (var polygon in value.GetProperty("coordinates").EnumerateArray())
                    AddRings(polygon);
                break;
            case var type:
                throw new FormatException("wanted a Polygon or a MultiPolygon, got " + type);
        }
    }

    void AddRings(JsonElement rings) => m_polygons.Add([.. rings.EnumerateArray().Select(ring => ring.EnumerateArray()
        .Select(at => at.GetArrayLength() < 2
            ? throw new FormatException("wanted x and y, got " + at.GetArrayLength() + " numbers")
            : new double2(at[0].GetDouble(), at[1].GetDouble())).ToArray())]);

    void ReadWkt()
    {
        string word = Word();
        if (word.StartsWith("SRID", StringComparison.OrdinalIgnoreCase) && m_text.IndexOf(';') is var end and >= 0)
        {
            m_at = end + 1;
            word = Word();
        }
        bool isMany = word.Equals("MULTIPOLYGON", StringComparison.OrdinalIgnoreCase);
        if (!isMany && !word.Equals("POLYGON", StringComparison.OrdinalIgnoreCase))
            throw Bad("GeoJSON, POLYGON or MULTIPOLYGON");
        if (char.IsLetter(SkipSpaces()))
            Word();
        if (isMany)
            InParentheses(Polygon);
        else
            Polygon();
        if (SkipSpaces() != '\0')
            throw Bad("the end");
    }

    void Polygon()
    {
        m_polygons.Add([]);
        InParentheses(Ring);
    }

    void Ring()
    {
        List<double2> points = [];
        InParentheses(() =>
        {
            points.Add(new double2(Number(), Number()));
            while (SkipSpaces() != ',' && SkipSpaces() != ')')
                Number();
        });
        m_polygons[^1].Add([.. points]);
    }

    void InParentheses(Action item)
    {
        Take('(');
        item();
        while (SkipSpaces() == ',')
        {
            m_at++;
            item();
        }
        Take(')');
    }

    double Number() => double.TryParse(While(c => "+-.eE0123456789".Contains(c)), NumberStyles.Float,
        CultureInfo.InvariantCulture, out double value) ? value : throw Bad("a number");

    string Word() => While(char.IsLetter);

    string While(Func<char, bool> belongs)
    {
        SkipSpaces();
        int from = m_at;
        while (m_at < m_text.Length && belongs(m_text[m_at]))
            m_at++;
        return m_text[from..m_at];
    }

    void Take(char wanted)
    {
        if (SkipSpaces() != wanted)
            throw Bad("'" + wanted + "'");
        m_at++;
    }

    // Returns what is next, '\0' at the end.
    char SkipSpaces()
    {
        while (m_at < m_text.Length && char.IsWhiteSpace(m_text[m_at]))
            m_at++;
        return m_at < m_text.Length ? m_text[m_at] : '\0';
    }

    FormatException Bad(string wanted) => new("wanted " + wanted + " at character " + (m_at + 1) + ", got "
        + (m_at < m_text.Length ? "'" + m_text[m_at] + "'" : "the end"));
}
