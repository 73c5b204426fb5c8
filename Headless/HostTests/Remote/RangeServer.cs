using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.Extensions.DependencyInjection;

namespace FastPoints.HostTests.Remote;

// Serves the files of a folder by ranges, by HTTP/1.1 on a free port of the loopback. Kestrel has the connections; the answers
// are written here byte by byte, for Kestrel would let none be wrong.
sealed class RangeServer : IDisposable
{
    readonly string m_folder;
    readonly WebApplication m_host;
    readonly CancellationTokenSource m_ends = new();
    readonly List<RangeRequest> m_requests = new();
    long m_bytes;
    int m_connections, m_peakConnections;

    public RangeServer(string folder, int latencyMs = 0)
    {
        m_folder = Path.GetFullPath(folder);
        LatencyMs = latencyMs;
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.WebHost.UseKestrelCore().ConfigureKestrel(options =>
            options.Listen(IPAddress.Loopback, 0, listen => listen.Run(ServeConnection)));
        m_host = builder.Build();
        m_host.StartAsync().GetAwaiter().GetResult();
        Address = m_host.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>().Addresses.Single();
    }

    public string Address { get; } // Without a slash at its end.

    public int LatencyMs { get; set; } // Before each answer.

    public Task Gate { get; set; } // No answer begins before; null: none waits.

    // Which fault a request meets; null: none.
    public Func<RangeRequest, Fault> Plan { get; set; }

    public string RedirectsTo { get; set; } // Another server, which has the files; null: this one has them.

    // Since the server began, or ResetCounts.
    public IReadOnlyList<RangeRequest> Requests
    {
        get
        {
            lock (m_requests)
                return m_requests.ToArray();
        }
    }

    public long Bytes => Interlocked.Read(ref m_bytes); // Of bodies, as sent.

    public int PeakConnections => Volatile.Read(ref m_peakConnections);

    public string Of(string name) => Address + "/" + name;

    public void ResetCounts()
    {
        lock (m_requests)
        {
            m_requests.Clear();
            m_peakConnections = m_connections;
        }
        Interlocked.Exchange(ref m_bytes, 0);
    }

    public void Dispose()
    {
        if (m_ends.IsCancellationRequested)
            return;
        m_ends.Cancel();
        using (var now = new CancellationTokenSource(0))
            m_host.StopAsync(now.Token).GetAwaiter().GetResult();
        ((IDisposable)m_host).Dispose();
    }

    async Task ServeConnection(ConnectionContext connection)
    {
        lock (m_requests)
            m_peakConnections = Math.Max(m_peakConnections, ++m_connections);
        try
        {
            RangeRequest request;
            while ((request = await RangeRequest.Read(connection.Transport.Input, m_ends.Token)) != null)
            {
                request.Fault = Plan?.Invoke(request) ?? Fault.None;
                lock (m_requests)
                    m_requests.Add(request);
                if (Gate != null)
                    await Gate.WaitAsync(m_ends.Token);
                if (LatencyMs > 0)
                    await Task.Delay(LatencyMs, m_ends.Token);
                if (!await Answer(connection, request))
                    break;
            }
        }
        catch (Exception e) when (e is IOException or OperationCanceledException or ConnectionAbortedException)
        {
            // The client has gone, or the server goes.
        }
        finally
        {
            lock (m_requests)
                m_connections--;
        }
    }

    // Returns whether the connection goes on.
    async Task<bool> Answer(ConnectionContext connection, RangeRequest request)
    {
        RangeAnswer answer = RangeAnswer.Of(m_folder, request);
        Faults.Into(answer, request.Fault, request);
        if (RedirectsTo != null)
            answer.Redirect(RedirectsTo + request.Target);
        PipeWriter output = connection.Transport.Output;
        await output.WriteAsync(Encoding.ASCII.GetBytes(answer.Head()), m_ends.Token);
        if (request.Method != "HEAD" && answer.RawHead == null)
            await WriteBody(output, answer);
        switch (answer.End)
        {
            case AnswerEnd.Reset: connection.Abort(); return false;
            case AnswerEnd.Close: return false;
            case AnswerEnd.Stall: await connection.Transport.Input.ReadAsync(m_ends.Token); return false;
            case AnswerEnd.EndlessHead: await WriteHeadForever(output); return false;
            default: return true;
        }
    }

    async Task WriteHeadForever(PipeWriter output)
    {
        byte[] line = Encoding.ASCII.GetBytes("X-More: " + new string('x', 1000) + "\r\n");
        while (!(await output.WriteAsync(line, m_ends.Token)).IsCompleted)
            await Task.Delay(1, m_ends.Token);
    }

    async Task WriteBody(PipeWriter output, RangeAnswer answer)
    {
        using FileStream file = answer.Body == null && answer.Path != null ? File.OpenRead(answer.Path) : null;
        byte[] buffer = new byte[answer.ByteDelayMs > 0 ? 1 : (int)Math.Clamp(answer.Bytes, 1, 64 << 10)];
        long end = answer.SentBytes >= 0 ? answer.SentBytes : answer.Bytes;
        for (long at = 0; at < end; at += buffer.Length)
        {
            Memory<byte> part = buffer.AsMemory(0, (int)Math.Min(end - at, buffer.Length));
            Fill(answer, file, at, part.Span);
            if (answer.ByteDelayMs > 0)
                await Task.Delay(answer.ByteDelayMs, m_ends.Token);
            if (answer.IsChunked)
                await output.WriteAsync(Encoding.ASCII.GetBytes(part.Length.ToString("x") + "\r\n"), m_ends.Token);
            Interlocked.Add(ref m_bytes, part.Length);
            if ((await output.WriteAsync(part, m_ends.Token)).IsCompleted)
                throw new IOException();
            if (answer.IsChunked)
                await output.WriteAsync("\r\n"u8.ToArray(), m_ends.Token);
        }
        if (answer.IsChunked && answer.SentBytes < 0)
            await output.WriteAsync("0\r\n\r\n"u8.ToArray(), m_ends.Token);
    }

    // Zeros behind the file's end.
    static void Fill(RangeAnswer answer, FileStream file, long at, Span<byte> into)
    {
        into.Clear();
        if (file != null)
            RandomAccess.Read(file.SafeFileHandle, into, answer.From + at);
        else if (answer.Body != null && at < answer.Body.Length)
            answer.Body.AsSpan((int)at, (int)Math.Min(into.Length, answer.Body.Length - at)).CopyTo(into);
    }
}
