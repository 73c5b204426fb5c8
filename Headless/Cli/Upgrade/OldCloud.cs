using System.Text.Json.Nodes;

namespace FastPoints.Cli.Upgrade;

/// <summary>A cloud of version 2: its manifest, its upper nodes and its list of chunks. All that it gives was hashed and
/// checked.</summary>
sealed unsafe class OldCloud : IDisposable
{
    const string HierarchyName = "hierarchy.bin", UpperName = "upper.bin";

    readonly string m_folder;
    readonly int m_planeCount;
    OldTable? m_upper;

    OldCloud(string folder, CloudManifest manifest, List<SourceEntry> sources)
    {
        m_folder = folder;
        Manifest = manifest;
        Sources = sources;
        m_planeCount = manifest.CreateLayout().Planes.Count;
    }

    public CloudManifest Manifest { get; } // As of version 3, but for where the hierarchy is.
    public List<SourceEntry> Sources { get; }
    public OldTable Upper => m_upper!;
    public List<OldChunk> Chunks { get; } = [];

    public string UpperPath => Path.Combine(m_folder, UpperName);

    public string PathOf(in OldChunk chunk) => Path.Combine(m_folder, StoreFormat.ChunkFolderName,
        chunk.Number.ToString("D6", CultureInfo.InvariantCulture) + ".bin");

    public static long VersionOf(string folder) => Members(folder).Long("version");

    public static OldCloud Open(string folder)
    {
        var (manifest, sources, files) = ReadManifest(folder);
        if (manifest.IsBuilding)
            throw new PointCloudException(FailureCode.Unsupported, folder, -1,
                "was not built to its end by an older version: convert its sources again");
        var cloud = new OldCloud(folder, manifest, sources);
        try
        {
            cloud.ReadHierarchy(files);
            return cloud;
        }
        catch
        {
            cloud.Dispose();
            throw;
        }
    }

    public void Dispose() => m_upper?.Dispose();

    /// <returns>The nodes of a chunk; the caller disposes them.</returns>
    public OldTable TableOf(in OldChunk chunk)
    {
        string path = PathOf(chunk);
        var header = ReadHeader(path, OldHeader.ChunkMagic);
        if (header.Number != chunk.Number || header.NodeCount != chunk.NodeCount || header.TableHash != chunk.TableHash
            || header.FileBytes != chunk.FileBytes || header.PointCount != chunk.PointCount
            || header.TableOffset != header.FileBytes - header.NodeBytes)
            throw Damage(path, 0, "is not the chunk that " + HierarchyName + " names");
        return Checked(path, StoreFile.Read(path, header.TableOffset, header.NodeBytes, Allocator.Persistent), header,
            chunk.Cube, header.TableOffset);
    }

    static JsonMembers Members(string folder)
    {
        string path = Path.Combine(folder, StoreFormat.ManifestName);
        return JsonMembers.Parse(StoreFile.ReadText(path), path);
    }

    static (CloudManifest Manifest, List<SourceEntry> Sources, JsonMembers Files) ReadManifest(string folder)
    {
        string path = Path.Combine(folder, StoreFormat.ManifestName);
        var members = Members(folder);
        members.RequireVersion(OldHeader.Version);
        // Only what said where things are has changed.
        string text;
        try
        {
            var json = JsonNode.Parse(StoreFile.ReadText(path))!.AsObject();
            json["version"] = StoreFormat.Version;
            json["hierarchy"] = JsonNode.Parse(
                """{"whole":false,"bytes":0,"rootOffset":0,"rootBytes":0,"rootHash":"0000000000000000"}""");
            text = json.ToJsonString();
        }
        catch (Exception e) when (e is JsonException or ArgumentException)
        {
            throw Damage(path, -1, "no JSON: " + e.Message);
        }
        return (CloudManifest.FromJson(text, path), StoredSources.FromJson(text, path), members.Object("files"));
    }

