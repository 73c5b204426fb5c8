namespace FastPoints.Cli.Sources;

public sealed class ConvertedCloudFacts
{
    sealed class Level
    {
        public int Nodes;
        public long Points;
        public int MaxPoints;
        public double Spacing;
    }

    const int NameWidth = 22;

    readonly string m_path;
    readonly SourceInfo m_source = new();
    readonly List<Level> m_levels = [];
    readonly List<(string Name, long Bytes)> m_planes = [];
    readonly List<SourceEntry> m_sources;
    readonly int m_edits, m_undone;

    public ConvertedCloudFacts(string path)
    {
        m_path = path;
        using var folder = CloudFolder.Open(path);
        Manifest = folder.Manifest;
        StoredFacts.AddTo(m_source, folder);
        var bytesOfPlane = new long[folder.Layout.Planes.Count];
        foreach (var table in folder.EachTable())
            Add(table, bytesOfPlane);
        Bytes = SourcePath.IsRemote(path) ? folder.Files().Sum(file => file.Bytes)
            : Directory.GetFiles(folder.FolderPath, "*", SearchOption.AllDirectories).Sum(f => new FileInfo(f).Length);
        m_sources = StoredSources.Read(folder.FolderPath);
        if (IsWhole)
        {
            var edits = EditJournal.Read(path, Manifest.CloudId);
            (m_edits, m_undone) = (edits.Count, edits.Operations.Count - edits.Count);
        }
        m_planes.AddRange(folder.Layout.Planes.Select((plane, i) => (plane.Name, bytesOfPlane[i])));
    }

    public PointCounts PointCounts => PointCounts.Of(new SourceInfo { HasPointsClaimed = false }, Manifest.Points);

    bool IsWhole => !Manifest.IsBuilding;

    void Add(NodeTable table, long[] bytesOfPlane)
    {
        for (int i = 0; i < table.Nodes.Length; i++)
        {
            var node = table.Nodes[i];
            int at = Manifest.Root.SideLog2 - node.SideLog2;
            while (m_levels.Count <= at)
                m_levels.Add(new Level());
            var level = m_levels[at];
            level.Nodes++;
            level.Points += node.PointCount;
            level.MaxPoints = Math.Max(level.MaxPoints, node.PointCount);
            double spacing = math.cmax(Manifest.Grid.Step) * Math.Pow(2, node.CellLog2);
            if (node.HasSpacing && (level.Spacing == 0 || spacing < level.Spacing))
                level.Spacing = spacing;
        }
        for (int i = 0; i < table.PlaneRanges.Length; i++)
            bytesOfPlane[i % table.PlaneCount] += table.PlaneRanges[i].LengthBytes;
    }

    public void Write(TextWriter writer)
    {
        writer.WriteLine(m_path);
        foreach (var (name, value) in Lines())
            writer.WriteLine("  " + name.PadRight(NameWidth) + value);
        foreach (var table in Tables())
        {
            writer.WriteLine();
            table.Write(writer, "  ");
        }
    }

    public IEnumerable<TextTable> Tables()
    {
        var attributes = new TextTable("attribute", "type", "min", "max");
        for (int i = 0; i < Manifest.Attributes.Count; i++)
            attributes.Add(Manifest.Attributes[i].Name, Manifest.Attributes[i].Type.ToString(),
                NumberFormat.Value(Manifest.Ranges[i].Min), NumberFormat.Value(Manifest.Ranges[i].Max));
        yield return attributes;
        var levels = new TextTable("level", "nodes", "points", "most in a node", "spacing");
        for (int i = 0; i < m_levels.Count; i++)
            levels.Add(NumberFormat.Count(i), NumberFormat.Count(m_levels[i].Nodes), NumberFormat.Count(m_levels[i].Points),
                NumberFormat.Count(m_levels[i].MaxPoints),
                m_levels[i].Spacing > 0 ? NumberFormat.Value(m_levels[i].Spacing) : "");
        yield return levels;
        var planes = new TextTable("plane", "bytes", "bytes a point");
        foreach (var (name, bytes) in m_planes)
            planes.Add(name, NumberFormat.Count(bytes),
                NumberFormat.Value(Math.Round(bytes / Math.Max(1.0, Manifest.Points), 2)));
        yield return planes;
    }

    public CloudManifest Manifest { get; }
    public long Bytes { get; }

