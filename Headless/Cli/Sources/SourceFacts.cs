namespace FastPoints.Cli.Sources;

public sealed class SourceFacts(PointReader reader)
{
    const int NameWidth = 22;

    readonly long m_points = reader.BlocksAreKnown ? reader.PointCount : reader.Info.PointsReadable;
    TreeFacts? m_tree;

    internal CloudSummary? Found { get; set; }

    internal Spread? Spread { get; set; }
    public SourceInfo Info { get; } = reader.Info;

    /// <summary>Points, where they are known without a scan or have been found; -1 otherwise.</summary>
    public long Points => Found?.Points ?? m_points;

    public PointCounts PointCounts => PointCounts.Of(Info, Points);

    public string Kind => Info.Format + (Info.Version != null ? " " + Info.Version : "")
        + (Info.PointFormat >= 0 ? ", point format " + Info.PointFormat : "")
        + (Info.RecordBytes > 0 ? ", " + Info.RecordBytes + " bytes a point" : "");

    public IEnumerable<(string Name, string Value)> Lines()
    {
        yield return ("format", Kind);
        yield return ("size", NumberFormat.Count(Info.FileBytes) + " bytes");
        string claimed = Info.HasPointsClaimed
            ? NumberFormat.Count(Info.PointsClaimed) + " by the header"
            : "the file does not say how many";
        if (Found != null)
            yield return ("points", NumberFormat.Count(Found.Points) + " found, " + claimed);
        else if (Info.PointsReadable >= 0 && (ulong)Info.PointsReadable != Info.PointsClaimed && Info.HasPointsClaimed)
            yield return ("points", NumberFormat.Count(Info.PointsReadable) + " in the file, " + claimed);
        else
            yield return ("points", claimed);
        if (Found is { NonFiniteCount: > 0 })
            yield return ("not finite", NumberFormat.Count(Found.NonFiniteCount, "point")
                + " have a coordinate that is no number");
        if (Info.HasBoundsClaimed)
            foreach (var line in BoundsLines(Found == null ? "bounds" : "bounds (header)", Info.BoundsClaimed))
                yield return line;
        if (Found != null)
            foreach (var line in BoundsLines("bounds (found)", Found.Bounds))
                yield return line;
        foreach (var line in SpreadLines())
            yield return line;
        yield return ("crs", Info.Crs.Summary ?? "unknown");
        if (AxesOf(Info.Crs.ToCloudCrs()) is var (kind, axes))
            yield return ("axes", axes + ", " + kind + "; coordinates are never swapped for them");
        yield return ("unit", UnitOf(Info.Crs.Units, Info.BoundsIfFinite));
        if (Info.GpsTime.Kind != GpsTimeKind.Unknown)
            yield return ("GPS times", Info.GpsTime.ToString());
        ReadTree();
        if (m_tree is { } tree)
            yield return ("octree", NumberFormat.Count(tree.Nodes, "node") + " on "
                + NumberFormat.Count(tree.Levels.Count, "level") + (tree.IsHierarchyRead ? "" : " so far") + ", "
                + NumberFormat.Count(tree.NodesWithoutPoints) + " of them without points"
                + (tree.Pages > 0 ? ", " + NumberFormat.Count(tree.Pages, "page") + " of hierarchy" : ""));
    }

    void ReadTree()
    {
        if (reader.Tree != null)
            m_tree ??= TreeFacts.Of(reader.Tree);
    }

    /// <summary>The source's own octree level by level, or null if it has none.</summary>
    public TextTable? Levels()
    {
        ReadTree();
        if (m_tree is not { } tree)
            return null;
        var table = new TextTable("level", "nodes", "points", "most in a node", "spacing");
        foreach (var level in tree.Levels)
            table.Add(level.Level.ToString(CultureInfo.InvariantCulture), NumberFormat.Count(level.Nodes),
                NumberFormat.Count(level.Points), NumberFormat.Count(level.MaxPoints),
                level.Spacing.ToString("G4", CultureInfo.InvariantCulture));
        return table;
    }

    IEnumerable<(string, string)> SpreadLines()
    {
        if (Spread == null)
            yield break;
        foreach (var line in BoundsLines("99.9 % lie in", Spread.RobustBounds))
            yield return line;
        string per = " points/" + Spread.Unit + "²";
        yield return ("density", Spread.Quartiles is not [var low, var median, var high] ? "no area, seen from above"
            : "median " + NumberFormat.FourDigits(median) + per + "; a quarter below " + NumberFormat.FourDigits(low)
                + ", three quarters below " + NumberFormat.FourDigits(high)
                + " (squares of " + NumberFormat.FourDigits(Spread.SquareEdge) + " " + Spread.Unit
                + " with points, seen along z)");
        if (GpsTime is { } time)
            yield return ("GPS time span", NumberFormat.FourDigits(time.Max - time.Min) + " s, " + NumberFormat.Value(time.Min)
                + " to " + NumberFormat.Value(time.Max));
    }

