namespace FastPoints.Cli.Cluster;

/// <summary>JSON that ends in a hash of all before it: files of a plan, and what tasks leave.</summary>
static class PlanFile
{
    const string HashStart = ",\"hash\":\"";
    const int MaxBytes = 64 << 20; // A task reads no more of a plan.

    public static string ToText(Action<Utf8JsonWriter> members, bool isIndented = false)
    {
        var bytes = new ArrayBufferWriter<byte>(4096);
        using (var json = new Utf8JsonWriter(bytes, new JsonWriterOptions
        {
            Indented = isIndented,
            Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
        }))
        {
            json.WriteStartObject();
            members(json);
            json.WriteEndObject();
        }
        var body = bytes.WrittenSpan[..^1].TrimEnd((byte)'\n');
        return Encoding.UTF8.GetString(body) + HashStart + ToHex(ContentHash.Of(body)) + "\"}\n";
    }

    /// <exception cref="PointCloudException">There is none, or it is damaged.</exception>
    public static JsonMembers Read(string path, out string text)
    {
        text = StoreFile.ReadText(path, MaxBytes);
        return Parse(text, path);
    }

    /// <exception cref="PointCloudException">It is damaged.</exception>
    public static JsonMembers Parse(string text, string path)
    {
        var json = JsonMembers.Parse(text, path);
        int end = text.LastIndexOf(HashStart, StringComparison.Ordinal);
        ulong wanted = json.Hex("hash"), got = end < 0 ? 0 : ContentHash.Of(Encoding.UTF8.GetBytes(text[..end]));
        return wanted == got ? json
            : throw new PointCloudException(FailureCode.BadInput, path, -1, StoreFile.HashProblem(wanted, got));
    }

    public static string ToHex(ulong value) => value.ToString("x16", CultureInfo.InvariantCulture);

    public static void WriteCube(Utf8JsonWriter json, GridCube cube) =>
        json.WriteNumbers(cube.Corner.X, cube.Corner.Y, cube.Corner.Z, cube.SideLog2);

    public static void WriteCubes(Utf8JsonWriter json, string name, IEnumerable<GridCube> cubes) =>
        json.WriteArray(name, cubes, cube => WriteCube(json, cube));

    public static GridCube ReadCube(JsonMembers json, string name) => CubeOf(json.Longs(name, 4), json, name);

    public static GridCube[] ReadCubes(JsonMembers json, string name) =>
        json.LongLists(name, 4).ConvertAll(numbers => CubeOf(numbers, json, name)).ToArray();

    static GridCube CubeOf(long[] numbers, JsonMembers json, string name) => numbers[3] is >= 0 and <= GridCube.MaxSideLog2
        ? new GridCube(new Grid3(numbers[0], numbers[1], numbers[2]), (int)numbers[3])
        : throw json.Wanted(name, "a corner and the logarithm of a side up to " + GridCube.MaxSideLog2);
}
