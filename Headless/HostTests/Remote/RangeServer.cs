using System.Buffers;
using System.IO.Pipelines;
using System.Net;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.Extensions.DependencyInjection;

namespace FastPoints.HostTests.Remote
{
    // Serves the files of a folder by ranges, by HTTP/1.1 on a free port of the loopback. Kestrel has the connections; the answers are
    // written here byte by byte, for Kestrel would let none be wrong.
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

        // Without a slash at its end.
        public string Address { get; }

        // Before each answer.
        public int LatencyMs { get; set; }

        // Since the server began, or ResetCounts.
        public IReadOnlyList<RangeRequest> Requests
        {
            get
            {
                lock (m_requests)
                    return m_requests.ToArray();
            }
        }

        // Of bodies, as sent.
        public long Bytes => Interlocked.Read(ref m_bytes);

        // At once.
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
                    lock (m_requests)
                        m_requests.Add(request);
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
            PipeWriter output = connection.Transport.Output;
            await output.WriteAsync(Encoding.ASCII.GetBytes(answer.Head()), m_ends.Token);
            if (request.Method != "HEAD")
                await WriteBody(output, answer);
            return true;
        }

        async Task WriteBody(PipeWriter output, RangeAnswer answer)
        {
            byte[] buffer = ArrayPool<byte>.Shared.Rent(64 << 10);
            try
            {
                using FileStream file = answer.Path == null ? null : File.OpenRead(answer.Path);
                for (long left = answer.Bytes; left > 0;)
                {
                    int part = (int)Math.Min(left, buffer.Length);
                    if (file == null)
                        buffer.AsSpan(0, part).Clear();
                    else
                        RandomAccess.Read(file.SafeFileHandle, buffer.AsSpan(0, part), answer.From + answer.Bytes - left);
                    left -= part;
                    Interlocked.Add(ref m_bytes, part);
                    if ((await output.WriteAsync(buffer.AsMemory(0, part), m_ends.Token)).IsCompleted)
                        throw new IOException();
                }
            }
            finally
            {
                ArrayPool<byte>.Shared.Return(buffer);
            }
        }
    }
}