    ColumnSummary? GpsTime => Found != null && Info.Schema.IndexOf(AttributeNames.GpsTime) is >= 0 and var i
        && Found.Columns[i].Finite > 0 ? Found.Columns[i] : null;

    IEnumerable<(string, string)> BoundsLines(string name, BoundsGeo bounds)
    {
        if (bounds.IsEmpty)
        {
            yield return (name, "empty");
            yield break;
        }
        for (int axis = 0; axis < 3; axis++)
        {
            double step = Info.Schema.Has(AttributeNames.X) &&
                !Info.Schema[Info.Schema.IndexOf(AttributeNames.X)].Type.IsFloat()
                ? Info.Transform.Scale[axis] : 0.001;
            string low = NumberFormat.Coordinate(bounds.Min[axis], step), high = NumberFormat.Coordinate(bounds.Max[axis], step);
            yield return (axis == 0 ? name : "", "xyz"[axis] + "  " + low + " to " + high + "   ("
                + NumberFormat.Coordinate(bounds.Max[axis] - bounds.Min[axis], step) + ")");
        }
    }

    public TextTable Attributes()
    {
        var table = Found == null ? new TextTable("attribute", "type") : new TextTable("attribute", "type", "min", "max");
        for (int i = 0; i < Info.Schema.Count; i++)
        {
            var attribute = Info.Schema[i];
            if (Found == null)
                table.Add(attribute.Name, attribute.Type.ToString());
            else
                table.Add(attribute.Name, attribute.Type.ToString(), Found.Columns[i].MinText ?? "",
                    Found.Columns[i].MaxText ?? "");
        }
        return table;
    }

    public void Write(TextWriter writer)
    {
        writer.WriteLine(Info.ShownPath);
        foreach (var (name, value) in Lines())
            writer.WriteLine("  " + name.PadRight(NameWidth) + value);
        foreach (var fact in Info.Facts)
            writer.WriteLine("  " + (fact.Key + " ").PadRight(NameWidth) + fact.Value);
        writer.WriteLine();
        Attributes().Write(writer, "  ");
        if (Levels() is { } levels)
        {
            writer.WriteLine();
            levels.Write(writer, "  ");
        }
        foreach (var (name, counts) in Counted())
        {
            writer.WriteLine();
            var table = new TextTable(name, "points", "%");
            for (int i = 0; i < counts.Length; i++)
                if (counts[i] > 0)
                    table.Add(NumberFormat.Count(i), NumberFormat.Count(counts[i]),
                        NumberFormat.Value(Math.Round(100.0 * counts[i] / Found!.Points, 2)));
            table.Write(writer, "  ");
        }
        if (Info.Warnings.Count > 0)
            writer.WriteLine();
        foreach (var warning in Info.Warnings)
            writer.WriteLine("  warning: " + (warning.Path != Info.ShownPath ? warning.ToString() : (warning.ByteOffset >= 0
                ? "at byte " + warning.ByteOffset.ToString(CultureInfo.InvariantCulture) + ": " : "") + warning.Text));
    }

    public static string UnitOf(CloudUnits units, BoundsGeo bounds) =>
        units.Describe(bounds) + (units.IsKnown ? "" : ": say it by --unit m, ft, us-ft or its metres");

    /// <returns>What EPSG's table says; null if it has no such system.</returns>
    public static (string Kind, string Axes)? AxesOf(CloudCrs crs)
    {
        if (crs.Epsg == 0 || EpsgTable.Find(crs.Epsg) is not { } system)
            return null;
        string axes = system.Axes + (system.Axes.Length < 3 && crs.VerticalEpsg != 0
            ? EpsgTable.Find(crs.VerticalEpsg)?.Axes : "");
        return (system.Kind.ToString().ToLowerInvariant(), axes);
    }

    /// <summary>A projected system whose second coordinate grows to the north, whatever the order of its axes.</summary>
    public static bool IsNorthAlongY(CloudCrs crs) => AxesOf(crs) is var (kind, axes)
        ? kind == "projected" && axes.Contains('N') && axes.Contains('E')
        : crs.Wkt is { } wkt && (wkt.Contains("PROJCS[") || wkt.Contains("PROJCRS[")) && !wkt.Contains("SOUTH");

    public static void WriteCrs(Utf8JsonWriter json, CloudCrs crs, BoundsGeo bounds)
    {
        json.WriteString("crs", crs.Name);
        WriteCode(json, "crsEpsg", crs.Epsg);
        WriteCode(json, "crsVerticalEpsg", crs.VerticalEpsg);
        json.WriteString("crsKind", AxesOf(crs)?.Kind);
        json.WriteString("crsAxes", AxesOf(crs)?.Axes);
        json.WriteReal("crsMetresPerUnit", crs.MetresPerUnit > 0 ? crs.MetresPerUnit : double.NaN);
        json.WriteReal("crsVerticalMetresPerUnit", crs.VerticalMetresPerUnit > 0 ? crs.VerticalMetresPerUnit : double.NaN);
        json.WriteBoolean("crsUnitKnown", crs.Units.IsKnown);
        json.WriteReal("crsPlacementError", crs.Units.IsInDegrees ? crs.Units.PlacementError(bounds) : double.NaN);
        json.WriteString("crsWkt", crs.Wkt);
    }

