using System.Threading.Channels;

namespace FastPoints.HostTests.Remote;

// A line to a server of this machine: an answer comes a round trip later than it would, a connection costs one more, and all
// connections together get so many bytes a second. TCP's slow start and lost packets are not simulated.
sealed class SlowLink : IDisposable
{
    const int PieceBytes = 8 << 10;

    readonly TcpListener m_listener = new(IPAddress.Loopback, 0);
    readonly CancellationTokenSource m_ends = new();
    readonly IPEndPoint m_server;
    readonly object m_lock = new();
    double m_freeAt; // Seconds of the clock.
    long m_bytes;
    int m_connections;

    public SlowLink(int serverPort, int roundTripMs, double megabitsPerSecond)
    {
        m_server = new IPEndPoint(IPAddress.Loopback, serverPort);
        RoundTripMs = roundTripMs;
        BytesPerSecond = megabitsPerSecond * 1e6 / 8;
        m_listener.Start(100);
        _ = Accept();
    }

    public int Port => ((IPEndPoint)m_listener.LocalEndpoint).Port;
    public int RoundTripMs { get; }
    public double BytesPerSecond { get; }

    // From the server, with headers and TLS.
    public long Bytes => Interlocked.Read(ref m_bytes);
    public int Connections => Volatile.Read(ref m_connections);

    public void Dispose()
    {
        m_ends.Cancel();
        m_listener.Stop();
    }

    static double Now => Stopwatch.GetTimestamp() / (double)Stopwatch.Frequency;

    async Task Accept()
    {
        try
        {
            while (true)
                _ = Carry(await m_listener.AcceptSocketAsync(m_ends.Token));
        }
        catch (Exception e) when (e is OperationCanceledException or SocketException or ObjectDisposedException)
        {
        }
    }

    async Task Carry(Socket client)
    {
        Interlocked.Increment(ref m_connections);
        using var server = new Socket(SocketType.Stream, ProtocolType.Tcp);
        using (client)
        {
            client.NoDelay = server.NoDelay = true;
            try
            {
                await server.ConnectAsync(m_server, m_ends.Token);
                await Task.WhenAny(Up(client, server), Down(server, client));
            }
            catch (Exception e) when (e is OperationCanceledException or SocketException)
            {
            }
        }
    }

    async Task Up(Socket client, Socket server)
    {
        double earliest = Now + RoundTripMs / 1000.0;
        var pieces = Channel.CreateUnbounded<(double Due, byte[] Bytes)>();
        Task sends = Send(pieces.Reader, server);
        byte[] buffer = new byte[PieceBytes];
        int count;
        while ((count = await client.ReceiveAsync(buffer, m_ends.Token)) > 0)
            pieces.Writer.TryWrite((Math.Max(Now, earliest) + RoundTripMs / 1000.0, buffer[..count]));
        pieces.Writer.Complete();
        await sends;
    }

    async Task Send(ChannelReader<(double Due, byte[] Bytes)> pieces, Socket server)
    {
        await foreach ((double due, byte[] bytes) in pieces.ReadAllAsync(m_ends.Token))
        {
            await Until(due);
            await server.SendAsync(bytes, m_ends.Token);
        }
    }

    async Task Down(Socket server, Socket client)
    {
        byte[] buffer = new byte[PieceBytes];
        double free = 0;
        while (true)
        {
            ValueTask<int> receive = server.ReceiveAsync(buffer, m_ends.Token);
            // What lay here already came while the piece before was late.
            double from = receive.IsCompleted ? free : Now;
            int count = await receive;
            if (count == 0)
                return;
            lock (m_lock)
                free = m_freeAt = Math.Max(from, m_freeAt) + count / BytesPerSecond;
            await Until(free);
            Interlocked.Add(ref m_bytes, count);
            for (int sent = 0; sent < count;)
                sent += await client.SendAsync(buffer.AsMemory(sent, count - sent), m_ends.Token);
        }
    }

    // The clock of delays is coarse: what is late makes up for it, for the times that are waited for are added up exactly.
    async Task Until(double due)
    {
        while (due - Now is var left && left > 0.0005)
            await Task.Delay(TimeSpan.FromSeconds(left), m_ends.Token);
    }
}