    public IEnumerable<(string Name, string Value)> Lines()
    {
        yield return ("format", "converted cloud " + StoreFormat.Version + (IsWhole ? "" : ", being built"));
        yield return ("size", NumberFormat.Count(Bytes) + " bytes");
        yield return ("points", NumberFormat.Count(Manifest.Points)
            + (Manifest.PointsLeftOut > 0 ? ", " + NumberFormat.Count(Manifest.PointsLeftOut) + " left out" : ""));
        var bounds = Manifest.BoundsGeo;
        for (int axis = 0; axis < 3 && !bounds.IsEmpty; axis++)
            yield return (axis == 0 ? "bounds" : "", "xyz"[axis] + "  "
                + NumberFormat.Coordinate(bounds.Min[axis], Manifest.Grid.Step[axis]) + " to "
                + NumberFormat.Coordinate(bounds.Max[axis], Manifest.Grid.Step[axis]));
        yield return ("crs", Manifest.CrsName ?? "unknown");
        if (SourceFacts.AxesOf(Manifest.Crs) is var (kind, axes))
            yield return ("axes", axes + ", " + kind + "; coordinates are never swapped for them");
        yield return ("unit", SourceFacts.UnitOf(Manifest.Crs.Units, Manifest.BoundsGeo));
        if (Manifest.GpsTime.Kind != GpsTimeKind.Unknown)
            yield return ("GPS times", Manifest.GpsTime.ToString());
        yield return ("octree", NumberFormat.Count(Manifest.NodeCount, "node") + " on "
            + NumberFormat.Count(m_levels.Count, "level") + " in " + NumberFormat.Count(Manifest.ChunkCount, "chunk"));
        yield return ("sampler", Manifest.Sampler);
        yield return ("checksum", Manifest.Checksum.ToString("x16", CultureInfo.InvariantCulture));
        if (m_edits + m_undone > 0)
            yield return ("edits", NumberFormat.Count(m_edits)
                + (m_undone > 0 ? ", " + NumberFormat.Count(m_undone) + " undone" : ""));
        yield return ("whole", IsWhole ? "yes" : "no, it is being built");
        foreach (var source in m_sources)
            yield return ("source", source.Name + ", " + NumberFormat.Count(source.FileBytes) + " bytes, "
                + NumberFormat.Count(source.Points, "point") + (source.Crs?.Name is { } crs ? ", " + crs : ""));
        foreach (var fact in m_source.Facts)
            yield return (fact.Key, fact.Value);
    }

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteString("format", "FastPoints");
        json.WriteString("version", StoreFormat.Version.ToString(CultureInfo.InvariantCulture));
        json.WriteNull("pointFormat");
        json.WriteInteger("points", Manifest.Points);
        json.WriteString("pointsAre", "counted");
        json.WriteInteger("pointsLeftOut", Manifest.PointsLeftOut);
        json.WriteBoolean("isWhole", IsWhole);
        json.WriteBounds("boundsClaimed", BoundsGeo.Empty);
        json.WriteBounds("bounds", Manifest.BoundsGeo);
        json.WriteVector("scale", Manifest.Grid.Step);
        json.WriteVector("offset", Manifest.Grid.Origin);
        json.WriteStartArray("attributes");
        for (int i = 0; i < Manifest.Attributes.Count; i++)
            SourceFacts.WriteAttribute(json, Manifest.Attributes[i], Manifest.Ranges[i].Min, Manifest.Ranges[i].Max);
        json.WriteEndArray();
        SourceFacts.WriteCrs(json, Manifest.Crs, Manifest.BoundsGeo);
        SourceFacts.WriteGpsTime(json, Manifest.GpsTime);
        SourceFacts.WriteFacts(json, m_source);
        json.WriteStartObject("tree");
        json.WriteNumber("nodes", Manifest.NodeCount);
        json.WriteNumber("chunks", Manifest.ChunkCount);
        json.WriteBoolean("isWhole", IsWhole);
        json.WriteObjects("levels", Enumerable.Range(0, m_levels.Count), i =>
        {
            json.WriteNumber("level", i);
            json.WriteNumber("nodes", m_levels[i].Nodes);
            json.WriteInteger("points", m_levels[i].Points);
            json.WriteNumber("mostPoints", m_levels[i].MaxPoints);
            json.WriteReal("spacing", m_levels[i].Spacing > 0 ? m_levels[i].Spacing : double.NaN);
        });
        json.WriteEndObject();
        json.WriteInteger("bytesOnDisk", Bytes);
        json.WriteStartObject("bytesOfPlane");
        foreach (var (name, bytes) in m_planes)
            json.WriteInteger(name, bytes);
        json.WriteEndObject();
        json.WriteString("sampler", Manifest.Sampler);
        json.WriteString("checksum", Manifest.Checksum.ToString("x16", CultureInfo.InvariantCulture));
        json.WriteObjects("sources", m_sources, source =>
        {
            json.WriteString("name", source.Name);
            json.WriteInteger("bytes", source.FileBytes);
            json.WriteInteger("points", source.Points);
        });
        json.WriteNumber("edits", m_edits);
        json.WriteNull("columnSums");
    }
}
