using System.Security.Cryptography.X509Certificates;

namespace FastPoints.HostTests.Remote;

// Debian's nginx over a folder, by TLS and without, with certificates of its own authority.
sealed class NginxServer : IDisposable
{
    readonly Process m_process;
    readonly string m_folder;
    readonly X509Certificate2 m_authority;

    public static string Program { get; } = new[] { "/usr/sbin/nginx", "/usr/local/sbin/nginx" }.FirstOrDefault(File.Exists);

    // folder: for its own files. served: the root of addresses. more: lines of configuration.
    public NginxServer(string folder, string served, string more = "")
    {
        if (Program == null)
            Assert.Ignore("no nginx here (./test --remote installs it)");
        m_folder = folder;
        Directory.CreateDirectory(Path.Combine(folder, "logs"));
        m_authority = WriteCertificates();
        (TlsPort, Port, Http2Port) = (FreePort(), FreePort(), FreePort());
        File.WriteAllText(Path.Combine(folder, "nginx.conf"), Configuration(served, more));
        var start = new ProcessStartInfo(Program) { RedirectStandardError = true };
        string[] args = { "-p", folder, "-c", Path.Combine(folder, "nginx.conf"), "-e", Path.Combine(folder, "error.log") };
        foreach (string arg in args)
            start.ArgumentList.Add(arg);
        m_process = Process.Start(start);
        AwaitPort(m_process, TlsPort);
    }

    public int TlsPort { get; }
    public int Port { get; }

    public int Http2Port { get; } // By TLS, too.

    public string AuthorityPath => Path.Combine(m_folder, "authority.pem"); // For SSL_CERT_FILE.

    // Of all answers that anyone has whole.
    public string[] AccessLog
    {
        get
        {
            // A line is written after its answer, but before this only process takes up another request.
            using var client = new HttpClient();
            client.GetAsync($"http://127.0.0.1:{Port}/{nameof(AccessLog)}").Result.Dispose();
            string[] lines = File.ReadAllLines(Path.Combine(m_folder, "access.log"));
            return lines.Where(line => !line.Contains(nameof(AccessLog))).ToArray();
        }
    }

    public string ErrorLog => File.ReadAllText(Path.Combine(m_folder, "error.log"));

    public void Dispose()
    {
        m_process.Kill();
        m_process.WaitForExit();
        m_process.Dispose();
        m_authority.Dispose();
    }

    // Trusts this server's authority alone, and checks all else.
    public HttpClientHandler Trusting() => new()
    {
        AllowAutoRedirect = false,
        MaxConnectionsPerServer = RemoteSettings.Current.MaxConnections,
        ServerCertificateCustomValidationCallback = (_, certificate, chain, _) =>
        {
            chain.ChainPolicy.TrustMode = X509ChainTrustMode.CustomRootTrust;
            chain.ChainPolicy.CustomTrustStore.Add(m_authority);
            chain.ChainPolicy.RevocationMode = X509RevocationMode.NoCheck;
            return certificate.MatchesHostname("127.0.0.1") && chain.Build(certificate);
        },
    };

    // master_process off: one process, as this user, which ends when it is killed.
    string Configuration(string served, string more) => $$"""
        daemon off; master_process off; pid {{m_folder}}/nginx.pid; error_log {{m_folder}}/error.log;
        events { worker_connections 512; }
        http {
          access_log {{m_folder}}/access.log; keepalive_requests 100000; sendfile on; tcp_nodelay on;
          client_body_temp_path {{m_folder}}/1; proxy_temp_path {{m_folder}}/2; fastcgi_temp_path {{m_folder}}/3;
          uwsgi_temp_path {{m_folder}}/4; scgi_temp_path {{m_folder}}/5;
          {{more}}
          server {
            listen 127.0.0.1:{{Port}}; listen 127.0.0.1:{{TlsPort}} ssl; listen 127.0.0.1:{{Http2Port}} ssl http2;
            ssl_certificate {{m_folder}}/server.pem; ssl_certificate_key {{m_folder}}/server.key;
            root {{served}};
          }
        }
        """;

    X509Certificate2 WriteCertificates()
    {
        DateTimeOffset now = DateTimeOffset.UtcNow;
        using ECDsa authorityKey = ECDsa.Create(ECCurve.NamedCurves.nistP256), key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        var authorityRequest = new CertificateRequest("CN=FastPoints tests", authorityKey, HashAlgorithmName.SHA256);
        authorityRequest.CertificateExtensions.Add(new X509BasicConstraintsExtension(true, false, 0, true));
        X509Certificate2 authority = authorityRequest.CreateSelfSigned(now.AddDays(-1), now.AddDays(30));
        var request = new CertificateRequest("CN=localhost", key, HashAlgorithmName.SHA256);
        var names = new SubjectAlternativeNameBuilder();
        names.AddIpAddress(IPAddress.Loopback);
        names.AddDnsName("localhost");
        request.CertificateExtensions.Add(names.Build());
        using X509Certificate2 certificate = request.Create(authority, now.AddDays(-1), now.AddDays(20), [1, 2, 3, 4]);
        File.WriteAllText(AuthorityPath, authority.ExportCertificatePem());
        File.WriteAllText(Path.Combine(m_folder, "server.pem"), certificate.ExportCertificatePem());
        File.WriteAllText(Path.Combine(m_folder, "server.key"), key.ExportPkcs8PrivateKeyPem());
        return authority;
    }

    internal static int FreePort()
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        return ((IPEndPoint)listener.LocalEndpoint).Port;
    }

    internal static void AwaitPort(Process server, int port)
    {
        for (var watch = Stopwatch.StartNew(); watch.Elapsed.TotalSeconds < 20; Thread.Sleep(20))
        {
            Assert.That(server.HasExited, Is.False, "it ended");
            using var client = new TcpClient();
            try
            {
                client.Connect(IPAddress.Loopback, port);
                return;
            }
            catch (SocketException)
            {
                // Not yet.
            }
        }
        Assert.Fail(server.StartInfo.FileName + " did not begin");
    }
}
