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
    readonly CloudManifest m_cloud;
    readonly SourceInfo m_source = new();
    readonly List<Level> m_levels = [];
    readonly List<(string Name, long Bytes)> m_planes = [];
    readonly long m_bytes;

    public ConvertedCloudFacts(string path)
    {
        m_path = path;
        using var folder = CloudFolder.Open(path);
        m_cloud = folder.Manifest;
        StoredFacts.AddTo(m_source, folder);
        m_bytes = SourcePath.IsRemote(path)
            ? m_cloud.HierarchyBytes + m_cloud.UpperBytes + folder.Chunks.Sum(chunk => chunk.FileBytes)
            : Directory.GetFiles(folder.FolderPath, "*", SearchOption.AllDirectories).Sum(f => new FileInfo(f).Length);
        var bytesOfPlane = new long[folder.Layout.Planes.Count];
        Add(folder.Upper, bytesOfPlane);
        for (int chunk = 0; chunk < folder.Chunks.Length; chunk++)
        {
            folder.FetchTablesFrom(chunk);
            using var table = folder.LoadTable(chunk);
            Add(table, bytesOfPlane);
        }
        m_planes.AddRange(folder.Layout.Planes.Select((plane, i) => (plane.Name, bytesOfPlane[i])));
    }

    public PointCounts PointCounts => PointCounts.Of(new SourceInfo { HasPointsClaimed = false }, m_cloud.Points);

    bool IsWhole => !m_cloud.IsBuilding;

    void Add(NodeTable table, long[] bytesOfPlane)
    {
        for (int i = 0; i < table.Nodes.Length; i++)
        {
            var node = table.Nodes[i];
            int at = m_cloud.Root.SideLog2 - node.SideLog2;
            while (m_levels.Count <= at)
                m_levels.Add(new Level());
            var level = m_levels[at];
            level.Nodes++;
            level.Points += node.PointCount;
            level.MaxPoints = Math.Max(level.MaxPoints, node.PointCount);
            double spacing = math.cmax(m_cloud.Grid.Step) * Math.Pow(2, node.CellLog2);
            if (node.HasSpacing && (level.Spacing == 0 || spacing < level.Spacing))
                level.Spacing = spacing;
        }
        for (int i = 0; i < table.Planes.Length; i++)
            bytesOfPlane[i % table.PlaneCount] += table.Planes[i].LengthBytes;
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
        for (int i = 0; i < m_cloud.Attributes.Count; i++)
            attributes.Add(m_cloud.Attributes[i].Name, m_cloud.Attributes[i].Type.ToString(),
                Human.Value(m_cloud.Ranges[i].Min), Human.Value(m_cloud.Ranges[i].Max));
        yield return attributes;
        var levels = new TextTable("level", "nodes", "points", "most in a node", "spacing");
        for (int i = 0; i < m_levels.Count; i++)
            levels.Add(Human.Count(i), Human.Count(m_levels[i].Nodes), Human.Count(m_levels[i].Points),
                Human.Count(m_levels[i].MaxPoints), m_levels[i].Spacing > 0 ? Human.Value(m_levels[i].Spacing) : "");
        yield return levels;
        var planes = new TextTable("plane", "bytes", "bytes a point");
        foreach (var (name, bytes) in m_planes)
            planes.Add(name, Human.Count(bytes), Human.Value(Math.Round(bytes / Math.Max(1.0, m_cloud.Points), 2)));
        yield return planes;
    }

    public CloudManifest Cloud => m_cloud;
    public long Bytes => m_bytes;

    public IEnumerable<(string Name, string Value)> Lines()
    {
        yield return ("format", "converted cloud " + StoreFormat.Version + (IsWhole ? "" : ", being built"));
        yield return ("size", Human.Count(m_bytes) + " bytes");
        yield return ("points", Human.Count(m_cloud.Points)
            + (m_cloud.PointsLeftOut > 0 ? ", " + Human.Count(m_cloud.PointsLeftOut) + " left out" : ""));
        var bounds = m_cloud.BoundsGeo;
        for (int axis = 0; axis < 3 && !bounds.IsEmpty; axis++)
            yield return (axis == 0 ? "bounds" : "", "xyz"[axis] + "  "
                + Human.Coordinate(bounds.Min[axis], m_cloud.Grid.Step[axis]) + " to "
                + Human.Coordinate(bounds.Max[axis], m_cloud.Grid.Step[axis]));
        yield return ("crs", m_cloud.CrsName ?? "unknown");
        if (SourceFacts.AxesOf(m_cloud.Crs) is var (kind, axes))
            yield return ("axes", axes + ", " + kind + "; coordinates are never swapped for them");
        yield return ("unit", SourceFacts.UnitOf(m_cloud.Crs.Units, m_cloud.BoundsGeo));
        if (m_cloud.GpsTime.Kind != GpsTimeKind.Unknown)
            yield return ("GPS times", m_cloud.GpsTime.ToString());
        yield return ("octree", Human.Count(m_cloud.NodeCount, "node") + " on " + Human.Count(m_levels.Count, "level") + " in "
            + Human.Count(m_cloud.ChunkCount, "chunk"));
        yield return ("sampler", m_cloud.Sampler);
        yield return ("checksum", m_cloud.Checksum.ToString("x16", CultureInfo.InvariantCulture));
        yield return ("whole", IsWhole ? "yes" : "no, it is being built");
        foreach (var source in m_cloud.Sources)
            yield return ("source", source.Name + ", " + Human.Count(source.FileBytes) + " bytes, "
                + Human.Count(source.Points, "point") + (source.Crs?.Name is { } crs ? ", " + crs : ""));
        foreach (var fact in m_source.Facts)
            yield return (fact.Key, fact.Value);
    }

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteString("format", "FastPoints");
        json.WriteString("version", StoreFormat.Version.ToString(CultureInfo.InvariantCulture));
        json.WriteNull("pointFormat");
        json.WriteInteger("points", m_cloud.Points);
        json.WriteString("pointsAre", "counted");
        json.WriteInteger("pointsLeftOut", m_cloud.PointsLeftOut);
        json.WriteBoolean("isWhole", IsWhole);
        json.WriteBounds("boundsClaimed", BoundsGeo.Empty);
        json.WriteBounds("bounds", m_cloud.BoundsGeo);
        json.WriteVector("scale", m_cloud.Grid.Step);
        json.WriteVector("offset", m_cloud.Grid.Origin);
        json.WriteStartArray("attributes");
        for (int i = 0; i < m_cloud.Attributes.Count; i++)
            SourceFacts.WriteAttribute(json, m_cloud.Attributes[i], m_cloud.Ranges[i].Min, m_cloud.Ranges[i].Max);
        json.WriteEndArray();
        SourceFacts.WriteCrs(json, m_cloud.Crs, m_cloud.BoundsGeo);
        SourceFacts.WriteGpsTime(json, m_cloud.GpsTime);
        SourceFacts.WriteFacts(json, m_source);
        json.WriteStartObject("tree");
        json.WriteNumber("nodes", m_cloud.NodeCount);
        json.WriteNumber("chunks", m_cloud.ChunkCount);
        json.WriteBoolean("isWhole", IsWhole);
        json.WriteStartArray("levels");
        for (int i = 0; i < m_levels.Count; i++)
        {
            json.WriteStartObject();
            json.WriteNumber("level", i);
            json.WriteNumber("nodes", m_levels[i].Nodes);
            json.WriteInteger("points", m_levels[i].Points);
            json.WriteNumber("mostPoints", m_levels[i].MaxPoints);
            json.WriteReal("spacing", m_levels[i].Spacing > 0 ? m_levels[i].Spacing : double.NaN);
            json.WriteEndObject();
        }
        json.WriteEndArray();
        json.WriteEndObject();
        json.WriteInteger("bytesOnDisk", m_bytes);
        json.WriteStartObject("bytesOfPlane");
        foreach (var (name, bytes) in m_planes)
            json.WriteInteger(name, bytes);
        json.WriteEndObject();
        json.WriteString("sampler", m_cloud.Sampler);
        json.WriteString("checksum", m_cloud.Checksum.ToString("x16", CultureInfo.InvariantCulture));
        json.WriteStartArray("sources");
        foreach (var source in m_cloud.Sources)
        {
            json.WriteStartObject();
            json.WriteString("name", source.Name);
            json.WriteInteger("bytes", source.FileBytes);
            json.WriteInteger("points", source.Points);
            json.WriteEndObject();
        }
        json.WriteEndArray();
        json.WriteNull("columnSums");
    }
}
