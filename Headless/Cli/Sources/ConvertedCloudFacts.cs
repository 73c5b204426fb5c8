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
    readonly CloudManifest m_manifest;
    readonly SourceInfo m_source = new();
    readonly List<Level> m_levels = [];
    readonly List<(string Name, long Bytes)> m_planes = [];
    readonly long m_bytes;
    readonly List<SourceEntry> m_sources;
    readonly int m_edits, m_undone;

    public ConvertedCloudFacts(string path)
    {
        m_path = path;
        using var folder = CloudFolder.Open(path);
        m_manifest = folder.Manifest;
        StoredFacts.AddTo(m_source, folder);
        var bytesOfPlane = new long[folder.Layout.Planes.Count];
        foreach (var table in folder.EachTable())
            Add(table, bytesOfPlane);
        m_bytes = SourcePath.IsRemote(path) ? folder.Files().Sum(file => file.Bytes)
            : Directory.GetFiles(folder.FolderPath, "*", SearchOption.AllDirectories).Sum(f => new FileInfo(f).Length);
        m_sources = StoredSources.Read(folder.FolderPath);
        if (IsWhole)
        {
            var edits = EditJournal.Read(path, m_manifest.CloudId);
            (m_edits, m_undone) = (edits.Count, edits.Operations.Count - edits.Count);
        }
        m_planes.AddRange(folder.Layout.Planes.Select((plane, i) => (plane.Name, bytesOfPlane[i])));
    }

    public PointCounts PointCounts => PointCounts.Of(new SourceInfo { HasPointsClaimed = false }, m_manifest.Points);

    bool IsWhole => !m_manifest.IsBuilding;

    void Add(NodeTable table, long[] bytesOfPlane)
    {
        for (int i = 0; i < table.Nodes.Length; i++)
        {
            var node = table.Nodes[i];
            int at = m_manifest.Root.SideLog2 - node.SideLog2;
            while (m_levels.Count <= at)
                m_levels.Add(new Level());
            var level = m_levels[at];
            level.Nodes++;
            level.Points += node.PointCount;
            level.MaxPoints = Math.Max(level.MaxPoints, node.PointCount);
            double spacing = math.cmax(m_manifest.Grid.Step) * Math.Pow(2, node.CellLog2);
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
        for (int i = 0; i < m_manifest.Attributes.Count; i++)
            attributes.Add(m_manifest.Attributes[i].Name, m_manifest.Attributes[i].Type.ToString(),
                NumberFormat.Value(m_manifest.Ranges[i].Min), NumberFormat.Value(m_manifest.Ranges[i].Max));
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
                NumberFormat.Value(Math.Round(bytes / Math.Max(1.0, m_manifest.Points), 2)));
        yield return planes;
    }

    public CloudManifest Manifest => m_manifest;
    public long Bytes => m_bytes;

    public IEnumerable<(string Name, string Value)> Lines()
    {
        yield return ("format", "converted cloud " + StoreFormat.Version + (IsWhole ? "" : ", being built"));
        yield return ("size", NumberFormat.Count(m_bytes) + " bytes");
        yield return ("points", NumberFormat.Count(m_manifest.Points)
            + (m_manifest.PointsLeftOut > 0 ? ", " + NumberFormat.Count(m_manifest.PointsLeftOut) + " left out" : ""));
        var bounds = m_manifest.BoundsGeo;
        for (int axis = 0; axis < 3 && !bounds.IsEmpty; axis++)
            yield return (axis == 0 ? "bounds" : "", "xyz"[axis] + "  "
                + NumberFormat.Coordinate(bounds.Min[axis], m_manifest.Grid.Step[axis]) + " to "
                + NumberFormat.Coordinate(bounds.Max[axis], m_manifest.Grid.Step[axis]));
        yield return ("crs", m_manifest.CrsName ?? "unknown");
        if (SourceFacts.AxesOf(m_manifest.Crs) is var (kind, axes))
            yield return ("axes", axes + ", " + kind + "; coordinates are never swapped for them");
        yield return ("unit", SourceFacts.UnitOf(m_manifest.Crs.Units, m_manifest.BoundsGeo));
        if (m_manifest.GpsTime.Kind != GpsTimeKind.Unknown)
            yield return ("GPS times", m_manifest.GpsTime.ToString());
        yield return ("octree", NumberFormat.Count(m_manifest.NodeCount, "node") + " on "
            + NumberFormat.Count(m_levels.Count, "level") + " in " + NumberFormat.Count(m_manifest.ChunkCount, "chunk"));
        yield return ("sampler", m_manifest.Sampler);
        yield return ("checksum", m_manifest.Checksum.ToString("x16", CultureInfo.InvariantCulture));
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
        json.WriteInteger("points", m_manifest.Points);
        json.WriteString("pointsAre", "counted");
        json.WriteInteger("pointsLeftOut", m_manifest.PointsLeftOut);
        json.WriteBoolean("isWhole", IsWhole);
        json.WriteBounds("boundsClaimed", BoundsGeo.Empty);
        json.WriteBounds("bounds", m_manifest.BoundsGeo);
        json.WriteVector("scale", m_manifest.Grid.Step);
        json.WriteVector("offset", m_manifest.Grid.Origin);
        json.WriteStartArray("attributes");
        for (int i = 0; i < m_manifest.Attributes.Count; i++)
            SourceFacts.WriteAttribute(json, m_manifest.Attributes[i], m_manifest.Ranges[i].Min, m_manifest.Ranges[i].Max);
        json.WriteEndArray();
        SourceFacts.WriteCrs(json, m_manifest.Crs, m_manifest.BoundsGeo);
        SourceFacts.WriteGpsTime(json, m_manifest.GpsTime);
        SourceFacts.WriteFacts(json, m_source);
        json.WriteStartObject("tree");
        json.WriteNumber("nodes", m_manifest.NodeCount);
        json.WriteNumber("chunks", m_manifest.ChunkCount);
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
        json.WriteInteger("bytesOnDisk", m_bytes);
        json.WriteStartObject("bytesOfPlane");
        foreach (var (name, bytes) in m_planes)
            json.WriteInteger(name, bytes);
        json.WriteEndObject();
        json.WriteString("sampler", m_manifest.Sampler);
        json.WriteString("checksum", m_manifest.Checksum.ToString("x16", CultureInfo.InvariantCulture));
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