    public static void WriteFacts(Utf8JsonWriter json, SourceInfo info)
    {
        json.WriteObjects("facts", info.Facts, fact =>
        {
            json.WriteString("name", fact.Key);
            json.WriteString("value", fact.Value);
        });
    }

    internal static void WriteGpsTime(Utf8JsonWriter json, GpsTime time) =>
        json.WriteString("gpsTime", time.Kind == GpsTimeKind.Unknown ? null : time.ToString());

    static void WriteCode(Utf8JsonWriter json, string key, int code)
    {
        if (code != 0)
            json.WriteNumber(key, code);
        else
            json.WriteNull(key);
    }

    IEnumerable<(string Name, long[] Counts)> Counted()
    {
        if (Found?.ClassCounts is { } classes)
            yield return ("class", classes);
        if (Found?.ReturnCounts is { } returns)
            yield return ("return", returns);
    }

    void WriteTree(Utf8JsonWriter json)
    {
        if (m_tree is not { } tree)
        {
            json.WriteNull("tree");
            return;
        }
        json.WriteStartObject("tree");
        json.WriteNumber("nodes", tree.Nodes);
        json.WriteNumber("nodesWithoutPoints", tree.NodesWithoutPoints);
        json.WriteBoolean("isWhole", tree.IsHierarchyRead);
        json.WriteNumber("pages", tree.Pages);
        json.WriteObjects("levels", tree.Levels, level =>
        {
            json.WriteNumber("level", level.Level);
            json.WriteNumber("nodes", level.Nodes);
            json.WriteInteger("points", level.Points);
            json.WriteNumber("mostPoints", level.MaxPoints);
            json.WriteReal("spacing", level.Spacing);
        });
        json.WriteEndObject();
    }

    internal static void WriteAttribute(Utf8JsonWriter json, PointAttribute attribute, double min, double max)
    {
        json.WriteStartObject();
        json.WriteString("name", attribute.Name);
        json.WriteString("type", attribute.Type.ToString());
        json.WriteReal("min", min);
        json.WriteReal("max", max);
        json.WriteEndObject();
    }

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteString("format", Info.Format);
        json.WriteString("version", Info.Version);
        if (Info.PointFormat >= 0)
            json.WriteNumber("pointFormat", Info.PointFormat);
        else
            json.WriteNull("pointFormat");
        bool isClaimed = Found == null && Info.HasPointsClaimed;
        if (Found != null)
            json.WriteInteger("points", Found.Points);
        else if (isClaimed)
            json.WriteInteger("points", Points < 0 ? Info.PointsClaimed : (ulong)Points);
        else
            json.WriteNull("points");
        json.WriteString("pointsAre", Found != null ? "counted" : isClaimed ? "claimed" : null);
        json.WriteBounds("boundsClaimed", Info.HasBoundsClaimed ? Info.BoundsClaimed : BoundsGeo.Empty);
        json.WriteBounds("bounds", Found?.Bounds ?? BoundsGeo.Empty);
        json.WriteInteger("bytes", Info.FileBytes);
        if (Info.RecordBytes > 0)
            json.WriteNumber("recordBytes", Info.RecordBytes);
        if (Found != null)
            json.WriteInteger("pointsNotFinite", Found.NonFiniteCount);
        Spread?.WriteKeys(json);
        if (GpsTime is { } time)
            json.WriteReal("gpsTimeSpan", time.Max - time.Min);
        json.WriteVector("scale", Info.Transform.Scale);
        json.WriteVector("offset", Info.Transform.Offset);
        json.WriteArray("attributes", Enumerable.Range(0, Info.Schema.Count), i =>
        {
            bool hasRange = Found != null && Found.Columns[i].Finite > 0;
            WriteAttribute(json, Info.Schema[i], hasRange ? Found!.Columns[i].Min : double.NaN,
                hasRange ? Found!.Columns[i].Max : double.NaN);
        });
        WriteCrs(json, Info.Crs.ToCloudCrs(), Info.BoundsIfFinite);
        WriteGpsTime(json, Info.GpsTime);
        WriteFacts(json, Info);
        WriteTree(json);
        foreach (var (name, counts) in Counted())
        {
            json.WriteStartObject(name == "class" ? "classes" : "returns");
            for (int i = 0; i < counts.Length; i++)
                if (counts[i] > 0)
                    json.WriteInteger(i.ToString(CultureInfo.InvariantCulture), counts[i]);
            json.WriteEndObject();
        }
        if (Found == null)
        {
            json.WriteNull("columnSums");
            return;
        }
        json.WriteStartObject("columnSums");
        for (int i = 0; i < Info.Schema.Count; i++)
            json.WriteString(Info.Schema[i].Name, Found.Columns[i].Sum.ToString(CultureInfo.InvariantCulture));
        json.WriteEndObject();
    }
}
