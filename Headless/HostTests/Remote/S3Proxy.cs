namespace FastPoints.HostTests.Remote;

enum S3Fault { None, LostAnswer, Broken500, Busy503, CutBody, StalledBody, WrongTag }

/// <summary>Stands before a server of S3's interface, and does wrong what networks and servers do.</summary>
sealed class S3Proxy : IDisposable
{
    readonly HttpListener m_listener = new();
    readonly HttpClient m_client = new();
    readonly string m_server;

    public S3Proxy(int serverPort)
    {
        Port = NginxServer.FreePort();
        m_server = "http://127.0.0.1:" + serverPort;
        m_listener.Prefixes.Add("http://127.0.0.1:" + Port + "/");
        m_listener.Start();
        Task.Run(Serve);
    }

    public int Port { get; }

    /// <summary>By method and path.</summary>
    public Func<string, string, S3Fault> Plan { get; set; } = (_, _) => S3Fault.None;

    public List<S3Fault> Done { get; } = [];

    async Task Serve()
    {
        while (m_listener.IsListening)
        {
            HttpListenerContext context;
            try
            {
                context = await m_listener.GetContextAsync();
            }
            catch (Exception e) when (e is HttpListenerException or ObjectDisposedException)
            {
                return;
            }
            _ = Task.Run(() => Answer(context));
        }
    }

    async Task Answer(HttpListenerContext context)
    {
        try
        {
            S3Fault fault;
            lock (Done)
            {
                fault = Plan(context.Request.HttpMethod, context.Request.Url!.AbsolutePath);
                if (fault != S3Fault.None)
                    Done.Add(fault);
            }
            if (fault is S3Fault.Broken500 or S3Fault.Busy503)
            {
                context.Response.StatusCode = fault == S3Fault.Broken500 ? 500 : 503;
                context.Response.Close();
                return;
            }
            using var answer = await m_client.SendAsync(Request(context.Request));
            byte[] body = await answer.Content.ReadAsByteArrayAsync();
            if (fault == S3Fault.LostAnswer)
                context.Response.Abort();
            else
                await Send(context, answer, body, fault);
        }
        catch (Exception e) when (e is HttpListenerException or IOException or ObjectDisposedException or HttpRequestException)
        {
            // Who asked went away.
        }
    }

    HttpRequestMessage Request(HttpListenerRequest from)
    {
        var request = new HttpRequestMessage(new HttpMethod(from.HttpMethod), m_server + from.RawUrl);
        if (from.HasEntityBody)
        {
            using var body = new MemoryStream();
            from.InputStream.CopyTo(body);
            request.Content = new ByteArrayContent(body.ToArray());
        }
        foreach (string name in from.Headers.AllKeys)
            if (name is not ("Connection" or "Expect" or "Transfer-Encoding")
                && !request.Headers.TryAddWithoutValidation(name!, from.Headers[name]))
                request.Content?.Headers.TryAddWithoutValidation(name!, from.Headers[name]);
        return request;
    }

    static async Task Send(HttpListenerContext context, HttpResponseMessage answer, byte[] body, S3Fault fault)
    {
        var response = context.Response;
        response.StatusCode = (int)answer.StatusCode;
        foreach (var header in answer.Headers.Concat(answer.Content.Headers))
            if (header.Key is not ("Content-Length" or "Transfer-Encoding" or "Connection" or "Keep-Alive"))
                response.Headers[header.Key] = string.Join(",", header.Value);
        if (fault == S3Fault.WrongTag && response.Headers["ETag"] != null)
            response.Headers["ETag"] = "\"0123456789abcdef0123456789abcdef\"";
        if (context.Request.HttpMethod == "HEAD" || response.StatusCode == 204)
        {
            response.Close();
            return;
        }
        response.ContentLength64 = body.Length;
        int half = fault is S3Fault.CutBody or S3Fault.StalledBody ? body.Length / 2 : body.Length;
        await response.OutputStream.WriteAsync(body.AsMemory(0, half));
        await response.OutputStream.FlushAsync();
        if (fault == S3Fault.StalledBody)
            await Task.Delay(1000);
        if (half < body.Length)
            response.Abort();
        else
            response.Close();
    }

    public void Dispose()
    {
        m_listener.Close();
        m_client.Dispose();
    }
}