    void ReadHierarchy(JsonMembers files)
    {
        string path = Path.Combine(m_folder, HierarchyName);
        var header = ReadHeader(path, OldHeader.HierarchyMagic);
        long bytes = header.NodeBytes;
        using var all = StoreFile.Read(path, 0, header.FileBytes, Allocator.Persistent);
        if (files.NonNegative("hierarchyBytes") != header.FileBytes || header.PointCount != Manifest.Points
            || header.TableOffset < OldHeader.SizeBytes
            || header.TableOffset != header.FileBytes - bytes - (long)header.ChunkCount * OldChunk.SizeBytes)
            throw Damage(path, 0, "is not the hierarchy that " + StoreFormat.ManifestName + " names");
        RequireHash(path, 0, files.Hex("hierarchyHash"), ContentHash.Of(all.AsReadOnlySpan()));
        long upperBytes = files.NonNegative("upperBytes");
        if (header.NodeCount > 0 && ReadHeader(UpperPath, OldHeader.UpperMagic).FileBytes != upperBytes)
            throw Damage(UpperPath, 0, "wanted " + upperBytes + " bytes");
        var table = new NativeArray<byte>(all.GetSubArray((int)header.TableOffset, (int)bytes), Allocator.Persistent);
        m_upper = Checked(path, table, header, Manifest.Root, upperBytes);
        var chunks = (OldChunk*)((byte*)all.GetUnsafeReadOnlyPtr() + header.TableOffset + bytes);
        for (int c = 0; c < header.ChunkCount; c++)
        {
            if (chunks[c].AttachNode < 0 || chunks[c].AttachNode >= header.NodeCount || chunks[c].NodeCount < 1
                || chunks[c].SideLog2 is < 0 or > GridCube.MaxSideLog2 || !Manifest.Root.ContainsAligned(chunks[c].Cube))
                throw Damage(path, -1, "chunk " + chunks[c].Number + " hangs on no node");
            Chunks.Add(chunks[c]);
        }
    }

    /// <summary>Takes over the bytes of a table.</summary>
    OldTable Checked(string path, NativeArray<byte> bytes, in OldHeader header, GridCube cube, long planesEnd)
    {
        var table = new OldTable(bytes, header.NodeCount, m_planeCount);
        try
        {
            if (header.Magic == OldHeader.ChunkMagic)
                RequireHash(path, header.TableOffset, header.TableHash, ContentHash.Of(bytes.AsReadOnlySpan()));
            int fault = table.FindFault(cube, planesEnd);
            return fault < 0 ? table : throw Damage(path, header.TableOffset, "node " + fault + " is not in order");
        }
        catch
        {
            table.Dispose();
            throw;
        }
    }

    OldHeader ReadHeader(string path, ulong magic)
    {
        using var bytes = StoreFile.Read(path, 0, OldHeader.SizeBytes, Allocator.Persistent);
        var header = *(OldHeader*)bytes.GetUnsafeReadOnlyPtr();
        if (header.Magic != magic || header.VersionNumber != OldHeader.Version)
            throw Damage(path, 0, "is no such file of version " + OldHeader.Version);
        RequireHash(path, 0, header.HeaderHash, ContentHash.Of(&header, OldHeader.SizeBytes - sizeof(ulong)));
        if (header.CloudId != Manifest.CloudId)
            throw Damage(path, 0, "is of another cloud");
        if (StoreFile.SizeOf(path) is var size && size != header.FileBytes)
            throw Damage(path, 0, "wanted " + header.FileBytes + " bytes, got " + size);
        return header.PlaneCount == m_planeCount && header.NodeCount >= 0 && header.ChunkCount >= 0 ? header
            : throw Damage(path, 0, "wanted " + m_planeCount + " planes, got " + header.PlaneCount);
    }

    public static void RequireHash(string path, long offset, ulong wanted, ulong got)
    {
        if (wanted != got)
            throw Damage(path, offset, "is damaged: " + StoreFile.HashProblem(wanted, got));
    }

    static PointCloudException Damage(string path, long offset, string what) =>
        new(FailureCode.BadInput, path, offset, what);
}
