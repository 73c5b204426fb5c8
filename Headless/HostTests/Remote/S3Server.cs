using Amazon.Runtime;

namespace FastPoints.HostTests.Remote;

/// <summary>A server of S3's interface that checks signatures (s3rver, whose keys are known), and the variables by which the
/// SDK finds it.</summary>
sealed class S3Server : IDisposable
{
    static readonly string[] s_variables = ["AWS_ENDPOINT_URL_S3", "AWS_REGION", "AWS_ACCESS_KEY_ID", "AWS_SECRET_ACCESS_KEY"];

    readonly StringBuilder m_log = new();
    readonly Process m_process;

    S3Server(Process process) => m_process = process;

    public int Port { get; private init; }

    public string[] Log
    {
        get
        {
            lock (m_log)
                return m_log.ToString().Split('\n');
        }
    }

    public static S3Server Start(string folder, string bucket)
    {
        string program = Path.Combine(Checkout.Repository.Root, "Headless/artifacts/s3/node_modules/s3rver/bin/s3rver.js");
        if (!File.Exists(program))
            Assert.Ignore("no server of S3's interface here (./test --remote installs it)");
        int port = NginxServer.FreePort();
        Use(port);
        var start = new ProcessStartInfo("node") { RedirectStandardOutput = true, RedirectStandardError = true };
        string[] args = [program, "-d", folder, "-a", "127.0.0.1", "-p", port.ToString(), "--configure-bucket", bucket];
        foreach (string arg in args)
            start.ArgumentList.Add(arg);
        Directory.CreateDirectory(folder);
        var server = new S3Server(Process.Start(start)) { Port = port };
        server.m_process.OutputDataReceived += (_, line) =>
        {
            lock (server.m_log)
                server.m_log.AppendLine(line.Data);
        };
        server.m_process.BeginOutputReadLine();
        server.m_process.BeginErrorReadLine();
        NginxServer.AwaitPort(server.m_process, port);
        return server;
    }

    /// <summary>Has the SDK ask a port of this machine.</summary>
    public static void Use(int port) => Set("http://127.0.0.1:" + port, "eu-west-1", "S3RVER", "S3RVER");

    public static void Set(params string[] values)
    {
        for (int i = 0; i < values.Length; i++)
            Environment.SetEnvironmentVariable(s_variables[i], values[i]);
        FallbackRegionFactory.Reset();
    }

    public void Dispose()
    {
        Set(null, null, null, null);
        m_process.Kill();
        m_process.Dispose();
    }
}
