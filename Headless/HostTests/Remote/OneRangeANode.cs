using System.Buffers.Binary;

namespace FastPoints.HostTests.Remote;

// How Potree's viewer asks for a cloud's nodes: one request each, four under way, in the order of levels. It is let off waiting
// for a node's parent, and decodes in no time.
sealed class OneRangeANode
{
    const int RequestsUnderWay = 4;

    readonly record struct Piece(string Name, long Offset, long Bytes, long Points);

    // Asked for one after the other, before any node.
    readonly List<Piece> m_tables = new();
    readonly List<Piece> m_nodes = new();

    public int Requests { get; private set; }

    // Of a cloud in a folder, as drawn from the camera.
    public static OneRangeANode OfConverted(string served, string name, CameraPath path, int budget)
    {
        var policy = new OneRangeANode();
        string folder = Path.Combine(served, name);
        policy.AddTable(served, name + "/cloud.json");
        policy.AddTable(served, name + "/hierarchy.bin");
        using var stream = new StreamContext(new MemoryNodePool(256 << 20, 16 << 20));
        stream.Settings.Selection.PointBudget = budget;
        var source = new FolderSource(CloudFolder.Open(folder), StoreLayout.ColorName);
        int cloud = stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
        using var views = new NativeArray<StreamView>(1, Allocator.Persistent)
        {
            [0] = path.CameraAt(0).ToStreamView(1280, 720),
        };
        while (!FrameStep.Run(stream, views).IsSettled)
            Thread.Sleep(1);
        foreach (var node in stream.Drawn.AsArray())
        {
            var ranges = Enumerable.Range(0, source.Planes.Length)
                .Select(p => stream.Clouds[cloud].RangeOf(node.Page, node.Node, p));
            policy.m_nodes.Add(new Piece(Path.GetRelativePath(served, source.PlanesPathOf(node.Page)),
                ranges.Min(r => r.OffsetBytes), stream.Clouds[cloud].BytesOf(node.Page, node.Node),
                PointsOf(stream, cloud, node.Page, node.Node)));
        }
        return policy;
    }

    static unsafe long PointsOf(StreamContext stream, int cloud, int page, int node) =>
        stream.Clouds[cloud].Pages[page].Nodes[node].PointCount;

    // Of all nodes, by the file's one page of hierarchy.
    public static OneRangeANode OfCopc(string served, string name)
    {
        byte[] file = File.ReadAllBytes(Path.Combine(served, name));
        long at = BinaryPrimitives.ReadInt64LittleEndian(file.AsSpan(429 + 40));
        long bytes = BinaryPrimitives.ReadInt64LittleEndian(file.AsSpan(429 + 48));
        var policy = new OneRangeANode();
        policy.m_tables.Add(new Piece(name, 0, 589, 0));
        policy.m_tables.Add(new Piece(name, at, bytes, 0));
        var nodes = new List<(int Level, Piece Piece)>();
        for (int entry = (int)at; entry < at + bytes; entry += 32)
        {
            int Int(int from) => BinaryPrimitives.ReadInt32LittleEndian(file.AsSpan(entry + from));
            if (Int(28) > 0)
            {
                long offset = BinaryPrimitives.ReadInt64LittleEndian(file.AsSpan(entry + 16));
                nodes.Add((Int(0), new Piece(name, offset, Int(24), Int(28))));
            }
        }
        policy.m_nodes.AddRange(nodes.OrderBy(n => n.Level).Select(n => n.Piece));
        return policy;
    }

    public static OneRangeANode OfEpt(string served, string name)
    {
        var policy = new OneRangeANode();
        policy.AddTable(served, name + "/ept.json");
        string root = Path.Combine(served, name);
        var pages = Directory.GetFiles(Path.Combine(root, "ept-hierarchy")).Select(Path.GetFileName).Order().ToList();
        var nodes = new SortedDictionary<string, Piece>(StringComparer.Ordinal);
        foreach (string page in pages)
        {
            policy.AddTable(served, name + "/ept-hierarchy/" + page);
            using var json = JsonDocument.Parse(File.ReadAllBytes(Path.Combine(root, "ept-hierarchy", page)));
            foreach (JsonProperty node in json.RootElement.EnumerateObject())
            {
                string file = Directory.GetFiles(Path.Combine(root, "ept-data"), node.Name + ".*").FirstOrDefault();
                if (node.Value.GetInt64() > 0 && file != null)
                    nodes[node.Name] = new Piece(name + "/ept-data/" + Path.GetFileName(file), 0, new FileInfo(file).Length,
                        node.Value.GetInt64());
            }
        }
        policy.m_nodes.AddRange(nodes.Values);
        return policy;
    }

    void AddTable(string served, string name) =>
        m_tables.Add(new Piece(name, 0, new FileInfo(Path.Combine(served, name)).Length, 0));

    // Until so many points have come.
    public double Seconds(string address, long points)
    {
        using var client = new HttpClient(new SocketsHttpHandler { MaxConnectionsPerServer = RequestsUnderWay });
        var watch = Stopwatch.StartNew();
        int next = 0;
        long arrived = 0;
        double seconds = double.NaN;
        Requests = 0;

        async Task Get(Piece piece)
        {
            using var request = new HttpRequestMessage(HttpMethod.Get, address + "/" + piece.Name);
            request.Headers.Range = new RangeHeaderValue(piece.Offset, piece.Offset + piece.Bytes - 1);
            using HttpResponseMessage answer = await client.SendAsync(request);
            await answer.EnsureSuccessStatusCode().Content.ReadAsByteArrayAsync();
            lock (m_nodes)
            {
                Requests++;
                arrived += piece.Points;
                if (double.IsNaN(seconds) && arrived >= points)
                    seconds = watch.Elapsed.TotalSeconds;
            }
        }

        async Task GetNodes()
        {
            for (int i; (i = Interlocked.Increment(ref next) - 1) < m_nodes.Count && double.IsNaN(seconds);)
                await Get(m_nodes[i]);
        }

        Task.Run(async () =>
        {
            foreach (Piece piece in m_tables)
                await Get(piece);
            await Task.WhenAll(Enumerable.Range(0, RequestsUnderWay).Select(_ => GetNodes()));
        }).GetAwaiter().GetResult();
        return seconds;
    }
}
